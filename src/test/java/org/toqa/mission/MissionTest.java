package org.toqa.mission;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.toqa.geometry.Vec2;

class MissionTest {

  private static final TransportTask TASK =
      new TransportTask(
          7,
          "box",
          3,
          new TaskPlace(new Vec2(1, 1), "Store"),
          new TaskPlace(new Vec2(5, 2), null),
          "lab",
          0,
          null,
          null,
          "ann",
          Instant.EPOCH);

  @Example
  void oneRobotFetchesCarriesAndParks() {
    Mission.Step step = Mission.assign(TASK, List.of("r1"), "nearest");
    assertEquals(TaskState.ASSIGNED, step.mission().state());
    assertEquals(List.of(new MissionCommand.Drive("r1", 1)), step.commands());

    step = step.mission().on(new MissionEvent.DriveStarted("r1", 1));
    assertEquals(TaskState.TO_OBJECT, step.mission().state());

    step = step.mission().on(new MissionEvent.PhaseEnded("r1", 1));
    assertEquals(TaskState.CARRYING, step.mission().state());
    assertEquals(List.of(new MissionCommand.Drive("r1", 2)), step.commands());
    assertEquals(List.of("Picked up at Store"), step.history());

    step = step.mission().on(new MissionEvent.PhaseEnded("r1", 2));
    assertEquals(TaskState.RETURNING, step.mission().state());
    assertEquals(List.of("Delivered at (5.00, 2.00)"), step.history());

    step = step.mission().on(new MissionEvent.PhaseEnded("r1", 3));
    assertEquals(TaskState.DONE, step.mission().state());
    assertEquals(List.of(new MissionCommand.LetGo("r1")), step.commands());
  }

  @Example
  void phaseTwoStartsWhenAllRobotsAreAtTheObject() {
    Mission mission = Mission.assign(TASK, List.of("r1", "r2"), "heavy").mission();
    Mission.Step first = mission.on(new MissionEvent.PhaseEnded("r1", 1));
    assertEquals(TaskState.TO_OBJECT, first.mission().state());
    assertTrue(first.commands().isEmpty());

    Mission.Step second = first.mission().on(new MissionEvent.PhaseEnded("r2", 1));
    assertEquals(TaskState.CARRYING, second.mission().state());
    assertEquals(
        List.of(new MissionCommand.Drive("r1", 2), new MissionCommand.Drive("r2", 2)),
        second.commands());
  }

  @Example
  void robotInPhaseThreeMayTakeTheNextTask() {
    Mission mission = Mission.assign(TASK, List.of("r1"), "nearest").mission();
    mission = mission.on(new MissionEvent.PhaseEnded("r1", 1)).mission();
    assertFalse(mission.on(new MissionEvent.Retasked("r1")).changed());
    mission = mission.on(new MissionEvent.PhaseEnded("r1", 2)).mission();
    assertEquals(TaskState.DONE, mission.on(new MissionEvent.Retasked("r1")).mission().state());
  }

  /** Whatever comes, in whatever order and however often: states only go forward. */
  @Property
  void anySequenceOfEventsLeavesALegalState(@ForAll("events") List<MissionEvent> events) {
    Mission mission = Mission.assign(TASK, List.of("r1", "r2"), "heavy").mission();
    for (MissionEvent event : events) {
      Mission.Step step = mission.on(event);
      assertTrue(step.mission().state().ordinal() >= mission.state().ordinal());
      assertEquals(step.changed(), !step.mission().equals(mission));
      mission = step.mission();
      assertEquals(
          mission.state() == TaskState.DONE,
          mission.carriers().stream().allMatch(Carrier::released));
      assertEquals(
          mission.state() == TaskState.CARRYING,
          mission.carriers().stream().allMatch(c -> c.phase() == 2 && !c.released()));
    }
  }

  @Property
  void anEventRepeatedAtOnceChangesNothingMore(@ForAll("events") List<MissionEvent> events) {
    Mission mission = Mission.assign(TASK, List.of("r1", "r2"), "heavy").mission();
    List<MissionEvent> seen = new ArrayList<>();
    for (MissionEvent event : events) {
      mission = mission.on(event).mission();
      seen.add(event);
      assertFalse(mission.on(event).changed(), () -> "after " + seen);
    }
  }

  @Provide
  Arbitrary<List<MissionEvent>> events() {
    Arbitrary<String> robots = Arbitraries.of("r1", "r2", "stranger");
    Arbitrary<Integer> phases = Arbitraries.integers().between(1, 3);
    Arbitrary<MissionEvent> started =
        Combinators.combine(robots, phases).as(MissionEvent.DriveStarted::new);
    Arbitrary<MissionEvent> ended =
        Combinators.combine(robots, phases).as(MissionEvent.PhaseEnded::new);
    Arbitrary<MissionEvent> retasked = robots.map(MissionEvent.Retasked::new);
    return Arbitraries.frequencyOf(
            net.jqwik.api.Tuple.of(1, started),
            net.jqwik.api.Tuple.of(6, ended),
            net.jqwik.api.Tuple.of(1, retasked))
        .list()
        .ofMaxSize(30);
  }
}
