package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.Socket;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Predicate;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Ack;
import org.toqa.link.message.AgentMessage.Done;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Reject;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.LineReader;
import org.toqa.link.message.LinkCodec;
import org.toqa.link.message.MessageReading.Understood;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.message.ServerMessage.Command;
import org.toqa.link.trust.LinkSocket;

/** A server's connection to one robot of a group whose world runs by itself. */
final class GroupServer implements AutoCloseable {

  private static final long LIMIT_NANOS = 20_000_000_000L;
  private static final long PING_NANOS = 20_000_000;
  private static final long FIRST_PING = 1_000_000_000;

  private final LinkSocket socket;
  private final List<AgentMessage> heard = new CopyOnWriteArrayList<>();
  private volatile boolean closed;

  /** A connection that is not encrypted. */
  static GroupServer plain(int port) {
    try {
      Socket socket = new Socket(InetAddress.getLoopbackAddress(), port);
      socket.setTcpNoDelay(true);
      return new GroupServer(LinkSocket.plain(socket));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  GroupServer(LinkSocket socket) {
    this.socket = socket;
    Thread.ofVirtual().start(this::read);
    Thread.ofVirtual().start(this::ping);
  }

  List<State> states() {
    return heard.stream().filter(State.class::isInstance).map(State.class::cast).toList();
  }

  List<Done> flags() {
    return heard.stream().filter(Done.class::isInstance).map(Done.class::cast).toList();
  }

  void accepted(Command command) {
    AgentMessage answer =
        await(
            m ->
                switch (m) {
                  case Ack(long seq) -> seq == command.seq();
                  case Reject(long seq, String _) -> seq == command.seq();
                  default -> false;
                },
            () -> say(command));
    if (answer instanceof Reject(long _, String reason)) {
      fail(reason);
    }
  }

  String refused(Command command) {
    return ((Reject)
            await(
                m -> m instanceof Reject(long seq, String _) && seq == command.seq(),
                () -> say(command)))
        .reason();
  }

  Hello awaitHello() {
    return (Hello) await(Hello.class::isInstance, () -> {});
  }

  /** Waits for a state that was not heard before. */
  State awaitState(Predicate<State> wished) {
    int known = heard.size();
    return (State)
        await(
            m -> m instanceof State state && heard.indexOf(m) >= known && wished.test(state),
            () -> {});
  }

  Done awaitFlag() {
    return (Done) await(Done.class::isInstance, () -> {});
  }

  @Override
  public void close() {
    closed = true;
    try {
      socket.close();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private AgentMessage await(Predicate<AgentMessage> wished, Runnable first) {
    first.run();
    long limit = System.nanoTime() + LIMIT_NANOS;
    while (System.nanoTime() < limit) {
      for (AgentMessage message : heard) {
        if (wished.test(message)) {
          return message;
        }
      }
      LockSupport.parkNanos(1_000_000);
    }
    return fail("It did not come; last heard: " + (heard.isEmpty() ? "nothing" : heard.getLast()));
  }

  private synchronized void say(ServerMessage message) {
    try {
      socket.out().write(LinkCodec.line(message));
    } catch (IOException e) {
      closed = true;
    }
  }

  private void ping() {
    for (long seq = FIRST_PING; !closed; seq++) {
      say(new ServerMessage.Ping(seq));
      LockSupport.parkNanos(PING_NANOS);
    }
  }

  private void read() {
    try {
      LineReader lines = new LineReader(socket.in());
      for (LineReader.Line line = lines.next(); line != null; line = lines.next()) {
        if (LinkCodec.agentMessage(line) instanceof Understood<AgentMessage>(var message)) {
          heard.add(message);
        }
      }
    } catch (IOException e) {
      closed = true;
    }
  }
}
