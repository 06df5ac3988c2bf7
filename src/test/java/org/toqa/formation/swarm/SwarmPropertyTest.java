package org.toqa.formation.swarm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Random;
import java.util.stream.IntStream;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Vec2;

class SwarmPropertyTest {
  private static final double ROUNDING = 1e-9;
  private static final double WIDTH = 1;

  /** Any swarm, on a lattice of a third of a robot's width so that ties are frequent. */
  @Provide
  Arbitrary<List<SwarmRobot>> swarms() {
    Arbitrary<Double> lattice = Arbitraries.integers().between(-20, 20).map(i -> i / 3.0);
    Arbitrary<Vec2> points = Combinators.combine(lattice, lattice).as(Vec2::new);
    return Combinators.combine(points, points)
        .as(SwarmRobot::new)
        .list()
        .ofMinSize(1)
        .ofMaxSize(12);
  }

  @Property
  void theLeaderOfASwarmInItsPlacesStaysWhoeverIsLost(
      @ForAll("swarms") List<SwarmRobot> robots,
      @ForAll @DoubleRange(min = -50, max = 50) double x,
      @ForAll long seed) {
    Vec2 leader = new Vec2(x, 7);
    List<SwarmRobot> inPlace =
        new ArrayList<>(
            robots.stream().map(r -> new SwarmRobot(leader.plus(r.wanted()), r.wanted())).toList());
    Random random = new Random(seed);
    while (!inPlace.isEmpty()) {
      assertEquals(0, VirtualLeader.position(inPlace).distanceTo(leader), ROUNDING);
      assertEquals(0, VirtualLeader.shapeError(inPlace), ROUNDING);
      inPlace.remove(random.nextInt(inPlace.size()));
    }
  }

  /** Two robots at 0 and 4 that should be at -1 and 1: leaders 1 and 3, mean 2; both 1 off. */
  @Example
  void theShapeErrorIsTheRootOfTheMeanSquare() {
    List<SwarmRobot> robots =
        List.of(
            new SwarmRobot(Vec2.ZERO, new Vec2(-1, 0)),
            new SwarmRobot(new Vec2(4, 0), new Vec2(1, 0)));

    assertEquals(new Vec2(2, 0), VirtualLeader.position(robots));
    assertEquals(1, VirtualLeader.shapeError(robots), ROUNDING);
  }

  @Property
  void observersAreThoseOfTheRulesReadOneByOne(
      @ForAll("swarms") List<SwarmRobot> robots,
      @ForAll @DoubleRange(min = -3.1, max = 3.1) double direction) {
    assertEquals(byTheWords(robots, direction), Observers.of(robots, direction, WIDTH));
  }

  /** The paper's sentences in their order, with sorting, and equations 4 and 5 written out. */
  private static Observers byTheWords(List<SwarmRobot> robots, double o) {
    int n = robots.size();
    if (n == 1) {
      return new Observers(OptionalInt.empty(), OptionalInt.of(0), OptionalInt.empty());
    }
    Vec2 l = VirtualLeader.position(robots);
    double[] xs = new double[n];
    double[] ys = new double[n];
    for (int i = 0; i < n; i++) {
      double x = robots.get(i).position().x() - l.x();
      double y = robots.get(i).position().y() - l.y();
      xs[i] = x * Math.cos(o) + y * Math.sin(o);
      ys[i] = y * Math.cos(o) - x * Math.sin(o);
    }
    List<Integer> all = IntStream.range(0, n).boxed().toList();
    int left = best(all, i -> ys[i], i -> xs[i]);
    List<Integer> others = all.stream().filter(i -> i != left).toList();
    int right = best(others, i -> -ys[i], i -> xs[i]);
    List<Integer> rest = others.stream().filter(i -> i != right).toList();
    OptionalInt middle =
        rest.isEmpty()
            ? OptionalInt.empty()
            : OptionalInt.of(best(rest, i -> xs[i], i -> -Math.abs(ys[i])));
    return new Observers(OptionalInt.of(left), middle, OptionalInt.of(right));
  }

  private interface Measure {
    double of(int robot);
  }

  private static int best(List<Integer> robots, Measure first, Measure second) {
    double most = robots.stream().mapToDouble(first::of).max().orElseThrow();
    return robots.stream()
        .filter(i -> most - first.of(i) < WIDTH / 2)
        .max(Comparator.<Integer>comparingDouble(second::of).thenComparing(i -> -i))
        .orElseThrow();
  }

  /** Fig. 6 of the paper in numbers: who is foremost and rightmost is the right one. */
  @Example
  void theForemostOfTheRightFlankIsRightAndTheNextBestIsMiddle() {
    List<SwarmRobot> robots =
        java.util.stream.Stream.of(new Vec2(0, 5), new Vec2(2, 0), new Vec2(4, -5), new Vec2(0, 0))
            .map(p -> new SwarmRobot(p, p))
            .toList();

    Observers observers = Observers.of(robots, 0, WIDTH);

    assertEquals(new Observers(OptionalInt.of(0), OptionalInt.of(1), OptionalInt.of(2)), observers);
    assertEquals(3, observers.count());
  }

  @Property
  void noMoreThanThreeLidarsAreOn(@ForAll("swarms") List<SwarmRobot> robots) {
    Observers observers = Observers.of(robots, 0, WIDTH);

    assertEquals(Math.min(3, robots.size()), observers.count());
    assertEquals(
        1 - observers.count() / (double) robots.size(), Observers.saving(robots.size()), ROUNDING);
  }

  /** The table of the paper, row by row, for a swarm that drives east. */
  @Example
  void turnsAreThoseOfTheTable() {
    SwarmLaw law = new SwarmLaw(Math.toRadians(5), 0, 0);
    Map<String, Turn> table = new HashMap<>();
    table.put("l", Turn.RIGHT);
    table.put("lm", Turn.RIGHT);
    table.put("r", Turn.LEFT);
    table.put("mr", Turn.LEFT);
    table.put("lr", Turn.STRAIGHT);
    table.put("", Turn.LEFT); // the target
    table.put("m", Turn.LEFT);
    table.put("lmr", Turn.LEFT);
    Vec2 target = new Vec2(10, 10);
    table.forEach(
        (who, turn) ->
            assertEquals(
                turn,
                law.next(SwarmLaw.Motion.straight(0), seenBy(who), target, new Random(1)).last(),
                who));
    for (Turn last : List.of(Turn.LEFT, Turn.RIGHT)) {
      for (String who : List.of("m", "lmr")) {
        SwarmLaw.Motion motion = new SwarmLaw.Motion(0, last);
        assertEquals(last, law.next(motion, seenBy(who), target, new Random(1)).last());
      }
    }
  }

  private static Sightings seenBy(String who) {
    return new Sightings(who.contains("l"), who.contains("m"), who.contains("r"));
  }

  @Property
  void theDirectionChangesByOneStepAtMost(
      @ForAll boolean left,
      @ForAll boolean middle,
      @ForAll boolean right,
      @ForAll @DoubleRange(min = -3.1, max = 3.1) double direction,
      @ForAll Turn last,
      @ForAll long seed) {
    SwarmLaw law = SwarmLaw.published(Math.toRadians(20));
    SwarmLaw.Motion motion = new SwarmLaw.Motion(direction, last);

    SwarmLaw.Motion next =
        law.next(motion, new Sightings(left, middle, right), new Vec2(1, 0), new Random(seed));

    double turned = Angles.difference(direction, next.direction());
    assertEquals(next.last().sign() * Math.toRadians(20), turned, ROUNDING);
  }

  /** Both epsilons within five standard deviations of 200,000 throws. */
  @Example
  void theOppositeTurnIsTakenAsOftenAsPublished() {
    SwarmLaw law = SwarmLaw.published(Math.toRadians(5));
    Random random = new Random(1);
    int throwsCount = 200_000;
    for (boolean isSeen : new boolean[] {true, false}) {
      Sightings seen = new Sightings(isSeen, false, false);
      Turn usual = isSeen ? Turn.RIGHT : Turn.LEFT;
      int opposite = 0;
      for (int i = 0; i < throwsCount; i++) {
        Turn turn = law.next(SwarmLaw.Motion.straight(0), seen, new Vec2(0, 10), random).last();
        opposite += turn == usual ? 0 : 1;
      }
      double epsilon = isSeen ? 0.001 : 0.01;
      double spread = Math.sqrt(epsilon * (1 - epsilon) / throwsCount);
      assertTrue(Math.abs(opposite / (double) throwsCount - epsilon) < 5 * spread);
    }
  }
}
