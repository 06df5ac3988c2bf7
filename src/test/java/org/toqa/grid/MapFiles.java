package org.toqa.grid;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Writes small map files into a test's own folder. */
final class MapFiles {
  static final String YAML =
      """
      image: floor.pgm
      resolution: 0.5
      origin: [1.0, 2.0, 0.0]
      negate: 0
      occupied_thresh: 0.65
      free_thresh: 0.196
      """;

  /** 3 x 2: free, unknown, occupied / free, free, free. */
  static final String PGM =
      """
      P2
      # drawn by hand
      3 2 255
      254 205 0
      255 254 254
      """;

  private final Path folder;

  MapFiles(Path folder) {
    this.folder = folder;
  }

  Path write(String name, String text) throws IOException {
    return Files.writeString(folder.resolve(name), text);
  }

  /** Reading the file fails with a sentence that has all these words. */
  static void assertRefused(Path file, String... words) {
    MapFormatException refusal =
        assertThrows(MapFormatException.class, () -> FloorReader.read(file));
    for (String word : words) {
      assertTrue(String.valueOf(refusal.getMessage()).contains(word), refusal::getMessage);
    }
  }
}
