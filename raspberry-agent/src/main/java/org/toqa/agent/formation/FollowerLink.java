package org.toqa.agent.formation;

import java.io.IOException;
import java.net.Socket;
import java.time.Duration;
import java.util.concurrent.BlockingQueue;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.link.channel.LineChannel;
import org.toqa.link.channel.LineChannel.WhenFull;
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
 * #close} never wait; what cannot be sent at once is not sent later, since an old pose misleads.
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
  private final Thread thread;
  private volatile Socket socket = new Socket();

  /** Null while the follower has not said hello. */
  private volatile @Nullable LineChannel channel;

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
    thread = Thread.ofVirtual().name(leader + "-to-" + follower.robot()).unstarted(this::run);
    thread.start(); // only now, since what it runs asks for it
  }

  String follower() {
    return follower.robot();
  }

  void send(LeaderMessage message) {
    LineChannel connected = channel;
    if (connected != null) {
      connected.send(LinkCodec.encode(message));
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
      } catch (RuntimeException e) { // else it would never connect again
        log.error("{}: the link to {} failed.", leader, follower.robot(), e);
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
    try (LineChannel opened =
        new LineChannel(fresh, thread.getName(), QUEUED_LINES, WhenFull.DROP_OLDEST)) {
      AgentMessage first = decode(opened.readLine());
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
      opened.start();
      channel = opened;
      readAnswers(opened);
    } finally {
      channel = null;
    }
  }

  private void readAnswers(LineChannel from) throws IOException {
    for (LineReader.Line line = from.readLine(); line != null; line = from.readLine()) {
      if (decode(line) instanceof FollowerReport report
          && !answers.offer(new Answer(follower.robot(), report))) {
        log.warn("{}: an answer of {} was lost.", leader, follower.robot());
      }
    }
  }

  private static @Nullable AgentMessage decode(LineReader.@Nullable Line line) {
    return line != null
            && LinkCodec.decodeAgentMessage(line) instanceof Decoded<AgentMessage>(var message)
        ? message
        : null;
  }

  private void closeSocket() {
    try {
      socket.close();
    } catch (IOException e) {
      log.debug("{}: closing the link to {} failed.", leader, follower.robot(), e);
    }
  }
}
