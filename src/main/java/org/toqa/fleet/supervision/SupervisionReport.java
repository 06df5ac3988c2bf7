package org.toqa.fleet.supervision;

import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.RobotView;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * How a supervision that runs gets on, as it was looked at last; it is not stored.
 *
 * @param doing what the supervisor does, or why it does nothing
 * @param need what a person must look at; null: nothing
 * @param refusals by box, why nobody can be told to carry it
 * @param hasSeenAll whether everything that can be seen of the floor was
 */
public record SupervisionReport(
    Sentence doing, @Nullable Sentence need, Map<Integer, Sentence> refusals, boolean hasSeenAll) {

  public SupervisionReport {
    refusals = Map.copyOf(refusals);
  }

  /**
   * @param seen what the supervisor has seen
   * @param refusals by box, also of boxes that are not carried any more
   */
  static SupervisionReport of(
      Supervision now,
      RobotView supervisor,
      FleetSnapshot snapshot,
      SeenArea seen,
      Map<Integer, Sentence> refusals) {
    boolean isSeeing = SupervisionRules.view(now, snapshot).isPresent();
    Map<Integer, Sentence> current = new TreeMap<>(refusals);
    current.keySet().retainAll(now.boxes().keySet());
    return new SupervisionReport(
        doing(now, supervisor, isSeeing, snapshot, seen),
        supervisor.state().isFit() && !isSeeing
            ? Phrase.SUPERVISION_BLIND.with(now.supervisor(), now.floor())
            : needOfBoxes(now, seen, current).orElse(null),
        current,
        seen.isComplete());
  }

  private static Optional<Sentence> needOfBoxes(
      Supervision now, SeenArea seen, Map<Integer, Sentence> refusals) {
    Optional<Sentence> refused =
        refusals.entrySet().stream()
            .findFirst()
            .map(
                box ->
                    Phrase.SUPERVISION_BOX_REFUSED.with(box.getKey(), now.floor(), box.getValue()));
    return refused.or(
        () ->
            now.boxes().values().stream()
                .filter(box -> box.place() == null && box.task() == null && !box.delivered())
                .filter(_ -> seen.isComplete())
                .findFirst()
                .map(box -> Phrase.SUPERVISION_BOX_NOT_FOUND.with(box.number(), now.floor())));
  }

  private static Sentence doing(
      Supervision now,
      RobotView supervisor,
      boolean isSeeing,
      FleetSnapshot snapshot,
      SeenArea seen) {
    String name = supervisor.name();
    RobotView.Work work = supervisor.work();
    if (work.charger() != null) {
      return Phrase.SUPERVISION_CHARGES.with(name);
    }
    if (!supervisor.state().isFit() || !isSeeing) {
      return Phrase.SUPERVISION_AWAY.with(name);
    }
    if (work.held() || work.driver() != null || work.task() != null) {
      return Phrase.SUPERVISION_OCCUPIED.with(name);
    }
    if (seen.isComplete()) {
      return Phrase.SUPERVISION_SEEN_ALL.with(name);
    }
    return SupervisionRules.maySearch(now, snapshot)
        ? Phrase.SUPERVISION_SEARCHES.with(name, (int) (100 * seen.share()))
        : Phrase.SUPERVISION_WAITS_FOR_WORKERS.with(name);
  }

  /** Why nobody can be told to carry that box; empty: somebody can, or was. */
  public Optional<Sentence> refusal(int box) {
    return Optional.ofNullable(refusals.get(box));
  }
}
