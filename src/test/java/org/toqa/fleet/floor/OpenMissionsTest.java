package org.toqa.fleet.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Vec2;
import org.toqa.mission.AssignedRobot;
import org.toqa.mission.Mission;
import org.toqa.mission.Phase;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Sentence;

class OpenMissionsTest {
  private static final Instant AT = Instant.EPOCH;
  private static final List<String> ROBOTS = List.of("r1", "r2", "r3", "r4");

  /** Whatever comes, goes and changes hands: as if all missions were looked through in order. */
  @Test
  void aRobotsMissionIsTheFirstThatItWorksFor() {
    SplittableRandom random = new SplittableRandom(1);
    OpenMissions missions = new OpenMissions();
    Map<Long, Mission> open = new LinkedHashMap<>();
    Map<Long, Mission> stored = new LinkedHashMap<>();
    int found = 0;
    for (int step = 0; step < 5_000; step++) {
      Mission mission = randomMission(random.nextInt(6), random);
      switch (random.nextInt(5)) {
        case 0, 1 -> {
          missions.put(mission, AT);
          update(open, mission, mission.state().isEnded());
        }
        case 2, 3 -> {
          missions.setStored(mission);
          update(stored, mission, mission.state().isEnded() || mission.state() == TaskState.QUEUED);
        }
        default -> {
          missions.remove(mission.id());
          open.remove(mission.id());
        }
      }
      for (String robot : ROBOTS) {
        assertEquals(firstOf(robot, open), missions.missionOf(robot));
        assertEquals(firstOf(robot, stored), missions.storedMissionOf(robot));
        found += missions.missionOf(robot).isPresent() ? 1 : 0;
      }
    }
    assertTrue(found > 1_000 && found < 19_000, "found " + found); // neither never nor always
  }

  /** Most tasks look as they did a tick before. */
  @Test
  void aMissionLooksTheSameUntilItWaitsForAnother() {
    Mission mission = randomMission(7, new SplittableRandom(1));
    OpenMissions.DatedMission dated = new OpenMissions.DatedMission(mission, AT);
    Sentence waits = Sentence.verbatim("for a door");
    TaskView first = dated.view(waits);
    assertEquals(TaskView.of(mission, waits, AT), first);
    assertSame(first, dated.view(Sentence.verbatim("for a door")));
    assertEquals(TaskView.of(mission, null, AT), dated.view(null));
    assertEquals(first, dated.view(waits));
  }

  private static void update(Map<Long, Mission> missions, Mission mission, boolean isOver) {
    if (isOver) {
      missions.remove(mission.id());
    } else {
      missions.put(mission.id(), mission);
    }
  }

  private static Optional<Mission> firstOf(String robot, Map<Long, Mission> missions) {
    return missions.values().stream()
        .filter(m -> m.assignedRobot(robot).filter(a -> !a.unassigned()).isPresent())
        .findFirst();
  }

  private static Mission randomMission(long id, SplittableRandom random) {
    TaskPlace place = new TaskPlace(Vec2.ZERO, null);
    TransportTask task =
        new TransportTask(id, "t", 1, place, place, "hall", 0, null, null, "Max", AT);
    TaskState state = TaskState.values()[random.nextInt(TaskState.values().length)];
    List<String> names = new ArrayList<>(ROBOTS);
    List<AssignedRobot> robots =
        IntStream.range(0, random.nextInt(3))
            .mapToObj(
                _ ->
                    new AssignedRobot(
                        names.remove(random.nextInt(names.size())),
                        Phase.TO_OBJECT,
                        random.nextBoolean(),
                        random.nextInt(3) == 0))
            .toList();
    return new Mission(task, state, robots, false, null, null, null);
  }
}
