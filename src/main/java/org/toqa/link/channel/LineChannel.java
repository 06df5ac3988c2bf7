package org.toqa.link.channel;

import java.io.IOException;
import java.io.OutputStream;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.link.message.LineReader;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.LinkSocket;

/**
 * Lines to and from the other end of a connection.
 *
 * <ol>
 *   <li>{@link #start} begins to write, by a thread of the channel's own.
 *   <li>{@link #send} puts a line into a bounded queue; any thread may call it, and it never waits.
 *   <li>{@link #readLine} waits for a line; one thread calls it.
 *   <li>{@link #close} closes the connection at once; any thread may call it, and it never waits.
 * </ol>
 */
public final class LineChannel implements AutoCloseable {

  private static final Logger log = LoggerFactory.getLogger(LineChannel.class);

  /** What happens to a line when the queue is full, since the other end does not read. */
  public enum WhenFull {
    /** The channel is closed: no line may be missing. */
    CLOSE,
    /** The oldest lines are dropped: only the newest count. */
    DROP_OLDEST
  }

  private final LinkSocket socket;
  private final String name;
  private final WhenFull whenFull;
  private final BlockingQueue<byte[]> outbox;
  private final Thread writer;
  private @Nullable LineReader lines;
  private volatile boolean hasOverflowed;

  /**
   * @param name for the log and the writing thread
   * @param capacity how many lines may wait to be written
   */
  public LineChannel(LinkSocket socket, String name, int capacity, WhenFull whenFull) {
    this.socket = socket;
    this.name = name;
    this.whenFull = whenFull;
    outbox = new ArrayBlockingQueue<>(capacity);
    writer = Thread.ofVirtual().name(name + "-writer").unstarted(this::writeLines);
  }

  /** To be called once. */
  public void start() {
    writer.start();
  }

  /** Who is at the other end; null where the connection is not encrypted. */
  public @Nullable Fingerprint peer() {
    return socket.peer();
  }

  /**
   * Queues a line.
   *
   * @param line bytes of UTF-8 with their line feed
   * @return false: the queue was full, and the channel is closed
   */
  public boolean send(byte[] line) {
    while (!outbox.offer(line)) {
      if (whenFull == WhenFull.CLOSE) {
        hasOverflowed = true;
        close();
        return false;
      }
      outbox.poll();
    }
    return true;
  }

  /** Whether it was closed because the other end did not read. */
  public boolean hasOverflowed() {
    return hasOverflowed;
  }

  /**
   * The next line; waits for it.
   *
   * @return null at the end of the stream
   * @throws IOException if the connection breaks, or was closed here
   */
  public LineReader.@Nullable Line readLine() throws IOException {
    if (lines == null) {
      lines = new LineReader(socket.in());
    }
    return lines.readLine();
  }

  /** Whether the next line has come already; for the thread that reads. */
  public boolean hasLine() {
    return lines != null && lines.hasLine();
  }

  @Override
  public void close() {
    writer.interrupt();
    try {
      socket.close();
    } catch (IOException e) {
      log.debug("{}: closing the connection failed.", name, e);
    }
  }

  private void writeLines() {
    try {
      OutputStream out = socket.out();
      while (true) {
        out.write(outbox.take());
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (IOException e) {
      log.debug("{}: writing ended.", name, e);
    }
  }
}
