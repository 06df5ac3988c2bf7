package org.toqa.link;

import java.io.IOException;
import java.io.OutputStream;
import java.net.SocketTimeoutException;
import java.time.Duration;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.DecodeResult;
import org.toqa.link.message.LineReader;
import org.toqa.link.message.LinkCodec;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.trust.HandshakeException.Reason;
import org.toqa.link.trust.LinkSocket;
import org.toqa.link.trust.LinkTls;

/**
 * One TCP connection to a robot. The thread that made it reads; another one writes what was queued,
 * so that {@link #send} never waits.
 */
final class RobotConnection implements AutoCloseable {
  /** A robot is at most so wide, metres. */
  private static final double MAX_FOOTPRINT = 10;

  private static final Logger log = LoggerFactory.getLogger(RobotConnection.class);

  /** A robot speaks five times a second; one that is silent for so long is behind a dead link. */
  private static final Duration SILENCE_TIMEOUT = Duration.ofSeconds(5);

  private static final int QUEUED_LINES = 1_000;

  private final RobotAddress address;
  private final String robot;
  private final String hostAndPort;
  private final LinkSocket socket;
  private final LineReader lines;
  private final BlockingQueue<byte[]> outbox = new ArrayBlockingQueue<>(QUEUED_LINES);
  private final Thread writer;
  private volatile boolean hasOverflowed;

  /** Connects; waits for it. */
  static RobotConnection open(RobotAddress address, RobotConnector connector) throws LinkException {
    LinkSocket socket = connector.connect(address, SILENCE_TIMEOUT);
    try {
      return new RobotConnection(address, socket);
    } catch (IOException e) {
      closeQuietly(socket);
      throw new LinkException(
          "The connection to %s broke: %s.".formatted(address.robot(), e.getMessage()));
    }
  }

  private RobotConnection(RobotAddress address, LinkSocket socket) throws IOException {
    this.address = address;
    this.robot = address.robot();
    this.hostAndPort = address.hostAndPort();
    this.socket = socket;
    lines = new LineReader(socket.in());
    writer = Thread.ofVirtual().name("link-" + robot + "-writer").start(this::writeLines);
  }

  /** The robot's first line. */
  Hello readHello() throws LinkException {
    AgentMessage first = readMessage();
    if (!(first instanceof Hello hello)) {
      throw new LinkException(
          "What answers at %s is not %s: it did not say hello.".formatted(hostAndPort, robot));
    }
    if (hello.version() != AgentMessage.VERSION) {
      throw new LinkException(
          "%s speaks version %d of the robot link, this server version %d; update the older one."
              .formatted(robot, hello.version(), AgentMessage.VERSION));
    }
    if (!hello.robot().equals(robot)) {
      throw new LinkException(
          "At %s answers robot %s, not %s; correct the address or the name."
              .formatted(hostAndPort, hello.robot(), robot));
    }
    if (!(hello.maxLoad() >= 0 && hello.maxSpeed() > 0 && isValidFootprint(hello.footprint()))) {
      throw new LinkException(
          "%s says that it carries %s kg, drives %s m/s and is %s m wide; correct its configuration."
              .formatted(robot, hello.maxLoad(), hello.maxSpeed(), hello.footprint()));
    }
    return hello;
  }

  private static boolean isValidFootprint(double metres) {
    return metres > 0 && metres <= MAX_FOOTPRINT;
  }

  /** The next message that can be understood; waits for it. */
  AgentMessage readMessage() throws LinkException {
    try {
      while (true) {
        LineReader.Line line = lines.readLine();
        if (line == null) {
          throw new LinkException("%s closed the connection.".formatted(robot));
        }
        AgentMessage message = decode(line);
        if (message != null) {
          return message;
        }
      }
    } catch (SocketTimeoutException e) {
      throw new LinkException(
          "%s has said nothing for %d s.".formatted(robot, SILENCE_TIMEOUT.toSeconds()));
    } catch (IOException e) {
      throw failure(e);
    }
  }

  private LinkException failure(IOException e) {
    if (hasOverflowed) {
      return new LinkException("%s does not take what it is told.".formatted(robot));
    }
    if (socket.peer() != null) { // with TLS 1.3 the robot's no comes when it is first read
      Reason reason = LinkTls.reasonOf(e);
      return reason == Reason.CUT_OFF
          ? new LinkException("%s closed the connection.".formatted(robot))
          : RobotConnector.trustFailure(address, reason, e);
    }
    return new LinkException("The connection to %s broke: %s.".formatted(robot, e.getMessage()));
  }

  void send(ServerMessage message) {
    if (!outbox.offer(LinkCodec.encode(message))) {
      hasOverflowed = true;
      close();
    }
  }

  @Override
  public void close() {
    writer.interrupt();
    closeQuietly(socket);
  }

  private @Nullable AgentMessage decode(LineReader.Line line) {
    return switch (LinkCodec.decodeAgentMessage(line)) {
      case DecodeResult.Decoded<AgentMessage>(AgentMessage message) -> message;
      case DecodeResult.Invalid<AgentMessage>(long _, String reason) -> {
        log.warn("{}: a line of the robot was ignored: {}", robot, reason);
        yield null;
      }
    };
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
      log.debug("{}: writing ended.", robot, e);
    }
  }

  private static void closeQuietly(LinkSocket socket) {
    try {
      socket.close();
    } catch (IOException e) {
      log.debug("Closing a socket failed.", e);
    }
  }
}
