package org.toqa.link;

import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.net.UnknownHostException;
import java.time.Duration;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.LineReader;
import org.toqa.link.message.LinkCodec;
import org.toqa.link.message.MessageReading;
import org.toqa.link.message.ServerMessage;

/**
 * One TCP connection to a robot. The thread that made it reads; another one writes what was queued,
 * so that {@link #send} never waits.
 */
final class RobotConnection implements AutoCloseable {
  /** A robot is at most so wide, metres. */
  private static final double WIDEST = 10;

  private static final Logger log = LoggerFactory.getLogger(RobotConnection.class);

  private static final Duration CONNECT_LIMIT = Duration.ofSeconds(3);

  /** A robot speaks five times a second; one that is silent for so long is behind a dead link. */
  private static final Duration SILENCE_LIMIT = Duration.ofSeconds(5);

  private static final int QUEUED_LINES = 1_000;

  private final String robot;
  private final String place;
  private final Socket socket;
  private final LineReader lines;
  private final BlockingQueue<byte[]> outbox = new ArrayBlockingQueue<>(QUEUED_LINES);
  private final Thread writer;
  private volatile boolean overflowed;

  /** Connects; waits for it. */
  static RobotConnection open(String robot, String host, int port, boolean offLoopbackToo)
      throws LinkException {
    String place = host + ":" + port;
    Socket socket = new Socket();
    try {
      InetAddress address = InetAddress.getByName(host);
      if (!address.isLoopbackAddress() && !offLoopbackToo) {
        throw new LinkException(
            "%s is on another machine (%s), and the link is not encrypted; the server's configuration must allow that by name."
                .formatted(robot, place));
      }
      socket.setTcpNoDelay(true);
      socket.setSoTimeout((int) SILENCE_LIMIT.toMillis());
      socket.connect(new InetSocketAddress(address, port), (int) CONNECT_LIMIT.toMillis());
      return new RobotConnection(robot, place, socket);
    } catch (LinkException | IOException e) {
      closeQuietly(socket);
      throw asSentence(e, robot, place, host);
    }
  }

  private RobotConnection(String robot, String place, Socket socket) throws IOException {
    this.robot = robot;
    this.place = place;
    this.socket = socket;
    lines = new LineReader(socket.getInputStream());
    writer = Thread.ofVirtual().name("link-" + robot + "-writer").start(this::write);
  }

  /** The robot's first line. */
  Hello hello() throws LinkException {
    AgentMessage first = next();
    if (!(first instanceof Hello hello)) {
      throw new LinkException(
          "What answers at %s is not %s: it did not say hello.".formatted(place, robot));
    }
    if (hello.version() != AgentMessage.VERSION) {
      throw new LinkException(
          "%s speaks version %d of the robot link, this server version %d; update the older one."
              .formatted(robot, hello.version(), AgentMessage.VERSION));
    }
    if (!hello.robot().equals(robot)) {
      throw new LinkException(
          "At %s answers robot %s, not %s; correct the address or the name."
              .formatted(place, hello.robot(), robot));
    }
    if (!(hello.maxLoad() >= 0 && hello.maxSpeed() > 0 && isSize(hello.footprint()))) {
      throw new LinkException(
          "%s says that it carries %s kg, drives %s m/s and is %s m wide; correct its configuration."
              .formatted(robot, hello.maxLoad(), hello.maxSpeed(), hello.footprint()));
    }
    return hello;
  }

  private static boolean isSize(double metres) {
    return metres > 0 && metres <= WIDEST;
  }

  /** The next message that can be understood; waits for it. */
  AgentMessage next() throws LinkException {
    try {
      while (true) {
        LineReader.Line line = lines.next();
        if (line == null) {
          throw new LinkException("%s closed the connection.".formatted(robot));
        }
        AgentMessage message = understood(line);
        if (message != null) {
          return message;
        }
      }
    } catch (SocketTimeoutException e) {
      throw new LinkException(
          "%s has said nothing for %d s.".formatted(robot, SILENCE_LIMIT.toSeconds()));
    } catch (IOException e) {
      throw new LinkException(
          overflowed
              ? "%s does not take what it is told.".formatted(robot)
              : "The connection to %s broke: %s.".formatted(robot, e.getMessage()));
    }
  }

  void send(ServerMessage message) {
    if (!outbox.offer(LinkCodec.line(message))) {
      overflowed = true;
      close();
    }
  }

  @Override
  public void close() {
    writer.interrupt();
    closeQuietly(socket);
  }

  private @Nullable AgentMessage understood(LineReader.Line line) {
    return switch (LinkCodec.agentMessage(line)) {
      case MessageReading.Understood<AgentMessage>(AgentMessage message) -> message;
      case MessageReading.Refused<AgentMessage>(long _, String reason) -> {
        log.warn("{}: a line of the robot was ignored: {}", robot, reason);
        yield null;
      }
    };
  }

  private void write() {
    try {
      OutputStream out = socket.getOutputStream();
      while (true) {
        out.write(outbox.take());
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (IOException e) {
      log.debug("{}: writing ended.", robot, e);
    }
  }

  private static LinkException asSentence(Exception e, String robot, String place, String host) {
    return switch (e) {
      case LinkException sentence -> sentence;
      case UnknownHostException _ ->
          new LinkException("The host %s of %s is not known.".formatted(host, robot));
      case SocketTimeoutException _ ->
          new LinkException("%s does not answer at %s.".formatted(robot, place));
      default ->
          new LinkException(
              "%s cannot be reached at %s: %s.".formatted(robot, place, e.getMessage()));
    };
  }

  private static void closeQuietly(Socket socket) {
    try {
      socket.close();
    } catch (IOException e) {
      log.debug("Closing a socket failed.", e);
    }
  }
}
