package org.toqa.app.demo;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.toqa.sim.Body;
import tools.jackson.databind.json.JsonMapper;

/**
 * Writes where bodies really are, a line of JSON for each moment and floor: {@code seconds} of the
 * simulated world, {@code floor}, and {@code bodies} as {@link Body} has them.
 */
final class BodyRecorder implements AutoCloseable {
  private final Writer file;

  /**
   * @param seconds of the world, since its start
   */
  private record Line(double seconds, String floor, List<Body> bodies) {}

  private BodyRecorder(Writer file) {
    this.file = file;
  }

  /**
   * @throws IOException the file cannot be written
   */
  static BodyRecorder create(Path file) throws IOException {
    return new BodyRecorder(Files.newBufferedWriter(file, StandardCharsets.UTF_8));
  }

  /**
   * Writes one moment, so that it can be read at once.
   *
   * @param at the world's time, since its start
   * @throws UncheckedIOException it cannot be written
   */
  void write(Duration at, String floor, List<Body> bodies) {
    try {
      file.write(
          JsonMapper.shared().writeValueAsString(new Line(at.toNanos() / 1e9, floor, bodies))
              + '\n');
      file.flush();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void close() throws IOException {
    file.close();
  }
}
