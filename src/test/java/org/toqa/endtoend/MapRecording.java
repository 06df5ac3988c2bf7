package org.toqa.endtoend;

import com.microsoft.playwright.Page;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import org.toqa.testbed.BrowserTest;

/**
 * What the live map draws: how far each text on it moves and, in a whole walk, a WebM film that the
 * browser itself makes.
 */
final class MapRecording implements AutoCloseable {
  private static final Path SCRIPT = Path.of("src/test/resources/org/toqa/endtoend/film.js");

  private final Page page;
  private final OutputStream file;

  private MapRecording(Page page, OutputStream file) {
    this.page = page;
    this.file = file;
  }

  /**
   * Makes the camera ready.
   *
   * @param page has not been opened yet
   */
  static MapRecording of(Page page, Path file) throws IOException {
    MapRecording film = new MapRecording(page, Files.newOutputStream(file));
    page.addInitScript(SCRIPT);
    page.exposeFunction("keepFilm", chunk -> film.write((String) chunk[0]));
    return film;
  }

  private boolean write(String chunk) {
    try {
      file.write(Base64.getDecoder().decode(chunk));
      return true;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** From here on it is noted. The map must be shown. */
  void start() {
    page.evaluate(
        BrowserTest.IS_WHOLE_WALK
            ? "beginFilm(document.querySelector('#map'))"
            : "beginFilm(null)");
  }

  /** Pixels that a text on the map has gone since the film began. */
  double distanceMoved(String text) {
    return ((Number) page.evaluate("text => wayOf(text)", text)).doubleValue();
  }

  /** The rest is kept. */
  void stop() {
    page.evaluate("endFilm()");
  }

  @Override
  public void close() throws IOException {
    file.close();
  }
}
