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

/** A floor: whether its robots are on hold. */
public final class FloorServlet extends ApiServlet {

  /**
   * @param hold null while its robots may drive
   */
  private record FloorHoldJson(String floor, @Nullable HoldJson hold) {}

  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Fleet fleet = services().fleet();
    String floor = RequestPath.parameter(request, "floor");
    String user = Caller.of(request).name();
    CompletionStage<Answer<Optional<Hold>>> answer =
        RequestPath.lastSegment(request).equals("hold")
            ? fleet.holdFloor(floor, user)
            : fleet.resumeFloor(floor, user);
    Hold hold = acceptedValue(request, FleetAnswers.await(answer)).orElse(null);
    Json.send(request, response, 200, new FloorHoldJson(floor, HoldJson.of(hold)));
  }
}
