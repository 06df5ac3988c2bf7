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
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.toqa.accounts.Account;
import org.toqa.fleet.Answer;
import org.toqa.fleet.CheckRefusedException;
import org.toqa.fleet.KeyedAnswer;
import org.toqa.fleet.PartsOrder;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.Schedule;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskView;
import org.toqa.grid.FloorMap;
import org.toqa.web.FleetAnswers;
import org.toqa.web.IdempotentSubmitter;
import org.toqa.web.IdempotentSubmitter.BatchOutcome;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.OrderRejections;
import org.toqa.web.input.ScheduleOrder;
import org.toqa.web.input.ScheduleReader;
import org.toqa.web.input.TaskOrderReader;
import org.toqa.web.input.TemplateAccess;
import org.toqa.wording.Sentence;

/** Assigns a transport task: carry this load from here to there. */
public final class NewTaskPage extends PageHandler {
  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    addFloorAttributes(request);
    request.setAttribute("idempotencyKey", UUID.randomUUID());
    show(request, response, "new-task");
  }

  public static void submit(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    Instant now = services(request).clock().instant();
    Optional<String> next;
    try {
      next = submit(request, errors, now);
    } catch (CheckRefusedException e) {
      addFloorAttributes(request);
      request.setAttribute("idempotencyKey", idempotencyKey(request));
      showRefused(request, response, "new-task", FORM, e);
      return;
    }
    if (next.isPresent()) {
      redirect(request, response, next.get());
    } else {
      addFloorAttributes(request);
      request.setAttribute("idempotencyKey", idempotencyKey(request));
      showAgain(request, response, "new-task", errors);
    }
  }

  /** Where to go when the task, or the schedule, is there; empty: an error says why it is not. */
  private static Optional<String> submit(
      HttpServletRequest request, FieldErrors errors, Instant now) {
    return isImmediate(request)
        ? readForm(request, errors, fields -> TaskOrderReader.readEnteredParts(fields, now))
            .flatMap(order -> submit(order, request, errors))
        : readForm(request, errors, fields -> ScheduleReader.readForm(fields, now))
            .flatMap(order -> schedule(order, UnaryOperator.identity(), request, errors))
            .map(schedule -> "/schedules?added=" + schedule.id());
  }

  static boolean isImmediate(HttpServletRequest request) {
    String when = request.getParameter("when");
    return when == null || when.isEmpty() || when.equals("now");
  }

  /**
   * @param atField files what the fleet refuses under a field of the form
   */
  static Optional<Schedule> schedule(
      ScheduleOrder order,
      UnaryOperator<Answer<Schedule>> atField,
      HttpServletRequest request,
      FieldErrors errors) {
    Caller user = Caller.of(request);
    UUID key =
        IdempotentSubmitter.idempotencyKey(user.account(), "schedule " + idempotencyKey(request));
    KeyedAnswer<Schedule> answer = add(order, user, key, request);
    return added(
        answer instanceof KeyedAnswer.KeyReused<Schedule>
            ? add(order, user, UUID.randomUUID(), request)
            : answer,
        atField,
        request,
        errors);
  }

  private static KeyedAnswer<Schedule> add(
      ScheduleOrder order, Caller user, UUID key, HttpServletRequest request) {
    return FleetAnswers.await(
        services(request)
            .fleet()
            .schedules()
            .add(
                order.order(),
                order.recurrence(),
                order.until(),
                order.template(),
                IdempotentSubmitter.orderer(user.account()),
                key));
  }

  private static Optional<Schedule> added(
      KeyedAnswer<Schedule> answer,
      UnaryOperator<Answer<Schedule>> atField,
      HttpServletRequest request,
      FieldErrors errors) {
    return switch (answer) {
      case KeyedAnswer.Answered<Schedule>(var first) ->
          acceptedValue(request, atField.apply(first), errors);
      case KeyedAnswer.Repeated<Schedule>(Schedule before) -> Optional.of(before);
      case KeyedAnswer.KeyReused<Schedule>() -> Optional.empty();
    };
  }

  /** The page of the task, or of the order where it is carried as several. */
  private static Optional<String> submit(
      PartsOrder order, HttpServletRequest request, FieldErrors errors) {
    if (order.tasks().size() == 1) {
      TaskOrder only = order.tasks().getFirst();
      return submit(only, answer -> atFormField(only, answer), request, errors)
          .map(task -> "/tasks/" + task.id());
    }
    Account user = Caller.of(request).account();
    UUID key = IdempotentSubmitter.idempotencyKey(user, "order " + idempotencyKey(request));
    IdempotentSubmitter submitter = services(request).submitter();
    BatchOutcome outcome = submitter.submitOrder(order, user, key);
    List<TaskView> tasks =
        switch (outcome instanceof BatchOutcome.KeyReused
            ? submitter.submitOrder(order, user, UUID.randomUUID())
            : outcome) {
          case BatchOutcome.Answered(var answer) ->
              OrderRejections.ofForm(order.kind(), Texts.of(request)).accepted(answer, errors);
          case BatchOutcome.Repeated(List<TaskView> before) -> before;
          case BatchOutcome.KeyReused() -> List.of();
        };
    return tasks.stream()
        .limit(1)
        .flatMap(first -> Stream.ofNullable(first.task().part()))
        .map(part -> "/orders/" + part.order())
        .findFirst();
  }

  /**
   * @param atField files what the fleet refuses under a field of the form
   */
  static Optional<TaskView> submit(
      TaskOrder order,
      UnaryOperator<Answer<TaskView>> atField,
      HttpServletRequest request,
      FieldErrors errors) {
    Account user = Caller.of(request).account();
    return switch (services(request)
        .submitter()
        .submit(
            order,
            user,
            IdempotentSubmitter.idempotencyKey(user, "form " + idempotencyKey(request)))) {
      case KeyedAnswer.Answered<TaskView>(var answer) ->
          acceptedValue(request, atField.apply(answer), errors);
      case KeyedAnswer.Repeated<TaskView>(TaskView before) -> Optional.of(before);
      case KeyedAnswer.KeyReused<TaskView>() ->
          acceptedValue(
              request,
              atField.apply(
                  FleetAnswers.await(
                      services(request)
                          .fleet()
                          .submit(order, IdempotentSubmitter.orderer(user), UUID.randomUUID()))),
              errors);
    };
  }

  /** The first two stops are the form's start and goal, or of a drive the first one its goal. */
  private static Answer<TaskView> atFormField(TaskOrder order, Answer<TaskView> answer) {
    if (answer instanceof Answer.Rejected<TaskView>(String field, Sentence sentence)
        && field != null
        && field.startsWith("stops.")) {
      int stop = Integer.parseInt(field.substring("stops.".length()));
      return new Answer.Rejected<>(
          OrderRejections.entered(order.isDrive() ? stop + 1 : stop, "stop"), sentence);
    }
    return answer;
  }

  /** The same form that was sent twice, as by a double click, orders one task. */
  static String idempotencyKey(HttpServletRequest request) {
    return Objects.requireNonNullElseGet(
        request.getParameter("idempotencyKey"), () -> UUID.randomUUID().toString());
  }

  /** The chosen floor's stations can be selected; without a choice, the first floor's. */
  static void addFloorAttributes(HttpServletRequest request) {
    List<FloorMap> floors = services(request).fleet().floors();
    String wanted = request.getParameter("floor");
    FloorMap floor =
        floors.stream()
            .filter(f -> f.name().equals(wanted))
            .findFirst()
            .orElseGet(floors::getFirst);
    request.setAttribute("weekdays", DayOfWeek.values());
    request.setAttribute(
        "templates", TemplateAccess.seenBy(Caller.of(request), services(request).templates()));
    request.setAttribute("floor", floor);
    List<RobotView> robots =
        services(request).fleet().snapshots().latest().robots().stream()
            .filter(robot -> robot.floor().equals(floor.name()))
            .toList();
    request.setAttribute("robots", robots.stream().map(RobotView::name).toList());
    String[] chosen = request.getParameterValues("onlyRobots");
    request.setAttribute("chosenRobots", chosen == null ? List.of() : List.of(chosen));
    request.setAttribute(
        "hasArms", robots.stream().anyMatch(robot -> robot.capabilities().arm() != null));
  }
}
