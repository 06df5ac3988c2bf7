package org.toqa.grid;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.yaml.snakeyaml.LoaderOptions;
import org.yaml.snakeyaml.Yaml;
import org.yaml.snakeyaml.constructor.SafeConstructor;
import org.yaml.snakeyaml.error.MarkedYAMLException;
import org.yaml.snakeyaml.error.YAMLException;

/** The keys and values of one YAML mapping, read with their types or refused by place. */
final class YamlFields {
  private final String location;
  private final Map<?, ?> values;

  private YamlFields(String location, Map<?, ?> values) {
    this.location = location;
    this.values = values;
  }

  /** The whole file as one mapping with no other keys than these. */
  static YamlFields read(Path file, List<String> known) throws MapFormatException {
    LoaderOptions limits = new LoaderOptions();
    limits.setAllowDuplicateKeys(false);
    limits.setMaxAliasesForCollections(0);
    limits.setNestingDepthLimit(8);
    byte[] bytes = MapLimits.readBytes(file, MapLimits.MAX_YAML_BYTES);
    try {
      Object root =
          new Yaml(new SafeConstructor(limits)).load(new String(bytes, StandardCharsets.UTF_8));
      return of(file.toString(), root, known);
    } catch (MarkedYAMLException e) {
      int line = e.getProblemMark() == null ? 1 : e.getProblemMark().getLine() + 1;
      throw new MapFormatException(
          "%s, line %d: not valid YAML (%s).".formatted(file, line, e.getProblem()), e);
    } catch (YAMLException e) {
      throw new MapFormatException(file + ": not valid YAML (" + e.getMessage() + ").", e);
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
            "%s: unknown key '%s'; did you mean '%s'?"
                .formatted(place, key, nearest(String.valueOf(key), known)));
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

  private static String nearest(String word, List<String> known) {
    return known.stream().min(Comparator.comparingInt(k -> editDistance(word, k))).orElseThrow();
  }

  /** Letters to insert, delete or replace (Levenshtein, 1966). */
  private static int editDistance(String a, String b) {
    int[] row = new int[b.length() + 1];
    for (int j = 0; j <= b.length(); j++) {
      row[j] = j;
    }
    for (int i = 1; i <= a.length(); i++) {
      int diagonal = row[0];
      row[0] = i;
      for (int j = 1; j <= b.length(); j++) {
        int replaced = diagonal + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
        diagonal = row[j];
        row[j] = Math.min(replaced, 1 + Math.min(row[j], row[j - 1]));
      }
    }
    return row[b.length()];
  }
}
