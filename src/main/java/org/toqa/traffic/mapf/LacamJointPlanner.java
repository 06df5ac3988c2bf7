package org.toqa.traffic.mapf;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.DistanceTables;
import org.toqa.traffic.JointPlanner;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.Spacing;

/**
 * Plans the robots of a floor together: {@link Lacam} without rings that move at once finds a plan,
 * {@link PrioritisedPlanning} perhaps a better one, and {@link NeighbourhoodSearch} takes out the
 * detours. These two know nothing of rings; where one has come in, the first plan is kept, as it is
 * where robots stand nearer to each other than they may drive.
 */
public final class LacamJointPlanner implements JointPlanner {
  private static final long SEED = 7275;

  /** Improvements that are tried, for all and for each robot: a few milliseconds' work. */
  private static final int IMPROVEMENTS = 100;

  private static final int IMPROVEMENTS_EACH = 10;

  /** Of the time left after the first plan, what improving it may take. */
  private static final double SHARE_OF_IMPROVING = 0.3;

  @Override
  public Optional<List<int[]>> plan(
      RoadGraph roads, Spacing spacing, int[] starts, int[] goals, Deadline deadline) {
    char[][] distances = DistanceTables.of(roads, goals, deadline);
    if (distances.length < goals.length) {
      return Optional.empty();
    }
    SplittableRandom random = new SplittableRandom(SEED);
    StepSearch steps =
        spacing.isNone()
            ? new Pibt(roads, distances, goals, random.split(), false)
            : new SpacedPibt(roads, spacing, distances, random.split());
    Lacam lacam = new Lacam(roads, distances, starts, goals, random.split(), steps);
    if (!(lacam.search(deadline) instanceof Lacam.Outcome.Found(var configurations))) {
      return Optional.empty();
    }
    if (isAnyTooNear(spacing, starts)) {
      return Optional.of(configurations);
    }
    int[][] first = VertexPaths.of(configurations);
    SearchBudget budget =
        new SearchBudget(
            deadline.afterShare(SHARE_OF_IMPROVING),
            IMPROVEMENTS + IMPROVEMENTS_EACH * starts.length);
    int @Nullable [][] second =
        new PrioritisedPlanning(roads, spacing, distances, first, random.split()).plan(budget);
    int[][] best =
        second != null && VertexPaths.sumOfCosts(second) < VertexPaths.sumOfCosts(first)
            ? second
            : first.clone();
    long lowerBound =
        IntStream.range(0, starts.length).mapToLong(i -> distances[i][starts[i]]).sum();
    new NeighbourhoodSearch(roads, spacing, distances, best, random.split())
        .improve(lowerBound, budget);
    List<int[]> improved = configurations(best);
    return Optional.of(StepOrder.hasCycle(roads, spacing, improved) ? configurations : improved);
  }

  /** Whether robots stand so near to each other that only steps apart lead on. */
  private static boolean isAnyTooNear(Spacing spacing, int[] places) {
    if (spacing.isNone()) {
      return false;
    }
    Set<Integer> taken = new HashSet<>();
    for (int place : places) {
      taken.add(place);
    }
    return Arrays.stream(places)
        .anyMatch(place -> Arrays.stream(spacing.near(place)).anyMatch(taken::contains));
  }

  private static List<int[]> configurations(int[][] paths) {
    int steps = Arrays.stream(paths).mapToInt(path -> path.length).max().orElse(1);
    List<int[]> configurations = new ArrayList<>();
    for (int step = 0; step < steps; step++) {
      int[] places = new int[paths.length];
      for (int robot = 0; robot < paths.length; robot++) {
        places[robot] = VertexPaths.at(paths[robot], step);
      }
      configurations.add(places);
    }
    return configurations;
  }
}
