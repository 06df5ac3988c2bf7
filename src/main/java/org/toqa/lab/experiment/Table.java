package org.toqa.lab.experiment;

import java.util.List;

/**
 * A table beside the figures.
 *
 * @param name of its file, without the ending: lower-case words with hyphens
 * @param title for a person
 * @param columns their heads, with units
 * @param rows each as long as the columns
 */
public record Table(String name, String title, List<String> columns, List<List<String>> rows) {

  /**
   * @throws IllegalArgumentException if a row is not as long as the columns
   */
  public Table {
    columns = List.copyOf(columns);
    rows = rows.stream().map(List::copyOf).toList();
    for (List<String> row : rows) {
      if (row.size() != columns.size()) {
        throw new IllegalArgumentException(
            "A row of the table %s has %d cells, not %d."
                .formatted(name, row.size(), columns.size()));
      }
    }
  }
}
