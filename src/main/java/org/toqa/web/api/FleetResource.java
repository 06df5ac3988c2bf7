package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.Hold;
import org.toqa.web.FleetAnswers;
import org.toqa.web.access.Caller;

/** The fleet as a whole: whether it is paused. */
public final class FleetResource extends ApiHandler {

  /**
   * @param pause null while robots may drive
   */
  private record FleetJson(@Nullable HoldJson pause) {
    static FleetJson of(@Nullable Hold pause) {
      return new FleetJson(HoldJson.of(pause));
    }
  }

  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Json.send(
        request,
        response,
        200,
        FleetJson.of(services(request).fleet().snapshots().latest().pause()));
  }

  public static void pause(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    send(request, response, services(request).fleet().pauseAll(Caller.of(request).name()));
  }

  public static void resume(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    send(request, response, services(request).fleet().resumeAll(Caller.of(request).name()));
  }

  private static void send(
      HttpServletRequest request,
      HttpServletResponse response,
      CompletionStage<Answer<Optional<Hold>>> answer)
      throws IOException {
    Json.send(
        request,
        response,
        200,
        FleetJson.of(acceptedValue(request, FleetAnswers.await(answer)).orElse(null)));
  }
}
