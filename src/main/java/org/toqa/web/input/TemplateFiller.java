package org.toqa.web.input;

import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collector;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskTemplate;
import org.toqa.fleet.TaskTemplate.Parameter;
import org.toqa.fleet.TaskTemplateStore;
import org.toqa.fleet.TemplateUse;
import org.toqa.web.access.Caller;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/**
 * Makes orders from templates: the values of the parameters are put into the template's order,
 * which is then read as every order is. What it makes means something only where no sentence was
 * filed.
 */
public final class TemplateFiller {
  /** Where the name of a template stands in an order. */
  public static final String TEMPLATE = "template";

  /** Where the values of its parameters stand. */
  public static final String VALUES = "values";

  private static final JsonMapper MAPPER = JsonMapper.builder().build();

  private final List<TaskTemplate> templates;

  /**
   * @param templates those that may be used
   */
  public TemplateFiller(List<TaskTemplate> templates) {
    this.templates = List.copyOf(templates);
  }

  /** Makes orders from those that the caller may use. */
  public static TemplateFiller of(Caller caller, TaskTemplateStore store) {
    return new TemplateFiller(TemplateAccess.seenBy(caller, store));
  }

  /** An order that a program gives: with the name of a template, or itself. */
  public OrderedTask read(Fields fields) {
    if (!fields.has(TEMPLATE)) {
      return OrderedTask.of(TaskOrderReader.read(fields));
    }
    Optional<TaskTemplate> template = named(fields);
    Map<String, JsonNode> values = fields.members(VALUES);
    fields.refuseUnknown();
    return template
        .map(found -> fill(found, values, fields, VALUES + ".", TaskOrderReader::read))
        .orElseGet(() -> OrderedTask.of(TaskOrderReader.NOTHING));
  }

  /** The template that the fields name; a sentence is filed where there is none of that name. */
  Optional<TaskTemplate> named(Fields fields) {
    String name = fields.text(TEMPLATE);
    Optional<TaskTemplate> found =
        templates.stream().filter(one -> one.name().equalsIgnoreCase(name)).findFirst();
    if (found.isEmpty()) {
      fields
          .errors()
          .add(
              fields.path(TEMPLATE),
              fields.texts().get("error.template.unknown", name == null ? "" : name));
    }
    return found;
  }

  /** A line of a table: the name of a template, and a column for each of its parameters. */
  OrderedTask readEntered(CsvFields line, Instant now) {
    Optional<TaskTemplate> template = named(line);
    if (template.isEmpty()) {
      return OrderedTask.of(TaskOrderReader.NOTHING);
    }
    Set<String> columns = columns(template.get()).collect(toSetOfColumns());
    line.cells().keySet().stream()
        .filter(column -> !column.equals(TEMPLATE) && line.has(column))
        .filter(column -> !columns.contains(column))
        .forEach(
            column ->
                line.errors()
                    .add(
                        column,
                        line.texts()
                            .get("error.import.template.column", template.get().name(), column)));
    return readEntered(template.get(), line, "", now);
  }

  /** All columns of a table in which values of parameters can stand. */
  Set<String> columns() {
    return templates.stream().flatMap(TemplateFiller::columns).collect(toSetOfColumns());
  }

  /** Upper and lower case are the same there. */
  private static Collector<String, ?, Set<String>> toSetOfColumns() {
    return Collectors.toCollection(() -> new TreeSet<>(String.CASE_INSENSITIVE_ORDER));
  }

  private static Stream<String> columns(TaskTemplate template) {
    return template.parameters().stream()
        .flatMap(
            parameter ->
                ParameterKind.of(parameter.field()).filter(ParameterKind.PLACE::equals).isPresent()
                    ? Stream.of("", "X", "Y").map(parameter.name()::concat)
                    : Stream.of(parameter.name()));
  }

  /**
   * An order that a person gives, who has filled in the parameters of a template.
   *
   * @param prefix before their names
   */
  public static OrderedTask readEntered(
      TaskTemplate template, Fields fields, String prefix, Instant now) {
    Map<String, JsonNode> values = new LinkedHashMap<>();
    for (Parameter parameter : template.parameters()) {
      ParameterKind.of(parameter.field())
          .map(kind -> kind.value(fields, prefix + parameter.name()))
          .ifPresent(value -> values.put(parameter.name(), value));
    }
    return fill(
        template, values, fields, prefix, order -> TaskOrderReader.readEdited(order, now, null));
  }

  /** The order again that was made from a template which has changed since. */
  public static OrderedTask again(TaskTemplate template, TemplateUse use, Fields fields) {
    Map<String, JsonNode> values = new LinkedHashMap<>();
    MAPPER
        .readTree(use.values())
        .properties()
        .forEach(value -> values.put(value.getKey(), value.getValue()));
    return fill(template, values, fields, VALUES + ".", TaskOrderReader::read);
  }

  /**
   * @param prefix before the names of parameters in the fields
   */
  private static OrderedTask fill(
      TaskTemplate template,
      Map<String, JsonNode> values,
      Fields fields,
      String prefix,
      Function<Fields, TaskOrder> reader) {
    FieldErrors errors = fields.errors();
    int before = errors.sentences().size();
    refuseUnknown(template, values, fields, prefix);
    ObjectNode order = order(template);
    for (Parameter parameter : template.parameters()) {
      JsonNode value = values.get(parameter.name());
      String at = fields.path(prefix + parameter.name());
      if (value == null || value.isNull()) {
        if (OpenFields.value(order, parameter.field()) == null) {
          errors.add(at, fields.texts().get("error.template.value.missing", parameter.name()));
        }
      } else if (!OpenFields.fill(order, parameter.field(), value)) {
        errors.add(at, fields.texts().get("error.place.missing", parameter.name()));
      }
    }
    if (errors.sentences().size() > before) {
      return OrderedTask.of(TaskOrderReader.NOTHING);
    }
    FieldErrors found = new FieldErrors();
    TaskOrder read = reader.apply(JsonFields.of(order, fields.texts(), found));
    TemplateUse use =
        new TemplateUse(template.id(), template.name(), template.changedAt(), json(values));
    OrderedTask ordered = new OrderedTask(read, template, use);
    found.sentences().forEach((field, sentence) -> file(ordered, field, sentence, fields, prefix));
    return ordered;
  }

  private static void file(
      OrderedTask ordered, String field, String sentence, Fields fields, String prefix) {
    String at = String.valueOf(ordered.entered(field, prefix));
    boolean isOfTemplate = at.equals(TEMPLATE);
    fields
        .errors()
        .add(
            fields.path(at),
            isOfTemplate ? fields.texts().get("error.template.broken", field, sentence) : sentence);
  }

  private static void refuseUnknown(
      TaskTemplate template, Map<String, JsonNode> values, Fields fields, String prefix) {
    List<String> known = template.parameters().stream().map(Parameter::name).toList();
    for (String name : values.keySet()) {
      if (!known.contains(name)) {
        String shown = name.length() > 60 ? name.substring(0, 60) + "…" : name;
        fields
            .errors()
            .add(
                fields.path(prefix + shown),
                known.isEmpty()
                    ? fields.texts().get("error.template.value.none", template.name())
                    : fields
                        .texts()
                        .get(
                            "error.template.value.unknown",
                            template.name(),
                            shown,
                            known.stream().collect(Collectors.joining(", "))));
      }
    }
  }

  private static String json(Map<String, JsonNode> values) {
    ObjectNode object = JsonNodeFactory.instance.objectNode();
    values.forEach(object::set);
    return object.toString();
  }

  /** The order of a template, with its floor, and with the template's name where it has none. */
  public static ObjectNode order(TaskTemplate template) {
    ObjectNode order = object(template.order());
    order.put("floor", template.floor());
    if (!order.has("name")) {
      order.put("name", template.name());
    }
    return order;
  }

  /** The object in that JSON, which this server wrote. */
  public static ObjectNode object(String json) {
    return (ObjectNode) MAPPER.readTree(json);
  }

  /** The same of what somebody may have changed; null: it is no object. */
  public static @Nullable ObjectNode objectIn(@Nullable String json) {
    try {
      return json != null && MAPPER.readTree(json) instanceof ObjectNode object ? object : null;
    } catch (tools.jackson.core.JacksonException e) {
      return null;
    }
  }
}
