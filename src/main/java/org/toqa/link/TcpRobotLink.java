package org.toqa.link;

import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.link.channel.Backoff;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.ServerMessage;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** A link that connects, listens, and connects again, on a virtual thread of its own. */
final class TcpRobotLink implements RobotLink {
  private static final Logger log = LoggerFactory.getLogger(TcpRobotLink.class);

  private final RobotAddress address;
  private final RobotConnector connector;
  private final Listener listener;
  private final Backoff backoff = new Backoff();
  private final Thread thread;
  private volatile boolean closed;
  private volatile @Nullable RobotConnection connection;
  private @Nullable Sentence lastFailure;

  TcpRobotLink(RobotAddress address, RobotConnector connector, Listener listener) {
    this.address = address;
    this.connector = connector;
    this.listener = listener;
    thread = Thread.ofVirtual().name("link-" + address.robot()).unstarted(this::run);
  }

  void start() {
    thread.start();
  }

  @Override
  public void send(ServerMessage message) {
    RobotConnection now = connection;
    if (now != null) {
      now.send(message);
    }
  }

  @Override
  public void close() {
    closed = true;
    thread.interrupt(); // ends a wait, and a socket that is being connected or read
  }

  private void run() {
    while (!closed) {
      try {
        runConnection();
      } catch (LinkException e) {
        notifyListener(e.sentence(), e.isTrustFailure());
      } catch (RuntimeException e) { // else nobody would ever hear the robot again
        log.error("{}: what it said could not be taken; it is connected anew.", address.robot(), e);
        notifyListener(Phrase.CONNECTION_ENDED_BY_FAULT.with(address.robot()), false);
      }
      pause();
    }
  }

  private void runConnection() throws LinkException {
    long connectedAt = System.nanoTime();
    try (RobotConnection opened = RobotConnection.open(address, connector)) {
      var hello = opened.readHello();
      lastFailure = null;
      connection = opened;
      listener.connected(hello);
      while (!closed) {
        RobotConnection.Received next = opened.readNext();
        String fault = next.fault();
        if (next.superseded() > 0 || fault != null) {
          listener.passedOver(next.superseded(), fault == null ? 0 : 1);
        }
        if (fault != null) {
          listener.misunderstood(fault);
        }
        AgentMessage message = next.message();
        if (message != null && !listener.received(message)) {
          throw new LinkException(Phrase.SENDS_MORE_THAN_CAN_BE_TAKEN.with(address.robot()));
        }
      }
    } finally {
      connection = null;
      if (isLasting(connectedAt)) {
        backoff.reset();
      }
    }
  }

  /** One that ends sooner is made again later and later: a robot may do so all the time. */
  private static boolean isLasting(long connectedAt) {
    return System.nanoTime() - connectedAt > Backoff.LONGEST.toNanos() * 2;
  }

  /** Once for each reason, not once for each attempt. */
  private void notifyListener(Sentence sentence, boolean isTrustFailure) {
    if (closed || sentence.equals(lastFailure)) {
      return;
    }
    lastFailure = sentence;
    if (isTrustFailure) {
      listener.refused(sentence);
    } else {
      listener.disconnected(sentence);
    }
  }

  private void pause() {
    try {
      if (!closed) {
        Thread.sleep(backoff.nextDelay());
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // only close() interrupts, and the loop sees it
    }
  }
}
