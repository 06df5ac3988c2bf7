package org.toqa.link;

import java.io.IOException;
import java.net.SocketTimeoutException;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
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
import org.toqa.wording.Sentence;

/** One TCP connection to a robot. The thread that made it reads; {@link #send} never waits. */
final class RobotConnection implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(RobotConnection.class);

  /**
   * A robot reports five times a second; with one that is silent for so long the link is broken.
   */
  private static final Duration SILENCE_TIMEOUT = Duration.ofSeconds(5);

  /** A daemon says hello at once; one that says nothing for so long waits for something. */
  private static final Duration LONG_SILENCE = Duration.ofSeconds(2);

  private static final Duration UNREADABLE_LOG_INTERVAL = Duration.ofSeconds(10);

  /** Between two looks at a connection whose lines come faster than they are read. */
  private static final long CROWDED_NANOS = 1_000_000;

  private static final int QUEUED_LINES = 1_000;

  private final RobotAddress address;
  private final String robot;
  private final String hostAndPort;
  private final LineChannel channel;
  private final double widestRobot;
  private final ReadingPace pace = new ReadingPace(System.nanoTime());

  /** A line that was read already, to see whether it supersedes the one before. */
  private LineReader.@Nullable Line ahead;

  private boolean hasGreeted;
  private long unreadable;

  /** What was wrong with the last line that was unreadable. */
  private String fault = "";

  private long unreadableLogged = System.nanoTime() - UNREADABLE_LOG_INTERVAL.toNanos();

  /**
   * A line of the robot.
   *
   * @param message null: the line cannot be understood
   * @param superseded states that were passed over before it, for newer ones had come
   * @param fault what is wrong with a line that cannot be understood
   */
  record Received(@Nullable AgentMessage message, int superseded, @Nullable String fault) {}

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
    return new RobotConnection(address, channel, connector.widestRobot());
  }

  private RobotConnection(RobotAddress address, LineChannel channel, double widestRobot) {
    this.address = address;
    this.robot = address.robot();
    this.hostAndPort = address.place();
    this.channel = channel;
    this.widestRobot = widestRobot;
  }

  /**
   * The robot's first message; waits for it.
   *
   * @throws LinkException if it is no hello, or not that of the robot
   */
  Hello readHello() throws LinkException {
    @Nullable AgentMessage first = readFirstMessage();
    if (!(first instanceof Hello hello)) {
      throw new LinkException(Phrase.SAYS_NO_HELLO.with(hostAndPort, robot));
    }
    if (hello.version() != AgentMessage.VERSION) {
      throw new LinkException(
          Phrase.SPEAKS_ANOTHER_VERSION.with(robot, hello.version(), AgentMessage.VERSION));
    }
    if (!hello.robot().equals(robot)) {
      throw LinkException.trustFailure(Phrase.HAS_ANOTHER_NAME.with(hostAndPort, robot));
    }
    Optional<Sentence> objection = RobotFigures.objection(hello, widestRobot);
    if (objection.isPresent()) {
      throw LinkException.trustFailure(objection.get());
    }
    hasGreeted = true;
    return hello;
  }

  /** A paired daemon waits for who shows who he is, and ends the connection then. */
  private @Nullable AgentMessage readFirstMessage() throws LinkException {
    long since = System.nanoTime();
    try {
      return readNext().message();
    } catch (LinkException e) {
      boolean hasWaited = System.nanoTime() - since >= LONG_SILENCE.toNanos();
      if (hasWaited && channel.peer() == null && unreadable == 0) {
        throw LinkException.trustFailure(Phrase.SAYS_NOTHING.with(robot, hostAndPort));
      }
      throw e;
    }
  }

  /**
   * Of a first line that cannot be understood: what is wrong with it, where it is a message at all.
   */
  private Sentence objectionToFirst(LineReader.Line line) {
    return line instanceof LineReader.Text(byte[] utf8) && utf8.length > 0 && utf8[0] == '{'
        ? Phrase.SAYS_WRONG_HELLO.with(robot, hostAndPort, fault)
        : Phrase.SAYS_NO_HELLO.with(hostAndPort, robot);
  }

  /**
   * The next line, of several states that have come the newest; waits for it.
   *
   * @throws LinkException if the connection ends, nothing comes for too long, or what comes first
   *     cannot be understood
   */
  Received readNext() throws LinkException {
    int superseded = 0;
    try {
      LineReader.Line line = nextLine();
      while (channel.hasLine()) {
        LineReader.Line next = nextLine();
        if (!StateLines.isSuperseded(line, next)) {
          ahead = next;
          break;
        }
        line = next;
        superseded++;
      }
      waitForTurn(superseded > 0);
      AgentMessage message = decode(line);
      if (message == null && !hasGreeted) {
        throw new LinkException(objectionToFirst(line));
      }
      return new Received(message, superseded, message == null ? fault : null);
    } catch (SocketTimeoutException e) {
      throw new LinkException(Phrase.HAS_FALLEN_SILENT.with(robot, SILENCE_TIMEOUT.toSeconds()));
    } catch (IOException e) {
      throw failure(e);
    }
  }

  private LineReader.Line nextLine() throws IOException, LinkException {
    LineReader.Line line = ahead == null ? channel.readLine() : ahead;
    ahead = null;
    if (line == null) {
      throw new LinkException(Phrase.CLOSED_THE_CONNECTION.with(robot));
    }
    return line;
  }

  /**
   * @param isCrowded lines come faster than they are read: others are read first
   */
  private void waitForTurn(boolean isCrowded) {
    long nanos = Math.max(pace.acquire(System.nanoTime()), isCrowded ? CROWDED_NANOS : 0);
    if (nanos > 0) {
      try {
        TimeUnit.NANOSECONDS.sleep(nanos);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt(); // the next read sees it
      }
    }
  }

  private LinkException failure(IOException e) {
    if (channel.hasOverflowed()) {
      return new LinkException(Phrase.TAKES_NO_COMMANDS.with(robot));
    }
    if (channel.peer() != null) { // with TLS 1.3 the robot's refusal comes with the first read
      Reason reason = LinkTls.reasonOf(e);
      return reason == Reason.CUT_OFF
          ? new LinkException(Phrase.CLOSED_THE_CONNECTION.with(robot))
          : RobotConnector.trustFailure(address, reason, e);
    }
    return new LinkException(Phrase.CONNECTION_BROKE.with(robot, String.valueOf(e.getMessage())));
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
      case DecodeResult.Decoded<AgentMessage>(AgentMessage message) -> {
        Optional<String> objection = RobotFigures.objection(message);
        objection.ifPresent(this::logUnreadable);
        yield objection.isPresent() ? null : message;
      }
      case DecodeResult.Invalid<AgentMessage>(long _, String reason) -> {
        logUnreadable(reason);
        yield null;
      }
    };
  }

  /** Of many lines a few. */
  private void logUnreadable(String reason) {
    unreadable++;
    fault = reason;
    long now = System.nanoTime();
    if (now - unreadableLogged >= UNREADABLE_LOG_INTERVAL.toNanos()) {
      log.warn("{}: a line of the robot was ignored, number {}: {}", robot, unreadable, reason);
      unreadableLogged = now;
    }
  }
}
