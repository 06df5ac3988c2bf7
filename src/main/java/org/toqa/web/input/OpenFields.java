package org.toqa.web.input;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskTemplate.Parameter;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** The fields of an order in JSON that parameters fill. */
public final class OpenFields {
  private static final List<String> OF_PLACE = List.of("station", "x", "y");

  private OpenFields() {}

  /** What stands in a field; of a stop its place. Null: nothing. */
  public static @Nullable JsonNode value(ObjectNode order, String field) {
    JsonNode found = order;
    for (String step : field.split("\\.", -1)) {
      found = found == null ? null : step(found, step);
    }
    if (found == null || found.isNull()) {
      return null;
    }
    return isStop(field) && found instanceof ObjectNode stop ? placeOf(stop) : found;
  }

  private static @Nullable JsonNode step(JsonNode of, String step) {
    return of.isArray() ? of.get(Integer.parseInt(step)) : of.get(step);
  }

  private static @Nullable JsonNode placeOf(ObjectNode stop) {
    ObjectNode place = stop.deepCopy();
    place.retain(OF_PLACE);
    return place.isEmpty() ? null : place;
  }

  /** A stop is what its place is, and what is waited for there. */
  private static boolean isStop(String field) {
    return field.startsWith("stops.") && field.indexOf('.', "stops.".length()) < 0;
  }

  /**
   * Puts a value into a field.
   *
   * @return whether the order has such a field: there is no stop of that number else
   */
  static boolean fill(ObjectNode order, String field, JsonNode value) {
    if (isStop(field)) {
      JsonNode stop = parent(order, field + ".");
      if (!(stop instanceof ObjectNode there) || !(value instanceof ObjectNode place)) {
        return false;
      }
      there.remove(OF_PLACE);
      there.setAll(place);
      return true;
    }
    if (!(parent(order, field) instanceof ObjectNode parent)) {
      return false;
    }
    parent.set(last(field), value);
    return true;
  }

  /** Takes what stands in a field out of the order. */
  static void clear(ObjectNode order, String field) {
    if (isStop(field)) {
      if (parent(order, field + ".") instanceof ObjectNode stop) {
        stop.remove(OF_PLACE);
      }
    } else if (parent(order, field) instanceof ObjectNode parent) {
      parent.remove(last(field));
    }
  }

  private static String last(String field) {
    return field.substring(field.lastIndexOf('.') + 1);
  }

  /**
   * What a field stands in; an object is made there where nothing is. Null: there is no such stop.
   */
  private static @Nullable JsonNode parent(ObjectNode order, String field) {
    JsonNode at = order;
    for (String step : field.substring(0, Math.max(0, field.lastIndexOf('.'))).split("\\.", -1)) {
      if (step.isEmpty()) {
        return at;
      }
      at =
          switch (at) {
            case ArrayNode list -> list.get(Integer.parseInt(step));
            case ObjectNode object when object.has(step) -> object.get(step);
            case ObjectNode object when step.equals("stops") -> null;
            case ObjectNode object -> object.putObject(step);
            case null, default -> null;
          };
    }
    return at;
  }

  /** The parameter that fills the field of which a sentence is, if there is one. */
  static Optional<Parameter> parameterAt(List<Parameter> parameters, String field) {
    return parameters.stream()
        .filter(
            parameter ->
                field.equals(parameter.field()) || field.startsWith(parameter.field() + "."))
        .max((a, b) -> Integer.compare(a.field().length(), b.field().length()));
  }
}
