package org.toqa.forecast;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.Random;
import java.util.function.ToDoubleFunction;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/** What holds for a forecast of any floor. */
class FloorForecastPropertyTest {
  private static final double ROUNDING = 1e-6;

  /** Paths are straight lines, so many times as long, with a turn at each end. */
  private record Straight(double times) implements Travel {
    @Override
    public ToDoubleFunction<Vec2> lengthsTo(Vec2 place, double diameter) {
      return from -> times * place.distanceTo(from);
    }

    @Override
    public Drive drive(Vec2 from, Vec2 to, double diameter) {
      return new Drive(times * from.distanceTo(to), Math.PI);
    }
  }

  @Property(tries = 60)
  void everyTaskHasATimeInOrderOrAReason(
      @ForAll Random random,
      @ForAll @IntRange(max = 5) int robots,
      @ForAll @IntRange(max = 8) int n) {
    List<ForecastRobot> fleet = robots(random, robots);
    List<ForecastTask.Begun> begun = new ArrayList<>();
    for (int i = 0; i < robots; i += 2) {
      begun.add(begun(random, i, fleet.get(i)));
    }
    List<ForecastTask.Queued> queued = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      OptionalLong after =
          i > 0 && random.nextInt(4) == 0 ? OptionalLong.of(100 + i - 1) : OptionalLong.empty();
      queued.add(queued(random, 100 + i, after, random.nextInt(5) == 0 ? Unknown.ON_HOLD : null));
    }

    Map<Long, Expectation> expected =
        FloorForecast.of(
            fleet,
            begun,
            queued,
            new Straight(1),
            1.2,
            new Charging(List.of(place(random)), 0.2, 0.95, 1800));

    assertEquals(begun.size() + queued.size(), expected.size());
    expected.forEach(
        (id, times) -> {
          assertEquals(
              times.delivery().isEmpty(), times.unknown() != null, () -> id + ": " + times);
          times.pickUp().ifPresent(at -> assertTrue(at >= 0, times::toString));
          times
              .delivery()
              .ifPresent(at -> assertTrue(at >= times.pickUp().orElse(0), times::toString));
        });
    for (ForecastTask.Queued task : queued) {
      OptionalDouble pickUp = Objects.requireNonNull(expected.get(task.id())).pickUp();
      if (task.after().isPresent() && pickUp.isPresent()) {
        Expectation before = Objects.requireNonNull(expected.get(task.after().getAsLong()));
        assertTrue(pickUp.getAsDouble() >= before.delivery().orElseThrow() - ROUNDING);
      }
    }
  }

  @Property(tries = 60)
  void aLongerPathMakesNothingEarlier(
      @ForAll Random random, @ForAll @DoubleRange(min = 1, max = 3) double times) {
    ForecastRobot robot = robots(random, 1).getFirst();
    ForecastTask.Queued task = queued(random, 1, OptionalLong.empty(), null);

    Expectation near = only(robot, task, new Straight(1), 1);
    Expectation far = only(robot, task, new Straight(times), 1);
    Expectation delayed = only(robot, task, new Straight(1), times);

    for (Expectation later : List.of(far, delayed)) {
      assertTrue(later.pickUp().orElseThrow() >= near.pickUp().orElseThrow() - ROUNDING);
      assertTrue(later.delivery().orElseThrow() >= near.delivery().orElseThrow() - ROUNDING);
    }
  }

  @Property(tries = 60)
  void aloneOnTheFloorItIsLengthOverSpeedAndTurnsOverTheirRate(@ForAll Random random) {
    ForecastRobot robot = robots(random, 1).getFirst();
    ForecastTask.Queued task = queued(random, 1, OptionalLong.empty(), null);

    Expectation expected = only(robot, task, new Straight(1), 1);

    double seconds = 0;
    Vec2 at = robot.place();
    for (Visit visit : task.visits()) {
      seconds +=
          at.distanceTo(visit.place()) / robot.speed()
              + Math.PI / robot.turnRate()
              + visit.waitSeconds();
      at = visit.place();
    }
    assertEquals(seconds, expected.delivery().orElseThrow(), ROUNDING);
  }

  @Property(tries = 30)
  void oneRobotDoesOneTaskAfterTheOther(
      @ForAll Random random, @ForAll @IntRange(min = 2, max = 6) int n) {
    ForecastRobot robot = robots(random, 1).getFirst();
    List<ForecastTask.Queued> tasks = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      tasks.add(queued(random, i, OptionalLong.empty(), null));
    }

    Map<Long, Expectation> expected =
        FloorForecast.of(List.of(robot), List.of(), tasks, new Straight(1), 1, Charging.NONE);

    List<Expectation> inOrder =
        expected.values().stream()
            .sorted(
                (a, b) -> Double.compare(a.delivery().orElseThrow(), b.delivery().orElseThrow()))
            .toList();
    for (int i = 1; i < n; i++) {
      assertTrue(
          inOrder.get(i).pickUp().orElseThrow()
              >= inOrder.get(i - 1).delivery().orElseThrow() - ROUNDING);
    }
  }

  private static Expectation only(
      ForecastRobot robot, ForecastTask.Queued task, Travel travel, double delay) {
    return Objects.requireNonNull(
        FloorForecast.of(List.of(robot), List.of(), List.of(task), travel, delay, Charging.NONE)
            .get(task.id()));
  }

  private static List<ForecastRobot> robots(Random random, int count) {
    List<ForecastRobot> robots = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      robots.add(
          new ForecastRobot(
              "r" + i,
              place(random),
              0,
              0.255,
              0.1 + random.nextDouble(),
              0.5 + random.nextDouble(),
              5,
              random.nextDouble()));
    }
    return robots;
  }

  private static ForecastTask.Begun begun(Random random, long id, ForecastRobot robot) {
    return new ForecastTask.Begun(
        id,
        1,
        List.of(new Visit(place(random), 0)),
        random.nextBoolean(),
        List.of(robot.name()),
        new Drive(10 * random.nextDouble(), random.nextDouble()),
        null);
  }

  private static ForecastTask.Queued queued(
      Random random, long id, OptionalLong after, @Nullable Unknown unknown) {
    return new ForecastTask.Queued(
        id,
        5 * random.nextDouble(),
        List.of(new Visit(place(random), 0), new Visit(place(random), random.nextInt(20))),
        List.of(),
        false,
        after,
        100 * random.nextDouble(),
        unknown);
  }

  private static Vec2 place(Random random) {
    return new Vec2(20 * random.nextDouble(), 10 * random.nextDouble());
  }
}
