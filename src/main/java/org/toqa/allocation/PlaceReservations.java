package org.toqa.allocation;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.toqa.geometry.Vec2;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Who may fetch and set down where. Robots that are round a load have no room for others among
 * them, and cannot step aside: a task for several robots is given out only while nobody else uses
 * any of its places, and then nobody else is sent there. It takes all of them at once or none, so
 * no two tasks can wait for each other.
 *
 * <p>A task that waits for a place goes before later ones there. Confined to one round.
 */
final class PlaceReservations {
  private final List<PlaceUse> uses;

  /** Tasks that wait. */
  private final Set<Long> waiting = new HashSet<>();

  PlaceReservations(List<PlaceUse> inUse) {
    this.uses = new ArrayList<>(inUse);
  }

  /** Its places are its own from now on. */
  void reserve(AllocationTask task, boolean together) {
    uses.addAll(PlaceUse.of(task, together));
  }

  /** Its places are kept for it until it gets them. */
  void keepForWaiting(AllocationTask task, boolean together) {
    waiting.add(task.id());
    reserve(task, together);
  }

  /** Why it cannot have its places now, a sentence; empty: it can. */
  Optional<Sentence> conflict(AllocationTask task, boolean together) {
    return conflict(task, together, uses);
  }

  /** The same, as if no task waited for a place. */
  Optional<Sentence> conflictWithUsers(AllocationTask task, boolean together) {
    return conflict(
        task, together, uses.stream().filter(use -> !waiting.contains(use.task())).toList());
  }

  private Optional<Sentence> conflict(
      AllocationTask task, boolean together, List<PlaceUse> others) {
    return conflict(task, task.start(), Phrase.START, together, others)
        .or(
            () ->
                task.via().stream()
                    .flatMap(stop -> conflict(task, stop, Phrase.STOP, together, others).stream())
                    .findFirst())
        .or(() -> conflict(task, task.goal(), Phrase.GOAL, together, others));
  }

  private Optional<Sentence> conflict(
      AllocationTask task, Vec2 place, Phrase name, boolean together, List<PlaceUse> others) {
    return others.stream()
        .filter(use -> use.task() != task.id() && (together || use.together()))
        .filter(use -> use.place().distanceTo(place) < PlaceUse.REACH)
        .findFirst()
        .map(use -> sentence(use, name, together));
  }

  private Sentence sentence(PlaceUse use, Phrase name, boolean together) {
    return phrase(use, together).with(use.task(), name.with());
  }

  private Phrase phrase(PlaceUse use, boolean together) {
    if (waiting.contains(use.task())) {
      return Phrase.ANOTHER_COMES_FIRST;
    }
    return together ? Phrase.TEAM_NEEDS_PLACE : Phrase.PLACE_USED_BY_TEAM;
  }
}
