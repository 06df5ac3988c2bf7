package org.toqa.planning.smooth;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.OptionalDouble;
import java.util.concurrent.atomic.AtomicLong;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.exact.ShortestDiscPath;
import org.toqa.planning.smooth.Scenes.Query;
import org.toqa.planning.smooth.SmoothResult.Found;
import org.toqa.planning.smooth.SmoothResult.NotFound;
import org.toqa.planning.smooth.SmoothResult.Reason;
import org.toqa.planning.smooth.WayPath.Progress;
import org.toqa.planning.smooth.curve.SmoothCurve;
import org.toqa.planning.smooth.curve.SplineFitter;

class SmoothPlannerPropertyTest {
  private static final int ITERATIONS = 1500;

  private final SmoothPlanner planner = new SmoothPlanner(SmoothMethod.HYBRID, 1);

  @Provide
  Arbitrary<Query> queries() {
    return Scenes.queries();
  }

  private static SmoothResult plan(SmoothPlanner planner, Query query, int iterations) {
    DiscSpace space = DiscSpace.of(query.grid(), query.radius());
    return planner.plan(space, query.from(), query.to(), PlanningBudget.iterations(iterations));
  }

  @Property(tries = 400, edgeCases = EdgeCasesMode.NONE)
  void pathsAndCurvesAreFreeAndNearlyShortest(@ForAll("queries") Query query) {
    OptionalDouble shortest =
        new ShortestDiscPath(query.grid(), query.radius()).length(query.from(), query.to());
    SmoothResult result = plan(planner, query, ITERATIONS);
    if (shortest.isEmpty()) {
      Reason reason = assertInstanceOf(NotFound.class, result).reason();
      double rounding = 1e-8 * query.grid().resolution();
      boolean startIsFree = clearance(query, query.from()) >= query.radius() - rounding;
      boolean goalIsFree = clearance(query, query.to()) >= query.radius() - rounding;
      assertEquals(
          startIsFree ? goalIsFree ? Reason.NO_PATH : Reason.GOAL_BLOCKED : Reason.START_BLOCKED,
          reason);
      return;
    }
    WayPath path = assertInstanceOf(Found.class, result).path();
    double rounding = 1e-7 * query.grid().resolution();
    assertTrue(Scenes.clearance(query.grid(), path.points()) >= query.radius() - rounding);
    assertEquals(query.from(), path.points().getFirst());
    assertEquals(query.to(), path.points().getLast());
    assertTrue(path.length() >= shortest.getAsDouble() - 1e-6 * query.grid().resolution());
    assertTrue(path.length() <= 1.03 * shortest.getAsDouble() + rounding, path::toString);
    assertCurveIsFree(query, path);
  }

  private static double clearance(Query query, Vec2 point) {
    return Scenes.clearance(query.grid(), point, point);
  }

  private static void assertCurveIsFree(Query query, WayPath path) {
    DiscSpace space = DiscSpace.of(query.grid(), query.radius());
    SmoothCurve curve = new SplineFitter(space).fit(path.points());
    if (curve.pieces().isEmpty()) {
      assertEquals(query.from(), query.to());
      return;
    }
    List<Vec2> points = curve.points(query.radius() / 40);
    // a chord of 1/40 radius leaves a curve of that radius by 1/12800 of it
    assertTrue(Scenes.clearance(query.grid(), points) >= query.radius() * (1 - 1e-3));
    assertEquals(0, points.getFirst().distanceTo(query.from()), 1e-9);
    assertEquals(0, points.getLast().distanceTo(query.to()), 1e-9);
    assertTrue(curve.length() <= 1.02 * path.length() + 1e-9);
  }

  @Property(tries = 100, edgeCases = EdgeCasesMode.NONE)
  void aLongerSearchOnlyShortensAndTheSameSeedGivesTheSamePath(@ForAll("queries") Query query) {
    SmoothResult result = plan(planner, query, ITERATIONS);
    assertEquals(result, plan(new SmoothPlanner(SmoothMethod.HYBRID, 1), query, ITERATIONS));
    if (result instanceof Found(WayPath path)) {
      List<Progress> progress = path.progress();
      for (int i = 1; i < progress.size(); i++) {
        assertTrue(progress.get(i).length() < progress.get(i - 1).length());
        assertTrue(progress.get(i).iteration() >= progress.get(i - 1).iteration());
      }
      assertEquals(progress.getLast().length(), path.length(), 1e-9);
    }
  }

  @ParameterizedTest
  @EnumSource(SmoothMethod.class)
  void eachPartAloneGoesRoundAWall(SmoothMethod method) {
    OccupancyGrid grid =
        OccupancyGrid.parse("..........", "....@.....", "....@.....", "....@.....", "..........");
    Query query = new Query(grid, 0.3, new Vec2(1, 2.5), new Vec2(8, 2.5));
    WayPath path =
        assertInstanceOf(Found.class, plan(new SmoothPlanner(method, 3), query, 4000)).path();
    assertTrue(Scenes.clearance(grid, path.points()) >= 0.3 - 1e-8);
  }

  @Test
  void whenTimeIsOverItSaysSo() {
    AtomicLong clock = new AtomicLong();
    OccupancyGrid grid = OccupancyGrid.parse("...", ".@.", ".@.");
    SmoothResult result =
        planner.plan(
            DiscSpace.of(grid, 0.4),
            new Vec2(0.5, 0.5),
            new Vec2(2.5, 0.5),
            PlanningBudget.time(Duration.ofNanos(1), clock::incrementAndGet));
    assertEquals(new NotFound(Reason.OUT_OF_TIME), result);
  }

  @Test
  void aBudgetHasAnIteration() {
    assertThrows(IllegalArgumentException.class, () -> PlanningBudget.iterations(0));
  }
}
