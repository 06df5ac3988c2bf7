package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import org.toqa.fleet.OrderView;
import org.toqa.fleet.PartsOrder;
import org.toqa.fleet.TaskView;
import org.toqa.web.IdempotentSubmitter.BatchOutcome;
import org.toqa.web.Orders;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.OrderRejections;
import org.toqa.web.input.TaskOrderReader;

/** Orders that are carried as several tasks, and new ones. */
public final class OrdersResource extends ApiHandler {
  private static final int DEFAULT_LIMIT = 20;
  private static final int MAX_LIMIT = 100;

  public static void list(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    int offset = queryNumber(request, "offset", 0, 0, Integer.MAX_VALUE);
    int limit = queryNumber(request, "limit", DEFAULT_LIMIT, 1, MAX_LIMIT);
    Orders orders = new Orders(services(request));
    response.setHeader("X-Total-Count", Long.toString(orders.count()));
    Json.send(
        request,
        response,
        200,
        orders.page(offset, limit).stream().map(OrderJson::withoutTasks).toList());
  }

  public static void add(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    PartsOrder order = readBody(request, TaskOrderReader::readParts);
    List<TaskView> tasks =
        switch (services(request)
            .submitter()
            .submitOrder(order, Caller.of(request).account(), IdempotencyKey.of(request))) {
          case BatchOutcome.Answered(var answer) -> {
            FieldErrors errors = new FieldErrors();
            List<TaskView> added =
                OrderRejections.ofJson(order.kind(), Texts.of(request)).accepted(answer, errors);
            throwIfAny(errors);
            yield added;
          }
          case BatchOutcome.Repeated(List<TaskView> before) -> before;
          case BatchOutcome.KeyReused() ->
              throw Problem.of(422, Texts.of(request).get("problem.idempotencyKey.used"))
                  .exception();
        };
    OrderView added =
        new Orders(services(request)).of(tasks).values().stream().findFirst().orElseThrow();
    response.setHeader("Location", request.getContextPath() + "/api/v1/orders/" + added.id());
    Json.send(request, response, HttpServletResponse.SC_CREATED, OrderJson.of(added));
  }
}
