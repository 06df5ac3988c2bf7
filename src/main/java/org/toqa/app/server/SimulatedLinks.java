package org.toqa.app.server;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.IntPredicate;
import java.util.function.LongSupplier;
import java.util.stream.Collectors;
import org.toqa.link.PairingResult;
import org.toqa.link.RobotAddress;
import org.toqa.link.RobotLink;
import org.toqa.link.RobotLinkFactory;
import org.toqa.link.gateway.GatewayState;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.trust.PairingCode;
import org.toqa.sim.Participant;
import org.toqa.wording.Sentence;

/**
 * Links where the simulated world waits until what its robots say has been read: a machine that is
 * held up for some tenths of a second would else count them as lost, as their time goes faster than
 * its own. The other way round the robots wait for the server's ping. Real robots are not waited
 * for, nor are simulated ones that are lost.
 */
final class SimulatedLinks implements RobotLinkFactory, Participant {
  /** Robots report five times a second, and are lost after two. */
  private static final long OVERDUE_NANOS = Duration.ofSeconds(1).toNanos();

  private static final long LOST_NANOS = Duration.ofSeconds(2).toNanos();

  private final RobotLinkFactory links;
  private final IntPredicate isSimulated;
  private final LongSupplier worldNanos;

  /** By link that is connected: when it was heard last, by the world's time. */
  private final Map<Listener, Long> heardAt = new ConcurrentHashMap<>();

  /**
   * @param isSimulated whether the robot that listens on that port of loopback is one of the world
   * @param worldNanos the world's time
   */
  SimulatedLinks(RobotLinkFactory links, IntPredicate isSimulated, LongSupplier worldNanos) {
    this.links = links;
    this.isSimulated = isSimulated;
    this.worldNanos = worldNanos;
  }

  @Override
  public RobotLink open(RobotAddress address, RobotLink.Listener listener) {
    if (address.gateway() != null || !isSimulated.test(address.port())) {
      return links.open(address, listener);
    }
    Listener heard = new Listener(address.robot(), listener);
    RobotLink link = links.open(address, heard);
    return new RobotLink() {
      @Override
      public void send(ServerMessage message) {
        link.send(message);
      }

      @Override
      public void close() {
        link.close();
        heard.close();
      }
    };
  }

  @Override
  public PairingResult pair(RobotAddress robot, PairingCode code) {
    return links.pair(robot, code);
  }

  @Override
  public List<GatewayState> gateways() {
    return links.gateways();
  }

  @Override
  public void tick(long nanos) {}

  @Override
  public boolean isReady(long nanos) {
    for (long heard : heardAt.values()) { // at every step
      if (isAwaited(nanos - heard)) {
        return false;
      }
    }
    return true;
  }

  private static boolean isAwaited(long silence) {
    return silence > OVERDUE_NANOS && silence <= LOST_NANOS;
  }

  /** For the log: whom the world waits for. */
  @Override
  public String toString() {
    long nanos = worldNanos.getAsLong();
    return heardAt.entrySet().stream()
        .filter(heard -> isAwaited(nanos - heard.getValue()))
        .map(heard -> heard.getKey().robot)
        .sorted()
        .collect(Collectors.joining(", ", "what is said by ", ""));
  }

  private final class Listener implements RobotLink.Listener {
    private final String robot;
    private final RobotLink.Listener listener;
    private boolean isClosed;

    Listener(String robot, RobotLink.Listener listener) {
      this.robot = robot;
      this.listener = listener;
    }

    @Override
    public void connected(Hello hello) {
      listener.connected(hello);
      setHeard(true);
    }

    @Override
    public boolean received(AgentMessage message) {
      boolean isTaken = listener.received(message);
      setHeard(true);
      return isTaken;
    }

    @Override
    public void passedOver(int states, int unreadable) {
      listener.passedOver(states, unreadable);
    }

    @Override
    public void misunderstood(String fault) {
      listener.misunderstood(fault);
    }

    @Override
    public void disconnected(Sentence why) {
      setHeard(false);
      listener.disconnected(why);
    }

    @Override
    public void refused(Sentence sentence) {
      setHeard(false);
      listener.refused(sentence);
    }

    /**
     * @param isWaitedFor there is a connection, over which more will come
     */
    private synchronized void setHeard(boolean isWaitedFor) {
      if (isWaitedFor && !isClosed) {
        heardAt.put(this, worldNanos.getAsLong());
      } else {
        heardAt.remove(this);
      }
    }

    synchronized void close() {
      isClosed = true;
      heardAt.remove(this);
    }
  }
}
