package org.toqa.web.input;

import java.time.DateTimeException;
import java.time.Duration;
import java.time.Instant;
import java.time.OffsetDateTime;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskOrder.StopOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.mission.ArmHandling;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.web.Texts;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/**
 * The fields of a JSON object that somebody sent. Each is asked for by its name; what was not asked
 * for is unknown, and {@link #refuseUnknown} says so. A field of the wrong type gets a sentence and
 * counts as missing, as does null.
 */
public final class JsonFields implements Fields {
  private final JsonNode object;
  private final String prefix;
  private final Texts texts;
  private final FieldErrors errors;
  private final Set<String> known = new LinkedHashSet<>();

  private JsonFields(JsonNode object, String prefix, Texts texts, FieldErrors errors) {
    this.object = object;
    this.prefix = prefix;
    this.texts = texts;
    this.errors = errors;
  }

  /** The fields of that object, which are named from the top. */
  public static JsonFields of(ObjectNode object, Texts texts, FieldErrors errors) {
    return new JsonFields(object, "", texts, errors);
  }

  /** An object without fields. */
  static JsonFields empty(Texts texts, FieldErrors errors) {
    return of(JsonNodeFactory.instance.objectNode(), texts, errors);
  }

  @Override
  public @Nullable String text(String name) {
    return value(name)
        .flatMap(
            value ->
                value.isString()
                    ? Optional.of(value.stringValue())
                    : refuseType(name, "error.type.text"))
        .orElse(null);
  }

  /** Infinite when it is beyond what a double holds. */
  @Override
  public @Nullable Double number(String name) {
    return value(name)
        .flatMap(
            value ->
                value.isNumber()
                    ? Optional.of(value.doubleValueOpt().orElse(Double.POSITIVE_INFINITY))
                    : this.<Double>refuseType(name, "error.type.number"))
        .orElse(null);
  }

  @Override
  public boolean flag(String name) {
    return value(name)
        .flatMap(
            value ->
                value.isBoolean()
                    ? Optional.of(value.booleanValue())
                    : this.<Boolean>refuseType(name, "error.type.boolean"))
        .orElse(false);
  }

  /** A list of texts. */
  @Override
  public List<String> choices(String name) {
    return value(name)
        .flatMap(
            value ->
                value.isArray() && value.values().stream().allMatch(JsonNode::isString)
                    ? Optional.of(value.values().stream().map(JsonNode::stringValue).toList())
                    : this.<List<String>>refuseType(name, "error.type.texts"))
        .orElse(List.of());
  }

  /** A list of whole numbers; empty where there is none. */
  public List<Integer> integers(String name, int max) {
    Optional<JsonNode> list = value(name);
    if (list.isPresent()
        && !(list.get().isArray() && list.get().values().stream().allMatch(JsonNode::isInt))) {
      return this.<List<Integer>>refuseType(name, "error.type.integers").orElse(List.of());
    }
    if (list.isPresent() && list.get().size() > max) {
      errors.add(path(name), texts.get("error.listLong", path(name), max));
      return List.of();
    }
    return list.map(numbers -> numbers.values().stream().map(JsonNode::intValue).toList())
        .orElse(List.of());
  }

  /** A list of objects; empty where there is none. */
  public List<JsonFields> objects(String name, int max) {
    Optional<JsonNode> list = value(name);
    if (list.isPresent()
        && !(list.get().isArray() && list.get().values().stream().allMatch(JsonNode::isObject))) {
      return this.<List<JsonFields>>refuseType(name, "error.type.objects").orElse(List.of());
    }
    if (list.isPresent() && list.get().size() > max) {
      errors.add(path(name), texts.get("error.listLong", path(name), max));
      return List.of();
    }
    List<JsonFields> objects = new ArrayList<>();
    for (JsonNode item : list.map(JsonNode::values).orElse(List.of())) {
      String at = path(name) + "." + objects.size() + ".";
      objects.add(new JsonFields(item, at, texts, errors));
    }
    return objects;
  }

  /** It must be there. */
  @Override
  public JsonFields object(String name) {
    return optionalObject(name)
        .orElseGet(
            () -> {
              errors.add(path(name), texts.get("error.type.object", path(name)));
              // one sentence for all that is not there
              return new JsonFields(
                  JsonNodeFactory.instance.objectNode(),
                  path(name) + ".",
                  texts,
                  new FieldErrors());
            });
  }

  @Override
  public Map<String, JsonNode> members(String name) {
    Map<String, JsonNode> members = new LinkedHashMap<>();
    value(name)
        .flatMap(
            value -> value.isObject() ? Optional.of(value) : refuseType(name, "error.type.object"))
        .ifPresent(value -> value.properties().forEach(m -> members.put(m.getKey(), m.getValue())));
    return members;
  }

  /** The object itself. */
  ObjectNode copy() {
    return (ObjectNode) object.deepCopy();
  }

  private Optional<JsonFields> optionalObject(String name) {
    return value(name)
        .flatMap(
            value ->
                value.isObject()
                    ? Optional.of(new JsonFields(value, path(name) + ".", texts, errors))
                    : refuseType(name, "error.type.object"));
  }

  /** Also where it is null. Who asks for it knows it: {@link #refuseUnknown} does not refuse it. */
  @Override
  public boolean has(String name) {
    known.add(name);
    return object.has(name);
  }

  /** The field's name from the top, as errors name it. */
  @Override
  public String path(String name) {
    return prefix + name;
  }

  @Override
  public void refuseUnknown() {
    for (String name : object.propertyNames()) {
      if (!known.contains(name)) {
        String shown = name.length() > 60 ? name.substring(0, 60) + "…" : name;
        errors.add(
            path(shown), texts.get("error.unknownField", path(shown), String.join(", ", known)));
      }
    }
  }

  /** With its offset from UTC. */
  @Override
  public @Nullable Instant moment(String name, String errorKey) {
    String given = text(name);
    try {
      return given == null ? null : OffsetDateTime.parse(given).toInstant();
    } catch (DateTimeException e) {
      errors.add(path(name), texts.get(errorKey));
      return null;
    }
  }

  /** An object with the name of a station, or with coordinates. */
  @Override
  public Where place(String name) {
    Optional<JsonNode> place = value(name).filter(JsonNode::isObject);
    if (place.isEmpty()) {
      errors.add(path(name), texts.get("error.place.missing", name));
      return new Where.Station("");
    }
    return place(name, new JsonFields(place.get(), path(name) + ".", texts, errors));
  }

  private Where place(String name, JsonFields place) {
    String station = place.text("station");
    if (!place.has("station")) {
      InputRules rules = rules();
      Vec2 position =
          new Vec2(
              rules.coordinate(place.path("x"), place.number("x")),
              rules.coordinate(place.path("y"), place.number("y")));
      place.refuseUnknown();
      return new Where.Point(position);
    }
    if (station == null || place.object.has("x") || place.object.has("y")) {
      errors.add(path(name), texts.get("error.place.missing", name));
    } else {
      place.refuseUnknown();
    }
    return new Where.Station(station == null ? "" : station);
  }

  @Override
  public List<Where> places(String name, int max) {
    List<JsonNode> given =
        value(name)
            .flatMap(
                value ->
                    value.isArray() && value.values().stream().allMatch(JsonNode::isObject)
                        ? Optional.of(List.copyOf(value.values()))
                        : this.<List<JsonNode>>refuseType(name, "error.type.places"))
            .orElse(List.of());
    if (given.size() > max) {
      errors.add(path(name), texts.get("error.stops.many", max));
      return List.of();
    }
    List<Where> places = new ArrayList<>();
    for (JsonNode place : given) {
      String at = path(name) + "." + places.size();
      places.add(place(at, new JsonFields(place, at + ".", texts, errors)));
    }
    return places;
  }

  @Override
  public List<StopOrder> stops(String name, int max) {
    List<StopOrder> stops = new ArrayList<>();
    for (JsonFields stop : objects(name, max)) {
      boolean awaitsPerson = stop.flag("waitForPerson");
      Duration wait = stop.rules().stopWait(stop.path("waitSeconds"), stop.number("waitSeconds"));
      String at = name + "." + stops.size();
      Optional<JsonFields> charge = stop.optionalObject("charge");
      stops.add(
          charge.isPresent()
              ? charge(at, stop, charge.get(), awaitsPerson, wait)
              : new StopOrder(place(at, stop), awaitsPerson, wait));
    }
    return stops;
  }

  /** At a charging point instead of a place. */
  private StopOrder charge(
      String at,
      JsonFields stop,
      JsonFields charge,
      boolean awaitsPerson,
      @Nullable Duration wait) {
    String charger = charge.text("charger");
    Double until = charge.rules().chargeLevel(charge.path("until"), charge.number("until"));
    charge.refuseUnknown();
    if (Stream.of("station", "x", "y").anyMatch(stop::has)) {
      errors.add(path(at), texts.get("error.charge.place"));
    }
    stop.refuseUnknown();
    return new StopOrder(new Where.Charger(charger), awaitsPerson, wait, until);
  }

  @Override
  public @Nullable LoadSize size(String name) {
    return optionalObject(name)
        .map(
            size -> {
              LoadSize read = rules().size(path(name), size.number("length"), size.number("width"));
              size.refuseUnknown();
              return read;
            })
        .orElse(null);
  }

  @Override
  public @Nullable ArmHandling arm(String name) {
    return optionalObject(name)
        .map(
            arm -> {
              ArmHandling read = new ArmHandling(arm.point("pick"), arm.point("place"));
              arm.refuseUnknown();
              return read;
            })
        .orElse(null);
  }

  @Override
  public Map<Integer, Vec2> boxTargets(String name, int max) {
    Map<Integer, Vec2> targets = new TreeMap<>();
    for (JsonFields box : objects(name, max)) {
      int number = rules().boxNumber(box.path("box"), box.number("box"), targets.keySet());
      targets.put(number, box.point("target"));
      box.refuseUnknown();
    }
    return targets;
  }

  /** An object with coordinates. */
  public Vec2 point(String name) {
    JsonFields point = object(name);
    Vec2 read =
        new Vec2(
            point.rules().coordinateOfPose(point.path("x"), point.number("x")),
            point.rules().coordinateOfPose(point.path("y"), point.number("y")));
    point.refuseUnknown();
    return read;
  }

  @Override
  public Texts texts() {
    return texts;
  }

  @Override
  public FieldErrors errors() {
    return errors;
  }

  private Optional<JsonNode> value(String name) {
    known.add(name);
    return Optional.ofNullable(object.get(name)).filter(value -> !value.isNull());
  }

  private <T> Optional<T> refuseType(String name, String key) {
    errors.add(path(name), texts.get(key, path(name)));
    return Optional.empty();
  }
}
