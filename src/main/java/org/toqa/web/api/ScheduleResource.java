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

/** One schedule, and the commands that pause, resume and delete it. */
public final class ScheduleResource extends ApiHandler {
  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Json.send(request, response, 200, ScheduleJson.of(schedule(request)));
  }

  public static void pause(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    long id = ownSchedule(request).id();
    var _ = FleetAnswers.await(commands(request).pause(id, Caller.of(request).name()));
    get(request, response);
  }

  public static void resume(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    long id = ownSchedule(request).id();
    var _ = FleetAnswers.await(commands(request).resume(id, Caller.of(request).name()));
    get(request, response);
  }

  public static void delete(HttpServletRequest request, HttpServletResponse response) {
    long id = ownSchedule(request).id();
    var _ = FleetAnswers.await(commands(request).delete(id, Caller.of(request).name()));
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  private static Schedules commands(HttpServletRequest request) {
    return services(request).fleet().schedules();
  }

  private static Schedule ownSchedule(HttpServletRequest request) {
    Schedule schedule = schedule(request);
    if (!ScheduleAccess.canChange(Caller.of(request), schedule)) {
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
