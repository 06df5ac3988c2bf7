package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.fail;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.AllocationMethod;
import org.toqa.allocation.Policy;
import org.toqa.fleet.manager.AgentFleet;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.link.PairingResult;
import org.toqa.link.RobotAddress;
import org.toqa.link.RobotLink;
import org.toqa.link.RobotLinkFactory;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.PairingCode;
import org.toqa.store.Database;
import org.toqa.store.JdbiFleetStore;
import org.toqa.store.JdbiScheduleStore;
import org.toqa.store.MemoryDatabase;
import org.toqa.wording.Sentence;

/**
 * The agents over a real store, with robots that the test plays, in time that the test brings. Time
 * goes on only when all that followed from its last step is done, so that no machine is too slow.
 */
public final class FleetStage implements AutoCloseable {
  static final Duration REASSIGN_AFTER = Duration.ofSeconds(30);
  private static final Duration STEP = Duration.ofMillis(100);

  /** Of the time that the test brings, for one condition. */
  private static final Duration LIMIT = Duration.ofMinutes(10);

  private static final String STORE = "store-";

  private final FloorMap floor;
  private final List<FloorMap> floors = new ArrayList<>();
  private final ChargingRules charging;
  private final AllocationMethod method;
  private final UnaryOperator<FleetStore> tamper;
  private final SingleThreadRuntime runtime = new SingleThreadRuntime();
  private final Map<String, ScriptedRobot> robots = new LinkedHashMap<>();
  public final Database database = MemoryDatabase.open("fleet-" + System.nanoTime());
  public final JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
  Instant now = Instant.parse("2026-11-21T08:00:00Z");
  private volatile Duration clockAhead = Duration.ZERO;
  public AgentFleet fleet;
  private volatile @Nullable Fingerprint pairingFingerprint;

  /** Of all pictures that there were, one after the other: the same run has the same one. */
  private int digest;

  public FleetStage(FloorMap floor) {
    this(floor, ChargingRules.USUAL);
  }

  FleetStage(FloorMap floor, ChargingRules charging) {
    this(floor, charging, Policy.OPTIMAL);
  }

  FleetStage(FloorMap floor, ChargingRules charging, Policy policy) {
    this(floor, charging, policy.method(), UnaryOperator.identity());
  }

  /**
   * @param tamper what is put between each server and the store
   */
  public FleetStage(
      FloorMap floor,
      ChargingRules charging,
      AllocationMethod method,
      UnaryOperator<FleetStore> tamper) {
    this.floor = floor;
    floors.add(floor);
    this.charging = charging;
    this.method = method;
    this.tamper = tamper;
    this.fleet = open();
  }

  /** The server ends, and starts again with the robots that there are now. */
  public void restart() {
    fleet.close();
    fleet = open();
  }

  /** To be known after the next start, as all others; robots are added to the first one. */
  void addFloor(FloorMap next) {
    floors.add(next);
  }

  /** To be known after the next start. */
  public ScriptedRobot add(String name, Vec2 at, @Nullable String parking) {
    return add(name, at, parking, null);
  }

  ScriptedRobot add(
      String name, Vec2 at, @Nullable String parking, @Nullable Fingerprint fingerprint) {
    return add(name, at, parking, fingerprint, ScriptedRobot.MAX_LOAD);
  }

  /**
   * @param maxLoad kilograms
   */
  ScriptedRobot add(
      String name,
      Vec2 at,
      @Nullable String parking,
      @Nullable Fingerprint fingerprint,
      double maxLoad) {
    ScriptedRobot robot = new ScriptedRobot(name, at);
    robots.put(name, robot);
    robot.setMaxLoad(maxLoad);
    robot.setPeers(this::scriptedRobot);
    store.saveRobot(
        RobotRecord.direct(
            name, floor.name(), "127.0.0.1", 1, maxLoad, parking, false, fingerprint));
    return robot;
  }

  /** The robot's agent takes part in negotiations so, from now on. */
  void setBidding(String name, StrangeBidder.Habit habit) {
    runtime.setBidding(name, habit);
  }

  ScriptedRobot scriptedRobot(String name) {
    return Objects.requireNonNull(robots.get(name));
  }

  private AgentFleet open() {
    RobotLinkFactory links =
        new RobotLinkFactory() {
          @Override
          public RobotLink open(RobotAddress address, RobotLink.Listener listener) {
            return robots
                .computeIfAbsent(address.robot(), name -> new ScriptedRobot(name, new Vec2(0, 0)))
                .link(listener);
          }

          @Override
          public PairingResult pair(RobotAddress robot, PairingCode code) {
            Fingerprint shown = pairingFingerprint;
            return shown == null
                ? new PairingResult.Unreachable(Sentence.verbatim("The robot does not answer."))
                : new PairingResult.Paired(shown);
          }
        };
    AgentFleet opened =
        new AgentFleet(
            FloorsInMemory.of(floors.toArray(FloorMap[]::new)),
            watched(tamper.apply(store)),
            new JdbiScheduleStore(database.jdbi()),
            links,
            method,
            new FleetRules(REASSIGN_AFTER, charging, 1),
            () -> now.plus(clockAhead),
            now,
            runtime);
    opened.rejections(List.of(), "Max").toCompletableFuture().join(); // then its agents have begun
    return opened;
  }

  private FleetStore watched(FleetStore asked) {
    return TamperedStore.of(
        asked,
        (method, arguments, real) -> {
          runtime.recordSlowCall(method);
          return real.go();
        });
  }

  /**
   * Sets the wall clock.
   *
   * @param ahead of the time that goes on
   */
  void setClock(Duration ahead) {
    clockAhead = ahead;
  }

  /** Lets time go on, and the robots drive, until it is so. */
  public void await(Predicate<FleetSnapshot> condition) throws InterruptedException {
    if (!becomesTrue(condition)) {
      fail("It is still so: " + fleet.snapshots().latest());
    }
  }

  /** Until all that followed from what happened is done; the clock does not advance meanwhile. */
  public void awaitQuiescence() throws InterruptedException {
    runtime.awaitQuiescence();
  }

  /** Whether it comes to be so while time goes on. */
  boolean becomesTrue(Predicate<FleetSnapshot> condition) throws InterruptedException {
    Instant end = now.plus(LIMIT);
    runtime.awaitQuiescence();
    while (fleet.snapshots().latest().robots().isEmpty()
        || !condition.test(fleet.snapshots().latest())) {
      if (!now.isBefore(end)) {
        return false;
      }
      step();
    }
    return true;
  }

  /** Lets that much time go on, whatever happens. */
  void pass(Duration time) throws InterruptedException {
    runtime.awaitQuiescence();
    for (Instant end = now.plus(time); now.isBefore(end); ) {
      step();
    }
  }

  /**
   * Lets that much time go on in which robots speak, and the server hears of it afterwards.
   *
   * @param atEnd happens before that
   */
  void holdUp(Duration time, Runnable atEnd) throws InterruptedException {
    runtime.runWhileHeldUp(
        () -> {
          for (Instant end = now.plus(time); now.isBefore(end); ) {
            now = now.plus(STEP);
            robots.values().forEach(ScriptedRobot::step);
            fleet.tick(now);
          }
          atEnd.run();
        });
  }

  /**
   * A store that says nothing to some agents, until this is said of others.
   *
   * @param agents such as "tasks-hall" and "floor-hall"
   */
  public void stopStoreFor(Predicate<String> agents) {
    Predicate<String> executors =
        name -> name.startsWith(STORE) && agents.test(name.substring(STORE.length()));
    if (!runtime.hasSerialExecutor(executors)) {
      throw new IllegalArgumentException("no agent is named so");
    }
    runtime.stop(executors);
  }

  /** For all agents again. */
  public void startStore() {
    runtime.stop(_ -> false);
  }

  /** Robots that take their time to pair, or no longer. */
  void stopPairing(boolean stops) {
    runtime.stop(name -> stops && name.startsWith("pairing-"));
  }

  /** The certificates that robots show when they pair; without one they cannot be reached. */
  void setPairingFingerprint(Fingerprint fingerprint) {
    pairingFingerprint = fingerprint;
  }

  /** Lets the time pass in which callers wait for answers. */
  public void passAnswerTime(Duration time) {
    runtime.advance(time);
  }

  private void step() throws InterruptedException {
    runtime.setWatching(true);
    now = now.plus(STEP);
    for (ScriptedRobot robot : robots.values()) {
      robot.step();
      runtime.awaitQuiescence();
    }
    fleet.tick(now);
    runtime.awaitQuiescence();
    runtime.setWatching(false);
    digest = 31 * digest + fleet.snapshots().latest().toString().hashCode();
  }

  int digest() {
    return digest;
  }

  /** Whatever a test is about: no agent has waited for anything. */
  @Override
  public void close() {
    fleet.close();
    database.close();
    runtime.close();
    runtime.assertAgentsNeverWaited();
  }
}
