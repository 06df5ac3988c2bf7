package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.ManualAnswer;
import org.toqa.fleet.ManualOrder;
import org.toqa.web.FleetAnswers;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.InputRules;
import org.toqa.web.input.ManualOrderReader;
import org.toqa.wording.Sentence;

/** Driving a robot by hand, step by step. */
public final class ManualDriveResource extends ApiHandler {

  /**
   * @param driving whether it has something to drive now
   * @param refusal why it does not go on; null: it does, or is not ready yet
   */
  private record ManualDriveJson(
      UUID lease, String driver, boolean driving, @Nullable Sentence refusal) {}

  public static void drive(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    ManualOrder order = readBody(request, ManualOrderReader::read);
    ManualAnswer answer =
        acceptedValue(
            request,
            FleetAnswers.await(
                services(request)
                    .fleet()
                    .driveByHand(
                        RequestPath.parameter(request, "name"), order, Caller.of(request).name())));
    Json.send(
        request,
        response,
        200,
        new ManualDriveJson(answer.lease(), answer.driver(), answer.isDriving(), answer.refusal()));
  }

  public static void end(HttpServletRequest request, HttpServletResponse response) {
    FieldErrors errors = new FieldErrors();
    UUID lease =
        new InputRules(Texts.of(request), errors)
            .requiredLease("lease", request.getParameter("lease"));
    throwIfAny(errors);
    acceptedValue(
        request,
        FleetAnswers.await(
            services(request)
                .fleet()
                .endManualDrive(
                    RequestPath.parameter(request, "name"), lease, Caller.of(request).name())));
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }
}
