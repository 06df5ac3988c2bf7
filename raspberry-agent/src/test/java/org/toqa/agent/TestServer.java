package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Ack;
import org.toqa.link.message.AgentMessage.FollowerReport;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Reject;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.DecodeResult;
import org.toqa.link.message.LineReader;
import org.toqa.link.message.LinkCodec;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.message.ServerMessage.Command;
import org.toqa.motion.Segment;

/** The other end of the link, over a real socket. Its pings have numbers of their own. */
final class TestServer implements AutoCloseable {

  private static final Duration LIMIT = Duration.ofSeconds(10);
  private static final long FIRST_PING = 1_000_000_000;

  private final Rig rig;
  private final Socket socket;
  private final BlockingQueue<AgentMessage> incoming = new LinkedBlockingQueue<>();
  private final List<AgentMessage> received = new ArrayList<>();
  private @Nullable Hello hello;
  private volatile boolean ended;
  private long nextPing = FIRST_PING;

  TestServer(Rig rig) {
    this.rig = rig;
    try {
      socket = new Socket(InetAddress.getLoopbackAddress(), rig.daemon().port());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Begins to read; until then it is a server that connects and never listens. */
  void startReading() {
    Thread.ofVirtual().start(this::read);
  }

  void awaitHello() {
    hello = assertInstanceOf(Hello.class, await(m -> m instanceof Hello));
  }

  Hello hello() {
    return Objects.requireNonNull(hello);
  }

  /** Everything heard so far, oldest first. */
  List<AgentMessage> received() {
    synchronise();
    return List.copyOf(received);
  }

  <M extends AgentMessage> List<M> received(Class<M> type) {
    return received().stream().filter(type::isInstance).map(type::cast).toList();
  }

  /** The last state, no older than a fifth of a second of the robot's time. */
  State state() {
    return received(State.class).getLast();
  }

  Pose pose() {
    return state().pose();
  }

  /** Sends the command; what the robot answers to it at once. */
  AgentMessage ask(Command command) {
    send(command);
    return await(m -> isAnswer(m, command.seq()));
  }

  private static boolean isAnswer(AgentMessage message, long asked) {
    return switch (message) {
      case Ack(long seq) -> seq == asked;
      case Reject(long seq, String _) -> seq == asked;
      default -> false;
    };
  }

  void assertAccepted(Command command) {
    AgentMessage answer = ask(command);
    if (answer instanceof Reject(long _, String reason)) {
      fail(reason);
    }
  }

  /** Sends a command that is to be refused; why it was. */
  String rejectReason(Command command) {
    return assertInstanceOf(Reject.class, ask(command)).reason();
  }

  /** Says that the end of this drive is stored; it has arrived when this returns. */
  void acknowledge(long drive) {
    send(new ServerMessage.AckDone(drive));
    synchronise();
  }

  void send(ServerMessage message) {
    send(LinkCodec.encode(message));
  }

  /** Sends a line of text, whatever it is; the answer's reason. */
  String rejectReasonOfLine(String line) {
    send((line + "\n").getBytes(StandardCharsets.UTF_8));
    return assertInstanceOf(Reject.class, await(m -> m instanceof Reject)).reason();
  }

  void send(byte[] bytes) {
    try {
      socket.getOutputStream().write(bytes);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Time goes on while the server pings as servers do. */
  void advance(Duration time) {
    Duration ping = Duration.ofMillis(500);
    for (Duration left = time; left.isPositive(); left = left.minus(ping)) {
      rig.advance(left.compareTo(ping) < 0 ? left : ping);
      synchronise();
    }
  }

  /** Time goes on until a state is as wanted. */
  State advanceUntil(Predicate<State> wanted, Duration most) {
    Duration step = Duration.ofMillis(100);
    for (Duration left = most; left.isPositive(); left = left.minus(step)) {
      advance(step);
      if (wanted.test(state())) {
        return state();
      }
    }
    return fail("Not within " + most + "; the last state was " + state());
  }

  /** Waits, while no time of the robot passes, until the daemon has closed the connection. */
  void awaitEnd() {
    long limit = System.nanoTime() + LIMIT.toNanos();
    while (!ended) {
      rig.tickWithoutTime();
      drain();
      if (System.nanoTime() > limit) {
        fail("The connection was not closed.");
      }
    }
  }

  /** Everything that either side has said until now has arrived. */
  void synchronise() {
    ask(new ServerMessage.Ping(nextPing++));
  }

  /** The same for a leader, which is answered by a follower that is none of its own too. */
  void synchroniseAsLeader() {
    long task = nextPing++;
    send(new ServerMessage.FormationEnd(task));
    await(m -> m instanceof FollowerReport keep && keep.task() == task);
  }

  @Override
  public void close() {
    try {
      socket.close();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  static ServerMessage.Drive drive(
      long seq, @Nullable Long task, int phase, Pose start, List<Segment> segments) {
    return new ServerMessage.Drive(seq, task, phase, start, segments, segments.size(), true, 0);
  }

  private AgentMessage await(Predicate<AgentMessage> wanted) {
    long limit = System.nanoTime() + LIMIT.toNanos();
    while (System.nanoTime() < limit) {
      rig.tickWithoutTime();
      AgentMessage message = drain();
      if (message != null && wanted.test(message)) {
        return message;
      }
    }
    return fail(
        "The answer did not come; the connection %s; last heard was %s"
            .formatted(
                ended ? "has ended" : "lives", received.reversed().stream().limit(5).toList()));
  }

  private @Nullable AgentMessage drain() {
    try {
      AgentMessage message = incoming.poll(1, TimeUnit.MILLISECONDS);
      if (message != null) {
        received.add(message);
      }
      return message;
    } catch (InterruptedException e) {
      throw new AssertionError(e);
    }
  }

  private void read() {
    try {
      LineReader lines = new LineReader(socket.getInputStream());
      for (LineReader.Line line = lines.readLine(); line != null; line = lines.readLine()) {
        switch (LinkCodec.decodeAgentMessage(line)) {
          case DecodeResult.Decoded<AgentMessage>(AgentMessage message) -> incoming.add(message);
          case DecodeResult.Invalid<AgentMessage>(long _, String reason) ->
              throw new AssertionError(reason);
        }
      }
    } catch (IOException e) {
      // closed by either side: the same end
    } finally {
      ended = true;
    }
  }
}
