package org.toqa.web.input;

import java.io.IOException;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CoderResult;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.apache.commons.csv.CSVFormat;
import org.apache.commons.csv.CSVParser;
import org.apache.commons.csv.CSVRecord;

/**
 * A table as a spreadsheet saves it: CSV in UTF-8, with or without a byte order mark. Its cells are
 * separated by commas, semicolons or tabs, whichever its first line has.
 *
 * @param lines without those that are blank
 * @param flaw what kept the rest from being read
 */
record CsvTable(char separator, List<Line> lines, Optional<Flaw> flaw) {
  private static final String BYTE_ORDER_MARK = "\uFEFF";

  /**
   * @param number of the line where it begins, as an editor counts them, from 1
   */
  record Line(long number, List<String> cells) {
    boolean isBlank() {
      return cells.stream().allMatch(String::isBlank);
    }
  }

  /** From that line on it is no table. */
  record Flaw(long line, Kind kind) {
    enum Kind {
      ENCODING,
      BINARY,
      QUOTES
    }
  }

  static CsvTable read(byte[] file) {
    CharBuffer text = CharBuffer.allocate(file.length); // no character is shorter than a byte
    CoderResult result =
        StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(file), text, true);
    text.flip();
    long lines = 1 + text.chars().filter(c -> c == '\n').count();
    if (result.isError()) {
      return broken(lines, Flaw.Kind.ENCODING);
    }
    return text.chars().anyMatch(c -> c == 0)
        ? broken(1, Flaw.Kind.BINARY)
        : parse(text.toString().replaceFirst("^" + BYTE_ORDER_MARK, ""));
  }

  private static CsvTable broken(long line, Flaw.Kind kind) {
    return new CsvTable(',', List.of(), Optional.of(new Flaw(line, kind)));
  }

  private static CsvTable parse(String text) {
    char separator = separator(text.lines().findFirst().orElse(""));
    CSVFormat format =
        CSVFormat.RFC4180
            .builder()
            .setDelimiter(separator)
            .setIgnoreSurroundingSpaces(separator != '\t')
            .get();
    List<Line> lines = new ArrayList<>();
    long next = 1;
    try (CSVParser parser = CSVParser.parse(new StringReader(text), format)) {
      for (CSVRecord cells : parser) {
        Line line = new Line(next, cells.toList());
        if (!line.isBlank()) {
          lines.add(line);
        }
        next = parser.getCurrentLineNumber() + 1;
      }
    } catch (IOException | UncheckedIOException e) { // of the quotes: a string is always readable
      return new CsvTable(separator, lines, Optional.of(new Flaw(next, Flaw.Kind.QUOTES)));
    }
    return new CsvTable(separator, lines, Optional.empty());
  }

  private static char separator(String header) {
    if (header.indexOf(';') >= 0) {
      return ';';
    }
    return header.indexOf('\t') >= 0 ? '\t' : ',';
  }
}
