package org.toqa.fleet;

import java.time.InstantSource;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Predicate;
import org.toqa.link.PairingResult;
import org.toqa.link.RobotAddress;
import org.toqa.link.RobotLink;
import org.toqa.link.RobotLinkFactory;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Ack;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Reject;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.message.ServerMessage.Command;
import org.toqa.link.trust.PairingCode;
import org.toqa.wording.Sentence;

/**
 * Links that know how far behind the world they are. In a world that waits until they are settled
 * no command and no report is later than a step, however slow the machine.
 */
final class SteppedLinks implements RobotLinkFactory {
  /** Reports come every 200 ms; a step after that the next one is there. */
  private static final long OLDEST_REPORT_MILLIS = 220;

  private final RobotLinkFactory real;
  private final InstantSource clock;
  private final Map<String, Traffic> traffic = new ConcurrentHashMap<>();

  /**
   * @param clock by which the robots stamp their reports
   */
  SteppedLinks(RobotLinkFactory real, InstantSource clock) {
    this.real = real;
    this.clock = clock;
  }

  /**
   * Whether every robot that is connected was heard of late, and has answered all commands, or will
   * in its next tick.
   *
   * @param hasPendingMessages whether something that the robot has received waits for that
   */
  boolean areSettled(Predicate<String> hasPendingMessages) {
    long now = clock.millis();
    return traffic.entrySet().stream()
        .allMatch(
            link ->
                link.getValue().isHeard(now)
                    && (link.getValue().isAnswered() || hasPendingMessages.test(link.getKey())));
  }

  @Override
  public RobotLink open(RobotAddress address, RobotLink.Listener listener) {
    Traffic link = new Traffic(listener);
    traffic.put(address.robot(), link);
    RobotLink opened = real.open(address, link);
    return new RobotLink() {
      @Override
      public void send(ServerMessage message) {
        link.note(message);
        opened.send(message);
      }

      @Override
      public void close() {
        traffic.remove(address.robot(), link);
        opened.close();
      }
    };
  }

  @Override
  public PairingResult pair(RobotAddress robot, PairingCode code) {
    return real.pair(robot, code);
  }

  @Override
  public String toString() {
    return traffic + " at " + clock.millis();
  }

  /** What was sent and not answered, and when the robot was last heard. */
  private final class Traffic implements RobotLink.Listener {
    private final RobotLink.Listener listener;
    private final Set<Long> unanswered = new TreeSet<>();
    private boolean connected;
    private long heard;

    Traffic(RobotLink.Listener listener) {
      this.listener = listener;
    }

    synchronized boolean isHeard(long now) {
      return !connected || now - heard <= OLDEST_REPORT_MILLIS;
    }

    synchronized boolean isAnswered() {
      return unanswered.isEmpty();
    }

    synchronized void note(ServerMessage message) {
      if (connected && message instanceof Command command) {
        unanswered.add(command.seq());
      }
    }

    @Override
    public void connected(Hello hello) {
      synchronized (this) {
        connected = true;
        heard = clock.millis();
      }
      listener.connected(hello);
    }

    @Override
    public void passedOver(int states, int unreadable) {
      listener.passedOver(states, unreadable);
    }

    @Override
    public boolean received(AgentMessage message) {
      boolean isTaken = listener.received(message);
      synchronized (this) {
        switch (message) {
          case Ack(long seq) -> unanswered.remove(seq);
          case Reject(long seq, String _) -> unanswered.remove(seq);
          case State state -> heard = state.stamp();
          default -> {}
        }
      }
      return isTaken;
    }

    @Override
    public void disconnected(Sentence why) {
      forget();
      listener.disconnected(why);
    }

    @Override
    public void refused(Sentence sentence) {
      forget();
      listener.refused(sentence);
    }

    private synchronized void forget() {
      connected = false;
      unanswered.clear();
    }

    @Override
    public synchronized String toString() {
      return connected ? "heard at " + heard + ", unanswered " + unanswered : "not connected";
    }
  }
}
