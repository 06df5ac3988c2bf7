package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.fleet.Answer;
import org.toqa.fleet.BatchAnswer;
import org.toqa.fleet.OrderView;
import org.toqa.fleet.TaskView;
import org.toqa.mission.MissionEvent;
import org.toqa.web.Orders;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.OrderAccess;
import org.toqa.web.input.OrderRejections;
import org.toqa.web.input.TaskCommandReader;

/** One order with its tasks, and what may be done with all of them. */
public final class OrderResource extends ApiHandler {
  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    send(request, response, order(request));
  }

  /** A body is needed only where the place of loads on board must be said. */
  public static void cancel(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    MissionEvent.Cancel cancel = readCancel(request);
    if (cancel.choice() != null) { // else all of it is asked first whether something is on board
      OrderAccess.tellAtOnce(
          services(request), Caller.of(request), RequestPath.number(request, "id"), cancel);
    }
    OrderView order = changeableOrder(request);
    Answer<TaskView> refusal = new Orders(services(request)).cancel(order, cancel);
    if (refusal != null) {
      acceptedValue(request, refusal);
    }
    send(request, response, order(request));
  }

  private static MissionEvent.Cancel readCancel(HttpServletRequest request) throws IOException {
    Caller user = Caller.of(request);
    if (!JsonBody.isIn(request)) {
      return new MissionEvent.Cancel(user.name(), null);
    }
    return readBody(
        request,
        fields -> {
          MissionEvent.Cancel cancel =
              new TaskCommandReader(fields.texts(), fields.errors())
                  .readCancel(user, fields.text("load"));
          fields.refuseUnknown();
          return cancel;
        });
  }

  public static void hold(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    MissionEvent.Hold hold = new MissionEvent.Hold(Caller.of(request).name());
    OrderAccess.tellAtOnce(
        services(request), Caller.of(request), RequestPath.number(request, "id"), hold);
    tell(request, response, user -> hold);
  }

  /** Legs that wait for the one before them go on waiting. */
  public static void resume(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    tell(request, response, user -> new MissionEvent.Resume(user.name(), true));
  }

  public static void prioritise(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    tell(
        request,
        response,
        user ->
            readBody(
                request,
                fields -> {
                  MissionEvent.Prioritise command =
                      new TaskCommandReader(fields.texts(), fields.errors())
                          .readPriority(user, fields.number("priority"), null);
                  fields.refuseUnknown();
                  return command;
                }));
  }

  /** Reads a command from the body, if it has one. */
  @FunctionalInterface
  private interface CommandReader {
    MissionEvent.OperatorCommand read(Caller user) throws IOException;
  }

  private static void tell(
      HttpServletRequest request, HttpServletResponse response, CommandReader reader)
      throws IOException {
    OrderView order = changeableOrder(request);
    if (!new Orders(services(request)).tellOpen(order, reader.read(Caller.of(request)))) {
      throw Problem.of(409, Texts.of(request).get("order.ended")).exception();
    }
    send(request, response, order(request));
  }

  /** Orders again what has ended without delivery. */
  public static void retry(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    OrderView order = changeableOrder(request);
    Texts texts = Texts.of(request);
    BatchAnswer answer =
        services(request)
            .submitter()
            .retry(order.id(), Caller.of(request).account())
            .orElseThrow(
                () -> Problem.of(409, texts.get("problem.order.nothingToRetry")).exception());
    FieldErrors errors = new FieldErrors();
    OrderRejections.ofJson(order.kind(), texts).accepted(answer, errors);
    throwIfAny(errors);
    send(request, response, order(request));
  }

  private static OrderView changeableOrder(HttpServletRequest request) {
    OrderView order = order(request);
    if (!OrderAccess.canChange(Caller.of(request), order)) {
      throw Problem.of(403, Texts.of(request).get("problem.notYourOrder")).exception();
    }
    return order;
  }

  private static OrderView order(HttpServletRequest request) {
    return new Orders(services(request))
        .order(RequestPath.number(request, "id"))
        .orElseThrow(
            () -> Problem.of(404, Texts.of(request).get("problem.noSuchOrder")).exception());
  }

  private static void send(
      HttpServletRequest request, HttpServletResponse response, OrderView order)
      throws IOException {
    Json.send(request, response, 200, OrderJson.of(order));
  }
}
