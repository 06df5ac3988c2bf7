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
import org.toqa.link.message.DecodeResult.Decoded;
import org.toqa.link.message.LineReader;
import org.toqa.link.message.LinkCodec;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.message.ServerMessage.Command;
import org.toqa.link.trust.LinkSocket;

/** A server's connection to one robot of a group whose world runs by itself. */
public final class FormationServer implements AutoCloseable {

  private static final long LIMIT_NANOS = 20_000_000_000L;
  private static final long PING_NANOS = 20_000_000;
  private static final long FIRST_PING = 1_000_000_000;

  private final LinkSocket socket;
  private final List<AgentMessage> received = new CopyOnWriteArrayList<>();
  private volatile boolean closed;

  /** A connection that is not encrypted. */
  static FormationServer plain(int port) {
    try {
      Socket socket = new Socket(InetAddress.getLoopbackAddress(), port);
      socket.setTcpNoDelay(true);
      return new FormationServer(LinkSocket.plain(socket));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  public FormationServer(LinkSocket socket) {
    this.socket = socket;
    Thread.ofVirtual().start(this::read);
    Thread.ofVirtual().start(this::ping);
  }

  public List<State> states() {
    return received.stream().filter(State.class::isInstance).map(State.class::cast).toList();
  }

  List<Done> dones() {
    return received.stream().filter(Done.class::isInstance).map(Done.class::cast).toList();
  }

  public void assertAccepted(Command command) {
    AgentMessage answer =
        await(
            m ->
                switch (m) {
                  case Ack(long seq) -> seq == command.seq();
                  case Reject(long seq, String _) -> seq == command.seq();
                  default -> false;
                },
            () -> send(command));
    if (answer instanceof Reject(long _, String reason)) {
      fail(reason);
    }
  }

  String rejectReason(Command command) {
    return ((Reject)
            await(
                m -> m instanceof Reject(long seq, String _) && seq == command.seq(),
                () -> send(command)))
        .reason();
  }

  public Hello awaitHello() {
    return (Hello) await(Hello.class::isInstance, () -> {});
  }

  /** Waits for a state that was not heard before. */
  public State awaitState(Predicate<State> wanted) {
    int known = received.size();
    return (State)
        await(
            m -> m instanceof State state && received.indexOf(m) >= known && wanted.test(state),
            () -> {});
  }

  Done awaitDone() {
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

  private AgentMessage await(Predicate<AgentMessage> wanted, Runnable first) {
    first.run();
    long limit = System.nanoTime() + LIMIT_NANOS;
    while (System.nanoTime() < limit) {
      for (AgentMessage message : received) {
        if (wanted.test(message)) {
          return message;
        }
      }
      LockSupport.parkNanos(1_000_000);
    }
    return fail(
        "It did not come; last heard: " + (received.isEmpty() ? "nothing" : received.getLast()));
  }

  private synchronized void send(ServerMessage message) {
    try {
      socket.out().write(LinkCodec.encode(message));
    } catch (IOException e) {
      closed = true;
    }
  }

  private void ping() {
    for (long seq = FIRST_PING; !closed; seq++) {
      send(new ServerMessage.Ping(seq));
      LockSupport.parkNanos(PING_NANOS);
    }
  }

  private void read() {
    try {
      LineReader lines = new LineReader(socket.in());
      for (LineReader.Line line = lines.readLine(); line != null; line = lines.readLine()) {
        if (LinkCodec.decodeAgentMessage(line) instanceof Decoded<AgentMessage>(var message)) {
          received.add(message);
        }
      }
    } catch (IOException e) {
      closed = true;
    }
  }
}
