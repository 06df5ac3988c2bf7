package org.toqa.fleet.dispatch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.toqa.allocation.AllocationTask;
import org.toqa.allocation.Availability;
import org.toqa.allocation.Candidate;
import org.toqa.formation.GroupMobility;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TaskPlace;
import org.toqa.wording.Sentence;

class RoomFindingsTest {
  private static final Instant NOON = Instant.parse("2026-11-29T12:00:00Z");
  private static final Sentence WHY = Sentence.verbatim("There is no room.");
  private static final long TASK = 7;

  private static final AllocationTask JOB =
      new AllocationTask(TASK, 8, Vec2.ZERO, new Vec2(5, 5), NOON);

  private final RoomFindings rooms = new RoomFindings();

  @Test
  void narrowerRobotsMayHaveIt() {
    List<Candidate> robots =
        List.of(robot("a", 0.6, false), robot("b", 0.3, false), robot("c", 0.3, false));
    rooms.add(JOB, question(0.6, GroupMobility.NON_HOLONOMIC), WHY, robots, NOON);

    assertEquals(List.of("b", "c"), allowed(robots));
    assertFalse(rooms.isWithoutRoom(TASK));

    rooms.add(JOB, question(0.3, GroupMobility.NON_HOLONOMIC), WHY, robots, NOON);
    assertTrue(rooms.isWithoutRoom(TASK));
  }

  @Test
  void thoseThatCanGoSidewaysMayHaveItThoughTheyAreWider() {
    List<Candidate> robots =
        List.of(robot("a", 0.3, false), robot("b", 0.3, false), robot("c", 0.6, true));
    rooms.add(JOB, question(0.3, GroupMobility.NON_HOLONOMIC), WHY, robots, NOON);
    assertTrue(rooms.isWithoutRoom(TASK)); // one alone is too weak

    List<Candidate> more =
        List.of(
            robot("a", 0.3, false),
            robot("b", 0.3, false),
            robot("c", 0.6, true),
            robot("d", 0.6, true));
    rooms.add(JOB, question(0.3, GroupMobility.NON_HOLONOMIC), WHY, more, NOON);
    assertEquals(List.of("c", "d"), allowed(more));

    rooms.add(JOB, question(0.6, GroupMobility.FORWARD), WHY, more, NOON);
    assertTrue(rooms.isWithoutRoom(TASK));
  }

  @Test
  void afterAWhileEveryTeamIsTriedAgain() {
    List<Candidate> robots =
        List.of(robot("a", 0.6, false), robot("b", 0.3, false), robot("c", 0.3, false));
    rooms.add(JOB, question(0.6, GroupMobility.NON_HOLONOMIC), WHY, robots, NOON);

    assertEquals(Map.of(), rooms.takeDue(NOON.plusSeconds(59)));
    assertEquals(
        List.of(TASK), List.copyOf(rooms.takeDue(NOON.plus(Duration.ofMinutes(1))).keySet()));
    assertEquals(List.of("a", "b", "c"), allowed(robots));
  }

  private List<String> allowed(List<Candidate> robots) {
    AllocationTask job = rooms.restricted(JOB, robots);
    return robots.stream().filter(job::allowsInTeam).map(Candidate::robot).toList();
  }

  private static PathQuery.TeamQuestion question(double diameter, GroupMobility mobility) {
    return new PathQuery.TeamQuestion(
        new TaskPlace(Vec2.ZERO, null), List.of(), 2, diameter, mobility, null);
  }

  private static Candidate robot(String name, double diameter, boolean isOmnidirectional) {
    return new Candidate(
        name,
        5,
        diameter,
        0.25,
        isOmnidirectional,
        Vec2.ZERO,
        Vec2.ZERO,
        1.0,
        Availability.FREE,
        null);
  }
}
