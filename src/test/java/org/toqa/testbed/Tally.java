package org.toqa.testbed;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * How much was tried, of each kind. Tests say it when they are done, each a line of {@code
 * target/tally.tsv}; {@code ./toqa test} adds the lines up and fails where a kind is missing.
 */
public final class Tally {
  private static final Path FILE = Path.of("target", "tally.tsv");

  private Tally() {}

  /**
   * @param kind in the plural, such as "property tries"
   */
  public static void add(String kind, long count) {
    append(kind, count, "");
  }

  /**
   * Says of one thing that it was left out.
   *
   * @param what a test's name, and why
   */
  public static void leftOut(String what) {
    append("left out", 1, "\t" + what.replaceAll("\\s+", " "));
  }

  /** One write a line, so that those of several processes do not mix. */
  private static void append(String kind, long count, String rest) {
    byte[] line = (kind + "\t" + count + rest + "\n").getBytes(StandardCharsets.UTF_8);
    try {
      Files.createDirectories(FILE.getParent());
      Files.write(FILE, line, StandardOpenOption.CREATE, StandardOpenOption.APPEND);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
