package org.toqa.fleet;

import java.util.ArrayDeque;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentSkipListMap;
import org.toqa.link.PairingResult;
import org.toqa.link.RobotAddress;
import org.toqa.link.RobotLink;
import org.toqa.link.RobotLinkFactory;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.trust.PairingCode;
import org.toqa.sim.SimulatedFleet;
import org.toqa.wording.Sentence;

/**
 * Links whose messages arrive between the steps of a world. What is on its way is waited for, and
 * what robots say is told the fleet in the order of their names: so however slow the machine, and
 * whoever is faster, the same seed gives the same run.
 */
final class SteppedLinks implements RobotLinkFactory {
  private final RobotLinkFactory real;
  private final Map<String, Traffic> traffic = new ConcurrentSkipListMap<>();

  SteppedLinks(RobotLinkFactory real) {
    this.real = real;
  }

  /** Whether nothing is on its way between the fleet and robots that it is connected to. */
  boolean areSettled(SimulatedFleet robots) {
    return traffic.entrySet().stream()
        .allMatch(link -> link.getValue().isSettled(robots, link.getKey()));
  }

  /** Whether there is anything that the fleet was not told yet. */
  boolean haveArrived() {
    return traffic.values().stream().anyMatch(Traffic::hasArrived);
  }

  /** Tells the fleet what has come since the last time. */
  void deliver() {
    traffic.values().forEach(Traffic::deliver);
  }

  @Override
  public RobotLink open(RobotAddress address, RobotLink.Listener listener) {
    Traffic link = new Traffic(listener);
    traffic.put(address.robot(), link);
    RobotLink opened = real.open(address, link);
    return new RobotLink() {
      @Override
      public void send(ServerMessage message) {
        link.countSent();
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
    return traffic.toString();
  }

  /** What has come over a link and was not told yet, and how much was said. */
  private static final class Traffic implements RobotLink.Listener {
    private final RobotLink.Listener listener;
    private final Queue<Runnable> arrived = new ArrayDeque<>();

    /** Whether it is known how the first attempt to connect went. */
    private boolean isTried;

    private boolean isConnected;

    /** Whether anything but the hello has come. */
    private boolean isInUse;

    /** Messages over this connection. */
    private long sent;

    private long received;

    /** Whether the fleet did not take what the robot said last. */
    private boolean isTooMuch;

    Traffic(RobotLink.Listener listener) {
      this.listener = listener;
    }

    synchronized boolean isSettled(SimulatedFleet robots, String robot) {
      if (!isTried) {
        return robots.hasPendingMessages(robot); // it says hello in its next tick
      }
      if (!isConnected) {
        return true;
      }
      // until then it may have another connection for the server's
      boolean isKnown = isInUse || (sent > 0 && !robots.hasPendingMessages(robot));
      return robots.hasReceivedFromServer(robot, sent)
          && (!isKnown || robots.sentToServer(robot) <= received);
    }

    synchronized boolean hasArrived() {
      return !arrived.isEmpty();
    }

    synchronized void deliver() {
      for (Runnable next = arrived.poll(); next != null; next = arrived.poll()) {
        next.run();
      }
    }

    synchronized void countSent() {
      if (isConnected) {
        sent++;
      }
    }

    @Override
    public synchronized void connected(Hello hello) {
      isTried = true;
      isConnected = true;
      isInUse = false;
      sent = 0;
      received = 1;
      arrived.add(() -> listener.connected(hello));
    }

    @Override
    public synchronized void passedOver(int states, int unreadable) {
      received += states + unreadable;
      arrived.add(() -> listener.passedOver(states, unreadable));
    }

    @Override
    public synchronized boolean received(AgentMessage message) {
      received++;
      isInUse = true;
      arrived.add(() -> isTooMuch = !listener.received(message));
      return !isTooMuch;
    }

    @Override
    public synchronized void disconnected(Sentence why) {
      end(() -> listener.disconnected(why));
    }

    @Override
    public synchronized void refused(Sentence why) {
      end(() -> listener.refused(why));
    }

    private void end(Runnable telling) {
      isTried = true;
      isConnected = false;
      arrived.add(telling);
    }

    @Override
    public synchronized String toString() {
      return isConnected ? "%d sent, %d received".formatted(sent, received) : "not connected";
    }
  }
}
