package org.toqa.grid;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.toqa.yaml.Spelling;
import org.toqa.yaml.YamlParser;
import org.toqa.yaml.YamlSyntaxException;

/** The keys and values of one YAML mapping, read with their types or refused by place. */
final class YamlFields {
  private final String location;
  private final Map<?, ?> values;

  private YamlFields(String location, Map<?, ?> values) {
    this.location = location;
    this.values = values;
  }

  /** The whole file as one mapping with no other keys than these. */
  static YamlFields read(MapFile file, List<String> known) throws MapFormatException {
    return read(file, known, MapLimits.MAX_YAML_BYTES);
  }

  /**
   * @param maxBytes that it may have
   */
  static YamlFields read(MapFile file, List<String> known, int maxBytes) throws MapFormatException {
    byte[] bytes = file.read(maxBytes);
    try {
      Object root = YamlParser.parse(new String(bytes, StandardCharsets.UTF_8), maxBytes);
      return of(file.toString(), root, known);
    } catch (YamlSyntaxException e) {
      String place =
          e.line().isPresent() ? file + ", line " + e.line().getAsInt() : file.toString();
      throw new MapFormatException("%s: not valid YAML (%s).".formatted(place, e.problem()), e);
    }
  }

  private static YamlFields of(String place, @Nullable Object node, List<String> known)
      throws MapFormatException {
    if (!(node instanceof Map<?, ?> map)) {
      throw new MapFormatException(
          place + ": expected keys with values: " + String.join(", ", known) + ".");
    }
    for (Object key : map.keySet()) {
      if (!(key instanceof String name && known.contains(name))) {
        throw new MapFormatException(
            "%s: unknown key '%s'; ".formatted(place, key)
                + Spelling.near(String.valueOf(key), known)
                    .map("did you mean '%s'?"::formatted)
                    .orElseGet(() -> "there are: " + String.join(", ", known) + "."));
      }
    }
    return new YamlFields(place, map);
  }

  boolean has(String key) {
    return values.get(key) != null;
  }

  MapFormatException error(String key, String remedy) {
    return new MapFormatException("%s, key '%s': %s".formatted(location, key, remedy));
  }

  String text(String key) throws MapFormatException {
    if (required(key) instanceof String text) {
      return text;
    }
    throw error(key, "expected text; put it in quotes.");
  }

  double number(String key) throws MapFormatException {
    return number(key, required(key));
  }

  /** A coordinate or a length, within what any site can mean. */
  double metres(String key) throws MapFormatException {
    double metres = number(key);
    if (Math.abs(metres) > MapLimits.FARTHEST) {
      throw error(key, "is in metres, at most " + (long) MapLimits.FARTHEST + " from zero.");
    }
    return metres;
  }

  private double number(String key, @Nullable Object value) throws MapFormatException {
    if (value instanceof Number number && Double.isFinite(number.doubleValue())) {
      return number.doubleValue();
    }
    throw error(key, "expected a finite number, not '" + value + "'.");
  }

  List<Double> numbers(String key, int count) throws MapFormatException {
    List<Double> numbers = new ArrayList<>();
    if (required(key) instanceof List<?> list && list.size() == count) {
      for (Object item : list) {
        numbers.add(number(key, item));
      }
      return numbers;
    }
    throw error(key, "expected a list of " + count + " numbers.");
  }

  /** A list of mappings, each with no other keys than these; empty where the key is absent. */
  List<YamlFields> items(String key, List<String> known) throws MapFormatException {
    if (!has(key)) {
      return List.of();
    }
    if (!(values.get(key) instanceof List<?> list)) {
      throw error(key, "expected a list; start each entry with '- '.");
    }
    List<YamlFields> items = new ArrayList<>();
    for (Object item : list) {
      items.add(of("%s, %s number %d".formatted(location, key, items.size() + 1), item, known));
    }
    return items;
  }

  private Object required(String key) throws MapFormatException {
    Object value = values.get(key);
    if (value == null) {
      throw error(key, "is missing; add it.");
    }
    return value;
  }
}
