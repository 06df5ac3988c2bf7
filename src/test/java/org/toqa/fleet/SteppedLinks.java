package org.toqa.fleet;

import java.time.InstantSource;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
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
 * Links that know how far behind the world they are. A world that waits until they are settled is
 * never ahead of them by more than the longest time between two reports, however slow the machine.
 */
final class SteppedLinks implements RobotLinkFactory {
  /** Reports come every 200 ms. */
  private static final long OLDEST_REPORT_MILLIS = 400;

  /** A daemon answers in the tick after the one in which a command came. */
  private static final long OLDEST_COMMAND_MILLIS = 200;

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

  /** Whether every robot that is connected was heard of late, and has answered all commands. */
  boolean areSettled() {
    long now = clock.millis();
    return traffic.values().stream().allMatch(link -> link.isSettled(now));
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
  public PairingResult pair(String robot, String host, int port, PairingCode code) {
    return real.pair(robot, host, port, code);
  }

  @Override
  public String toString() {
    return traffic + " at " + clock.millis();
  }

  /** What was sent and not answered, and when the robot was last heard. */
  private final class Traffic implements RobotLink.Listener {
    private final RobotLink.Listener listener;
    private final Map<Long, Long> unanswered = new TreeMap<>();
    private boolean connected;
    private long heard;

    Traffic(RobotLink.Listener listener) {
      this.listener = listener;
    }

    synchronized boolean isSettled(long now) {
      return !connected
          || (now - heard <= OLDEST_REPORT_MILLIS
              && unanswered.values().stream()
                  .allMatch(sent -> now - sent <= OLDEST_COMMAND_MILLIS));
    }

    synchronized void note(ServerMessage message) {
      if (connected && message instanceof Command command) {
        unanswered.put(command.seq(), clock.millis());
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
    public void received(AgentMessage message) {
      listener.received(message);
      synchronized (this) {
        switch (message) {
          case Ack(long seq) -> unanswered.remove(seq);
          case Reject(long seq, String _) -> unanswered.remove(seq);
          case State state -> heard = state.stamp();
          default -> {}
        }
      }
    }

    @Override
    public void disconnected(String why) {
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
