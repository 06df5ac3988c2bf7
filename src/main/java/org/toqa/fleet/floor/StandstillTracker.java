package org.toqa.fleet.floor;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.toqa.fleet.FloorView.StandstillView;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.traffic.floor.Standstill;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Tells which standstills of a floor are new, which last and which are over. */
final class StandstillTracker {
  /** A ring of more robots is told by the first of them, so that it fits the history. */
  private static final int MAX_NAMED = 4;

  private final OccupancyGrid grid;
  private Map<Who, StandstillView> lasting = Map.of();

  /** What makes a standstill the same one as a moment ago: a cycle has no first robot. */
  private record Who(Standstill.Kind kind, Set<String> robots) {
    static Who of(Standstill standstill) {
      return new Who(standstill.kind(), Set.copyOf(standstill.robots()));
    }
  }

  record Change(List<StandstillView> begun, List<StandstillView> ended) {}

  StandstillTracker(OccupancyGrid grid) {
    this.grid = grid;
  }

  /**
   * @param seen all that are seen now
   */
  Change update(List<Standstill> seen) {
    Map<Who, StandstillView> before = lasting;
    Map<Who, StandstillView> now = new LinkedHashMap<>();
    for (Standstill standstill : seen) {
      Who who = Who.of(standstill);
      StandstillView known = before.get(who);
      now.put(who, known == null ? view(standstill) : known);
    }
    lasting = now;
    return new Change(without(now, before), without(before, now));
  }

  /** Those that last, each as it was first seen. */
  List<StandstillView> lasting() {
    return List.copyOf(lasting.values());
  }

  private static List<StandstillView> without(
      Map<Who, StandstillView> these, Map<Who, StandstillView> those) {
    Map<Who, StandstillView> left = new LinkedHashMap<>(these);
    left.keySet().removeAll(those.keySet());
    return List.copyOf(left.values());
  }

  private StandstillView view(Standstill standstill) {
    List<Vec2> where = standstill.cells().stream().map(grid::centre).toList();
    Phrase phrase =
        switch (standstill.kind()) {
          case CYCLE_OF_WAITS -> Phrase.RING_OF_WAITS;
          case NOT_MOVING -> Phrase.DOES_NOT_MOVE;
        };
    Sentence text = phrase.with(robotNames(standstill.robots()), places(where));
    return new StandstillView(standstill.robots(), where, standstill.since(), text);
  }

  static Sentence endSentence(StandstillView standstill) {
    return Phrase.STANDSTILL_OVER.with(robotNames(standstill.robots()));
  }

  private static Sentence robotNames(List<String> robots) {
    Sentence first = Sentence.names(robots.stream().limit(MAX_NAMED).toList());
    return robots.size() > MAX_NAMED
        ? Phrase.AND_MORE.with(first, robots.size() - MAX_NAMED)
        : first;
  }

  private static Sentence places(List<Vec2> where) {
    return Sentence.joined(
        Phrase.LISTED, where.stream().limit(MAX_NAMED).map(Sentence::of).toList());
  }
}
