package org.toqa.localisation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.BitSet;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.localisation.RangeFilter.Correction;
import org.toqa.localisation.RangeFilter.Range;

/** Robots in a room of 4 m x 3 m whose walls are exactly known. */
class RangeFilterPropertyTest {
  private static final Walls ROOM =
      new GridWalls(new OccupancyGrid(40, 30, 0.1, Vec2.ZERO, new BitSet()));

  private static final List<Pose> BEAMS =
      Stream.of(-0.5, 0.0, 0.5, 1.0)
          .map(turns -> new Pose(0.03, 0.02, turns * Math.PI)) // not in the middle
          .toList();

  private static final double DEVIATION = 0.01;

  private final RangeFilter filter = new RangeFilter(new RangeFilter.Body(0.2, 1e-4, 0.02, 5));

  private static List<Range> ranges(Pose truth, SplittableRandom noise, double deviation) {
    return BEAMS.stream()
        .map(
            beam -> {
              double metres = ROOM.hit(truth.compose(beam), 10).orElseThrow().distance();
              return new Range(beam, metres + deviation * noise.nextGaussian(), DEVIATION);
            })
        .toList();
  }

  /** Its place; of its heading, walls that it meets squarely tell hardly anything. */
  @Property(tries = 100)
  void aRobotThatIsALittleWrongIsCorrected(
      @ForAll @DoubleRange(min = 1, max = 3) double x,
      @ForAll @DoubleRange(min = 1, max = 2) double y,
      @ForAll @DoubleRange(min = -0.2, max = 0.2) double theta,
      @ForAll @DoubleRange(min = -0.1, max = 0.1) double wrong,
      @ForAll long seed) {
    Pose truth = new Pose(x, y, theta);
    PoseEstimate estimate =
        PoseEstimate.of(new Pose(x + wrong, y - wrong, theta + wrong / 2), 0.06, 0.06);
    SplittableRandom noise = new SplittableRandom(seed);
    int used = 0;
    for (int i = 0; i < 20; i++) {
      Correction correction = filter.corrected(estimate, ranges(truth, noise, DEVIATION), ROOM);
      estimate = correction.estimate();
      used += correction.used();
    }
    assertTrue(used > 40, "believed: " + used);
    assertTrue(estimate.pose().distanceTo(truth) < 0.02, estimate::toString);
    assertTrue(estimate.positionDeviation() < 0.006, estimate::toString);
  }

  /** The derivatives by which it corrects are those of the rays themselves. */
  @Property(tries = 100)
  void anErrorTooSmallToBendAnythingIsCorrectedExactly(
      @ForAll @DoubleRange(min = 1.5, max = 2.5) double x,
      @ForAll @DoubleRange(min = 1.3, max = 1.7) double y,
      @ForAll @DoubleRange(min = 0.15, max = 0.25) double theta) {
    Pose truth = new Pose(x, y, theta);
    PoseEstimate estimate = PoseEstimate.of(new Pose(x + 1e-4, y - 2e-4, theta + 1e-4), 0.01, 0.01);
    List<Range> exact =
        ranges(truth, new SplittableRandom(1), 0).stream()
            .map(range -> new Range(range.beam(), range.metres(), 1e-6))
            .toList();
    estimate = filter.corrected(estimate, exact, ROOM).estimate();
    assertEquals(0, estimate.pose().distanceTo(truth), 1e-5);
    assertEquals(0, Angles.difference(theta, estimate.pose().theta()), 1e-5);
  }

  /** P stays a covariance, and grows with what is driven. */
  @Property(tries = 100)
  void drivingMakesItLessSure(
      @ForAll @DoubleRange(min = -3, max = 3) double theta,
      @ForAll @DoubleRange(min = -0.3, max = 0.3) double step,
      @ForAll @DoubleRange(min = -0.5, max = 0.5) double turn) {
    Pose odometry = new Pose(5, -3, 1); // of any frame
    PoseEstimate estimate = PoseEstimate.of(new Pose(1, 1, theta), 0.01, 0.01);
    for (int i = 0; i < 10; i++) {
      Pose next = odometry.compose(new Pose(step, 0, turn));
      PoseEstimate after = filter.moved(estimate, odometry, next);
      assertEquals(
          0, after.pose().distanceTo(estimate.pose().compose(odometry.relative(next))), 1e-9);
      assertTrue(after.tt() >= estimate.tt());
      assertTrue(after.xx() * after.yy() >= after.xy() * after.xy());
      assertTrue(after.xx() * after.tt() >= after.xt() * after.xt());
      odometry = next;
      estimate = after;
    }
  }

  @Test
  void somebodyWhoStandsBeforeTheWallIsNotTakenForIt() {
    Pose truth = new Pose(2, 1.5, 0);
    PoseEstimate estimate = PoseEstimate.of(truth, 0.02, 0.02);
    Range near = new Range(BEAMS.get(1), 0.8, DEVIATION);

    Correction correction = filter.corrected(estimate, List.of(near), ROOM);

    assertEquals(new Correction(estimate, 0, 1, 0), correction);
  }

  @Test
  void edgesSlantsNothingAndWhoIsLostTellNothing() {
    BitSet pillar = new BitSet();
    pillar.set(15 * 40 + 30); // from (3, 1.4) to (3.1, 1.5)
    Walls walls = new GridWalls(new OccupancyGrid(40, 30, 0.1, Vec2.ZERO, pillar));
    Pose ahead = new Pose(0, 0, 0);
    List<Range> two = List.of(new Range(ahead, 1, DEVIATION));
    Pose atEdge = new Pose(2, 1.495, 0);
    assertUnused(PoseEstimate.of(atEdge, 0.01, 0.01), two, walls);
    Pose aslant = new Pose(0.3, 2, 0.4); // (3 - 2) / sin 0.4 = 2.57 m to the upper wall
    assertUnused(
        PoseEstimate.of(aslant, 0.01, 0.01), List.of(new Range(ahead, 2.57, DEVIATION)), ROOM);
    Pose middle = new Pose(2, 1.5, 0);
    for (double nothing : new double[] {0, 0.02}) {
      assertUnused(
          PoseEstimate.of(middle, 0.01, 0.01), List.of(new Range(ahead, nothing, DEVIATION)), ROOM);
    }
    assertUnused(PoseEstimate.of(middle, 0.2, 0.01), two, ROOM);
    assertUnused(PoseEstimate.of(new Pose(-1, 1, 0), 0.01, 0.01), two, ROOM);
  }

  /** A wall that is 2 m ahead, and one at the end of what the sensor sees. */
  @Test
  void whoSeesNothingWhereAWallShouldBeMissesIt() {
    PoseEstimate middle = PoseEstimate.of(new Pose(2, 1.5, 0), 0.01, 0.01);
    Pose ahead = new Pose(0, 0, 0);
    for (double nothing : new double[] {5, 7}) {
      List<Range> ranges = List.of(new Range(ahead, nothing, DEVIATION));
      assertEquals(new Correction(middle, 0, 0, 1), filter.corrected(middle, ranges, ROOM));
    }
    RangeFilter shortSighted = new RangeFilter(new RangeFilter.Body(0.2, 1e-4, 0.02, 2.01));
    List<Range> ranges = List.of(new Range(ahead, 2.01, DEVIATION));
    assertEquals(new Correction(middle, 0, 0, 0), shortSighted.corrected(middle, ranges, ROOM));
  }

  private void assertUnused(PoseEstimate estimate, List<Range> ranges, Walls walls) {
    assertEquals(new Correction(estimate, 0, 0, 0), filter.corrected(estimate, ranges, walls));
  }
}
