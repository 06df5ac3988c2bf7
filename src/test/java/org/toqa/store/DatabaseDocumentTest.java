package org.toqa.store;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** {@code docs/database.md} gives a reason for each column of each table that there is. */
class DatabaseDocumentTest extends DatabaseTest {
  private static final Path DOCUMENT = Path.of("docs/database.md");
  private static final Pattern COLUMN = Pattern.compile("`([a-z_0-9]+)`");

  @Test
  void everyColumnHasItsReason() throws IOException {
    Map<String, TreeSet<String>> told = new TreeMap<>();
    String tables = Files.readString(DOCUMENT).split("## Tables and columns", 2)[1];
    for (String section : tables.split("\n### ", -1)) {
      String[] parts = section.split("\n", 2);
      told.put(
          parts[0].strip(),
          Arrays.stream(parts.length < 2 ? new String[0] : new String[] {parts[1]})
              .flatMap(text -> COLUMN.matcher(text).results().map(found -> found.group(1)))
              .collect(Collectors.toCollection(TreeSet::new)));
    }
    Map<String, TreeSet<String>> missing = new TreeMap<>();
    database
        .jdbi()
        .useHandle(
            h ->
                h.createQuery(
                        "select table_name, column_name from information_schema.columns"
                            + " where table_schema = schema()")
                    .map(
                        (row, context) ->
                            new String[] {
                              row.getString(1).toLowerCase(Locale.ROOT),
                              row.getString(2).toLowerCase(Locale.ROOT)
                            })
                    .forEach(
                        column -> {
                          if (!column[0].contains("flyway")
                              && !told.getOrDefault(column[0], new TreeSet<>())
                                  .contains(column[1])) {
                            missing
                                .computeIfAbsent(column[0], table -> new TreeSet<>())
                                .add(column[1]);
                          }
                        }));

    assertEquals(Map.of(), missing);
  }
}
