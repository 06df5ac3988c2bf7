package org.toqa.traffic.mapf;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Queue;
import java.util.stream.Stream;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.Heading;
import org.toqa.traffic.GridPose;
import org.toqa.traffic.MotionModel;
import org.toqa.traffic.check.TrafficChecker;

/** Tries everything: breadth-first over the places of all robots at once. For tiny floors. */
final class JointSearch {
  private final OccupancyGrid grid;
  private final TrafficChecker checker;

  JointSearch(OccupancyGrid grid) {
    this.grid = grid;
    this.checker = new TrafficChecker(grid, MotionModel.CLASSIC);
  }

  /** The least number of steps after which all are at their goals; empty where that is never. */
  OptionalInt shortestMakespan(List<Cell> starts, List<Cell> goals) {
    Map<List<Cell>, Integer> steps = new HashMap<>();
    Queue<List<Cell>> queue = new ArrayDeque<>();
    steps.put(starts, 0);
    queue.add(starts);
    while (!queue.isEmpty()) {
      List<Cell> places = queue.remove();
      int step = steps.getOrDefault(places, 0);
      if (places.equals(goals)) {
        return OptionalInt.of(step);
      }
      for (List<Cell> next : successors(places, List.of())) {
        if (steps.putIfAbsent(next, step + 1) == null) {
          queue.add(next);
        }
      }
    }
    return OptionalInt.empty();
  }

  private List<List<Cell>> successors(List<Cell> before, List<Cell> chosen) {
    int robot = chosen.size();
    if (robot == before.size()) {
      return List.of(chosen);
    }
    List<List<Cell>> all = new ArrayList<>();
    Cell from = before.get(robot);
    choices(from)
        .filter(
            to ->
                isInDirection(from, to)
                    && grid.isFree(to)
                    && !chosen.contains(to)
                    && !swaps(before, chosen, from, to))
        .forEach(
            to ->
                all.addAll(
                    successors(before, Stream.concat(chosen.stream(), Stream.of(to)).toList())));
    return all;
  }

  private boolean isInDirection(Cell from, Cell to) {
    return !grid.rules().isDirected()
        || checker
            .check(
                List.of(new GridPose(from, Heading.EAST)), List.of(new GridPose(to, Heading.EAST)))
            .stream()
            .noneMatch(v -> v.rule() == TrafficChecker.Rule.NOT_AGAINST_A_DIRECTION);
  }

  private static boolean swaps(List<Cell> before, List<Cell> chosen, Cell from, Cell to) {
    int other = before.indexOf(to);
    return other >= 0 && other < chosen.size() && chosen.get(other).equals(from);
  }

  private static Stream<Cell> choices(Cell c) {
    return Stream.of(
        c,
        new Cell(c.column() + 1, c.row()),
        new Cell(c.column() - 1, c.row()),
        new Cell(c.column(), c.row() + 1),
        new Cell(c.column(), c.row() - 1));
  }
}
