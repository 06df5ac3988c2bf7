package org.toqa.fleet;

import static java.util.Objects.requireNonNull;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.apache.pekko.actor.BootstrapSetup;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.actor.typed.ActorSystem;
import org.apache.pekko.actor.typed.Behavior;
import org.apache.pekko.actor.typed.javadsl.Behaviors;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.toqa.fleet.robot.RobotAgent;
import org.toqa.fleet.robot.RobotEvent;
import org.toqa.fleet.robot.RobotMessage;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.PairingResult;
import org.toqa.link.RobotAddress;
import org.toqa.link.RobotLink;
import org.toqa.link.RobotLinkFactory;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.trust.PairingCode;
import org.toqa.mission.Phase;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;
import org.toqa.store.Database;
import org.toqa.store.JdbiFleetStore;
import org.toqa.store.MemoryDatabase;
import scala.concurrent.ExecutionContext;

/** What a robot is told while its drives are being stored, and when it counts as silent. */
@Timeout(60)
class RobotAgentTest {
  private static final RobotRecord R1 =
      RobotRecord.direct("r1", "hall", "127.0.0.1", 1, 5, null, false, null);
  private static final Pose START = new Pose(0, 0, 0);
  private static final Segment METRE = new Segment(0.5, 0, 2); // 0.5 m/s for 2 s
  private static final Duration STEP = Duration.ofMillis(100);

  private final SingleThreadRuntime runtime = new SingleThreadRuntime();
  private final Database database = MemoryDatabase.open("robot-" + System.nanoTime());
  private final JdbiFleetStore store = new JdbiFleetStore(database.jdbi());
  private final StoreWriter writer =
      new StoreWriter("floor-hall", runtime, store::inOneTransaction, change -> {});
  private final ScriptedRobot robot = new ScriptedRobot("r1", new Vec2(0, 0));
  private final List<RobotEvent> told = new ArrayList<>();
  private Instant now = Instant.parse("2026-11-21T08:00:00Z");
  private ActorSystem<RobotMessage> agent;
  private volatile RobotLink.@Nullable Listener listener;

  @BeforeEach
  void start() throws InterruptedException {
    store.saveRobot(R1);
    agent =
        ActorSystem.create(
            behavior(),
            "robot",
            BootstrapSetup.create()
                .withDefaultExecutionContext(
                    ExecutionContext.fromExecutor(runtime.agentExecutor().orElseThrow())));
    runtime.awaitQuiescence();
    robot.step();
    runtime.awaitQuiescence();
    assertInstanceOf(RobotEvent.Connected.class, told.getLast());
  }

  /** The agent below one that hears what it tells. */
  private Behavior<RobotMessage> behavior() {
    return Behaviors.setup(
        context -> {
          ActorRef<RobotEvent> floor =
              context.spawn(
                  Behaviors.receiveMessage(
                      event -> {
                        told.add(event);
                        return Behaviors.same();
                      }),
                  "floor");
          ActorRef<RobotMessage> r1 =
              context.spawn(RobotAgent.of(R1, floor, store, writer, links(), now, runtime), "r1");
          return Behaviors.receiveMessage(
              message -> {
                r1.tell(message);
                return Behaviors.same();
              });
        });
  }

  private RobotLinkFactory links() {
    return new RobotLinkFactory() {
      @Override
      public RobotLink open(RobotAddress address, RobotLink.Listener heard) {
        listener = heard;
        return robot.link(heard);
      }

      @Override
      public PairingResult pair(RobotAddress robot, PairingCode code) {
        throw new UnsupportedOperationException();
      }
    };
  }

  @AfterEach
  void stop() throws Exception {
    agent.terminate();
    agent.getWhenTerminated().toCompletableFuture().get(20, TimeUnit.SECONDS);
    database.close();
    runtime.close();
  }

  @Test
  void aHoldOvertakesAnExtendThatIsBeingStored() throws Exception {
    tell(drive(1L));
    runtime.stop(name -> true);
    tell(new RobotMessage.Extend(1, List.of(METRE, METRE), 2, true));
    tell(new RobotMessage.Release(3));
    assertKinds("Drive");

    tell(new RobotMessage.Hold(true));

    assertKinds("Drive", "Hold");
    assertTrue(robot.isHeld());
    runtime.stop(name -> false);
    runtime.awaitQuiescence();
    assertKinds("Drive", "Hold", "Extend", "Release");
  }

  @Test
  void aResumeGoesOutAtOnceToo() throws Exception {
    tell(drive(1L));
    runtime.stop(name -> true);
    tell(new RobotMessage.Hold(true));
    tell(new RobotMessage.Extend(1, List.of(METRE, METRE), 2, true));

    tell(new RobotMessage.Hold(false));

    assertFalse(robot.isHeld());
  }

  @Test
  void aCancelOvertakesWhatIsBeingStoredAndThatIsDropped() throws Exception {
    tell(drive(1L));
    runtime.stop(name -> true);
    tell(new RobotMessage.Extend(1, List.of(METRE, METRE), 2, true));
    tell(new RobotMessage.Release(3));

    tell(new RobotMessage.Cancel(1L));

    assertFalse(robot.isDriving());
    runtime.stop(name -> false);
    tell(drive(2L));
    assertKinds("Drive", "Cancel", "Drive");
    assertTrue(robot.isDriving());
  }

  @Test
  void aDriveThatAHoldHasOvertakenIsStoredAgainUnderAHigherNumber() throws Exception {
    runtime.stop(name -> true);
    tell(drive(1L));
    tell(new RobotMessage.Extend(1, List.of(METRE, METRE), 2, true));

    tell(new RobotMessage.Hold(true));

    assertKinds("Hold");
    for (int i = 0; i < 30; i++) {
      tick(); // pings do not overtake it as well
    }
    runtime.stop(name -> false);
    runtime.awaitQuiescence();
    assertKinds("Hold", "Drive", "Extend");
    long hold = robot.obeyed().get(0).seq();
    ServerMessage.Drive drive = (ServerMessage.Drive) robot.obeyed().get(1);
    assertTrue(drive.seq() > hold);
    assertEquals(drive.seq(), ((ServerMessage.Extend) robot.obeyed().get(2)).drive());
    assertEquals(drive.seq(), store.drive("r1").orElseThrow().seq());
    assertEquals(3, store.drive("r1").orElseThrow().trajectory().segments().size());
    assertEquals(drive.seq(), lastBegun().drive().seq());
  }

  @Test
  void aDriveThatIsBeingStoredIsCancelledBeforeItIsSent() throws Exception {
    runtime.stop(name -> true);
    tell(drive(1L));
    long number = lastBegun().drive().seq();

    tell(new RobotMessage.Cancel(1L));

    assertEquals(new RobotEvent.DriveWithdrawn("r1", number), told.getLast());
    runtime.stop(name -> false);
    runtime.awaitQuiescence();
    assertKinds("Cancel");
    assertFalse(robot.isDriving());
  }

  @Test
  void aRobotThatSpokeWhileTheServerWasHeldUpIsNotSilent() throws Exception {
    for (int i = 0; i < 50; i++) {
      robot.step();
    }
    now = now.plusSeconds(5);
    tick();

    assertFalse(isSilent());
    robot.fallSilent();
    now = now.plusSeconds(5);
    tick();
    assertFalse(isSilent(), "it may have spoken meanwhile");
    for (int i = 0; i < 30; i++) {
      tick();
    }
    assertTrue(isSilent());
  }

  @Test
  void ofEndsThatARobotSaysWithoutEndTheFloorHearsFiveASecond() throws Exception {
    sayEnds(100);
    assertEquals(10, endsTold()); // after a pause two seconds' worth at once

    for (int i = 0; i < 10; i++) {
      tick(); // a second
    }
    sayEnds(100);
    assertEquals(10 + 5, endsTold());
  }

  private void sayEnds(int times) throws InterruptedException {
    for (int i = 0; i < times; i++) {
      requireNonNull(listener).received(new AgentMessage.Done(null, 0, 3));
      runtime.awaitQuiescence();
    }
  }

  private long endsTold() {
    return told.stream().filter(RobotEvent.PhaseEnded.class::isInstance).count();
  }

  private boolean isSilent() {
    return told.stream().anyMatch(RobotEvent.FellSilent.class::isInstance);
  }

  private RobotEvent.DriveBegun lastBegun() {
    return told.stream()
        .filter(RobotEvent.DriveBegun.class::isInstance)
        .map(RobotEvent.DriveBegun.class::cast)
        .reduce((first, next) -> next)
        .orElseThrow();
  }

  private void tick() throws InterruptedException {
    now = now.plus(STEP);
    tell(new RobotMessage.Tick(() -> now));
  }

  private void tell(RobotMessage message) throws InterruptedException {
    agent.tell(message);
    runtime.awaitQuiescence();
  }

  private static RobotMessage.Drive drive(@Nullable Long task) {
    return new RobotMessage.Drive(
        task, Phase.TO_OBJECT, new Trajectory(START, List.of(METRE, METRE)), 1, false, 0, null);
  }

  /** By their names. */
  private void assertKinds(String... kinds) {
    assertEquals(
        List.of(kinds), robot.obeyed().stream().map(c -> c.getClass().getSimpleName()).toList());
  }
}
