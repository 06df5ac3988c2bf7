package org.toqa.app.server;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.toqa.agent.Daemon;
import org.toqa.agent.TickSchedule;
import org.toqa.agent.config.AgentConfig;
import org.toqa.agent.config.ChassisConfig;
import org.toqa.agent.drive.MotionLimits;
import org.toqa.link.RobotAddress;
import org.toqa.link.http.ExchangeListener;
import org.toqa.link.http.HttpRobotClient;
import org.toqa.link.http.RobotDescription;
import org.toqa.localisation.RangeSource;
import org.toqa.motion.DriveKind;

/**
 * The daemon of a robot that takes wheel commands over HTTP: it runs in this process, by the
 * machine's clock, and listens on loopback.
 */
public final class HttpRobotDaemon implements AutoCloseable {
  private static final int ANY_FREE_PORT = 0;

  /** Of the speed of its wheels: the rest is for coming back to the path. */
  private static final double SHARE_OF_SPEED = 0.8;

  /** Radians a second, which a narrow robot could exceed. */
  private static final double MOST_TURN_RATE = 3.5;

  /** Metres a second squared. */
  private static final double ACCELERATION = 0.5;

  /** Radians a second squared. */
  private static final double TURN_ACCELERATION = 3;

  private final Daemon daemon;

  private HttpRobotDaemon(Daemon daemon) {
    this.daemon = daemon;
  }

  /**
   * Asks the robot what it is, and opens its daemon; waits for some seconds at most.
   *
   * @param name of the robot
   * @param folder of the daemon
   * @param client is closed by whoever made it, after the daemon
   * @param listener is told of each exchange, in the thread of {@link #run}
   * @param ranges that it publishes
   * @param clock for stamps
   * @throws org.toqa.link.http.HttpRobotException the robot does not answer as it should
   * @throws IOException the folder cannot be used
   */
  public static HttpRobotDaemon open(
      String name,
      Path folder,
      HttpRobotClient client,
      ExchangeListener listener,
      RangeSource ranges,
      InstantSource clock)
      throws IOException {
    RobotDescription body = client.describe();
    double turnRate = Math.min(MOST_TURN_RATE, SHARE_OF_SPEED * 2 * body.maxSpeed() / body.track());
    AgentConfig config =
        new AgentConfig(
            name,
            InetAddress.getLoopbackAddress(),
            ANY_FREE_PORT,
            false,
            folder,
            body.maxLoad(),
            body.footprint(),
            DriveKind.DIFFERENTIAL,
            new MotionLimits(
                SHARE_OF_SPEED * body.maxSpeed(), turnRate, ACCELERATION, TURN_ACCELERATION),
            AgentConfig.Following.of(DriveKind.DIFFERENTIAL),
            new ChassisConfig.Http(client, body, listener, ranges));
    return new HttpRobotDaemon(Daemon.open(config, clock, System.nanoTime()));
  }

  /** Where it listens, and what it is known by. */
  public RobotAddress address() {
    return new RobotAddress(
        daemon.robot(),
        InetAddress.getLoopbackAddress().getHostAddress(),
        daemon.port(),
        daemon.fingerprint().orElse(null));
  }

  /** Ticks it, on the thread that calls, as long as it goes on. */
  public void run(BooleanSupplier goesOn) {
    Thread own = Thread.currentThread();
    daemon.setMessageListener(() -> LockSupport.unpark(own));
    TickSchedule schedule = new TickSchedule(daemon, System.nanoTime());
    while (goesOn.getAsBoolean()) {
      long now = System.nanoTime();
      long wait = schedule.nanosUntilDue(now);
      if (wait > 0) {
        LockSupport.parkNanos(wait);
      } else {
        schedule.tick(now);
      }
    }
  }

  /**
   * Tells the robot to stand, and ends the daemon; waits for less than half a second for answers. A
   * robot that gives none stands by itself.
   */
  @Override
  public void close() throws IOException {
    daemon.close();
  }
}
