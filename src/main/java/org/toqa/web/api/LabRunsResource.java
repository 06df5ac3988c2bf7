package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.lab.record.LabOrder;
import org.toqa.lab.record.LabRun;
import org.toqa.lab.record.Laboratory;
import org.toqa.lab.record.Laboratory.Ordered;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.LabOrderReader;

/** All runs of the laboratory, and new ones. */
public final class LabRunsResource extends ApiHandler {
  public static void list(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Laboratory laboratory = services(request).laboratory();
    Json.send(
        request,
        response,
        200,
        laboratory.store().runs().stream().map(run -> LabRunJson.of(run, laboratory)).toList());
  }

  public static void start(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Texts texts = Texts.of(request);
    LabOrder order = readBody(request, LabOrderReader::readJson);
    Laboratory laboratory = services(request).laboratory();
    LabRun run =
        switch (laboratory.start(order, Caller.of(request).name())) {
          case Ordered.Queued(LabRun queued) -> queued;
          case Ordered.QueueFull _ ->
              throw Problem.of(409, texts.get("problem.laboratory.queue", Laboratory.MOST_WAITING))
                  .exception();
          case Ordered.ArchiveFull _ ->
              throw Problem.of(409, texts.get("problem.laboratory.archive", Laboratory.MOST_KEPT))
                  .exception();
        };
    response.setHeader(
        "Location", request.getContextPath() + "/api/v1/laboratory/runs/" + run.id());
    Json.send(request, response, HttpServletResponse.SC_CREATED, LabRunJson.of(run, laboratory));
  }
}
