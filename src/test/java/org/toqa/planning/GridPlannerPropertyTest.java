package org.toqa.planning;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.toqa.planning.PlanChecker.Rule;
import org.toqa.planning.PlanResult.Found;
import org.toqa.planning.PlanResult.NotFound;
import org.toqa.planning.PlanResult.Reason;
import org.toqa.planning.RandomGrids.Query;

class GridPlannerPropertyTest {
  private final PathPlanner heading = new HeadingAStar();
  private final PathPlanner octile = new JumpPointSearch();

  @Provide
  Arbitrary<Query> strewn() {
    return RandomGrids.strewn(1, 12, 0.5, 1);
  }

  @Provide
  Arbitrary<Query> rooms() {
    return RandomGrids.rooms(1);
  }

  @Provide
  Arbitrary<Query> aisles() {
    return RandomGrids.strewnAlongAnAisle(0.15);
  }

  @Provide
  Arbitrary<Query> caves() {
    return RandomGrids.caves(10, 32);
  }

  @Provide
  Arbitrary<Query> mazes() {
    return RandomGrids.mazes(8, 32);
  }

  @Property
  void headingWaysAreShortestOnStrewnGrids(@ForAll("strewn") Query query) {
    assertHeadingWayIsShortest(query);
  }

  @Property(tries = 300)
  void headingWaysAreShortestInRooms(@ForAll("rooms") Query query) {
    assertHeadingWayIsShortest(query);
  }

  @Property(tries = 300)
  void headingWaysAreShortestInCaves(@ForAll("caves") Query query) {
    assertHeadingWayIsShortest(query);
  }

  @Property(tries = 300)
  void headingWaysAreShortestInMazes(@ForAll("mazes") Query query) {
    assertHeadingWayIsShortest(query);
  }

  @Property(tries = 300)
  void headingWaysAreShortestAlongAisles(@ForAll("aisles") Query query) {
    assertHeadingWayIsShortest(query);
  }

  @Property
  void octileWaysAreShortestOnStrewnGrids(@ForAll("strewn") Query query) {
    assertOctileWayIsShortest(query);
  }

  @Property(tries = 300)
  void octileWaysAreShortestInRooms(@ForAll("rooms") Query query) {
    assertOctileWayIsShortest(query);
  }

  /** Longer than the 64 cells that a jump point search looks at together. */
  @Property(tries = 500)
  void octileWaysAreShortestAlongAisles(@ForAll("aisles") Query query) {
    assertOctileWayIsShortest(query);
  }

  @Provide
  Arbitrary<Query> oneWayGrids() {
    return RandomGrids.withDirections(RandomGrids.strewn(1, 12, 0.3, 1));
  }

  @Property
  void waysAreShortestWhereSomeAreDrivenOneWay(@ForAll("oneWayGrids") Query query) {
    assertHeadingWayIsShortest(query);
    assertOctileWayIsShortest(query);
  }

  @Property(tries = 200)
  void plannersRememberNothing(@ForAll("rooms") Query first, @ForAll("rooms") Query second) {
    for (PathPlanner used : List.of(new HeadingAStar(), new JumpPointSearch())) {
      PlanResult firstAnswer = used.plan(first.grid(), first.start(), first.goal());
      used.plan(second.grid(), second.start(), second.goal());
      used.plan(first.grid(), first.goal(), first.start());
      assertEquals(firstAnswer, used.plan(first.grid(), first.start(), first.goal()));
    }
  }

  @Property(tries = 200)
  void octileWaysAreShortestInCaves(@ForAll("caves") Query query) {
    assertOctileWayIsShortest(query);
  }

  @Property(tries = 200)
  void octileWaysAreShortestInMazes(@ForAll("mazes") Query query) {
    assertOctileWayIsShortest(query);
  }

  private void assertOctileWayIsShortest(Query query) {
    OptionalDouble shortest =
        ReferenceSearch.shortest(query.grid(), query.start(), query.goal(), ReferenceSearch.FREE);
    PlanResult result = octile.plan(query.grid(), query.start(), query.goal());
    assertSame(query, shortest, result, Rule.OCTILE);
  }

  private void assertHeadingWayIsShortest(Query query) {
    OptionalDouble inArcs =
        ReferenceSearch.shortest(
            query.grid(), query.start(), query.goal(), ReferenceSearch.ARCS_ONLY);
    PlanResult result = heading.plan(query.grid(), query.start(), query.goal());
    if (inArcs.isPresent()) {
      assertEquals(0, assertInstanceOf(Found.class, result).path().turnsOnSpot());
      assertSame(query, inArcs, result, Rule.HEADING);
    } else {
      OptionalDouble withTurns =
          ReferenceSearch.shortest(
              query.grid(), query.start(), query.goal(), ReferenceSearch.ARCS_AND_SPOT_TURNS);
      assertSame(query, withTurns, result, Rule.HEADING);
      if (result instanceof Found(Path path)) {
        assertTrue(path.turnsOnSpot() > 0);
      }
    }
  }

  private static void assertSame(
      Query query, OptionalDouble shortest, PlanResult result, Rule rule) {
    if (shortest.isPresent()) {
      Path path = assertInstanceOf(Found.class, result).path();
      assertEquals(shortest.getAsDouble(), path.cost(), 1e-9);
      assertEquals(
          Optional.empty(),
          PlanChecker.violation(query.grid(), query.start(), query.goal(), path, rule));
    } else {
      Reason reason = assertInstanceOf(NotFound.class, result).reason();
      Reason expected =
          !query.grid().isFree(query.start())
              ? Reason.START_BLOCKED
              : !query.grid().isFree(query.goal()) ? Reason.GOAL_BLOCKED : Reason.NO_PATH;
      assertEquals(expected, reason);
    }
  }
}
