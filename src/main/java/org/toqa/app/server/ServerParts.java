package org.toqa.app.server;

import com.github.benmanes.caffeine.cache.Ticker;
import java.io.IOException;
import java.time.InstantSource;
import java.util.concurrent.Semaphore;
import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.LoginThrottle;
import org.toqa.accounts.PasswordHasher;
import org.toqa.app.config.Configuration;
import org.toqa.sim.SimulatedFleet;
import org.toqa.telemetry.mqtt.BrokerDoor;
import org.toqa.web.AllowedHosts;
import org.toqa.web.ConcurrencyLimits;
import org.toqa.web.RequestLimit;

/**
 * What all sites of a server have in common: its limits, which are of callers and addresses, and
 * the work on passwords.
 *
 * @param throttle of guesses at all sites together
 * @param telemetry the broker of all sites
 * @param laboratory with one permit: of all sites together one experiment runs at a time
 * @param simulated the robots that live in this process, once they do
 */
record ServerParts(
    PasswordHasher passwords,
    LoginThrottle throttle,
    RequestLimit requestLimit,
    ConcurrencyLimits concurrency,
    AllowedHosts hosts,
    InstantSource clock,
    ServerTelemetry telemetry,
    Semaphore laboratory,
    AtomicReference<@Nullable SimulatedFleet> simulated) {

  /**
   * @throws IOException the MQTT broker cannot be had; the message says what to do
   */
  static ServerParts of(
      Configuration configuration, PasswordHasher passwords, InstantSource wallClock)
      throws IOException {
    Configuration.Limits limits = configuration.limits();
    RequestLimit requests =
        new RequestLimit(configuration.requestsPerSecond(), Ticker.systemTicker());
    return new ServerParts(
        passwords,
        new LoginThrottle(new SteadyClock(wallClock.instant(), System::nanoTime)),
        requests,
        ConcurrencyLimits.of(
            limits.requestsAtOnce(),
            limits.streamsPerUser(),
            limits.streamsPerAddress(),
            limits.connections()),
        new AllowedHosts(configuration.hosts()),
        wallClock,
        ServerTelemetry.start(
            configuration.broker(),
            new BrokerDoor(
                limits.connections(),
                limits.connectionsPerAddress(),
                block -> requests.tryAcquire("MQTT address " + block).isZero())),
        new Semaphore(1, true),
        new AtomicReference<>());
  }

  /** Whether one of the robots that live in this process listens on that port of loopback. */
  boolean isSimulated(int port) {
    SimulatedFleet robots = simulated.get();
    return robots != null && robots.isListeningOn(port);
  }
}
