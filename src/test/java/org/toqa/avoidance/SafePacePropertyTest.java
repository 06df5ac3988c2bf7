package org.toqa.avoidance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import org.toqa.avoidance.Encounter.TimedPoint;
import org.toqa.geometry.Vec2;

class SafePacePropertyTest {
  private static final double RADIUS = 0.1;
  private static final double SAMPLE = 0.03;
  private static final double ACCELERATION = 0.5;
  private static final double FASTEST = 0.5;
  private static final int SAMPLES = 500;
  private static final SafePace PACE = new SafePace(RADIUS, ACCELERATION, SAMPLE);

  /** A disc that strays from where it is told to go, by no more than its drift allows. */
  private static final class Stray {
    private Vec2 position;
    private final Vec2 velocity;
    private final double radius;
    private final double drift;

    Stray(RandomGenerator random, double drift) {
      this.position = new Vec2(4 * random.nextDouble(), 3 * random.nextDouble() - 1.5);
      double speed = 0.5 * random.nextDouble();
      this.velocity = new Vec2(speed, 0).rotated(2 * Math.PI * random.nextDouble());
      this.radius = 0.03 + 0.2 * random.nextDouble();
      this.drift = drift;
    }

    MovingDisc told() {
      return new MovingDisc(position, velocity, radius, drift);
    }

    /** Each step's own velocity is within the drift of the one that is told. */
    void move(RandomGenerator random) {
      Vec2 stray = new Vec2(drift, 0).rotated(2 * Math.PI * random.nextDouble());
      position = position.plus(velocity.plus(stray).times(SAMPLE));
    }
  }

  @Property(tries = 400, edgeCases = EdgeCasesMode.NONE)
  void aRobotDrivesIntoNoDiscWhateverTheyDoWithinTheirDrift(
      @ForAll long seed, @ForAll @IntRange(min = 1, max = 12) int count) {
    RandomGenerator random = new SplittableRandom(seed);
    double drift = random.nextBoolean() ? 0 : 0.1 * random.nextDouble();
    List<Stray> discs = new ArrayList<>();
    while (discs.size() < count) {
      Stray disc = new Stray(random, drift);
      if (disc.position.norm() > disc.radius + RADIUS) {
        discs.add(disc);
      }
    }
    double metres = 0;
    double speed = 0;
    for (int i = 0; i < SAMPLES; i++) {
      double from = metres;
      List<MovingDisc> told = discs.stream().map(Stray::told).toList();
      double next = PACE.next(ahead -> on(from + ahead), speed, FASTEST, told);
      assertTrue(Math.abs(next - speed) <= ACCELERATION * SAMPLE + 1e-12, "brakes as it can");
      List<Vec2> before = discs.stream().map(disc -> disc.position).toList();
      discs.forEach(disc -> disc.move(random));
      metres += next * SAMPLE;
      for (int d = 0; d < discs.size() && next > 0; d++) {
        for (double share = 0; share <= 1; share += 0.25) {
          Vec2 robot = on(from + share * (metres - from));
          Vec2 disc = before.get(d).plus(discs.get(d).position.minus(before.get(d)).times(share));
          double gap = robot.distanceTo(disc) - RADIUS - discs.get(d).radius;
          assertTrue(gap > -1e-3, "drove into a disc by " + gap);
        }
      }
      speed = next;
    }
  }

  /** A path that winds: its points are no farther apart than the metres between them. */
  private static Vec2 on(double metres) {
    return new Vec2(0.8 * metres, 0.2 * Math.sin(3 * metres) * 0.9);
  }

  @Test
  void withNobodyNearItIsAsFastAsItIsTold() {
    double speed = 0;
    for (int i = 0; i < 50; i++) {
      speed = PACE.next(SafePacePropertyTest::on, speed, FASTEST, List.of());
    }
    assertEquals(FASTEST, speed, 1e-12);
  }

  @Test
  void itWaitsForADiscThatCrossesAndGoesOnBehindIt() {
    // crosses x = 1 at 0.2 m/s, from 1 m beside the path
    MovingDisc disc = new MovingDisc(new Vec2(1, -0.5), new Vec2(0, 0.2), 0.15, 0);
    double metres = 0;
    double speed = 0;
    double slowest = 1;
    for (int i = 0; i < 400 && metres < 2; i++) {
      double from = metres;
      speed = PACE.next(ahead -> new Vec2(from + ahead, 0), speed, FASTEST, List.of(disc));
      metres += speed * SAMPLE;
      slowest = i < 20 ? slowest : Math.min(slowest, speed);
      disc = disc.after(SAMPLE);
    }
    assertTrue(slowest < 0.1, "it slowed down to " + slowest);
    assertTrue(metres >= 2, "and went on");
  }

  @Property(tries = 1000, edgeCases = EdgeCasesMode.NONE)
  void encountersAreWhereSmallStepsFindThem(@ForAll long seed) {
    RandomGenerator random = new SplittableRandom(seed);
    Vec2 from = new Vec2(random.nextDouble(), random.nextDouble());
    Vec2 to = new Vec2(random.nextDouble(), random.nextDouble());
    double begin = random.nextDouble();
    double duration = 0.1 + random.nextDouble();
    MovingDisc disc =
        new MovingDisc(
            new Vec2(random.nextDouble(), random.nextDouble()),
            new Vec2(random.nextDouble() - 0.5, random.nextDouble() - 0.5),
            0.1 * random.nextDouble(),
            random.nextBoolean() ? 0 : 0.3 * random.nextDouble());
    Optional<Encounter> found =
        Encounter.first(
            List.of(new TimedPoint(begin, from), new TimedPoint(begin + duration, to)),
            RADIUS,
            List.of(disc));

    int steps = 20_000;
    double first = Double.POSITIVE_INFINITY;
    for (int i = 0; i <= steps && first == Double.POSITIVE_INFINITY; i++) {
      double share = (double) i / steps;
      double time = begin + share * duration;
      Vec2 robot = from.plus(to.minus(from).times(share));
      if (robot.distanceTo(disc.positionAt(time)) < RADIUS + disc.reachAt(time)) {
        first = time;
      }
    }
    if (first < Double.POSITIVE_INFINITY) {
      assertEquals(first, found.orElseThrow().seconds(), 2 * duration / steps);
    } else if (found.isPresent()) { // a touch between two steps
      double time = found.get().seconds();
      double gap = found.get().place().distanceTo(disc.positionAt(time));
      assertEquals(RADIUS + disc.reachAt(time), gap, 1e-6);
    }
  }
}
