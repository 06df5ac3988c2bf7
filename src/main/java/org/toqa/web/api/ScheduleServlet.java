package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.fleet.Schedule;
import org.toqa.fleet.Schedules;
import org.toqa.web.FleetAnswers;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.ScheduleAccess;
import org.toqa.web.route.Routes;

/** One schedule, and operator commands to it. */
public final class ScheduleServlet extends ApiServlet {
  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Json.send(request, response, 200, ScheduleJson.of(schedule(request)));
  }

  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Schedule schedule = ownSchedule(request);
    Schedules schedules = services().fleet().schedules();
    String user = Caller.of(request).name();
    var _ =
        FleetAnswers.await(
            RequestPath.lastSegment(request).equals("pause")
                ? schedules.pause(schedule.id(), user)
                : schedules.resume(schedule.id(), user));
    Json.send(request, response, 200, ScheduleJson.of(schedule(request)));
  }

  @Override
  protected void doDelete(HttpServletRequest request, HttpServletResponse response) {
    Schedule schedule = ownSchedule(request);
    var _ =
        FleetAnswers.await(
            services().fleet().schedules().delete(schedule.id(), Caller.of(request).name()));
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  private Schedule ownSchedule(HttpServletRequest request) {
    Schedule schedule = schedule(request);
    if (!ScheduleAccess.canChange(Caller.of(request), schedule)) {
      throw Problem.of(403, Texts.of(request).get("problem.notYourSchedule")).exception();
    }
    return schedule;
  }

  private Schedule schedule(HttpServletRequest request) {
    return services()
        .schedules()
        .schedule(RequestPath.number(request, "id"))
        .orElseThrow(
            () -> Problem.of(404, Texts.of(request).get("problem.noSuchSchedule")).exception());
  }
}
