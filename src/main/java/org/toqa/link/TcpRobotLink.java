package org.toqa.link;

import org.jspecify.annotations.Nullable;
import org.toqa.link.message.ServerMessage;
import org.toqa.wording.Sentence;

/** A link that connects, listens, and connects again, on a virtual thread of its own. */
final class TcpRobotLink implements RobotLink {

  private final RobotAddress address;
  private final Dialer dialer;
  private final Listener listener;
  private final Backoff backoff = new Backoff();
  private final Thread thread;
  private volatile boolean closed;
  private volatile @Nullable RobotConnection connection;
  private @Nullable Sentence told;

  TcpRobotLink(RobotAddress address, Dialer dialer, Listener listener) {
    this.address = address;
    this.dialer = dialer;
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
        converse();
      } catch (LinkException e) {
        tell(e.sentence(), e.isRefusal());
      }
      pause();
    }
  }

  private void converse() throws LinkException {
    try (RobotConnection made = RobotConnection.open(address, dialer)) {
      var hello = made.hello();
      backoff.reset();
      told = null;
      connection = made;
      listener.connected(hello);
      while (!closed) {
        listener.received(made.next());
      }
    } finally {
      connection = null;
    }
  }

  /** Once for each reason, not once for each attempt. */
  private void tell(Sentence sentence, boolean refusal) {
    if (closed || sentence.equals(told)) {
      return;
    }
    told = sentence;
    if (refusal) {
      listener.refused(sentence);
    } else {
      listener.disconnected(sentence.english());
    }
  }

  private void pause() {
    try {
      if (!closed) {
        Thread.sleep(backoff.next());
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // only close() interrupts, and the loop sees it
    }
  }
}
