package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.Hold;
import org.toqa.link.gateway.GatewayState;
import org.toqa.web.FleetAnswers;
import org.toqa.web.access.Caller;

/** The fleet as a whole: whether it is paused, and its gateways. */
public final class FleetResource extends ApiHandler {

  /**
   * @param pause null while robots may drive
   */
  private record FleetJson(@Nullable HoldJson pause, List<GatewayJson> gateways) {
    static FleetJson of(@Nullable Hold pause, List<GatewayState> gateways) {
      return new FleetJson(HoldJson.of(pause), gateways.stream().map(GatewayJson::of).toList());
    }
  }

  private record GatewayJson(
      String name, boolean connected, Instant since, @Nullable String address) {
    static GatewayJson of(GatewayState state) {
      return new GatewayJson(state.name(), state.isConnected(), state.since(), state.address());
    }
  }

  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Fleet fleet = services(request).fleet();
    Json.send(
        request, response, 200, FleetJson.of(fleet.snapshots().latest().pause(), fleet.gateways()));
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
        FleetJson.of(
            acceptedValue(request, FleetAnswers.await(answer)).orElse(null),
            services(request).fleet().gateways()));
  }
}
