package org.toqa.agent.routing;

import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.ByteBuffer;
import java.nio.channels.SelectionKey;
import java.nio.channels.Selector;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;

/**
 * The local interface of a babeld that runs (babeld(8), protocol 1.0), read only: after its
 * greeting it answers each request by lines, the last of which is {@code ok}. For one thread; an
 * interrupt ends a wait with an {@link IOException}.
 */
final class LocalInterface implements AutoCloseable {

  private static final int MOST_BYTES = 4_000_000;
  private static final byte[] DUMP = "dump\n".getBytes(StandardCharsets.US_ASCII);
  private static final List<String> REFUSALS = List.of("no", "bad");

  private final SocketChannel channel;
  private final Selector selector;
  private final Duration limit;

  /**
   * Connects, and reads the greeting.
   *
   * @param limit of each answer
   * @throws IOException nothing listens there, or it is no babeld
   */
  LocalInterface(Path socket, Duration limit) throws IOException {
    this.limit = limit;
    channel = SocketChannel.open(StandardProtocolFamily.UNIX);
    try {
      channel.connect(UnixDomainSocketAddress.of(socket));
      channel.configureBlocking(false);
      selector = Selector.open();
    } catch (IOException e) {
      channel.close();
      throw e;
    }
    try {
      channel.register(selector, SelectionKey.OP_READ);
      List<String> greeting = answer();
      if (greeting.isEmpty() || !greeting.getFirst().startsWith("BABEL 1.")) {
        throw new IOException("it does not speak the protocol 1 of babeld");
      }
    } catch (IOException e) {
      close();
      throw e;
    }
  }

  /** All that it knows now. */
  RouteTable table() throws IOException {
    if (channel.write(ByteBuffer.wrap(DUMP)) < DUMP.length) {
      throw new IOException("it takes no request");
    }
    return RouteTable.parse(answer());
  }

  /** The lines of an answer, without its last. */
  private List<String> answer() throws IOException {
    long end = System.nanoTime() + limit.toNanos();
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    ByteBuffer part = ByteBuffer.allocate(16_384);
    while (true) {
      long left = (end - System.nanoTime()) / 1_000_000;
      if (left <= 0 || bytes.size() > MOST_BYTES || Thread.currentThread().isInterrupted()) {
        throw new IOException("it does not answer");
      }
      selector.select(left);
      selector.selectedKeys().clear();
      if (channel.read(part.clear()) < 0) {
        throw new EOFException("it has closed its local interface");
      }
      bytes.write(part.array(), 0, part.position());
      String text = bytes.toString(StandardCharsets.UTF_8);
      if (text.endsWith("\n")) {
        List<String> lines = text.lines().toList();
        String last = lines.getLast().split(" ", 2)[0];
        if (last.equals("ok")) {
          return lines.subList(0, lines.size() - 1);
        }
        if (REFUSALS.contains(last)) {
          throw new IOException("it refuses to tell its routes: " + lines.getLast());
        }
      }
    }
  }

  @Override
  public void close() throws IOException {
    channel.close();
    selector.close();
  }
}
