package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.DateTimeException;
import java.time.Instant;
import java.time.OffsetDateTime;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.KeyedAnswer;
import org.toqa.fleet.Recurrence;
import org.toqa.fleet.Schedule;
import org.toqa.fleet.TaskOrder;
import org.toqa.web.FleetAnswers;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.RecurrenceRules;

/** All schedules, and new ones. */
public final class SchedulesServlet extends ApiServlet {
  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Json.send(
        request,
        response,
        200,
        services().schedules().schedules().stream().map(ScheduleJson::of).toList());
  }

  @Override
  protected void doPost(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Texts texts = Texts.of(request);
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonFields.of(request, errors);
    TaskOrder order = TaskOrderReader.read("task", fields, texts, errors);
    RecurrenceRules rules = new RecurrenceRules(texts, errors, services().clock().instant());
    Recurrence recurrence = recurrence(fields, rules, texts, errors);
    Instant until = rules.until("until", moment("until", fields, texts, errors));
    fields.refuseUnknown();
    if (order.deadline() != null) {
      errors.add("task.deadline", texts.get("error.schedule.deadline"));
    }
    throwIfAny(errors);
    Schedule schedule =
        switch (FleetAnswers.await(
            services()
                .fleet()
                .schedules()
                .add(
                    order,
                    recurrence,
                    until,
                    Caller.of(request).name(),
                    IdempotencyKey.of(request)))) {
          case KeyedAnswer.Answered<Schedule>(var answer) -> acceptedValue(request, answer);
          case KeyedAnswer.Repeated<Schedule>(Schedule before) -> before;
          case KeyedAnswer.KeyReused<Schedule>() ->
              throw Problem.of(422, texts.get("problem.idempotencyKey.used")).exception();
        };
    response.setHeader("Location", request.getContextPath() + "/api/v1/schedules/" + schedule.id());
    Json.send(request, response, HttpServletResponse.SC_CREATED, ScheduleJson.of(schedule));
  }

  private static Recurrence recurrence(
      JsonFields fields, RecurrenceRules rules, Texts texts, FieldErrors errors) {
    if (fields.has("everyMinutes")) {
      return rules.every(
          "from",
          moment("from", fields, texts, errors),
          "everyMinutes",
          fields.number("everyMinutes"));
    }
    return fields.has("weekdays")
        ? rules.weekly(fields.texts("weekdays"), fields.text("time"), "zone", fields.text("zone"))
        : rules.once("at", moment("at", fields, texts, errors));
  }

  private static @Nullable Instant moment(
      String name, JsonFields fields, Texts texts, FieldErrors errors) {
    String given = fields.text(name);
    try {
      return given == null ? null : OffsetDateTime.parse(given).toInstant();
    } catch (DateTimeException e) {
      errors.add(name, texts.get("error.schedule.moment"));
      return null;
    }
  }
}
