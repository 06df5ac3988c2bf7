package org.toqa.web.page;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.concurrent.CompletionStage;
import org.toqa.web.FleetAnswers;
import org.toqa.web.access.Caller;

/** The forms on every page that pause and resume all robots. */
public final class FleetForms extends PageHandler {
  public static void pause(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    answer(request, response, services(request).fleet().pauseAll(Caller.of(request).name()));
  }

  public static void resume(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    answer(request, response, services(request).fleet().resumeAll(Caller.of(request).name()));
  }

  private static void answer(
      HttpServletRequest request, HttpServletResponse response, CompletionStage<?> done)
      throws IOException {
    FleetAnswers.await(done);
    redirect(
        request,
        response,
        ReturnAddress.parse(request, request.getParameter("back")).orElse("/map"));
  }
}
