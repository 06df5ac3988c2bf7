package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import org.toqa.fleet.Answer;
import org.toqa.fleet.BatchAnswer;
import org.toqa.fleet.CheckRefusedException;
import org.toqa.fleet.OrderView;
import org.toqa.fleet.PartsToRetry;
import org.toqa.fleet.TaskView;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.TaskState;
import org.toqa.web.ErrorResponse;
import org.toqa.web.Orders;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.OrderAccess;
import org.toqa.web.input.OrderRejections;
import org.toqa.web.input.TaskCommandReader;

/** One order of several tasks: its progress, its parts, and what may be done with all of them. */
public final class OrderPage extends PageHandler {
  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<OrderView> order = order(request);
    if (order.isEmpty()) {
      sendNotFound(request, response, "problem.noSuchOrder");
      return;
    }
    addAttributes(request, order.get());
    show(request, response, "order");
  }

  public static void cancel(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    MissionEvent.Cancel cancel =
        new TaskCommandReader(Texts.of(request), errors)
            .readCancel(Caller.of(request), new FormFields(request, errors).text("load"));
    if (errors.isEmpty() && cancel.choice() != null) { // else it is asked first what is on board
      OrderAccess.tellAtOnce(
          services(request), Caller.of(request), RequestPath.number(request, "id"), cancel);
    }
    Optional<OrderView> order = changeableOrder(request, response);
    if (order.isEmpty()) {
      return;
    }
    if (errors.isEmpty()) {
      Answer<TaskView> refusal = new Orders(services(request)).cancel(order.get(), cancel);
      if (refusal != null) {
        acceptedValue(request, refusal, errors);
      }
    }
    answer(request, response, order.get(), errors);
  }

  public static void hold(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    MissionEvent.Hold hold = new MissionEvent.Hold(Caller.of(request).name());
    OrderAccess.tellAtOnce(
        services(request), Caller.of(request), RequestPath.number(request, "id"), hold);
    tell(request, response, (reader, fields, user) -> hold);
  }

  /** Legs that wait for the one before them go on waiting. */
  public static void resume(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    tell(request, response, (reader, fields, user) -> new MissionEvent.Resume(user.name(), true));
  }

  public static void prioritise(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    tell(
        request,
        response,
        (reader, fields, user) -> reader.readPriority(user, fields.number("priority"), null));
  }

  @FunctionalInterface
  private interface CommandReader {
    MissionEvent.OperatorCommand read(TaskCommandReader reader, FormFields fields, Caller user);
  }

  private static void tell(
      HttpServletRequest request, HttpServletResponse response, CommandReader reader)
      throws ServletException, IOException {
    Optional<OrderView> order = changeableOrder(request, response);
    if (order.isEmpty()) {
      return;
    }
    FieldErrors errors = new FieldErrors();
    Texts texts = Texts.of(request);
    MissionEvent.OperatorCommand command =
        reader.read(
            new TaskCommandReader(texts, errors),
            new FormFields(request, errors),
            Caller.of(request));
    if (errors.isEmpty() && !new Orders(services(request)).tellOpen(order.get(), command)) {
      errors.add(FORM, texts.get("order.ended"));
    }
    answer(request, response, order.get(), errors);
  }

  /** Orders again what has ended without delivery. */
  public static void retry(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<OrderView> order = changeableOrder(request, response);
    if (order.isEmpty()) {
      return;
    }
    FieldErrors errors = new FieldErrors();
    Texts texts = Texts.of(request);
    try {
      Optional<BatchAnswer> answer =
          services(request).submitter().retry(order.get().id(), Caller.of(request).account());
      answer.ifPresentOrElse(
          given -> OrderRejections.ofForm(order.get().kind(), texts).accepted(given, errors),
          () -> errors.add(FORM, texts.get("problem.order.nothingToRetry")));
    } catch (CheckRefusedException e) {
      addAttributes(request, order.get());
      showRefused(request, response, "order", FORM, e);
      return;
    }
    answer(request, response, order.get(), errors);
  }

  private static void answer(
      HttpServletRequest request, HttpServletResponse response, OrderView order, FieldErrors errors)
      throws ServletException, IOException {
    if (errors.isEmpty()) {
      redirect(request, response, "/orders/" + order.id());
    } else {
      addAttributes(request, order(request).orElse(order));
      FieldErrors shown = new FieldErrors(); // there is no field to show a sentence at
      shown.add(FORM, String.join(" ", errors.sentences().values()));
      showAgain(request, response, "order", shown);
    }
  }

  private static Optional<OrderView> changeableOrder(
      HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<OrderView> order = order(request);
    if (order.isEmpty()) {
      sendNotFound(request, response, "problem.noSuchOrder");
    } else if (!OrderAccess.canChange(Caller.of(request), order.get())) {
      ErrorResponse.send(request, response, 403, Texts.of(request).get("problem.notYourOrder"));
      return Optional.empty();
    }
    return order;
  }

  private static Optional<OrderView> order(HttpServletRequest request) {
    return new Orders(services(request)).order(RequestPath.number(request, "id"));
  }

  private static void addAttributes(HttpServletRequest request, OrderView order) {
    request.setAttribute("order", order);
    request.setAttribute("mayChange", OrderAccess.canChange(Caller.of(request), order));
    request.setAttribute("mayRetry", !PartsToRetry.of(order).orders().isEmpty());
    request.setAttribute("stuck", order.stuck());
    order.priority().ifPresent(priority -> request.setAttribute("priority", priority));
    request.setAttribute(
        "carrying", order.open().stream().anyMatch(task -> task.state() == TaskState.CARRYING));
  }
}
