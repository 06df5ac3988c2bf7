package org.toqa.allocation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.toqa.allocation.Floors.busy;
import static org.toqa.allocation.Floors.free;
import static org.toqa.allocation.Floors.job;
import static org.toqa.allocation.Floors.situation;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;
import org.toqa.wording.Sentence;

/** Loads for several robots by zones; the floor is 80 m long, four robots make zones of 20 m. */
class ZoneTeamsTest {
  private static final Candidate FIRST = free("r1", 5, 10);
  private static final Candidate SECOND = free("r2", 5, 30);
  private static final Candidate THIRD = free("r3", 5, 50);
  private static final Candidate FOURTH = free("r4", 5, 70);

  @Test
  void inTheFirstZoneItsRobotLeadsAndTheOthersComeFromTheRight() {
    assertEquals(
        given(
            List.of("r1", "r2", "r3"),
            "too heavy for one robot; 3 carry 4.0 kg each, led by r1, which parks in zone 1;"
                + " the load lies in zone 1 of 4"),
        allocate(12, 5, FIRST, SECOND, THIRD, FOURTH));
  }

  @Test
  void inAMiddleZoneItsRobotLeadsAndTheOthersComeFromBothSides() {
    assertEquals(
        given(
            List.of("r3", "r2", "r4"),
            "too heavy for one robot; 3 carry 4.0 kg each, led by r3, which parks in zone 3;"
                + " the load lies in zone 3 of 4"),
        allocate(12, 45, FIRST, SECOND, THIRD, FOURTH));
  }

  @Test
  void inTheLastZoneTheSearchWidensPastRobotsThatAreNotFree() {
    assertEquals(
        given(
            List.of("r4", "r2", "r1"),
            "too heavy for one robot; 3 carry 4.0 kg each, led by r4, which parks in zone 4;"
                + " the load lies in zone 4 of 4"),
        allocate(12, 75, FIRST, SECOND, busy("r3", 5, 50, 9), FOURTH));
  }

  @Test
  void aRobotThatComesHomeFromAnotherZoneCountsByWhereItParks() {
    // three zones; r4 drives home past the load, and the others park nearer to it
    Candidate returning = at(FOURTH, new Vec2(30, 5));
    assertEquals(
        List.of("r2", "r1"), Outcome.robots(allocate(8, 30, FIRST, SECOND, returning).getFirst()));
    assertEquals(
        List.of("r1", "r4"),
        Outcome.robots(allocate(8, 30, FIRST, busy("r2", 5, 30, 9), returning).getFirst()));
  }

  @Test
  void tooFewRobotsWaitWithTheNumberThatIsNeeded() {
    assertEquals(
        List.of(
            new Decision.Unassigned(
                1, Sentence.verbatim("It needs 3 robots together; 2 of 3 are free."), List.of())),
        allocate(12, 5, FIRST, busy("r2", 5, 30, 9), FOURTH));
  }

  private static Candidate at(Candidate robot, Vec2 position) {
    return new Candidate(
        robot.robot(),
        robot.maxLoad(),
        robot.diameter(),
        robot.speed(),
        robot.isOmnidirectional(),
        position,
        robot.parking(),
        robot.battery(),
        robot.availability(),
        robot.task());
  }

  private static List<Decision> given(List<String> robots, String why) {
    return List.of(new Decision.Assigned(1, robots, Sentence.verbatim(why)));
  }

  private static List<Decision> allocate(double load, double x, Candidate... robots) {
    return Outcome.inEnglish(
        NegotiatedAllocator.of(Policy.ZONES)
            .allocate(situation(List.of(job(1, load, x)), List.of(robots))));
  }
}
