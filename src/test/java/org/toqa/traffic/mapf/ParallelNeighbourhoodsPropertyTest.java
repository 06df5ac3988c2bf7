package org.toqa.traffic.mapf;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.toqa.grid.MoveRules;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.DistanceTables;
import org.toqa.traffic.RandomFloors;
import org.toqa.traffic.RandomFloors.Floor;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.Spacing;
import org.toqa.traffic.mapf.Lacam.Outcome.Found;
import org.toqa.traffic.mapf.MapfResult.Solved;

/** Several searches at once on one plan. */
class ParallelNeighbourhoodsPropertyTest {
  private static final int ITERATIONS = 1000;

  @Provide
  Arbitrary<Floor> floors() {
    return RandomFloors.strewn(8, 0.2, 24);
  }

  @Property(tries = 20)
  void threeThreadsKeepTheRulesAndComeToTheSamePlanEachTime(@ForAll("floors") Floor floor) {
    RoadGraph roads = new RoadGraph(floor.grid());
    int[][] first = firstPlan(roads, floor);
    if (first.length == 0) {
      return;
    }
    char[][] distances = distances(roads, first);
    long lowerBound =
        IntStream.range(0, first.length).mapToLong(i -> distances[i][first[i][0]]).sum();

    int[][] paths = improved(roads, distances, first, lowerBound);

    assertTrue(VertexPaths.sumOfCosts(paths) <= VertexPaths.sumOfCosts(first));
    PlanAssertions.assertSound(
        new MapfInstance(roads, floor.starts(), floor.goals()),
        new Solved(new MapfPlan(roads, paths), lowerBound));
    assertArrayEquals(paths, improved(roads, distances, first, lowerBound));
  }

  @Property(tries = 100)
  void admitsWhatConflictsWithNobody(@ForAll("floors") Floor floor) {
    RoadGraph roads = new RoadGraph(floor.grid().withRules(MoveRules.NONE)); // for paths back
    int[][] paths = firstPlan(roads, floor);
    if (paths.length < 2) {
      return;
    }
    int last = Arrays.stream(paths).mapToInt(path -> path.length).max().orElse(0);
    for (int[] other : paths) {
      ReservationTable table = new ReservationTable(roads, last);
      table.add(other);
      int[] backwards =
          IntStream.range(0, other.length).map(t -> other[other.length - 1 - t]).toArray();
      Stream.concat(Arrays.stream(paths), Stream.of(backwards))
          .forEach(
              path ->
                  assertEquals(
                      !VertexPaths.hasConflict(Spacing.none(roads), other, path),
                      table.admits(path)));
    }
  }

  private static int[][] improved(
      RoadGraph roads, char[][] distances, int[][] first, long lowerBound) {
    int[][] paths = first.clone();
    SplittableRandom random = new SplittableRandom(5);
    List<NeighbourhoodSearch> searches =
        Stream.of(paths, first.clone(), first.clone())
            .map(
                plan ->
                    new NeighbourhoodSearch(
                        roads, Spacing.none(roads), distances, plan, random.split()))
            .toList();
    try (ExecutorService threads = Executors.newFixedThreadPool(2)) {
      new ParallelNeighbourhoods(searches, threads)
          .improve(lowerBound, new SearchBudget(Deadline.none(), ITERATIONS));
    }
    return paths;
  }

  /** Empty where there is none. */
  private static int[][] firstPlan(RoadGraph roads, Floor floor) {
    int[] starts = floor.starts().stream().mapToInt(roads::vertex).toArray();
    int[] goals = floor.goals().stream().mapToInt(roads::vertex).toArray();
    for (int robot = 0; robot < starts.length; robot++) {
      if (!roads.canReach(starts[robot], goals[robot])) {
        return new int[0][];
      }
    }
    char[][] distances = DistanceTables.of(roads, goals, Deadline.none());
    SplittableRandom random = new SplittableRandom(2);
    StepSearch steps = new Pibt(roads, distances, goals, random.split(), true);
    return new Lacam(roads, distances, starts, goals, random.split(), steps)
                .search(new CountedDeadline(5000).deadline())
            instanceof Found(List<int[]> configurations)
        ? VertexPaths.of(configurations)
        : new int[0][];
  }

  private static char[][] distances(RoadGraph roads, int[][] paths) {
    int[] goals = Arrays.stream(paths).mapToInt(path -> path[path.length - 1]).toArray();
    return DistanceTables.of(roads, goals, Deadline.none());
  }
}
