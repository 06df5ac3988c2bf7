package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.fleet.schedule.Schedule;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.ScheduleCommands;

/** One schedule, and the commands that pause, resume and delete it. */
public final class ScheduleResource extends ApiHandler {
  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Json.send(request, response, 200, ScheduleJson.of(schedule(request)));
  }

  public static void pause(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    commands(request).pause(ownSchedule(request), Caller.of(request));
    get(request, response);
  }

  public static void resume(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    commands(request).resume(ownSchedule(request), Caller.of(request));
    get(request, response);
  }

  public static void delete(HttpServletRequest request, HttpServletResponse response) {
    commands(request).delete(ownSchedule(request), Caller.of(request));
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  private static ScheduleCommands commands(HttpServletRequest request) {
    return new ScheduleCommands(services(request), Texts.of(request));
  }

  private static Schedule ownSchedule(HttpServletRequest request) {
    Schedule schedule = schedule(request);
    if (!ScheduleCommands.canChange(Caller.of(request), schedule)) {
      throw Problem.of(403, Texts.of(request).get("problem.notYourSchedule")).exception();
    }
    return schedule;
  }

  private static Schedule schedule(HttpServletRequest request) {
    return services(request)
        .schedules()
        .schedule(RequestPath.number(request, "id"))
        .orElseThrow(
            () -> Problem.of(404, Texts.of(request).get("problem.noSuchSchedule")).exception());
  }
}
