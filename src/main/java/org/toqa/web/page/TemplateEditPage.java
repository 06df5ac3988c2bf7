package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.PartsOrder;
import org.toqa.fleet.TaskTemplate;
import org.toqa.fleet.TaskTemplate.Parameter;
import org.toqa.fleet.TaskView;
import org.toqa.web.IdempotentSubmitter;
import org.toqa.web.Tasks;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.OpenFields;
import org.toqa.web.input.TaskOrderJson;
import org.toqa.web.input.TaskOrderReader;
import org.toqa.web.input.TemplateAccess;
import org.toqa.web.input.TemplateCommands;
import org.toqa.web.input.TemplateFields;
import org.toqa.web.input.TemplateFiller;
import org.toqa.web.input.TemplateReader;
import org.toqa.web.input.Version;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ObjectNode;

/** Makes a template of a task, and changes it: which of its fields are asked for each time. */
public final class TemplateEditPage extends PageHandler {
  private static final String VIEW = "template-edit";

  /**
   * A field of the order.
   *
   * @param label in the reader's language
   * @param value that is in it; empty: none
   * @param ask whether it is asked for: never, suggest or always
   * @param as the parameter's name
   */
  public record Row(String field, String label, String value, String ask, String as) {}

  /** Of a task, or of the order that the form of a new task has made. */
  public static void showNew(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<ObjectNode> order = orderOfTask(request);
    if (order.isEmpty()) {
      order = Optional.ofNullable(TemplateFiller.objectIn(request.getParameter("order")));
    }
    if (order.isEmpty()) {
      redirect(request, response, "/tasks/new");
      return;
    }
    addAttributes(request, order.get(), List.of());
    show(request, response, VIEW);
  }

  private static Optional<ObjectNode> orderOfTask(HttpServletRequest request) {
    String id = request.getParameter("task");
    return id == null || !id.matches("[1-9][0-9]{0,17}")
        ? Optional.empty()
        : new Tasks(services(request))
            .task(Long.parseLong(id))
            .map(TaskView::task)
            .map(TaskOrderJson::write);
  }

  /** What was entered into the form of a new task goes on to the page that asks for the rest. */
  public static void ofForm(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    Instant now = services(request).clock().instant();
    Optional<PartsOrder> order =
        readForm(request, errors, fields -> TaskOrderReader.readEnteredParts(fields, now));
    if (order.isPresent() && order.get().tasks().size() > 1) {
      errors.add(FORM, Texts.of(request).get("error.template.parts"));
    }
    if (!errors.isEmpty()) {
      NewTaskPage.addFloorAttributes(request);
      request.setAttribute("idempotencyKey", NewTaskPage.idempotencyKey(request));
      showAgain(request, response, "new-task", errors);
      return;
    }
    String json = TaskOrderJson.write(order.orElseThrow().tasks().getFirst()).toString();
    redirect(
        request,
        response,
        "/templates/new?order=" + URLEncoder.encode(json, StandardCharsets.UTF_8));
  }

  public static void add(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    Optional<TaskTemplate> added =
        read(request, errors).flatMap(template -> commands(request).add(template, errors));
    if (added.isPresent()) {
      redirect(request, response, "/templates?done=added");
      return;
    }
    addSent(request, null);
    showAgain(request, response, VIEW, errors);
  }

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<TaskTemplate> template = TemplatesPage.changeable(request, response);
    if (template.isPresent()) {
      addTemplate(request, template.get());
      show(request, response, VIEW);
    }
  }

  public static void replace(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<TaskTemplate> seen = TemplatesPage.changeable(request, response);
    if (seen.isEmpty()) {
      return;
    }
    FieldErrors errors = new FieldErrors();
    if (new EditConflict(request, Version.of(seen.get())).isStale()) {
      errors.add(FORM, Texts.of(request).get("error.changed"));
      addTemplate(request, seen.get());
      showConflict(request, response, VIEW, errors);
      return;
    }
    Optional<TaskTemplate> changed =
        read(request, errors)
            .flatMap(template -> commands(request).replace(seen.get(), template, errors));
    if (changed.isPresent()) {
      redirect(request, response, "/templates?done=changed");
      return;
    }
    addSent(request, seen.get());
    showAgain(request, response, VIEW, errors);
  }

  private static Optional<TaskTemplate> read(HttpServletRequest request, FieldErrors errors) {
    return readForm(
        request,
        errors,
        fields ->
            TemplateReader.readForm(
                fields,
                services(request).fleet().floors(),
                IdempotentSubmitter.orderer(Caller.of(request).account()),
                services(request).clock().instant()));
  }

  private static TemplateCommands commands(HttpServletRequest request) {
    return new TemplateCommands(services(request), Texts.of(request), Caller.of(request));
  }

  private static void addSent(HttpServletRequest request, @Nullable TaskTemplate template) {
    ObjectNode order = TemplateFiller.objectIn(request.getParameter("order"));
    addAttributes(request, order == null ? TemplateFiller.object("{}") : order, List.of());
    addVersion(request, template);
  }

  private static void addTemplate(HttpServletRequest request, TaskTemplate template) {
    addAttributes(request, TemplateFiller.order(template), template.parameters());
    addVersion(request, template);
  }

  private static void addVersion(HttpServletRequest request, @Nullable TaskTemplate template) {
    if (template != null) {
      request.setAttribute("template", template);
      request.setAttribute("version", Version.of(template));
    }
  }

  private static void addAttributes(
      HttpServletRequest request, ObjectNode order, List<Parameter> parameters) {
    Texts texts = Texts.of(request);
    List<Row> rows = new ArrayList<>();
    for (String field : TemplateFields.of(order)) {
      JsonNode value = OpenFields.value(order, field);
      Optional<Parameter> open =
          parameters.stream().filter(one -> one.field().equals(field)).findFirst();
      String asked = value == null ? "always" : "suggest";
      String suggested = open.map(Parameter::name).orElse(name(field, texts));
      rows.add(
          new Row(
              field,
              label(field, texts),
              TemplateView.text(value),
              entry(request, "ask." + field, open.isPresent() ? asked : "never"),
              entry(request, "as." + field, suggested)));
    }
    request.setAttribute("order", order.toString());
    request.setAttribute("rows", rows);
    request.setAttribute("mayShare", TemplateAccess.canShare(Caller.of(request)));
  }

  private static String entry(HttpServletRequest request, String field, String otherwise) {
    return Objects.requireNonNullElse(request.getParameter(field), otherwise);
  }

  /** What is special of a field: all but the number of its stop. */
  static String kind(String field) {
    return field.replaceFirst("^stops\\.\\d+", "stop").replace('.', '-');
  }

  static int stop(String field) {
    return field.startsWith("stops.") ? Integer.parseInt(field.split("\\.", -1)[1]) + 1 : 0;
  }

  private static String label(String field, Texts texts) {
    return texts.get("template.field." + kind(field), stop(field));
  }

  private static String name(String field, Texts texts) {
    return texts.get("template.as." + kind(field), stop(field));
  }
}
