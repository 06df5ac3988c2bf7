package org.toqa.mission;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.statistics.Statistics;

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
      mission = MissionEvents.givenToRobots(mission);
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
      mission = MissionEvents.givenToRobots(mission).apply(event).mission();
      assertFalse(mission.apply(event).hasChanges(), event::toString);
    }
  }

  /** A person can always end a task that has not delivered its load. */
  @Property
  void whateverHappenedATaskThatHasNotDeliveredCanBeCancelled(
      @ForAll("events") List<MissionEvent> events) {
    Mission mission = Mission.queued(MissionTest.TASK);
    for (MissionEvent event : events) {
      mission = MissionEvents.givenToRobots(mission).apply(event).mission();
    }
    boolean isDelivered =
        mission.state() == TaskState.RETURNING || mission.state() == TaskState.DONE;
    Statistics.label("not delivered")
        .collect(!isDelivered)
        .coverage(coverage -> coverage.check(true).percentage(p -> p > 30));
    if (isDelivered) {
      return;
    }
    mission = mission.apply(new MissionEvent.Cancel("max", LoadChoice.HERE)).mission();
    for (AssignedRobot assigned : mission.assignedRobots()) {
      mission =
          mission.apply(new MissionEvent.Stopped(assigned.robot(), MissionEvents.SPOT)).mission();
    }
    assertEquals(TaskState.CANCELLED, mission.state());
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

  @Provide
  Arbitrary<List<MissionEvent>> events() {
    return MissionEvents.upTo(40);
  }
}
