package org.toqa.traffic.oneshot;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.DistanceTables;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.floor.JointPlanner;

/** Plans the robots of a floor together by {@link Lacam}, without rings that move at once. */
public final class LacamFloorPlanner implements JointPlanner {
  private static final long SEED = 7275;

  @Override
  public Optional<List<int[]>> plan(RoadGraph roads, int[] starts, int[] goals, Deadline deadline) {
    char[][] distances = DistanceTables.of(roads, goals, deadline);
    if (distances.length < goals.length) {
      return Optional.empty();
    }
    Lacam lacam = new Lacam(roads, distances, starts, goals, new SplittableRandom(SEED), false);
    return lacam.search(deadline) instanceof Lacam.Outcome.Found(var configurations)
        ? Optional.of(configurations)
        : Optional.empty();
  }
}
