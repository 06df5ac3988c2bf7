package org.toqa.fleet.dispatch;

import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.actor.typed.ActorSystem;
import org.apache.pekko.actor.typed.Behavior;
import org.apache.pekko.actor.typed.javadsl.Behaviors;
import org.toqa.fleet.FleetRules;
import org.toqa.fleet.FleetRuntime;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.StoredRobot;
import org.toqa.fleet.floor.FloorAgent;
import org.toqa.fleet.floor.FloorEvent;
import org.toqa.fleet.floor.FloorMessage;
import org.toqa.fleet.floor.StoredFloorState;
import org.toqa.fleet.robot.AgentHealth;
import org.toqa.fleet.robot.RobotAgents;
import org.toqa.fleet.robot.Supervision;
import org.toqa.grid.FloorMap;
import org.toqa.link.RobotLinkFactory;
import org.toqa.mission.Mission;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * The agents of one floor and of its robots, as in an {@link FloorFleet}, without a manager above
 * them: who made it begins the tasks, and is told what the floor tells a manager.
 *
 * <p>It reads no clock: {@link #tick} brings the time.
 */
public final class FloorSystem implements AutoCloseable {
  private static final long CLOSE_SECONDS = 10;

  private final FleetRuntime runtime;
  private final ActorSystem<FloorEvent> system;
  private final CompletableFuture<ActorRef<FloorMessage>> floor = new CompletableFuture<>();

  /**
   * Waits until all agents have begun; what {@link FleetRuntime#agentExecutor} is handed meanwhile
   * must be done by another thread.
   *
   * @param robots all that the floor has
   * @param rules as those of a whole fleet
   * @param clock for the times in the history
   * @param now of the time that {@link #tick} brings
   * @param listener called by an agent
   * @throws IllegalStateException an agent cannot start; the message says which one and why
   */
  public FloorSystem(
      FloorMap map,
      List<RobotRecord> robots,
      FleetStore store,
      RobotLinkFactory links,
      FleetRules rules,
      InstantSource clock,
      Instant now,
      FleetRuntime runtime,
      Consumer<FloorEvent> listener) {
    this.runtime = runtime;
    StoredFloorState memory =
        new StoredFloorState(
            robots.stream().map(StoredRobot::added).toList(), null, null, List.of(), List.of());
    Behavior<FloorEvent> manager =
        Behaviors.setup(
            context -> {
              AgentHealth.of(context.getSystem()).expectStart();
              floor.complete(
                  context.spawn(
                      FloorAgent.of(
                          map, memory, store, links, rules, clock, now, runtime, context.getSelf()),
                      "floor"));
              return Behaviors.receiveMessage(
                  event -> {
                    listener.accept(event);
                    return Behaviors.same();
                  });
            });
    this.system =
        ActorSystem.create(
            Supervision.resuming(
                Phrase.DISPATCH_PART.with(map.name()), FloorEvent.class, runtime, manager),
            "floor",
            AgentSystemSetup.of(runtime));
    try {
      AgentHealth.of(system).started().toCompletableFuture().join();
    } catch (RuntimeException e) {
      system.terminate();
      throw new IllegalStateException(String.valueOf(e.getMessage()), e);
    }
  }

  /** Lets the agents do what is due by then, about ten times a second. */
  public void tick(Instant now) {
    RobotAgents.of(system).tick(now);
    tell(new FloorMessage.Tick(now));
  }

  /**
   * The robot shall carry out the task. Where it cannot, the listener is told {@link
   * FloorEvent.TaskNotBegun}.
   *
   * @param mission queued
   * @param why it was chosen
   */
  public void beginTask(Mission mission, String robot, Sentence why) {
    tell(new FloorMessage.BeginTask(mission, List.of(robot), why));
  }

  private void tell(FloorMessage message) {
    floor.join().tell(message);
  }

  /** What fails now, as {@link FloorFleet#failures}; empty while all is well. */
  public List<Sentence> failures() {
    return AgentHealth.of(system).failures(runtime.monotonicNanos());
  }

  /** Ends the agents; what they hand to the runtime meanwhile must be done by another thread. */
  @Override
  public void close() {
    system.terminate();
    try {
      system.getWhenTerminated().toCompletableFuture().get(CLOSE_SECONDS, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (TimeoutException | ExecutionException e) {
      throw new IllegalStateException("The agents did not end in time.", e);
    }
  }
}
