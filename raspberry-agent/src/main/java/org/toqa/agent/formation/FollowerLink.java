package org.toqa.agent.formation;

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
import org.toqa.link.message.AgentMessage.FollowerReport;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.DecodeResult.Decoded;
import org.toqa.link.message.LineReader;
import org.toqa.link.message.LinkCodec;
import org.toqa.link.message.ServerMessage.Follower;
import org.toqa.link.message.ServerMessage.LeaderMessage;
import org.toqa.link.trust.HandshakeException.Reason;
import org.toqa.link.trust.LinkSocket;
import org.toqa.link.trust.LinkTls;

/**
 * A leader's connection to one follower, made anew whenever it breaks. {@link #send} and {@link
 * #close} never wait; what cannot be sent at once is not sent later, since a place that is old
 * misleads.
 */
public final class FollowerLink implements AutoCloseable {

  private static final Logger log = LoggerFactory.getLogger(FollowerLink.class);

  private static final Duration RETRY_INTERVAL = Duration.ofMillis(250);

  /** Below a second of poses. */
  private static final int QUEUED_LINES = 4;

  /** A follower's answer, as the tick takes it. */
  public record Answer(String follower, FollowerReport report) {}

  private final String leader;
  private final Follower follower;
  private final FollowerConnector connector;
  private final BlockingQueue<Answer> answers;
  private final BlockingQueue<byte[]> outbox = new ArrayBlockingQueue<>(QUEUED_LINES);
  private final Thread thread;
  private volatile Socket socket = new Socket();
  private @Nullable Reason lastLoggedReason;

  /**
   * @param connector makes the connections
   * @param answers takes what the follower says, without waiting
   */
  FollowerLink(
      String leader,
      Follower follower,
      FollowerConnector connector,
      BlockingQueue<Answer> answers) {
    this.leader = leader;
    this.follower = follower;
    this.connector = connector;
    this.answers = answers;
    thread = Thread.ofVirtual().name(leader + "-to-" + follower.robot()).start(this::run);
  }

  String follower() {
    return follower.robot();
  }

  void send(LeaderMessage message) {
    byte[] line = LinkCodec.encode(message);
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
        runConnection(connector.connect(fresh, follower));
      } catch (IOException e) {
        logFailure(LinkTls.reasonOf(e), e);
      }
      try {
        Thread.sleep(RETRY_INTERVAL);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }
  }

  /** Once for each reason, not once for each attempt. */
  private void logFailure(Reason reason, IOException e) {
    if (reason == lastLoggedReason || Thread.currentThread().isInterrupted()) {
      log.debug("{}: the link to {} broke.", leader, follower.robot(), e);
    } else {
      log.warn("{}: the link to {} broke: {}", leader, follower.robot(), e.getMessage());
    }
    lastLoggedReason = reason;
  }

  private void runConnection(LinkSocket fresh) throws IOException {
    LineReader lines = new LineReader(fresh.in());
    AgentMessage first = decode(lines.readLine());
    if (!(first instanceof Hello hello) || !hello.robot().equals(follower.robot())) {
      log.warn(
          "{}: what answers at {}:{} is not {}.",
          leader,
          follower.host(),
          follower.port(),
          follower.robot());
      return;
    }
    lastLoggedReason = null;
    outbox.clear();
    Thread writer = Thread.ofVirtual().name(thread.getName() + "-writer").start(() -> write(fresh));
    try {
      for (LineReader.Line line = lines.readLine(); line != null; line = lines.readLine()) {
        if (decode(line) instanceof FollowerReport keep
            && !answers.offer(new Answer(follower.robot(), keep))) {
          log.warn("{}: an answer of {} was lost.", leader, follower.robot());
        }
      }
    } finally {
      writer.interrupt();
    }
  }

  private static @Nullable AgentMessage decode(LineReader.@Nullable Line line) {
    return line != null
            && LinkCodec.decodeAgentMessage(line) instanceof Decoded<AgentMessage>(var message)
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
