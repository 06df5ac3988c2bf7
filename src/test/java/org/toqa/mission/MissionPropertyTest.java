package org.toqa.mission;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tuple;
import org.toqa.geometry.Vec2;
import org.toqa.wording.Sentence;

/** Whatever comes, in whatever order and however often, a task stays in a legal state. */
class MissionPropertyTest {
  /** Which state may follow on which, beside itself. */
  private static final Map<TaskState, Set<TaskState>> NEXT = new EnumMap<>(TaskState.class);

  static {
    NEXT.put(TaskState.QUEUED, EnumSet.of(TaskState.ASSIGNED, TaskState.CANCELLED));
    NEXT.put(
        TaskState.ASSIGNED,
        EnumSet.of(TaskState.TO_OBJECT, TaskState.CARRYING, TaskState.QUEUED, TaskState.CANCELLED));
    NEXT.put(
        TaskState.TO_OBJECT,
        EnumSet.of(TaskState.ASSIGNED, TaskState.CARRYING, TaskState.QUEUED, TaskState.CANCELLED));
    NEXT.put(
        TaskState.CARRYING, EnumSet.of(TaskState.RETURNING, TaskState.QUEUED, TaskState.CANCELLED));
    NEXT.put(TaskState.RETURNING, EnumSet.of(TaskState.DONE));
    NEXT.put(TaskState.DONE, EnumSet.noneOf(TaskState.class));
    NEXT.put(TaskState.FAILED, EnumSet.noneOf(TaskState.class));
    NEXT.put(TaskState.CANCELLED, EnumSet.noneOf(TaskState.class));
  }

  @Property(tries = 5000)
  void anySequenceOfEventsLeavesALegalState(@ForAll("events") List<MissionEvent> events) {
    Mission mission = Mission.queued(MissionTest.TASK);
    for (MissionEvent event : events) {
      mission = givenToRobots(mission);
      Mission.Step step = mission.apply(event);
      assertEquals(step.hasChanges(), !step.mission().equals(mission), event::toString);
      TaskState next = step.mission().state();
      assertTrue(
          next == mission.state() || NEXT.getOrDefault(mission.state(), Set.of()).contains(next),
          mission.state() + " to " + next + " by " + event);
      mission = step.mission();
      assertLegal(mission);
    }
  }

  @Property
  void anEventRepeatedAtOnceChangesNothingMore(@ForAll("events") List<MissionEvent> events) {
    Mission mission = Mission.queued(MissionTest.TASK);
    for (MissionEvent event : events) {
      mission = givenToRobots(mission).apply(event).mission();
      assertFalse(mission.apply(event).hasChanges(), event::toString);
    }
  }

  /** The events that changed something are those that are stored. */
  @Property
  void replayingTheStoredEventsGivesTheSameState(@ForAll("events") List<MissionEvent> events) {
    List<MissionEvent> stored = new ArrayList<>();
    Mission lived = Mission.queued(MissionTest.TASK);
    for (MissionEvent event : events) {
      Mission.Step step = givenToRobots(lived).apply(event);
      if (step.hasChanges()) {
        stored.add(event);
        lived = step.mission();
      }
    }
    Mission replayed = Mission.queued(MissionTest.TASK);
    for (MissionEvent event : stored) {
      replayed = givenToRobots(replayed).apply(event).mission();
    }
    assertEquals(lived, replayed);
  }

  /** A person can always end a task that has not delivered its load. */
  @Property
  void whateverHappenedATaskThatHasNotDeliveredCanBeCancelled(
      @ForAll("events") List<MissionEvent> events) {
    Mission mission = Mission.queued(MissionTest.TASK);
    for (MissionEvent event : events) {
      mission = givenToRobots(mission).apply(event).mission();
    }
    if (mission.state() == TaskState.RETURNING || mission.state() == TaskState.DONE) {
      return;
    }
    mission = mission.apply(new MissionEvent.Cancel("max", LoadChoice.HERE)).mission();
    for (AssignedRobot assigned : mission.assignedRobots()) {
      mission = mission.apply(new MissionEvent.Stopped(assigned.robot(), spot())).mission();
    }
    assertEquals(TaskState.CANCELLED, mission.state());
  }

  /** As the manager does; a task on hold waits. */
  private static Mission givenToRobots(Mission mission) {
    return mission.state() == TaskState.QUEUED && !mission.held()
        ? mission.assign(List.of("r1", "r2"), Sentence.verbatim("heavy")).mission()
        : mission;
  }

  private static void assertLegal(Mission mission) {
    boolean allReleased = mission.assignedRobots().stream().allMatch(AssignedRobot::unassigned);
    switch (mission.state()) {
      case QUEUED, DONE, CANCELLED -> assertTrue(allReleased, mission::toString);
      case ASSIGNED, TO_OBJECT ->
          assertTrue(
              mission.assignedRobots().stream()
                  .allMatch(c -> c.phase() == Phase.TO_OBJECT && !c.unassigned()),
              mission::toString);
      case CARRYING ->
          assertTrue(
              mission.assignedRobots().stream()
                  .allMatch(c -> c.phase() == Phase.TO_GOAL && !c.unassigned()),
              mission::toString);
      case RETURNING ->
          assertTrue(
              !allReleased
                  && mission.assignedRobots().stream().allMatch(c -> c.phase() == Phase.HOME),
              mission::toString);
      case FAILED -> assertFalse(true, "nothing leads there");
    }
    Trouble trouble = mission.trouble();
    if (trouble != null) {
      AssignedRobot assigned = mission.assignedRobot(trouble.robot()).orElseThrow();
      assertTrue(assigned.phase().isCarryingTask() && !assigned.unassigned(), mission::toString);
    }
    if (mission.state().isEnded()) {
      assertFalse(mission.held(), mission::toString);
      assertTrue(mission.question().isEmpty(), mission::toString);
    }
  }

  private static TaskPlace spot() {
    return new TaskPlace(new Vec2(3, 1.5), null);
  }

  @Provide
  Arbitrary<List<MissionEvent>> events() {
    Arbitrary<String> robots = Arbitraries.of("r1", "r2", "unassigned");
    Arbitrary<Phase> phases = Arbitraries.of(Phase.TO_OBJECT, Phase.TO_GOAL, Phase.HOME);
    Arbitrary<TaskPlace> places = Arbitraries.just(spot()).injectNull(0.3);
    Arbitrary<MissionEvent> started =
        Combinators.combine(robots, phases).as(MissionEvent.DriveStarted::new);
    Arbitrary<MissionEvent> ended =
        Combinators.combine(robots, phases).as(MissionEvent.PhaseEnded::new);
    Arbitrary<MissionEvent> failures =
        Combinators.combine(robots, places)
            .flatAs(
                (robot, place) ->
                    Arbitraries.of(
                        new MissionEvent.RobotFailed(
                            robot, Sentence.verbatim("reports an error"), place),
                        new MissionEvent.RobotLost(robot, place),
                        new MissionEvent.RobotWithdrawn(robot, place)));
    Arbitrary<MissionEvent> others =
        robots.flatMap(
            robot ->
                Arbitraries.of(
                    new MissionEvent.RobotRecovered(robot),
                    new MissionEvent.Retasked(robot),
                    new MissionEvent.ChargingRequired(
                        robot, Sentence.verbatim("its battery has 10 %")),
                    new MissionEvent.Exchanged(robot, "r3", Sentence.verbatim("nearer")),
                    new MissionEvent.Stopped(robot, spot())));
    Arbitrary<MissionEvent> commands =
        Arbitraries.of(
            new MissionEvent.Hold("max"),
            new MissionEvent.Resume("max"),
            new MissionEvent.Prioritise("max", 7),
            new MissionEvent.Cancel("max", null),
            new MissionEvent.Cancel("max", LoadChoice.HERE),
            new MissionEvent.Cancel("max", LoadChoice.BACK),
            new MissionEvent.Answer("max", Reply.ANOTHER),
            new MissionEvent.Answer("max", Reply.WAIT),
            new MissionEvent.Answer("max", Reply.CANCEL));
    return Arbitraries.frequencyOf(
            Tuple.of(1, started),
            Tuple.of(8, ended),
            Tuple.of(2, failures),
            Tuple.of(2, others),
            Tuple.of(2, commands))
        .list()
        .ofMaxSize(40);
  }
}
