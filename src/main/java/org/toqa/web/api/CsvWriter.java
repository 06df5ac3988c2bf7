package org.toqa.web.api;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/** A table as RFC 4180 has it. */
final class CsvWriter {
  /** With one of these a spreadsheet would take a text for a formula. */
  private static final String FORMULA_SIGNS = "=+-@\t\r";

  private final StringBuilder lines = new StringBuilder();

  CsvWriter(List<String> header) {
    addLine(header.toArray());
  }

  /** Texts and times as they are, numbers with a point; null: an empty cell. */
  void addLine(@Nullable Object... cells) {
    lines
        .append(Arrays.stream(cells).map(CsvWriter::cell).collect(Collectors.joining(",")))
        .append("\r\n");
  }

  private static String cell(@Nullable Object value) {
    return switch (value) {
      case null -> "";
      case String text -> quoted(withoutFormula(text));
      default -> quoted(value.toString());
    };
  }

  private static String withoutFormula(String text) {
    return !text.isEmpty() && FORMULA_SIGNS.indexOf(text.charAt(0)) >= 0 ? "'" + text : text;
  }

  private static String quoted(String text) {
    boolean isPlain = text.chars().noneMatch(c -> c == '"' || c == ',' || c == '\r' || c == '\n');
    return isPlain ? text : '"' + text.replace("\"", "\"\"") + '"';
  }

  @Override
  public String toString() {
    return lines.toString();
  }
}
