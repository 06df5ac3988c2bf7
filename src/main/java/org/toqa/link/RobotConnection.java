package org.toqa.link;

import java.io.IOException;
import java.net.SocketTimeoutException;
import java.time.Duration;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.link.channel.LineChannel;
import org.toqa.link.channel.LineChannel.WhenFull;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.DecodeResult;
import org.toqa.link.message.LineReader;
import org.toqa.link.message.LinkCodec;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.trust.HandshakeException.Reason;
import org.toqa.link.trust.LinkTls;
import org.toqa.wording.Phrase;

/** One TCP connection to a robot. The thread that made it reads; {@link #send} never waits. */
final class RobotConnection implements AutoCloseable {
  /** A robot is at most so wide, metres. */
  private static final double MAX_FOOTPRINT = 10;

  private static final Logger log = LoggerFactory.getLogger(RobotConnection.class);

  /**
   * A robot reports five times a second; with one that is silent for so long the link is broken.
   */
  private static final Duration SILENCE_TIMEOUT = Duration.ofSeconds(5);

  private static final int QUEUED_LINES = 1_000;

  private final RobotAddress address;
  private final String robot;
  private final String hostAndPort;
  private final LineChannel channel;

  /**
   * Connects; waits for it.
   *
   * @throws LinkException if the robot cannot be reached, or one end does not trust the other
   */
  static RobotConnection open(RobotAddress address, RobotConnector connector) throws LinkException {
    String name = "link-" + address.robot();
    LineChannel channel =
        new LineChannel(
            connector.connect(address, SILENCE_TIMEOUT), name, QUEUED_LINES, WhenFull.CLOSE);
    channel.start();
    return new RobotConnection(address, channel);
  }

  private RobotConnection(RobotAddress address, LineChannel channel) {
    this.address = address;
    this.robot = address.robot();
    this.hostAndPort = address.hostAndPort();
    this.channel = channel;
  }

  /**
   * The robot's first message; waits for it.
   *
   * @throws LinkException if it is no hello, or not that of the robot
   */
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
      throw LinkException.trustFailure(Phrase.HAS_ANOTHER_NAME.with(hostAndPort, robot));
    }
    if (!(hello.maxLoad() >= 0
        && hello.maxSpeed() > 0
        && hello.maxTurnRate() > 0
        && isValidFootprint(hello.footprint()))) {
      throw new LinkException(
          "%s says that it carries %s kg, drives %s m/s, turns %s rad/s and is %s m wide; correct its configuration."
              .formatted(
                  robot,
                  hello.maxLoad(),
                  hello.maxSpeed(),
                  hello.maxTurnRate(),
                  hello.footprint()));
    }
    return hello;
  }

  private static boolean isValidFootprint(double metres) {
    return metres > 0 && metres <= MAX_FOOTPRINT;
  }

  /**
   * The next valid message; waits for it.
   *
   * @throws LinkException if the connection ends, or nothing comes for too long
   */
  AgentMessage readMessage() throws LinkException {
    try {
      while (true) {
        LineReader.Line line = channel.readLine();
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
    if (channel.hasOverflowed()) {
      return new LinkException("%s does not take what it is told.".formatted(robot));
    }
    if (channel.peer() != null) { // with TLS 1.3 the robot's refusal comes with the first read
      Reason reason = LinkTls.reasonOf(e);
      return reason == Reason.CUT_OFF
          ? new LinkException("%s closed the connection.".formatted(robot))
          : RobotConnector.trustFailure(address, reason, e);
    }
    return new LinkException("The connection to %s broke: %s.".formatted(robot, e.getMessage()));
  }

  void send(ServerMessage message) {
    channel.send(LinkCodec.encode(message));
  }

  @Override
  public void close() {
    channel.close();
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
}
