package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import org.toqa.lab.record.LabRun;
import org.toqa.lab.record.Laboratory;
import org.toqa.lab.record.ReportJson;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.input.FieldErrors;

/** One run of the laboratory: how far it is, and what it has given. */
public final class LabRunPage extends PageHandler {
  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<LabRun> run = run(request);
    if (run.isEmpty()) {
      sendNotFound(request, response, "problem.laboratory.noSuchRun");
      return;
    }
    addAttributes(request, run.get());
    show(request, response, "lab-run");
  }

  private static void addAttributes(HttpServletRequest request, LabRun run) {
    Laboratory laboratory = services(request).laboratory();
    request.setAttribute("view", LabRunView.of(run, laboratory));
    request.setAttribute(
        "report", laboratory.store().report(run.id()).map(ReportJson::read).orElse(null));
    request.setAttribute("drawings", laboratory.store().drawings(run.id()));
  }

  public static void stop(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<LabRun> run = run(request);
    if (run.isEmpty()) {
      sendNotFound(request, response, "problem.laboratory.noSuchRun");
    } else if (services(request).laboratory().stop(run.get().id())) {
      redirect(request, response, "/laboratory/runs/" + run.get().id());
    } else {
      refuse(request, response, run.get(), "problem.laboratory.over");
    }
  }

  public static void delete(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<LabRun> run = run(request);
    if (run.isEmpty()) {
      sendNotFound(request, response, "problem.laboratory.noSuchRun");
    } else if (services(request).laboratory().store().delete(run.get().id())) {
      redirect(request, response, "/laboratory?done=deleted");
    } else {
      refuse(request, response, run.get(), "problem.laboratory.runs");
    }
  }

  private static void refuse(
      HttpServletRequest request, HttpServletResponse response, LabRun run, String key)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    errors.add(FORM, Texts.of(request).get(key));
    addAttributes(request, run);
    showConflict(request, response, "lab-run", errors);
  }

  private static Optional<LabRun> run(HttpServletRequest request) {
    return services(request).laboratory().store().run(RequestPath.number(request, "id"));
  }
}
