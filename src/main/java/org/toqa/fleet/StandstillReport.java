package org.toqa.fleet;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.toqa.fleet.FloorView.StandstillView;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.traffic.floor.Standstill;

/** Tells which standstills of a floor are new, which last and which are over, in sentences. */
final class StandstillReport {
  /** A ring of more robots is told by the first of them, so that it fits the history. */
  private static final int MOST_NAMED = 4;

  private final OccupancyGrid grid;
  private Map<Who, StandstillView> lasting = Map.of();

  /** What makes a standstill the same one as a moment ago: a cycle has no first robot. */
  private record Who(Standstill.Kind kind, Set<String> robots) {
    static Who of(Standstill standstill) {
      return new Who(standstill.kind(), Set.copyOf(standstill.robots()));
    }
  }

  record Change(List<StandstillView> begun, List<StandstillView> over) {}

  StandstillReport(OccupancyGrid grid) {
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
    String whoAndWhere = named(standstill.robots()) + " at " + places(where);
    String text =
        switch (standstill.kind()) {
          case CYCLE_OF_WAITS ->
              whoAndWhere + " wait for each other in a ring. Their ways are planned anew.";
          case NOT_MOVING ->
              whoAndWhere
                  + " may drive and has not got on for long. It keeps its place, and the others"
                  + " are planned round it; look what holds it up.";
        };
    return new StandstillView(standstill.robots(), where, standstill.since(), text);
  }

  static String over(StandstillView standstill) {
    return "The standstill of " + named(standstill.robots()) + " is over.";
  }

  private static String named(List<String> robots) {
    return robots.stream().limit(MOST_NAMED).collect(Collectors.joining(", "))
        + (robots.size() > MOST_NAMED ? " and " + (robots.size() - MOST_NAMED) + " more" : "");
  }

  private static String places(List<Vec2> where) {
    return where.stream()
        .limit(MOST_NAMED)
        .map(p -> String.format(Locale.ROOT, "(%.2f, %.2f)", p.x(), p.y()))
        .collect(Collectors.joining(", "));
  }
}
