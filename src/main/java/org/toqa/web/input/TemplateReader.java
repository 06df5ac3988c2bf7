package org.toqa.web.input;

import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.toqa.fleet.Orderer;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.fleet.TaskTemplate;
import org.toqa.fleet.TaskTemplate.Parameter;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Place;
import org.toqa.web.Texts;
import org.toqa.wording.Phrase;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/**
 * Reads a template of tasks: {@code name}, {@code shared}, {@code order} and {@code parameters}.
 * What it reads means something only where no sentence was filed.
 */
public final class TemplateReader {
  private static final Pattern PARAMETER = Pattern.compile("[\\p{L}\\p{N}][\\p{L}\\p{N}_-]{0,39}");
  private static final String ORDER = "order";

  private final JsonFields fields;
  private final List<FloorMap> floors;
  private final Instant now;

  private TemplateReader(JsonFields fields, List<FloorMap> floors, Instant now) {
    this.fields = fields;
    this.floors = floors;
    this.now = now;
  }

  /**
   * A template that is not stored yet.
   *
   * @param floors those that there are, at least one
   * @param by who makes it
   */
  public static TaskTemplate read(
      JsonFields fields, List<FloorMap> floors, Orderer by, Instant now) {
    return new TemplateReader(fields, floors, now).read(by);
  }

  /**
   * The same as a person enters it: the order as JSON, and of each of its fields whether it is
   * asked for ({@code ask.FIELD}: {@code always}, {@code suggest} or {@code never}) and as what
   * ({@code as.FIELD}).
   */
  public static TaskTemplate readForm(Fields form, List<FloorMap> floors, Orderer by, Instant now) {
    ObjectNode order =
        Optional.ofNullable(TemplateFiller.objectIn(form.text(ORDER)))
            .orElseGet(JsonNodeFactory.instance::objectNode);
    ObjectNode body = JsonNodeFactory.instance.objectNode();
    body.put("name", form.text("name"));
    body.put("shared", form.flag("shared"));
    ArrayNode parameters = body.putArray("parameters");
    List<String> asked = new ArrayList<>();
    for (String field : TemplateFields.of(order)) {
      String ask = Objects.requireNonNullElse(form.text("ask." + field), "never");
      if (!List.of("never", "suggest", "always").contains(ask)) {
        form.errors().add("as." + field, form.texts().get("error.template.ask"));
      } else if (!ask.equals("never")) {
        asked.add(field);
        parameters.addObject().put("name", form.text("as." + field)).put("field", field);
        if (ask.equals("always")) {
          OpenFields.clear(order, field);
        }
      }
    }
    body.set(ORDER, order);
    FieldErrors errors = new FieldErrors();
    TaskTemplate read = read(JsonFields.of(body, form.texts(), errors), floors, by, now);
    errors.sentences().forEach((at, sentence) -> form.errors().add(entered(at, asked), sentence));
    return read;
  }

  /** Where in the form that was entered. */
  private static String entered(String at, List<String> asked) {
    if (!at.startsWith("parameters.")) {
      return at.startsWith(ORDER + ".") ? "form" : at;
    }
    return "as." + asked.get(Integer.parseInt(at.split("\\.", -1)[1]));
  }

  private TaskTemplate read(Orderer by) {
    String name = fields.rules().taskName(fields.path("name"), fields.text("name"));
    boolean shared = fields.flag("shared");
    ObjectNode order = fields.object(ORDER).copy();
    List<Parameter> parameters = parameters();
    fields.refuseUnknown();
    FloorMap floor = floor(order);
    order.remove("floor");
    TaskTemplate template =
        new TaskTemplate(
            0,
            name,
            floor.name(),
            order.toString(),
            parameters,
            shared,
            by.name(),
            by.account(),
            now);
    if (fields.errors().isEmpty()) {
      check(template, floor);
    }
    return template;
  }

  private FloorMap floor(ObjectNode order) {
    JsonFields of = JsonFields.of(order, fields.texts(), new FieldErrors());
    String name = of.text("floor");
    Optional<FloorMap> floor =
        floors.stream().filter(one -> name == null || one.name().equals(name)).findFirst();
    if (floor.isEmpty()) {
      String names = floors.stream().map(FloorMap::name).collect(Collectors.joining(", "));
      refuse(fields.path(ORDER) + ".floor", "problem.noSuchFloor", names);
    }
    return floor.orElseGet(floors::getFirst);
  }

  private List<Parameter> parameters() {
    List<Parameter> parameters = new ArrayList<>();
    for (JsonFields given : fields.objects("parameters", TaskTemplate.MOST_PARAMETERS)) {
      String name = given.text("name");
      String field = given.text("field");
      given.refuseUnknown();
      if (name == null || !PARAMETER.matcher(name.strip()).matches()) {
        refuse(given.path("name"), "error.template.parameter.name");
      } else if (parameters.stream().anyMatch(one -> one.name().equalsIgnoreCase(name.strip()))) {
        refuse(given.path("name"), "error.template.parameter.twice", name.strip());
      }
      if (field == null || ParameterKind.of(field).isEmpty()) {
        refuse(given.path("field"), "error.template.parameter.field");
      } else if (parameters.stream().anyMatch(one -> one.field().equals(field))) {
        refuse(given.path("field"), "error.template.parameter.fieldTwice", field);
      }
      parameters.add(new Parameter(name == null ? "" : name.strip(), field == null ? "" : field));
    }
    return parameters;
  }

  /** With examples for what is left open it must be an order that the fleet could be asked. */
  private void check(TaskTemplate template, FloorMap floor) {
    ObjectNode order = TemplateFiller.order(template);
    Map<String, Integer> examples = new LinkedHashMap<>();
    for (Parameter parameter : template.parameters()) {
      if (OpenFields.value(order, parameter.field()) == null) {
        int at = template.parameters().indexOf(parameter);
        examples.put(parameter.field(), at);
        boolean isThere =
            ParameterKind.of(parameter.field())
                .map(kind -> OpenFields.fill(order, parameter.field(), kind.example()))
                .orElse(false);
        if (!isThere) {
          refuse(fields.path("parameters." + at + ".field"), "error.template.parameter.stop");
        }
      }
    }
    if (!fields.errors().isEmpty()) {
      return;
    }
    FieldErrors found = new FieldErrors();
    TaskOrder read = TaskOrderReader.read(JsonFields.of(order, fields.texts(), found));
    found
        .sentences()
        .forEach((field, sentence) -> fields.errors().add(at(field, examples), sentence));
    if (read.deadline() != null && OpenFields.value(order, "deadline") != null) {
      refuseDeadline(examples);
    }
    if (found.isEmpty()) {
      checkStations(read, floor);
    }
  }

  private String at(String field, Map<String, Integer> examples) {
    return examples.entrySet().stream()
        .filter(open -> field.equals(open.getKey()) || field.startsWith(open.getKey() + "."))
        .findFirst()
        .map(open -> fields.path("parameters." + open.getValue() + ".field"))
        .orElse(fields.path(ORDER) + "." + field);
  }

  /** A moment passes: it is said with each order, or not at all. */
  private void refuseDeadline(Map<String, Integer> examples) {
    if (!examples.containsKey("deadline")) {
      refuse(fields.path(ORDER) + ".deadline", "error.template.deadline");
    }
  }

  private void checkStations(TaskOrder order, FloorMap floor) {
    List<String> stations = floor.stations().stream().map(Place::name).toList();
    for (int i = 0; i < order.places().size(); i++) {
      if (order.places().get(i) instanceof Where.Station(String name) && !stations.contains(name)) {
        String end = i == 0 ? "start" : "goal";
        fields
            .errors()
            .add(
                fields.path(ORDER) + "." + (order.stops().isEmpty() ? end : "stops." + i),
                fields
                    .texts()
                    .text(Phrase.NO_SUCH_STATION.with(name, String.join(", ", stations))));
      }
    }
  }

  private void refuse(String field, String key, Object... values) {
    Texts texts = fields.texts();
    fields.errors().add(field, texts.get(key, values));
  }
}
