package org.toqa.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.sim.ClearanceJudge.Clearance;

class ClearanceJudgeTest {
  private static final double RADIUS = 0.25;

  /** Cells of 1 m; the wall in the middle reaches from (2, 1) to (3, 2). */
  private static final OccupancyGrid HALL = OccupancyGrid.parse(".....", "..#..", ".....");

  private final ClearanceJudge judge = new ClearanceJudge(HALL);

  @Test
  void discsAreApartByWhatIsBetweenTheirEdges() {
    judge(robot("a", 1, 0.5), robot("b", 1.75, 1.5)); // 1.25 m between the middles

    assertEquals(0.75, between(), 1e-12);
    assertFalse(judge.betweenBodies().orElseThrow().isTouch());
  }

  @Test
  void discsThatTouchAreNotClear() {
    judge(robot("a", 1, 0.5), robot("b", 1.5, 0.5)); // twice the radius

    assertEquals(0, between(), 1e-12);
    assertTrue(judge.betweenBodies().orElseThrow().isTouch());
  }

  @Test
  void discsThatOverlapAreBelowZero() {
    judge(robot("a", 1, 0.5), robot("b", 1.3, 0.5));

    assertEquals(-0.2, between(), 1e-12); // 0.3 m less 0.5 m
  }

  @Test
  void nearestMomentIsKeptWithItsNamesAndTime() {
    judge.judge(Duration.ofSeconds(1), List.of(robot("a", 0.5, 0.5), robot("b", 4.5, 0.5)));
    judge.judge(Duration.ofSeconds(2), List.of(robot("a", 0.5, 0.5), robot("b", 1.5, 0.5)));
    judge.judge(Duration.ofSeconds(3), List.of(robot("a", 0.5, 0.5), robot("b", 4.5, 0.5)));

    Clearance nearest = judge.betweenBodies().orElseThrow();
    assertEquals(0.5, nearest.metres(), 1e-12);
    assertEquals(Set.of("a", "b"), Set.of(nearest.first(), nearest.second()));
    assertEquals(Duration.ofSeconds(2), nearest.at());
    assertEquals(3, judge.samples());
  }

  @Test
  void everyPairIsLookedAt() {
    judge(robot("a", 0.5, 0.5), robot("b", 4.5, 0.5), robot("c", 0.5, 1.1), robot("d", 4.5, 2.5));

    assertEquals(0.1, between(), 1e-12); // a and c
  }

  @Test
  void discBesideAWallIsAsFarAsItsEdge() {
    judge(robot("a", 1.6, 1.5));

    assertEquals(0.15, toWall(), 1e-12); // 0.4 m less the radius
  }

  /** A box round the disc would touch; the disc does not. */
  @Test
  void discAtTheCornerOfAWallIsAsFarAsTheCorner() {
    judge(robot("a", 1.8, 0.8));

    // sqrt(0.2^2 + 0.2^2) less the radius
    assertEquals(0.2 * Math.sqrt(2) - RADIUS, toWall(), 1e-12);
    assertFalse(judge.toWall().orElseThrow().isTouch());

    judge(robot("a", 1.83, 0.83)); // 0.2404 m from the corner
    assertTrue(judge.toWall().orElseThrow().isTouch());
  }

  @Test
  void discInsideAWallIsBelowZero() {
    judge(robot("a", 2.5, 1.5));

    assertEquals(-RADIUS, toWall(), 1e-12);
  }

  @Test
  void outsideOfTheGridIsAWall() {
    judge(robot("a", 0.3, 0.5));

    assertEquals(0.05, toWall(), 1e-12);
  }

  @Test
  void nearerWallIsFoundAfterAFartherOne() {
    judge(robot("a", 1, 1)); // 0.75 m to the edge of the grid
    judge(robot("a", 1.6, 1.5));

    assertEquals(0.15, toWall(), 1e-12);
  }

  @Test
  void carriersMayTouchTheirLoadAndEveryOtherBodyMayNot() {
    Body load = Body.load("load", new Pose(1, 0.5, 0), 0.4, 0.4, Set.of("a", "b"));
    judge(robot("a", 1.4, 0.5), robot("b", 0.6, 0.5), load); // both overlap the load by 0.05 m
    assertEquals(0.3, between(), 1e-12); // a and b

    judge(load, robot("c", 1, 1.15)); // 0.45 m from the load's side
    assertEquals(0.2, between(), 1e-12);

    judge(robot("c", 1, 0.5), load);
    assertEquals(-RADIUS, between(), 1e-12);
  }

  @Test
  void membersOfAGroupAreJudgedAgainstEachOther() {
    Body load = Body.load("load", new Pose(1, 0.5, 0), 0.4, 0.4, Set.of("a", "b"));
    judge(robot("a", 1.2, 0.5), robot("b", 0.8, 0.5), load);

    assertEquals(-0.1, between(), 1e-12);
  }

  /** Its corner is nearest: 0.2 m x sqrt(2) from its middle, towards the wall. */
  @Test
  void loadThatIsTurnedReachesTheWallWithItsCorner() {
    judge(Body.load("load", new Pose(1.6, 1.5, Math.PI / 4), 0.4, 0.4, Set.of()));

    assertEquals(0.4 - 0.2 * Math.sqrt(2), toWall(), 1e-12);
  }

  /** No corner of either is inside the other one. */
  @Test
  void loadsThatLieAcrossEachOtherTouch() {
    judge(
        Body.load("one", new Pose(1, 0.6, 0), 1, 0.1, Set.of("a")),
        Body.load("other", new Pose(1, 0.6, Math.PI / 2), 1, 0.1, Set.of("b")));

    assertEquals(0, between(), 1e-12);
    assertTrue(judge.betweenBodies().orElseThrow().isTouch());
  }

  @Test
  void longLoadReachesIntoAWallThatItsCarriersAreClearOf() {
    judge(
        robot("a", 1, 0.5),
        robot("b", 4, 0.5),
        Body.load("load", new Pose(2.5, 0.9, 0), 2, 0.4, Set.of("a", "b")));

    assertEquals(0, toWall(), 1e-12); // its edge is at 1.1 m, the wall begins at 1 m
    assertEquals("load", judge.toWall().orElseThrow().first());
  }

  /** Sizes differ, so that the nearest middles are not the nearest edges. */
  @Test
  void nearestOfManyIsFoundWhereverTheyAre() {
    Random random = new Random(1);
    for (int moment = 0; moment < 200; moment++) {
      ClearanceJudge open = new ClearanceJudge(null);
      List<Body> bodies =
          IntStream.range(0, 30)
              .mapToObj(i -> disc(i, random.nextDouble(40), random.nextDouble(40), random))
              .toList();

      open.judge(Duration.ZERO, bodies);

      assertEquals(nearest(bodies), open.betweenBodies().orElseThrow().metres(), 1e-12);
    }
  }

  private static Body disc(int name, double x, double y, Random random) {
    return Body.disc("r" + name, new Vec2(x, y), 0.1 + random.nextDouble());
  }

  private static double nearest(List<Body> bodies) {
    double nearest = Double.POSITIVE_INFINITY;
    for (Body one : bodies) {
      for (Body other : bodies) {
        double between = one.core().getFirst().distanceTo(other.core().getFirst());
        nearest =
            one.equals(other)
                ? nearest
                : Math.min(nearest, between - one.radius() - other.radius());
      }
    }
    return nearest;
  }

  /** A row of robots, each of which can be nearest to its neighbours only. */
  @Test
  void ofManyBodiesOnlyThoseThatCanBeNearestAreMeasured() {
    ClearanceJudge open = new ClearanceJudge(null);
    int robots = 500;
    int moments = 50;
    for (int moment = 0; moment < moments; moment++) {
      double drift = 0.001 * moment;
      open.judge(
          Duration.ofMillis(20L * moment),
          IntStream.range(0, robots).mapToObj(i -> robot("r" + i, i + drift, i % 7)).toList());
    }

    assertTrue(open.measured() <= 2L * robots * moments, () -> "measured " + open.measured());
  }

  private void judge(Body... bodies) {
    judge.judge(Duration.ZERO, List.of(bodies));
  }

  private double between() {
    return judge.betweenBodies().orElseThrow().metres();
  }

  private double toWall() {
    return judge.toWall().orElseThrow().metres();
  }

  private static Body robot(String name, double x, double y) {
    return Body.disc(name, new Vec2(x, y), RADIUS);
  }
}
