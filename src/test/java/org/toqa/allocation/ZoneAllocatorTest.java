package org.toqa.allocation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.toqa.allocation.Floors.busy;
import static org.toqa.allocation.Floors.free;
import static org.toqa.allocation.Floors.job;
import static org.toqa.allocation.Floors.situation;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.wording.Sentence;

/** The floor is 80 m long; four robots make zones of 20 m. */
class ZoneAllocatorTest {
  private final Allocator allocator = new ZoneAllocator();

  @Test
  void theRobotThatParksInTheLoadsZoneComesFirst() {
    assertEquals(
        given("r2", "the load lies in zone 2 of 4, and it parks there"),
        allocate(21, free("r1", 5, 10), free("r2", 5, 39), free("r3", 5, 50), free("r4", 5, 70)));
  }

  @Test
  void thenThoseBesideItTheNearerOneFirst() {
    assertEquals(
        given("r3", "the load lies in zone 2 of 4, and it parks beside it, in zone 3"),
        allocate(
            38, free("r1", 5, 10), busy("r2", 5, 39, 9), free("r3", 5, 50), free("r4", 5, 70)));
  }

  @Test
  void theSearchWidensBeyondTheZonesBestRobots() {
    assertEquals(
        given(
            "r4",
            "the load lies in zone 1 of 4; it parks in zone 4, the nearest with a free robot"),
        allocate(
            5, busy("r1", 5, 10, 7), busy("r2", 5, 39, 8), free("weak", 1, 50), free("r4", 5, 70)));
  }

  @Test
  void zonesFollowTheOrderOfTheParkingPointsNotTheirDistances() {
    // both park at the right end; the first of them still has the first zone
    assertEquals(
        given("b", "the load lies in zone 1 of 2, and it parks there"),
        allocate(5, free("a", 5, 79), free("b", 5, 78)));
  }

  private static List<Decision> given(String robot, String why) {
    return List.of(new Decision.Assigned(1, List.of(robot), Sentence.verbatim(why)));
  }

  private List<Decision> allocate(double x, Candidate... robots) {
    return Outcome.inEnglish(allocator.allocate(situation(List.of(job(1, 3, x)), List.of(robots))));
  }
}
