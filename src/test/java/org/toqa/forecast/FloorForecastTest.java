package org.toqa.forecast;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.function.ToDoubleFunction;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;

class FloorForecastTest {
  private static final Vec2 WEST = new Vec2(0, 0);
  private static final Vec2 EAST = new Vec2(10, 0);

  /** Behind it nobody comes. */
  private static final double WALL = 50;

  private static final Travel LINES =
      new Travel() {
        @Override
        public ToDoubleFunction<Vec2> lengthsTo(Vec2 place, double diameter) {
          return from -> place.x() > WALL ? Double.POSITIVE_INFINITY : place.distanceTo(from);
        }

        @Override
        public Drive drive(Vec2 from, Vec2 to, double diameter) {
          return to.x() > WALL ? Drive.IMPOSSIBLE : new Drive(from.distanceTo(to), 0);
        }
      };

  @Test
  void aQueuedTaskComesAfterWhatItsRobotHas() {
    ForecastTask.Begun begun =
        new ForecastTask.Begun(
            1, 1, List.of(new Visit(EAST, 0)), true, List.of("r1"), new Drive(5, 0), null);

    Map<Long, Expectation> expected = forecast(List.of(robot("r1", WEST)), begun, queued(2));

    assertEquals(OptionalDouble.of(10), at(expected, 1).delivery()); // 5 m at 0.5 m/s
    assertEquals(OptionalDouble.of(30), at(expected, 2).pickUp()); // and 10 m back to west
    assertEquals(OptionalDouble.of(50), at(expected, 2).delivery());
  }

  @Test
  void whoseBatteryIsLowThenChargesFirst() {
    ForecastRobot robot = new ForecastRobot("r1", WEST, 0, 0.25, 0.5, 1, 5, 0.2);
    Charging charging = new Charging(List.of(EAST), 0.2, 0.95, 1000);

    Map<Long, Expectation> expected =
        FloorForecast.of(
            List.of(robot), List.of(), List.of(queued(1), queued(2)), LINES, 1, charging);

    // The first ends at 20 s in the east, where it charges from 19.2 % (10 m of 1200 m) to 95 %.
    double charged = 20 + (0.95 - 0.2 + 10 / 1200.0) * 1000;
    assertEquals(charged + 20, at(expected, 2).pickUp().orElseThrow(), 1);
  }

  @Test
  void severalComeWhereOneIsTooWeak() {
    ForecastTask.Queued heavy = queued(1, 8, false, WEST, EAST);

    Map<Long, Expectation> expected =
        FloorForecast.of(
            List.of(robot("r1", WEST), robot("r2", EAST)),
            List.of(),
            List.of(heavy),
            LINES,
            1,
            Charging.NONE);

    assertEquals(20, at(expected, 1).pickUp().orElseThrow(), 1e-9); // r2 comes 10 m
    assertEquals(Unknown.NO_ROBOT, unknown(queued(1, 8, true, WEST, EAST)));
  }

  @Test
  void whatCannotBeSaidHasItsReason() {
    assertEquals(Unknown.NO_PATH, unknown(queued(1, 1, false, new Vec2(60, 0), EAST)));
    assertEquals(Unknown.NO_PATH, unknown(queued(1, 1, false, WEST, new Vec2(60, 0))));
    assertEquals(Unknown.NO_ROBOT, unknown(queued(1, 30, false, WEST, EAST)));
    ForecastTask.Queued visit =
        new ForecastTask.Queued(
            1,
            1,
            List.of(new Visit(WEST, 0), new Visit(EAST, Double.POSITIVE_INFINITY)),
            List.of(),
            true,
            OptionalLong.empty(),
            0,
            null);
    ForecastTask.Queued after =
        new ForecastTask.Queued(2, 1, visit.visits(), List.of(), true, OptionalLong.of(1), 0, null);

    Map<Long, Expectation> expected =
        FloorForecast.of(
            List.of(robot("r1", WEST), robot("r2", WEST)),
            List.of(),
            List.of(after, visit),
            LINES,
            1,
            Charging.NONE);

    assertEquals(
        new Expectation(OptionalDouble.of(0), OptionalDouble.empty(), Unknown.AWAITS_PERSON),
        expected.get(1L));
    assertEquals(Unknown.AFTER_UNKNOWN, at(expected, 2).unknown());
  }

  @Test
  void theDelayIsWhatRobotsLatelyTook() {
    Delay delay = Delay.NONE;
    assertEquals(1, delay.factor());
    for (int i = 0; i < 3000; i++) {
      delay = delay.measured(1, 1, 0.5);
    }
    assertTrue(delay.factor() > 1.7 && delay.factor() < 2, delay::toString);
    for (int i = 0; i < 3000; i++) {
      delay = delay.measured(1, 1, 1);
    }
    assertTrue(delay.factor() < 1.1, delay::toString);
  }

  @Test
  void aDriveAlongALineTurnsAtItsCorners() {
    Drive drive =
        Drive.along(List.of(WEST, new Vec2(2, 0), new Vec2(2, 0), new Vec2(2, 3)), Math.PI);

    assertEquals(5, drive.metres(), 1e-9);
    assertEquals(1.5 * Math.PI, drive.radians(), 1e-9); // round, and a quarter
  }

  private static Expectation at(Map<Long, Expectation> expected, long task) {
    return Objects.requireNonNull(expected.get(task));
  }

  private static @Nullable Unknown unknown(ForecastTask.Queued task) {
    Map<Long, Expectation> expected =
        FloorForecast.of(
            List.of(robot("r1", WEST)), List.of(), List.of(task), LINES, 1, Charging.NONE);
    return at(expected, task.id()).unknown();
  }

  private static Map<Long, Expectation> forecast(
      List<ForecastRobot> robots, ForecastTask.Begun begun, ForecastTask.Queued queued) {
    return FloorForecast.of(robots, List.of(begun), List.of(queued), LINES, 1, Charging.NONE);
  }

  private static ForecastRobot robot(String name, Vec2 place) {
    return new ForecastRobot(name, place, 0, 0.25, 0.5, 1, 5, null);
  }

  private static ForecastTask.Queued queued(long id) {
    return queued(id, 1, false, WEST, EAST);
  }

  private static ForecastTask.Queued queued(
      long id, double load, boolean isForOne, Vec2 start, Vec2 goal) {
    return new ForecastTask.Queued(
        id,
        load,
        List.of(new Visit(start, 0), new Visit(goal, 0)),
        List.of(),
        isForOne,
        OptionalLong.empty(),
        0,
        null);
  }
}
