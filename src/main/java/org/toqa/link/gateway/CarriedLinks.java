package org.toqa.link.gateway;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.net.UnknownHostException;
import java.time.Duration;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Semaphore;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.link.channel.LineChannel;
import org.toqa.link.message.GatewayMessage.NotOpened;
import org.toqa.link.message.GatewayMessage.Open;
import org.toqa.link.message.GatewayMessage.Reason;
import org.toqa.link.message.GatewayMessage.Stream;
import org.toqa.link.message.LinkCodec;
import org.toqa.link.trust.LinkSocket;

/** The links that a gateway carries for one connection of its server; each has a thread. */
final class CarriedLinks implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(CarriedLinks.class);

  static final int MAX_LINKS = 1_024;

  private static final Duration CONNECT_LIMIT = Duration.ofSeconds(3);

  private final AllowedAddresses allowed;
  private final Dialler dialler;
  private final LineChannel answers;
  private final Semaphore places = new Semaphore(MAX_LINKS);
  private final Set<AutoCloseable> connections = ConcurrentHashMap.newKeySet();

  /** Addresses that are not allowed, of which the log has a line. */
  private final Set<String> told = ConcurrentHashMap.newKeySet();

  private volatile boolean isClosed;

  /** Makes connections to the server. */
  @FunctionalInterface
  interface Dialler {
    LinkSocket dial() throws IOException, InterruptedException;
  }

  CarriedLinks(AllowedAddresses allowed, Dialler dialler, LineChannel answers) {
    this.allowed = allowed;
    this.dialler = dialler;
    this.answers = answers;
  }

  /** Does not wait for it. */
  void open(Open asked) {
    if (!places.tryAcquire()) {
      refuse(asked, Reason.TOO_MANY_LINKS, "");
      return;
    }
    Thread.ofVirtual()
        .name("stream-" + asked.stream())
        .start(
            () -> {
              try {
                carry(asked);
              } finally {
                places.release();
              }
            });
  }

  private void carry(Open asked) {
    Socket robot = new Socket();
    try {
      Optional<InetAddress> address = allowed.find(asked.host(), asked.port());
      if (address.isEmpty()) {
        tellNotAllowed(asked.host() + ":" + asked.port());
        refuse(asked, Reason.NOT_ALLOWED, "");
        return;
      }
      add(robot);
      robot.setTcpNoDelay(true);
      robot.connect(
          new InetSocketAddress(address.get(), asked.port()), (int) CONNECT_LIMIT.toMillis());
      relay(asked, robot);
    } catch (UnknownHostException e) {
      refuse(asked, Reason.HOST_NOT_KNOWN, "");
    } catch (SocketTimeoutException e) {
      refuse(asked, Reason.DOES_NOT_ANSWER, "");
    } catch (IOException e) {
      refuse(asked, Reason.CANNOT_BE_REACHED, String.valueOf(e.getMessage()));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      remove(robot);
    }
  }

  /** Once, though the server asks for it every few seconds; of very many, not of all. */
  private void tellNotAllowed(String address) {
    if (told.size() < MAX_LINKS && told.add(address)) {
      log.warn("The server asks for {}, which the configuration does not allow.", address);
    }
  }

  private void relay(Open asked, Socket robot) throws IOException, InterruptedException {
    LinkSocket server = dialler.dial();
    try {
      add(server);
      server.out().write(LinkCodec.encode(new Stream(asked.stream())));
      Relay.run(server, LinkSocket.plain(robot));
    } finally {
      remove(server);
    }
  }

  private void refuse(Open asked, Reason reason, String text) {
    answers.send(LinkCodec.encode(new NotOpened(asked.stream(), reason, text)));
  }

  private void add(AutoCloseable connection) throws IOException {
    connections.add(connection);
    if (isClosed) {
      throw new IOException("the connection to the server has ended");
    }
  }

  private void remove(AutoCloseable connection) {
    connections.remove(connection);
    GatewayConnection.closeQuietly(connection);
  }

  @Override
  public void close() {
    isClosed = true;
    connections.forEach(GatewayConnection::closeQuietly);
  }
}
