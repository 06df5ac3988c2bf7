package org.toqa.agent;

import java.io.IOException;
import java.io.OutputStream;
import java.net.Socket;
import java.time.Duration;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Keep;
import org.toqa.link.message.LineReader;
import org.toqa.link.message.LinkCodec;
import org.toqa.link.message.MessageReading.Understood;
import org.toqa.link.message.ServerMessage.Follower;
import org.toqa.link.message.ServerMessage.FromLeader;
import org.toqa.link.trust.HandshakeException.Reason;
import org.toqa.link.trust.LinkSocket;
import org.toqa.link.trust.LinkTls;

/**
 * A leader's connection to one follower, made anew whenever it breaks. {@link #send} and {@link
 * #close} never wait; what cannot be sent at once is not sent later, since a place that is old
 * misleads.
 */
final class FollowerLink implements AutoCloseable {

  private static final Logger log = LoggerFactory.getLogger(FollowerLink.class);

  private static final Duration BETWEEN_TRIES = Duration.ofMillis(250);

  /** Below a second of poses. */
  private static final int QUEUED_LINES = 4;

  /** A follower's answer, as the tick takes it. */
  record Answer(String follower, Keep keep) {}

  private final String leader;
  private final Follower follower;
  private final Dialer dialer;
  private final BlockingQueue<Answer> answers;
  private final BlockingQueue<byte[]> outbox = new ArrayBlockingQueue<>(QUEUED_LINES);
  private final Thread thread;
  private volatile Socket socket = new Socket();
  private @Nullable Reason told;

  /**
   * @param dialer makes the connections
   * @param answers takes what the follower says, without waiting
   */
  FollowerLink(String leader, Follower follower, Dialer dialer, BlockingQueue<Answer> answers) {
    this.leader = leader;
    this.follower = follower;
    this.dialer = dialer;
    this.answers = answers;
    thread = Thread.ofVirtual().name(leader + "-to-" + follower.robot()).start(this::run);
  }

  String follower() {
    return follower.robot();
  }

  void send(FromLeader message) {
    byte[] line = LinkCodec.line(message);
    while (!outbox.offer(line)) {
      outbox.poll();
    }
  }

  @Override
  public void close() {
    thread.interrupt();
    closeSocket();
  }

  private void run() {
    while (!Thread.currentThread().isInterrupted()) {
      try (Socket fresh = new Socket()) {
        socket = fresh;
        converse(dialer.connect(fresh, follower));
      } catch (IOException e) {
        tell(LinkTls.reasonOf(e), e);
      }
      try {
        Thread.sleep(BETWEEN_TRIES);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }
  }

  /** Once for each reason, not once for each attempt. */
  private void tell(Reason reason, IOException e) {
    if (reason == told || Thread.currentThread().isInterrupted()) {
      log.debug("{}: the link to {} broke.", leader, follower.robot(), e);
    } else {
      log.warn("{}: the link to {} broke: {}", leader, follower.robot(), e.getMessage());
    }
    told = reason;
  }

  private void converse(LinkSocket fresh) throws IOException {
    LineReader lines = new LineReader(fresh.in());
    AgentMessage first = understood(lines.next());
    if (!(first instanceof Hello hello) || !hello.robot().equals(follower.robot())) {
      log.warn(
          "{}: what answers at {}:{} is not {}.",
          leader,
          follower.host(),
          follower.port(),
          follower.robot());
      return;
    }
    told = null;
    outbox.clear();
    Thread writer = Thread.ofVirtual().name(thread.getName() + "-writer").start(() -> write(fresh));
    try {
      for (LineReader.Line line = lines.next(); line != null; line = lines.next()) {
        if (understood(line) instanceof Keep keep
            && !answers.offer(new Answer(follower.robot(), keep))) {
          log.warn("{}: an answer of {} was lost.", leader, follower.robot());
        }
      }
    } finally {
      writer.interrupt();
    }
  }

  private static @Nullable AgentMessage understood(LineReader.@Nullable Line line) {
    return line != null
            && LinkCodec.agentMessage(line) instanceof Understood<AgentMessage>(var message)
        ? message
        : null;
  }

  private void write(LinkSocket fresh) {
    try {
      OutputStream out = fresh.out();
      while (true) {
        out.write(outbox.take());
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (IOException e) {
      log.debug("{}: writing to {} ended.", leader, follower.robot(), e);
    }
  }

  private void closeSocket() {
    try {
      socket.close();
    } catch (IOException e) {
      log.debug("{}: closing the link to {} failed.", leader, follower.robot(), e);
    }
  }
}
