package org.toqa.allocation;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.toqa.geometry.Vec2;

/**
 * Who may fetch and set down where. Robots that stand round a load have no room for others among
 * them, and cannot step aside: a task for several robots is given out only while nobody else uses
 * its start or its goal, and then nobody else is sent there. It takes both places at once or none,
 * so no two tasks can wait for each other.
 *
 * <p>A task that waits for a place goes before later ones there. Confined to one round.
 */
final class PlacesInTurn {
  private final List<PlaceUse> uses;

  /** Tasks that wait. */
  private final Set<Long> waiting = new HashSet<>();

  PlacesInTurn(List<PlaceUse> inUse) {
    this.uses = new ArrayList<>(inUse);
  }

  /** Its places are its own from now on. */
  void take(Job job, boolean together) {
    uses.add(new PlaceUse(job.id(), job.start(), together));
    uses.add(new PlaceUse(job.id(), job.goal(), together));
  }

  /** Its places are kept for it until it gets them. */
  void keepFor(Job job, boolean together) {
    waiting.add(job.id());
    take(job, together);
  }

  /** Why it cannot have its places now, a sentence; empty: it can. */
  Optional<String> objection(Job job, boolean together) {
    return objection(job, together, uses);
  }

  /** The same, as if no task waited for a place. */
  Optional<String> objectionOfUsers(Job job, boolean together) {
    return objection(
        job, together, uses.stream().filter(use -> !waiting.contains(use.task())).toList());
  }

  private Optional<String> objection(Job job, boolean together, List<PlaceUse> others) {
    return objection(job, job.start(), "start", together, others)
        .or(() -> objection(job, job.goal(), "goal", together, others));
  }

  private Optional<String> objection(
      Job job, Vec2 place, String name, boolean together, List<PlaceUse> others) {
    return others.stream()
        .filter(use -> use.task() != job.id() && (together || use.together()))
        .filter(use -> use.place().distanceTo(place) < PlaceUse.REACH)
        .findFirst()
        .map(use -> sentence(use, name, together));
  }

  private String sentence(PlaceUse use, String name, boolean together) {
    if (waiting.contains(use.task())) {
      return "Task %d comes first at its %s.".formatted(use.task(), name);
    }
    return together
        ? "It needs several robots, which need its %s for themselves; task %d uses it now."
            .formatted(name, use.task())
        : "The robots that carry the load of task %d together use its %s now."
            .formatted(use.task(), name);
  }
}
