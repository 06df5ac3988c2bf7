package org.toqa.testbed;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Properties;

/** A file of texts in one language. */
public final class TextFile {
  private TextFile() {}

  /** In the order of the file; a bundle would answer in English what is missing in Arabic. */
  public static Map<String, String> read(Path file) {
    Map<String, String> inOrder = new LinkedHashMap<>();
    Properties ordered =
        new Properties() {
          @Override
          public synchronized Object put(Object key, Object value) {
            assertEquals(null, inOrder.put((String) key, (String) value), key + " is there twice");
            return super.put(key, value);
          }
        };
    try (var reader = Files.newBufferedReader(file)) {
      ordered.load(reader);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return inOrder;
  }
}
