package org.toqa.link.message;

import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * Cuts a stream of bytes into the lines of the robot link. It never holds more than one line of the
 * allowed length: a longer one is read to its end and reported as {@link TooLong}, and the next
 * line is read as usual. A last line without its line feed was cut off and is dropped.
 *
 * <p>For one thread.
 */
public final class LineReader {

  private static final int BUFFER_BYTES = 32 * 1024;

  private final InputStream in;
  private final byte[] buffer = new byte[BUFFER_BYTES];
  private int position;
  private int limit;

  public LineReader(InputStream in) {
    this.in = in;
  }

  /** One line. */
  public sealed interface Line {}

  /**
   * @param utf8 the line's bytes, without its line feed
   */
  @SuppressWarnings("ArrayRecordComponent") // handed on once, never compared
  public record Text(byte[] utf8) implements Line {}

  /**
   * @param bytes how many it had, with its line feed
   */
  public record TooLong(long bytes) implements Line {}

  /**
   * The next line, or null at the end of the stream; waits for it.
   *
   * @throws IOException when the stream cannot be read
   */
  public @Nullable Line readLine() throws IOException {
    byte[] line = new byte[0];
    long length = 0;
    while (true) {
      if (position == limit && !fill()) {
        return null;
      }
      int end = lineFeedIndex();
      int part = (end < 0 ? limit : end) - position;
      length += part;
      if (length < LinkCodec.MAX_LINE_BYTES) {
        line = append(line, part);
      } else {
        line = new byte[0];
      }
      position += part;
      if (end >= 0) {
        position++;
        return length < LinkCodec.MAX_LINE_BYTES ? new Text(line) : new TooLong(length + 1);
      }
    }
  }

  /** Whether the next line has come already, so that {@link #readLine} does not wait. */
  public boolean hasLine() {
    return lineFeedIndex() >= 0;
  }

  private boolean fill() throws IOException {
    int count = in.read(buffer);
    position = 0;
    limit = Math.max(0, count);
    return count > 0;
  }

  private int lineFeedIndex() {
    for (int i = position; i < limit; i++) {
      if (buffer[i] == '\n') {
        return i;
      }
    }
    return -1;
  }

  private byte[] append(byte[] line, int part) {
    byte[] longer = Arrays.copyOf(line, line.length + part);
    System.arraycopy(buffer, position, longer, line.length, part);
    return longer;
  }
}
