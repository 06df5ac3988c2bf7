package org.toqa.fleet.dispatch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.time.Instant;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.Answer;
import org.toqa.fleet.TaskOrder;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

class OrderValidatorTest {
  /** An aisle of a certain width in cells of 5 cm, four metres long from west to east. */
  private static FloorMap aisle(int width) {
    int columns = 80;
    BitSet walls = new BitSet();
    walls.set(0, columns);
    walls.set((width + 1) * columns, (width + 2) * columns);
    OccupancyGrid grid = new OccupancyGrid(columns, width + 2, 0.05, Vec2.ZERO, walls);
    return new FloorMap("aisle", grid, List.of(), List.of(), List.of());
  }

  private static Answer<TransportTask> carry(FloorMap floor, Vec2 from, Vec2 to) {
    TaskOrder order =
        new TaskOrder(
            "Carry",
            1,
            new TaskOrder.Where.Point(from),
            new TaskOrder.Where.Point(to),
            null,
            0,
            null,
            null);
    return new OrderValidator(floor, Set.of(), new PathQuery(Runnable::run))
        .checkTask(
            order,
            "clerk",
            Instant.EPOCH,
            new Capacity(100, List.of(), Map.of()),
            new OrderChecks(Runnable::run, 1, System::nanoTime).begin("clerk"))
        .toCompletableFuture()
        .join();
  }

  /** The robot of 25.5 cm fits between the walls though on no cell's middle. */
  @Test
  void anAisleHardlyWiderThanTheRobotIsAPath() {
    Answer<TransportTask> answer = carry(aisle(6), new Vec2(0.5, 0.2), new Vec2(3.5, 0.2));
    assertInstanceOf(Answer.Accepted.class, answer, answer::toString);
  }

  @Test
  void noRobotStandsInAnAisleNarrowerThanItself() {
    assertEquals(
        new Answer.Rejected<>(
            "start",
            Phrase.LIES_IN_WALL.with(Phrase.START.with(), Sentence.of(new Vec2(0.5, 0.18)))),
        carry(aisle(5), new Vec2(0.5, 0.18), new Vec2(3.5, 0.18)));
  }
}
