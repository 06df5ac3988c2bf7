package org.toqa.link.gateway;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.time.Duration;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.link.trust.LinkSocket;

/**
 * Carries bytes both ways between two connections. It holds one buffer each way: an end that does
 * not read makes the other one wait, as one connection between the two would.
 */
final class Relay {
  private static final Logger log = LoggerFactory.getLogger(Relay.class);

  private static final int BUFFER_BYTES = 16 * 1024;

  /** When one end has said all, so long the other may go on. */
  private static final Duration LONGEST_FAREWELL = Duration.ofSeconds(2);

  private Relay() {}

  /** Returns when it is over, with both closed. */
  static void run(LinkSocket a, LinkSocket b) {
    try (a;
        b) {
      Thread back = Thread.startVirtualThread(() -> copy(b, a));
      copy(a, b);
      back.join();
    } catch (IOException e) {
      log.debug("A connection could not be closed.", e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private static void copy(LinkSocket from, LinkSocket to) {
    try {
      InputStream in = from.in();
      OutputStream out = to.out();
      byte[] buffer = new byte[BUFFER_BYTES];
      for (int read = in.read(buffer); read >= 0; read = in.read(buffer)) {
        out.write(buffer, 0, read);
      }
      limit(from, to);
      to.endOutput();
    } catch (IOException e) {
      log.debug("A link has ended.", e);
      close(from);
      close(to);
    }
  }

  /** Both are closed some time after one has ended, whatever the other end does. */
  @SuppressWarnings("resource") // they close the sockets
  private static void limit(LinkSocket from, LinkSocket to) {
    var _ = from.startTimeLimit(LONGEST_FAREWELL);
    var _ = to.startTimeLimit(LONGEST_FAREWELL);
  }

  private static void close(LinkSocket socket) {
    try {
      socket.close();
    } catch (IOException e) {
      log.debug("A connection could not be closed.", e);
    }
  }
}
