package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Instant;
import org.toqa.fleet.KeyedAnswer;
import org.toqa.fleet.Schedule;
import org.toqa.web.FleetAnswers;
import org.toqa.web.IdempotentSubmitter;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.ScheduleOrder;
import org.toqa.web.input.ScheduleReader;
import org.toqa.web.input.TemplateFiller;

/** All schedules, and new ones. */
public final class SchedulesResource extends ApiHandler {
  public static void list(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Json.send(
        request,
        response,
        200,
        wantedFloor(request)
            .filter(
                services(request).schedules().schedules(),
                schedule -> schedule.floor(services(request).fleet().floors()))
            .stream()
            .map(ScheduleJson::of)
            .toList());
  }

  public static void add(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Texts texts = Texts.of(request);
    Instant now = services(request).clock().instant();
    TemplateFiller templates = TemplatesResource.usable(request);
    ScheduleOrder order =
        readBody(request, fields -> ScheduleReader.readJson(fields, templates, now));
    Schedule schedule =
        switch (FleetAnswers.await(
            services(request)
                .fleet()
                .schedules()
                .add(
                    order.order(),
                    order.recurrence(),
                    order.until(),
                    order.template(),
                    IdempotentSubmitter.orderer(Caller.of(request).account()),
                    IdempotencyKey.of(request)))) {
          case KeyedAnswer.Answered<Schedule>(var answer) -> acceptedValue(request, answer);
          case KeyedAnswer.Repeated<Schedule>(Schedule before) -> before;
          case KeyedAnswer.KeyReused<Schedule>() ->
              throw Problem.of(422, texts.get("problem.idempotencyKey.used")).exception();
        };
    response.setHeader("Location", request.getContextPath() + "/api/v1/schedules/" + schedule.id());
    Json.send(request, response, HttpServletResponse.SC_CREATED, ScheduleJson.of(schedule));
  }
}
