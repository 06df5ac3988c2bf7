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
  void anySequenceOfEventsLeavesALegalState(
      @ForAll("tasks") TransportTask task, @ForAll("events") List<MissionEvent> events) {
    Mission mission = Mission.queued(task);
    for (MissionEvent event : events) {
      mission = MissionEvents.givenToRobots(mission);
      Mission.Step step = mission.apply(event);
      assertEquals(step.hasChanges(), !step.mission().equals(mission), event::toString);
      TaskState next = step.mission().state();
      assertTrue(
          next == mission.state() || mayFollow(mission, next),
          mission.state() + " to " + next + " by " + event);
      mission = step.mission();
      assertLegal(mission);
    }
  }

  /** A drive never carries anything, and ends where it drives. */
  private static boolean mayFollow(Mission mission, TaskState next) {
    boolean isDrive = mission.task().isDrive();
    if (isDrive && next == TaskState.RETURNING) {
      return mission.state() == TaskState.ASSIGNED || mission.state() == TaskState.TO_OBJECT;
    }
    return NEXT.getOrDefault(mission.state(), Set.of()).contains(next)
        && !(isDrive && next == TaskState.CARRYING);
  }

  @Property
  void anEventRepeatedAtOnceChangesNothingMore(
      @ForAll("tasks") TransportTask task, @ForAll("events") List<MissionEvent> events) {
    Mission mission = Mission.queued(task);
    for (MissionEvent event : events) {
      mission = MissionEvents.givenToRobots(mission).apply(event).mission();
      assertFalse(mission.apply(event).hasChanges(), event::toString);
    }
  }

  /** A person can always end a task that has not delivered its load. */
  @Property
  void whateverHappenedATaskThatHasNotDeliveredCanBeCancelled(
      @ForAll("tasks") TransportTask task, @ForAll("events") List<MissionEvent> events) {
    Mission mission = Mission.queued(task);
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

  /** Whatever is lost, repeated or told late. */
  @Property
  void everyStopIsLeftOnceAndInOrder(
      @ForAll("tours") TransportTask task, @ForAll("manyEvents") List<MissionEvent> events) {
    Mission mission = Mission.queued(task);
    List<Integer> left = new ArrayList<>();
    for (MissionEvent event : events) {
      Mission before = MissionEvents.givenToRobots(mission);
      mission = before.apply(event).mission();
      boolean isDelivery =
          mission.state() == TaskState.RETURNING && before.state() != mission.state();
      if (mission.progress().stop() != before.progress().stop() || isDelivery) {
        left.add(before.progress().stop());
        assertTrue(
            isDelivery || mission.progress().stop() == before.progress().stop() + 1,
            before + " to " + mission);
      }
    }
    List<Integer> all = task.isDrive() ? List.of(0, 1, 2) : List.of(0, 1, 2, 3);
    assertEquals(all.subList(0, left.size()), left);
    boolean isDelivered = mission.state().isDelivered();
    assertEquals(isDelivered, left.size() == all.size());
    Statistics.label("delivered")
        .collect(isDelivered)
        .coverage(coverage -> coverage.check(true).percentage(p -> p > 1));
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
    if (mission.waitingStop().isPresent()) {
      assertTrue(
          mission.assignedRobots().stream().allMatch(AssignedRobot::arrived), mission::toString);
      assertTrue(mission.waitingStop().orElseThrow().hasWait(), mission::toString);
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
  Arbitrary<TransportTask> tasks() {
    return Arbitraries.of(
        MissionTest.TASK, MissionTest.TOUR, MissionTest.DRIVE, MissionTest.CHARGING_DRIVE);
  }

  @Provide
  Arbitrary<TransportTask> tours() {
    return Arbitraries.of(MissionTest.TOUR, MissionTest.DRIVE, MissionTest.CHARGING_DRIVE);
  }

  @Provide
  Arbitrary<List<MissionEvent>> manyEvents() {
    return MissionEvents.upTo(400, 20);
  }

  @Provide
  Arbitrary<List<MissionEvent>> events() {
    return MissionEvents.upTo(40);
  }
}
