package org.toqa.web.api;

import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import org.apache.commons.csv.CSVFormat;
import org.jspecify.annotations.Nullable;

/** A table as RFC 4180 has it, in which a spreadsheet finds no formulas. */
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
        .append(
            CSVFormat.RFC4180.format(Arrays.stream(cells).map(CsvWriter::withoutFormula).toArray()))
        .append(CSVFormat.RFC4180.getRecordSeparator());
  }

  private static @Nullable Object withoutFormula(@Nullable Object cell) {
    return cell instanceof String text
            && !text.isEmpty()
            && FORMULA_SIGNS.indexOf(text.charAt(0)) >= 0
        ? "'" + text
        : cell;
  }

  /** Sends the table, in UTF-8, as a file of that name. */
  void send(HttpServletResponse response, String fileName) throws IOException {
    byte[] bytes = lines.toString().getBytes(StandardCharsets.UTF_8);
    response.setContentType("text/csv;header=present;charset=UTF-8");
    response.setHeader("Content-Disposition", "attachment; filename=\"" + fileName + "\"");
    response.setContentLength(bytes.length);
    response.getOutputStream().write(bytes);
  }
}
