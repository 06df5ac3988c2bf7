package org.toqa.web.page;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.fleet.Answer;
import org.toqa.fleet.Fleet;
import org.toqa.web.ErrorResponse;
import org.toqa.web.FleetAnswers;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.wording.Sentence;

/** The button on the live map that puts a floor's robots on hold, and lets them go on. */
public final class FloorServlet extends PageServlet {
  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Fleet fleet = services().fleet();
    String floor = RequestPath.parameter(request, "floor");
    String user = Caller.of(request).name();
    Answer<?> answer =
        FleetAnswers.await(
            RequestPath.lastSegment(request).equals("hold")
                ? fleet.holdFloor(floor, user)
                : fleet.resumeFloor(floor, user));
    if (answer instanceof Answer.Unknown<?>(Sentence sentence)) {
      ErrorResponse.send(request, response, 404, Texts.of(request).text(sentence));
    } else {
      redirect(request, response, "/map");
    }
  }
}
