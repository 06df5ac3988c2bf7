package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.toqa.grid.Cell;

/** What is told of robots that do not get on, and when. */
class StandstillDetectorTest {
  private static final Duration LIMIT = Duration.ofMinutes(5);

  @Test
  void aRobotThatMayDriveAndDoesNotIsToldOnceItIsLateAndNoLongerWhenItGetsOn() {
    DrivenFloor floor = new DrivenFloor(DrivenFloor.draw("............"), 1);
    floor.put("a", new Cell(0, 0));
    floor.send("a", new Cell(11, 0));
    step(floor, Duration.ofSeconds(2));
    assertFalse(floor.isArrived("a"));
    assertEquals(List.of(), floor.traffic.standstills());

    floor.body("a").isStuck = true;
    Instant stopped = floor.now;
    until(floor, () -> !floor.traffic.standstills().isEmpty());
    Duration after = Duration.between(stopped, floor.now);
    Standstill told = floor.traffic.standstills().getFirst();

    // 10 s and three times a section's time less what it had got on before; a section of the
    // released 3 s takes no more than these
    assertTrue(after.toSeconds() >= 9 && after.toSeconds() <= 10 + 3 * 3 + 1, "after " + after);
    assertEquals(Standstill.Kind.NOT_MOVING, told.kind());
    assertEquals(List.of("a"), told.robots());
    assertEquals(List.of(floor.grid.cellAt(floor.body("a").pose.position())), told.cells());
    assertEquals(1, floor.traffic.standstills().size());

    floor.body("a").isStuck = false;
    until(floor, () -> floor.traffic.standstills().isEmpty());
    until(floor, () -> floor.isArrived("a"));
  }

  @Test
  void robotsThatWaitForEachOtherAreToldOnceThatHasLastedTwoSeconds() {
    DrivenFloor floor = barredAisle();
    until(floor, () -> !floor.traffic.standstills().isEmpty());
    Standstill told = floor.traffic.standstills().getFirst();

    assertEquals(Standstill.Kind.CYCLE_OF_WAITS, told.kind());
    assertEquals(List.of("a", "b"), told.robots());
    assertEquals(List.of(new Cell(0, 1), new Cell(8, 1)), told.cells());
    assertEquals(Duration.ofSeconds(2), Duration.between(told.since(), floor.now));
    step(floor, Duration.ofSeconds(10));
    assertEquals(List.of(told), floor.traffic.standstills());
  }

  @Test
  void aCycleOfWaitsIsOverWhenTheBayIsFreeAndBothArrive() {
    DrivenFloor floor = barredAisle();
    until(floor, () -> !floor.traffic.standstills().isEmpty());
    floor.find("c");
    until(floor, () -> floor.traffic.standstills().isEmpty());
    until(floor, floor::areAllArrived);
  }

  @Test
  void whoWaitsForSomebodyThatDrivesIsInNoStandstill() {
    DrivenFloor floor =
        new DrivenFloor(
            DrivenFloor.draw(
                "#########", //
                ".........",
                "####.####"),
            1);
    floor.put("a", new Cell(0, 1));
    floor.put("b", new Cell(8, 1));
    floor.send("a", new Cell(8, 1));
    floor.send("b", new Cell(0, 1));
    until(
        floor,
        () -> {
          assertEquals(List.of(), floor.traffic.standstills());
          return floor.areAllArrived();
        });
  }

  /** Two robots shall change places; the bay in which one could wait is barred by a lost one. */
  private static DrivenFloor barredAisle() {
    DrivenFloor floor =
        new DrivenFloor(
            DrivenFloor.draw(
                "#########", //
                ".........",
                "####.####",
                "####.####"),
            1);
    floor.put("a", new Cell(0, 1));
    floor.put("b", new Cell(8, 1));
    floor.put("c", new Cell(4, 2));
    floor.lose("c");
    floor.send("a", new Cell(8, 1));
    floor.send("b", new Cell(0, 1));
    return floor;
  }

  private static void step(DrivenFloor floor, Duration time) {
    Instant end = floor.now.plus(time);
    while (floor.now.isBefore(end)) {
      floor.step();
    }
  }

  private static void until(DrivenFloor floor, BooleanSupplier condition) {
    Instant end = floor.now.plus(LIMIT);
    while (!condition.getAsBoolean()) {
      assertTrue(floor.now.isBefore(end), () -> "still so: " + floor.traffic.standstills());
      floor.step();
    }
  }
}
