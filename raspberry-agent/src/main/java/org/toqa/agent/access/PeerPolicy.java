package org.toqa.agent.access;

import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.ReentrantLock;
import org.jspecify.annotations.Nullable;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.LinkTls;
import org.toqa.link.trust.PeerVerifier;

/**
 * Who may connect over an encrypted link: the paired server, the leader that it has named, and
 * anybody who wants to pair, since pairing has a check of its own.
 */
final class PeerPolicy implements PeerVerifier {

  /** A leader may connect before the server's message has named it. */
  private static final Duration LEADER_TIMEOUT = Duration.ofSeconds(1);

  private final ServerPin pin;
  private final Lock lock = new ReentrantLock();
  private final Condition leaderNamed = lock.newCondition();
  private @Nullable Fingerprint leader;

  PeerPolicy(ServerPin pin) {
    this.pin = pin;
  }

  @Override
  public boolean isTrusted(Fingerprint peer, String protocol) {
    return protocol.equals(LinkTls.PAIRING)
        || roleOf(peer) != PeerRole.UNTRUSTED
        || awaitLeader(peer);
  }

  PeerRole roleOf(Fingerprint peer) {
    if (pin.server().equals(Optional.of(peer))) {
      return PeerRole.SERVER;
    }
    lock.lock();
    try {
      return peer.equals(leader) ? PeerRole.LEADER : PeerRole.UNTRUSTED;
    } finally {
      lock.unlock();
    }
  }

  void setLeader(Fingerprint named) {
    lock.lock();
    try {
      leader = named;
      leaderNamed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  /** From now on this is the robot's only server; it has named no leader yet. */
  void setServer(Fingerprint server) throws IOException {
    pin.save(server);
    lock.lock();
    try {
      leader = null;
    } finally {
      lock.unlock();
    }
  }

  private boolean awaitLeader(Fingerprint peer) {
    lock.lock();
    try {
      long left = LEADER_TIMEOUT.toNanos();
      while (!peer.equals(leader) && left > 0) {
        left = leaderNamed.awaitNanos(left);
      }
      return peer.equals(leader);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    } finally {
      lock.unlock();
    }
  }
}
