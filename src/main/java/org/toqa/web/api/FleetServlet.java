package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.Hold;
import org.toqa.web.FleetAnswers;
import org.toqa.web.RequestPath;
import org.toqa.web.access.Caller;

/** The fleet as a whole: whether it is paused. */
public final class FleetServlet extends ApiServlet {

  /**
   * @param pause null while robots may drive
   */
  private record FleetJson(@Nullable HoldJson pause) {
    static FleetJson of(@Nullable Hold pause) {
      return new FleetJson(HoldJson.of(pause));
    }
  }

  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Json.send(
        request, response, 200, FleetJson.of(services().fleet().snapshots().latest().pause()));
  }

  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Fleet fleet = services().fleet();
    String user = Caller.of(request).name();
    CompletionStage<Answer<Optional<Hold>>> answer =
        RequestPath.lastSegment(request).equals("pause") ? fleet.pauseAll(user) : fleet.resumeAll(user);
    Json.send(
        request,
        response,
        200,
        FleetJson.of(acceptedValue(request, FleetAnswers.await(answer)).orElse(null)));
  }
}
