package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.fleet.schedule.Schedule;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.ScheduleCommands;

/** One schedule, and what people want of it. */
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
    ScheduleCommands schedules = new ScheduleCommands(services(), Texts.of(request));
    if (RequestPath.lastSegment(request).equals("pause")) {
      schedules.pause(schedule, Caller.of(request));
    } else {
      schedules.resume(schedule, Caller.of(request));
    }
    Json.send(request, response, 200, ScheduleJson.of(schedule(request)));
  }

  @Override
  protected void doDelete(HttpServletRequest request, HttpServletResponse response) {
    new ScheduleCommands(services(), Texts.of(request))
        .delete(ownSchedule(request), Caller.of(request));
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  private Schedule ownSchedule(HttpServletRequest request) {
    Schedule schedule = schedule(request);
    if (!ScheduleCommands.canChange(Caller.of(request), schedule)) {
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
