package org.toqa.planning;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.OptionalDouble;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.Tag;
import net.jqwik.api.lifecycle.AfterContainer;
import org.toqa.planning.PlanChecker.Rule;
import org.toqa.planning.PlanResult.Found;
import org.toqa.planning.PlanResult.NotFound;
import org.toqa.planning.PlanResult.Reason;
import org.toqa.planning.RandomGrids.Query;
import org.toqa.planning.cmct.CmctPlanner;
import org.toqa.testbed.Cases;

@Tag("full")
class CmctPlannerPropertyTest {
  private static final Cases PATHS = new Cases("paths of CMCT-PP");

  private final PathPlanner cmct = new CmctPlanner();

  @AfterContainer
  static void thereWerePaths() {
    PATHS.assertPossible(0.3);
  }

  @Provide
  Arbitrary<Query> strewn() {
    return RandomGrids.strewn(1, 12, 0.5, 1);
  }

  @Provide
  Arbitrary<Query> rooms() {
    return RandomGrids.rooms(1);
  }

  @Provide
  Arbitrary<Query> caves() {
    return RandomGrids.caves(10, 32);
  }

  @Provide
  Arbitrary<Query> mazes() {
    return RandomGrids.mazes(8, 32);
  }

  @Provide
  Arbitrary<Query> empty() {
    return RandomGrids.strewn(1, 40, 0, 1);
  }

  @Provide
  Arbitrary<Query> oneWayGrids() {
    return RandomGrids.withDirections(RandomGrids.strewn(1, 12, 0.3, 1));
  }

  @Property
  void arrivesOnStrewnGridsWhereThereIsAPath(@ForAll("strewn") Query query) {
    assertArrives(query);
  }

  @Property(tries = 300)
  void arrivesInRoomsWhereThereIsAPath(@ForAll("rooms") Query query) {
    assertArrives(query);
  }

  @Property(tries = 300)
  void arrivesInCavesWhereThereIsAPath(@ForAll("caves") Query query) {
    assertArrives(query);
  }

  @Property(tries = 300)
  void arrivesInMazesWhereThereIsAPath(@ForAll("mazes") Query query) {
    assertArrives(query);
  }

  @Property
  void pathIsTheShortestWhereNothingIsInTheWay(@ForAll("empty") Query query) {
    assertEquals(shortest(query).orElseThrow(), assertArrives(query).orElseThrow(), 1e-9);
  }

  @Property
  void keepsDirectionsOrSaysThatItGaveUp(@ForAll("oneWayGrids") Query query) {
    switch (cmct.plan(query.grid(), query.start(), query.goal())) {
      case Found(Path path) -> assertLegal(query, path);
      case NotFound(Reason reason, var where) ->
          assertEquals(
              !query.grid().isFree(query.start())
                  ? Reason.START_BLOCKED
                  : !query.grid().isFree(query.goal())
                      ? Reason.GOAL_BLOCKED
                      : query.grid().rules().isDirected() ? Reason.GAVE_UP : Reason.NO_PATH,
              reason,
              where::toString);
    }
  }

  /** The cost of its path; nothing where there is none. */
  private OptionalDouble assertArrives(Query query) {
    OptionalDouble shortest = shortest(query);
    PlanResult result = cmct.plan(query.grid(), query.start(), query.goal());
    if (!PATHS.count(shortest.isPresent())) {
      Reason expected =
          !query.grid().isFree(query.start())
              ? Reason.START_BLOCKED
              : !query.grid().isFree(query.goal()) ? Reason.GOAL_BLOCKED : Reason.NO_PATH;
      assertEquals(expected, assertInstanceOf(NotFound.class, result).reason());
      return OptionalDouble.empty();
    }
    Path path = assertInstanceOf(Found.class, result).path();
    assertLegal(query, path);
    assertTrue(path.cost() >= shortest.getAsDouble() - 1e-9);
    return OptionalDouble.of(path.cost());
  }

  private static void assertLegal(Query query, Path path) {
    assertEquals(
        Optional.empty(),
        PlanChecker.violation(query.grid(), query.start(), query.goal(), path, Rule.OCTILE));
  }

  private static OptionalDouble shortest(Query query) {
    return ReferenceSearch.shortest(
        query.grid(), query.start(), query.goal(), ReferenceSearch.FREE);
  }
}
