package org.toqa.agent.config;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.toqa.geometry.Vec2;
import org.toqa.yaml.Spelling;

/**
 * A part of a configuration file. It has no key that it does not know; each question names a key,
 * its default and its range.
 */
final class ConfigSection {

  private final String file;
  private final String path;
  private final Map<?, ?> values;

  /**
   * @param path the keys that lead here, each followed by a dot; empty for the whole file
   */
  ConfigSection(String file, String path, Map<?, ?> values, String... known)
      throws ConfigException {
    this.file = file;
    this.path = path;
    this.values = values;
    for (Object key : values.keySet()) {
      if (!List.of(known).contains(String.valueOf(key))) {
        throw new ConfigException(
            "%s: there is no key \"%s%s\"; ".formatted(file, path, key)
                + Spelling.near(String.valueOf(key), List.of(known))
                    .map(near -> "did you mean \"%s%s\"?".formatted(path, near))
                    .orElseGet(() -> "there are: " + String.join(", ", known)));
      }
    }
  }

  ConfigSection section(String key, String... known) throws ConfigException {
    Object value = values.get(key);
    if (value == null) {
      return new ConfigSection(file, path + key + ".", Map.of(), known);
    }
    if (value instanceof Map<?, ?> map) {
      return new ConfigSection(file, path + key + ".", map, known);
    }
    throw invalid(key, value, "keys of its own, indented below it");
  }

  boolean has(String key) {
    return values.get(key) != null;
  }

  String text(String key) throws ConfigException {
    Object value = values.get(key);
    if (value == null) {
      throw new ConfigException("%s: the key \"%s%s\" is missing.".formatted(file, path, key));
    }
    return text(key, value);
  }

  String text(String key, String defaultValue) throws ConfigException {
    Object value = values.get(key);
    return value == null ? defaultValue : text(key, value);
  }

  /** A list of texts; empty where the key is not there. */
  List<String> texts(String key) throws ConfigException {
    Object value = values.get(key);
    if (value == null) {
      return List.of();
    }
    if (!(value instanceof List<?> items && items.stream().allMatch(String.class::isInstance))) {
      throw invalid(key, value, "a list of texts, as in [wlan0]");
    }
    return items.stream().map(String.class::cast).toList();
  }

  /** A list of places, metres, map frame; empty where the key is not there. */
  List<Vec2> points(String key) throws ConfigException {
    Object value = values.get(key);
    if (value == null) {
      return List.of();
    }
    if (!(value instanceof List<?> items)) {
      throw invalid(key, value, "a list of {x: 1.0, y: 2.0}");
    }
    List<Vec2> points = new ArrayList<>();
    for (Object item : items) {
      if (!(item instanceof Map<?, ?> map && map.containsKey("x") && map.containsKey("y"))) {
        throw invalid(key, value, "a list of {x: 1.0, y: 2.0}");
      }
      ConfigSection point = new ConfigSection(file, path + key + ".", map, "x", "y");
      points.add(
          new Vec2(
              point.number("x", 0, -100_000, 100_000), point.number("y", 0, -100_000, 100_000)));
    }
    return points;
  }

  double number(String key, double defaultValue, double least, double most) throws ConfigException {
    Object value = values.get(key);
    if (value == null) {
      return defaultValue;
    }
    if (value instanceof Number n && n.doubleValue() >= least && n.doubleValue() <= most) {
      return n.doubleValue();
    }
    throw invalid(key, value, "a number from %s to %s".formatted(plain(least), plain(most)));
  }

  /** A list of as many numbers as the default has. */
  List<Double> numbers(String key, List<Double> defaultValue, double least, double most)
      throws ConfigException {
    Object value = values.get(key);
    if (value == null) {
      return defaultValue;
    }
    List<Double> numbers = new ArrayList<>();
    if (value instanceof List<?> items && items.size() == defaultValue.size()) {
      for (Object item : items) {
        if (item instanceof Number n && n.doubleValue() >= least && n.doubleValue() <= most) {
          numbers.add(n.doubleValue());
        }
      }
    }
    if (numbers.size() != defaultValue.size()) {
      throw invalid(
          key,
          value,
          "a list of %d numbers from %s to %s"
              .formatted(defaultValue.size(), plain(least), plain(most)));
    }
    return numbers;
  }

  long integer(String key, long defaultValue, long least, long most) throws ConfigException {
    Object value = values.get(key);
    if (value == null) {
      return defaultValue;
    }
    boolean isWhole = value instanceof Integer || value instanceof Long;
    if (isWhole && value instanceof Number n && n.longValue() >= least && n.longValue() <= most) {
      return n.longValue();
    }
    throw invalid(key, value, "a whole number from %d to %d".formatted(least, most));
  }

  boolean flag(String key, boolean defaultValue) throws ConfigException {
    Object value = values.get(key);
    if (value == null) {
      return defaultValue;
    }
    if (value instanceof Boolean flag) {
      return flag;
    }
    throw invalid(key, value, "true or false");
  }

  ConfigException invalid(String key, Object value, String wanted) {
    return new ConfigException(
        "%s: \"%s%s\" is %s; it must be %s.".formatted(file, path, key, value, wanted));
  }

  private String text(String key, Object value) throws ConfigException {
    if (value instanceof String text && !text.isBlank()) {
      return text;
    }
    throw invalid(key, value, "a text");
  }

  private static String plain(double number) {
    return number == Math.rint(number) ? String.valueOf((long) number) : String.valueOf(number);
  }
}
