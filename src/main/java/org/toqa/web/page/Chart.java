package org.toqa.web.page;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * A table that is drawn too.
 *
 * @param name of its texts
 * @param head what the rows are: the name of a text
 * @param isHorizontal whether its bars lie
 */
public record Chart(
    String name, String head, boolean isHorizontal, List<Column> columns, List<Row> rows) {

  /** How a column is drawn. Bars of one row are stacked. */
  public enum Shape {
    BAR,
    LINE,
    NONE
  }

  /** What a column's numbers are. */
  public enum Unit {
    COUNT,
    SECONDS,
    METRES,
    /** A part of a whole, 0 to 1; of several wholes more. */
    SHARE
  }

  /**
   * @param name of its text, and of its colour
   */
  public record Column(String name, Shape shape, Unit unit) {}

  /**
   * @param values one for each column; null: there is none
   */
  public record Row(String label, List<@Nullable Double> values) {}

  public Chart {
    columns = List.copyOf(columns);
    rows = List.copyOf(rows);
  }

  /** Whether there is nothing to be seen. */
  public boolean isEmpty() {
    return rows.stream()
        .flatMap(row -> row.values().stream())
        .allMatch(value -> value == null || value == 0);
  }
}
