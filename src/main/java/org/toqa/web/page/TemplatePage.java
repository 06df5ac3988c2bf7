package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.DayOfWeek;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.CheckRefusedException;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskTemplate;
import org.toqa.grid.FloorMap;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.Fields;
import org.toqa.web.input.OpenFields;
import org.toqa.web.input.OrderedTask;
import org.toqa.web.input.ParameterKind;
import org.toqa.web.input.ScheduleReader;
import org.toqa.web.input.TemplateFiller;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ObjectNode;

/** Orders a task from a template: what it leaves open is filled in. */
public final class TemplatePage extends PageHandler {
  private static final String VIEW = "template";

  /**
   * What is asked for, and what its fields have in them.
   *
   * @param what the special of the field that it fills
   * @param stop its number, from 1; 0: it is of none
   * @param field in the form
   * @param required whether the template suggests nothing
   */
  public record Open(
      String name,
      String what,
      int stop,
      String field,
      ParameterKind kind,
      boolean required,
      String text,
      String station,
      String x,
      String y,
      List<String> robots) {

    static Open of(TaskTemplate.Parameter parameter, ObjectNode order, HttpServletRequest request) {
      String field = TemplateFiller.VALUES + "." + parameter.name();
      JsonNode suggested = OpenFields.value(order, parameter.field());
      ParameterKind kind = ParameterKind.of(parameter.field()).orElseThrow();
      boolean isPlace = kind == ParameterKind.PLACE;
      return new Open(
          parameter.name(),
          TemplateEditPage.kind(parameter.field()),
          TemplateEditPage.stop(parameter.field()),
          field,
          kind,
          suggested == null,
          entry(request, field, suggested == null || isPlace ? "" : TemplateView.text(suggested)),
          entry(request, field + "Station", of(suggested, "station")),
          entry(request, field + "X", of(suggested, "x")),
          entry(request, field + "Y", of(suggested, "y")),
          robots(request, field, suggested));
    }

    private static String of(@Nullable JsonNode place, String part) {
      return place == null || !place.has(part)
          ? ""
          : part.equals("station")
              ? place.path(part).asString("")
              : TemplateView.number(place.path(part));
    }

    private static String entry(HttpServletRequest request, String field, String suggested) {
      String given = request.getParameter(field);
      return given == null ? suggested : given;
    }

    private static List<String> robots(
        HttpServletRequest request, String field, @Nullable JsonNode suggested) {
      String[] given = request.getParameterValues(field);
      if (given != null) {
        return Arrays.asList(given);
      }
      return suggested == null || !suggested.isArray()
          ? List.of()
          : suggested.values().stream().map(name -> name.asString("")).toList();
    }
  }

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<TaskTemplate> template = TemplatesPage.visible(request, response);
    if (template.isPresent()) {
      addAttributes(request, template.get());
      request.setAttribute("idempotencyKey", UUID.randomUUID());
      show(request, response, VIEW);
    }
  }

  private static void addAttributes(HttpServletRequest request, TaskTemplate template) {
    List<FloorMap> floors = services(request).fleet().floors();
    ObjectNode order = TemplateFiller.order(template);
    request.setAttribute(
        "entry", TemplateView.of(template, Caller.of(request), floors, Texts.of(request)));
    request.setAttribute(
        "open",
        template.parameters().stream()
            .map(parameter -> Open.of(parameter, order, request))
            .toList());
    request.setAttribute(
        "floor",
        floors.stream()
            .filter(floor -> floor.name().equals(template.floor()))
            .findFirst()
            .orElse(null));
    request.setAttribute("weekdays", DayOfWeek.values());
    request.setAttribute(
        "robots",
        services(request).fleet().snapshots().latest().robots().stream()
            .filter(robot -> robot.floor().equals(template.floor()))
            .map(RobotView::name)
            .toList());
  }

  public static void submit(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<TaskTemplate> template = TemplatesPage.visible(request, response);
    if (template.isEmpty()) {
      return;
    }
    FieldErrors errors = new FieldErrors();
    Optional<String> next;
    try {
      next = submit(template.get(), request, errors);
    } catch (CheckRefusedException e) {
      showRest(request, template.get());
      showRefused(request, response, VIEW, FORM, e);
      return;
    }
    if (next.isPresent()) {
      redirect(request, response, next.get());
    } else {
      showRest(request, template.get());
      showAgain(request, response, VIEW, errors);
    }
  }

  private static void showRest(HttpServletRequest request, TaskTemplate template) {
    addAttributes(request, template);
    request.setAttribute("idempotencyKey", NewTaskPage.idempotencyKey(request));
  }

  private static Optional<String> submit(
      TaskTemplate template, HttpServletRequest request, FieldErrors errors) {
    Instant now = services(request).clock().instant();
    return NewTaskPage.isImmediate(request)
        ? readForm(request, errors, fields -> read(template, fields, now))
            .flatMap(
                task ->
                    NewTaskPage.submit(
                        task.order(), answer -> inForm(task.atEntered(answer)), request, errors))
            .map(task -> "/tasks/" + task.id())
        : readForm(
                request,
                errors,
                fields -> ScheduleReader.readForm(fields, read(template, fields, now), now))
            .flatMap(
                order ->
                    NewTaskPage.schedule(
                        order,
                        answer ->
                            inForm(
                                new OrderedTask(order.order(), template, order.template())
                                    .atEntered(answer)),
                        request,
                        errors))
            .map(schedule -> "/schedules?added=" + schedule.id());
  }

  private static OrderedTask read(TaskTemplate template, Fields fields, Instant now) {
    return TemplateFiller.readEntered(template, fields, TemplateFiller.VALUES + ".", now);
  }

  /** What is wrong with the template itself is told above the form. */
  private static <T> Answer<T> inForm(Answer<T> answer) {
    return answer instanceof Answer.Rejected<T>(var field, var sentence)
            && TemplateFiller.TEMPLATE.equals(field)
        ? new Answer.Rejected<>(null, sentence)
        : answer;
  }
}
