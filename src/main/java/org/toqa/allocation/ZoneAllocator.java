package org.toqa.allocation;

import java.util.List;
import java.util.Optional;
import org.toqa.allocation.SequentialAllocation.Chosen;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * The load-based allocator (Tanta, "Load-based allocation"): of the robots that are strong enough,
 * the one that parks in the load's zone, then those beside it, then outward. A robot that drives
 * home counts as free wherever it parks. It looks at no distance, so a round is quick, and paths
 * are as short as the zones are narrow.
 */
public final class ZoneAllocator implements Allocator {
  /** The load's zone and those beside it hold the zone's best robots. */
  private static final int BEST = 1;

  @Override
  public List<Decision> allocate(AllocationProblem problem) {
    if (problem.robots().isEmpty()) {
      return SequentialAllocation.allocate(problem, (task, left) -> Optional.empty());
    }
    Zones zones = new Zones(problem.low(), problem.high(), problem.robots());
    Quotes quotes = problem.quotes();
    return SequentialAllocation.allocate(
        problem,
        (task, left) ->
            zones.outwardFrom(task.start()).stream()
                .filter(zone -> left.contains(zones.robotOf(zone)))
                .filter(zone -> quotes.of(task, zones.robotOf(zone)).isPossible())
                .findFirst()
                .map(zone -> new Chosen(zones.robotOf(zone), reason(zones, zone, task))));
  }

  private static Sentence reason(Zones zones, int zone, AllocationTask task) {
    int home = zones.zoneOf(task.start());
    if (zone == home) {
      return Phrase.PARKS_IN_ZONE.with(home + 1, zones.count());
    }
    Phrase phrase =
        Math.abs(zone - home) <= BEST ? Phrase.PARKS_BESIDE_ZONE : Phrase.PARKS_NEAREST_TO_ZONE;
    return phrase.with(home + 1, zones.count(), zone + 1);
  }
}
