package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.DayOfWeek;
import java.time.Instant;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Account;
import org.toqa.fleet.KeyedAnswer;
import org.toqa.fleet.Recurrence;
import org.toqa.fleet.Schedule;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.web.FleetAnswers;
import org.toqa.web.TaskSubmitter;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.InputRules;
import org.toqa.web.input.RecurrenceRules;

/** Assigns a transport task: carry this load from here to there. */
public final class NewTaskServlet extends PageServlet {
  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    addFloorAttributes(request);
    request.setAttribute("wish", UUID.randomUUID());
    show(request, response, "new-task");
  }

  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    Optional<String> next =
        isImmediate(request)
            ? read(request, errors)
                .flatMap(order -> submit(order, request, errors))
                .map(task -> "/tasks/" + task.id())
            : schedule(request, errors).map(schedule -> "/schedules?added=" + schedule.id());
    if (next.isPresent()) {
      redirect(request, response, next.get());
    } else {
      addFloorAttributes(request);
      request.setAttribute("wish", idempotencyKey(request));
      showAgain(request, response, "new-task", errors);
    }
  }

  private static boolean isImmediate(HttpServletRequest request) {
    String when = request.getParameter("when");
    return when == null || when.isEmpty() || when.equals("now");
  }

  private Optional<Schedule> schedule(HttpServletRequest request, FieldErrors errors) {
    Texts texts = Texts.of(request);
    FormFields fields = new FormFields(request, errors);
    RecurrenceRules rules = new RecurrenceRules(texts, errors, services().clock().instant());
    Optional<TaskOrder> order = read(request, errors);
    Recurrence recurrence = recurrence(fields, rules);
    Instant until = rules.until("until", fields.moment("until", "zone"));
    if (fields.text("deadline") != null) {
      errors.add("deadline", texts.get("error.schedule.deadline"));
    }
    if (!errors.isEmpty()) {
      return Optional.empty();
    }
    Caller user = Caller.of(request);
    UUID key = TaskSubmitter.idempotencyKey(user.account(), "schedule " + idempotencyKey(request));
    KeyedAnswer<Schedule> answer = add(order.orElseThrow(), recurrence, until, user, key);
    return added(
        answer instanceof KeyedAnswer.KeyReused<Schedule>
            ? add(order.get(), recurrence, until, user, UUID.randomUUID())
            : answer,
        request,
        errors);
  }

  private KeyedAnswer<Schedule> add(
      TaskOrder order, Recurrence recurrence, @Nullable Instant until, Caller user, UUID key) {
    return FleetAnswers.await(
        services().fleet().schedules().add(order, recurrence, until, user.name(), key));
  }

  private static Optional<Schedule> added(
      KeyedAnswer<Schedule> answer, HttpServletRequest request, FieldErrors errors) {
    return switch (answer) {
      case KeyedAnswer.Answered<Schedule>(var first) -> acceptedValue(request, first, errors);
      case KeyedAnswer.Repeated<Schedule>(Schedule before) -> Optional.of(before);
      case KeyedAnswer.KeyReused<Schedule>() -> Optional.empty();
    };
  }

  private static Recurrence recurrence(FormFields fields, RecurrenceRules rules) {
    return switch (fields.text("when")) {
      case "every" ->
          rules.every(
              "first",
              fields.moment("first", "zone"),
              "everyMinutes",
              fields.number("everyMinutes"));
      case "weekly" ->
          rules.weekly(fields.texts("weekday"), fields.text("time"), "time", fields.text("zone"));
      case null, default -> rules.once("first", fields.moment("first", "zone"));
    };
  }

  private Optional<TaskView> submit(
      TaskOrder order, HttpServletRequest request, FieldErrors errors) {
    Account user = Caller.of(request).account();
    return switch (services()
        .taskSubmitter()
        .submit(
            order, user, TaskSubmitter.idempotencyKey(user, "form " + idempotencyKey(request)))) {
      case KeyedAnswer.Answered<TaskView>(var answer) -> acceptedValue(request, answer, errors);
      case KeyedAnswer.Repeated<TaskView>(TaskView before) -> Optional.of(before);
      case KeyedAnswer.KeyReused<TaskView>() ->
          acceptedValue(
              request, FleetAnswers.await(services().fleet().submit(order, user.name())), errors);
    };
  }

  /** The same form that was sent twice, as by a double click, wishes for one task. */
  private static String idempotencyKey(HttpServletRequest request) {
    return Objects.requireNonNullElseGet(
        request.getParameter("wish"), () -> UUID.randomUUID().toString());
  }

  private Optional<TaskOrder> read(HttpServletRequest request, FieldErrors errors) {
    FormFields fields = new FormFields(request, errors);
    InputRules rules = new InputRules(Texts.of(request), errors);
    TaskOrder order =
        new TaskOrder(
            rules.taskName("name", fields.text("name")),
            rules.load("load", fields.number("load")),
            where("start", fields, rules),
            where("goal", fields, rules),
            fields.text("floor"),
            rules.priority("priority", fields.number("priority")),
            rules.futureDeadline(
                "deadline", fields.moment("deadline", "zone"), services().clock().instant()),
            size(fields, rules));
    return errors.isEmpty() ? Optional.of(order) : Optional.empty();
  }

  /** Both sides, or neither. */
  private static @Nullable LoadSize size(FormFields fields, InputRules rules) {
    boolean isGiven = fields.text("length") != null || fields.text("width") != null;
    return isGiven
        ? rules.size("size", fields.number("length", "size"), fields.number("width", "size"))
        : null;
  }

  /** A station goes before coordinates. */
  private static Where where(String field, FormFields fields, InputRules rules) {
    String station = fields.text(field + "Station");
    if (station != null) {
      return new Where.Station(station);
    }
    return new Where.Point(
        new Vec2(
            rules.coordinate(field, fields.number(field + "X", field)),
            rules.coordinate(field, fields.number(field + "Y", field))));
  }

  /** The chosen floor's stations can be selected; without a choice, the first floor's. */
  private void addFloorAttributes(HttpServletRequest request) {
    List<FloorMap> floors = services().fleet().floors();
    String wanted = request.getParameter("floor");
    FloorMap floor =
        floors.stream()
            .filter(f -> f.name().equals(wanted))
            .findFirst()
            .orElseGet(floors::getFirst);
    request.setAttribute("weekdays", DayOfWeek.values());
    request.setAttribute("floors", floors);
    request.setAttribute("floor", floor);
  }
}
