package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.DayOfWeek;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import org.toqa.fleet.Answer;
import org.toqa.fleet.Recurrence;
import org.toqa.fleet.Schedule;
import org.toqa.fleet.Schedules;
import org.toqa.web.ErrorResponse;
import org.toqa.web.FleetAnswers;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.ScheduleAccess;
import org.toqa.web.input.ScheduleQueryReader;
import org.toqa.web.input.Version;

/** All schedules, and operator commands to them. */
public final class SchedulesPage extends PageHandler {
  private static final int PAGE_SIZE = 50;

  /**
   * A schedule as the page shows it.
   *
   * @param kind names the text that says when it is due
   */
  public record Entry(
      Schedule schedule, Version version, String kind, List<DayOfWeek> days, boolean mayChange) {
    static Entry of(Schedule schedule, Caller caller) {
      return switch (schedule.recurrence()) {
        case Recurrence.Once once -> of(schedule, "once", List.of(), caller);
        case Recurrence.Every every -> of(schedule, "every", List.of(), caller);
        case Recurrence.Weekly weekly ->
            of(schedule, "weekly", weekly.days().stream().sorted().toList(), caller);
      };
    }

    private static Entry of(Schedule schedule, String kind, List<DayOfWeek> days, Caller caller) {
      return new Entry(
          schedule, Version.of(schedule), kind, days, ScheduleAccess.canChange(caller, schedule));
    }
  }

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    addAttributes(request, errors);
    showList(request, response, "schedules", errors);
  }

  private static void addAttributes(HttpServletRequest request, FieldErrors errors) {
    Caller caller = Caller.of(request);
    ScheduleQueryReader query =
        new ScheduleQueryReader(request, errors, services(request).fleet().floors());
    List<Schedule> wanted = query.filter(services(request).schedules().schedules());
    request.setAttribute("count", wanted.size());
    request.setAttribute("isFiltered", query.isFiltered());
    request.setAttribute("states", ScheduleQueryReader.State.values());
    request.setAttribute(
        "entries",
        ListPage.of(request, wanted.size(), PAGE_SIZE).of(wanted).stream()
            .map(schedule -> Entry.of(schedule, caller))
            .toList());
  }

  public static void pause(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    change(request, response, Schedules::pause);
  }

  public static void resume(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    change(request, response, Schedules::resume);
  }

  public static void delete(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    change(request, response, Schedules::delete);
  }

  /** Does with a schedule what the caller asks. */
  @FunctionalInterface
  private interface Change {
    CompletionStage<Answer<Schedule>> apply(Schedules schedules, long schedule, String user);
  }

  private static void change(
      HttpServletRequest request, HttpServletResponse response, Change change)
      throws ServletException, IOException {
    Optional<Schedule> schedule =
        services(request).schedules().schedule(RequestPath.number(request, "id"));
    if (schedule.isEmpty()) {
      sendNotFound(request, response, "problem.noSuchSchedule");
      return;
    }
    Caller caller = Caller.of(request);
    if (!ScheduleAccess.canChange(caller, schedule.get())) {
      ErrorResponse.send(request, response, 403, Texts.of(request).get("problem.notYourSchedule"));
      return;
    }
    if (new EditConflict(request, Version.of(schedule.get())).isStale()) {
      FieldErrors errors = new FieldErrors();
      errors.add("form", Texts.of(request).get("error.changed.schedule", schedule.get().id()));
      addAttributes(request, errors);
      showConflict(request, response, "schedules", errors);
      return;
    }
    var _ =
        FleetAnswers.await(
            change.apply(
                services(request).fleet().schedules(), schedule.get().id(), caller.name()));
    redirect(request, response, "/schedules");
  }
}
