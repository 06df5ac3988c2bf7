package org.toqa.traffic.lifelong;

import static org.toqa.traffic.RoadGraph.NONE;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.Spacing;
import org.toqa.traffic.mapf.StateGraph;

/**
 * What is left of the robots' operations where some of them are late: all go on in the order in
 * which they were to come to each vertex, so who was to come after a late one waits for it, and
 * nobody else does. Nobody is earlier than it meant to be, so where all are in time, all is as it
 * was.
 *
 * <p>That order has no cycle, since the operations had no full ring (W. Hoenig et al., "Persistent
 * and robust execution of MAPF schedules in warehouses", RA-L 2019). Cost: robots times steps.
 */
final class DelayedOperations {
  private static final int UNKNOWN = 0;
  private static final int ASKED = 1;
  private static final int GOES = 2;
  private static final int STAYS = 3;

  private final StateGraph graph;
  private final Spacing spacing;
  private final int depth;
  private final BitSet closed;
  private final int[][] former;
  private final int[] delays;
  private final int[][] operations;

  /** By robot: how many steps of its operation are done; {@code NONE}: it has none, and stays. */
  private final int[] done;

  /** By vertex: who is there. */
  private final int[] occupant;

  /** By vertex: who comes there, in that order. */
  private final Map<Integer, List<Visit>> visits = new HashMap<>();

  /** By robot: whether it goes on in the step that is looked at. */
  private final int[] answers;

  private int clock;

  /**
   * @param step of its operation by which the robot is there
   */
  private record Visit(int robot, int step) {}

  /** The parameters are those of {@link Operations#restart}. */
  DelayedOperations(
      StateGraph graph,
      Spacing spacing,
      int depth,
      BitSet closed,
      int[] present,
      int[][] former,
      int steps,
      int[] delays) {
    this.graph = graph;
    this.spacing = spacing;
    this.depth = depth;
    this.closed = closed;
    this.former = former;
    this.delays = delays;
    this.operations = new int[present.length][depth + 1];
    this.done = new int[present.length];
    this.answers = new int[present.length];
    this.occupant = new int[graph.roads().vertexCount()];
    Arrays.fill(occupant, NONE);
    for (int robot = 0; robot < present.length; robot++) {
      operations[robot][0] = present[robot];
      occupant[graph.vertex(present[robot])] = robot;
      done[robot] = former[robot] == null ? NONE : stepAt(former[robot], present[robot], steps);
      if (done[robot] != NONE) {
        addVisits(robot);
      }
    }
    visits.values().forEach(there -> there.sort(Comparator.comparingInt(Visit::step)));
    for (int t = 0; t < depth; t++) {
      clock = steps + t + 1;
      goOn(t);
    }
  }

  /** By robot: its states after 0, 1, 2 ... steps. */
  int[][] operations() {
    return operations;
  }

  /** The step by which an operation leads to a state, best that at which it should be there now. */
  private int stepAt(int[] meant, int state, int steps) {
    if (steps <= depth && meant[steps] == state) {
      return steps;
    }
    int step = 0;
    while (step <= depth && meant[step] != state) {
      step++;
    }
    return step > depth ? NONE : step;
  }

  private int vertexOf(int robot, int step) {
    return graph.vertex(former[robot][step]);
  }

  private void addVisits(int robot) {
    for (int step = done[robot] + 1; step <= depth; step++) {
      int vertex = vertexOf(robot, step);
      if (vertex != vertexOf(robot, step - 1)) {
        visits.computeIfAbsent(vertex, v -> new ArrayList<>()).add(new Visit(robot, step));
      }
    }
  }

  private List<Visit> visitsTo(int vertex) {
    return visits.getOrDefault(vertex, List.of());
  }

  /** The step after {@code t} of all. */
  private void goOn(int t) {
    Arrays.fill(answers, UNKNOWN);
    for (int robot = 0; robot < done.length; robot++) {
      skipWaits(robot);
    }
    for (int robot = 0; robot < done.length; robot++) {
      goes(robot, t);
    }
    for (int robot = 0; robot < done.length; robot++) {
      if (answers[robot] == GOES) {
        leave(robot);
      }
    }
    for (int robot = 0; robot < done.length; robot++) {
      if (answers[robot] == GOES) {
        done[robot]++;
        occupant[vertexOf(robot, done[robot])] = robot;
      }
      operations[robot][t + 1] =
          done[robot] == NONE || answers[robot] != GOES
              ? operations[robot][t]
              : former[robot][done[robot]];
    }
  }

  private void leave(int robot) {
    int from = vertexOf(robot, done[robot]);
    int to = vertexOf(robot, done[robot] + 1);
    occupant[from] = NONE;
    if (from != to) {
      visitsTo(to).removeIf(visit -> visit.robot == robot && visit.step == done[robot] + 1);
    }
  }

  /** Who is late makes up for it where it meant to wait. */
  private void skipWaits(int robot) {
    while (done[robot] != NONE
        && done[robot] + 1 < Math.min(clock, depth + 1)
        && former[robot][done[robot] + 1] == former[robot][done[robot]]) {
      done[robot]++;
    }
  }

  /** Whether it takes its next step after {@code t}. */
  private boolean goes(int robot, int t) {
    if (answers[robot] == UNKNOWN) {
      answers[robot] = ASKED;
      answers[robot] = mayGo(robot, t) ? GOES : STAYS;
    }
    return answers[robot] == GOES;
  }

  private boolean mayGo(int robot, int t) {
    int step = done[robot] + 1;
    if (done[robot] == NONE || t < delays[robot] || step > Math.min(depth, clock)) {
      return false;
    }
    int from = vertexOf(robot, step - 1);
    int to = vertexOf(robot, step);
    if (from == to) {
      return true;
    }
    if (closed.get(from * RoadGraph.DIRECTIONS + graph.roads().direction(from, to))
        || isBefore(robot, step, to)
        || !isLeft(to, t)) {
      return false;
    }
    for (int near : spacing.near(to)) {
      boolean isInWay = near != from && !spacing.mayBeAt(to, near, from, near) && !isLeft(near, t);
      if (isInWay || isBefore(robot, step, near)) {
        return false;
      }
    }
    return true;
  }

  /** Whether others are to come to a vertex before a robot comes to it, or near to it. */
  private boolean isBefore(int robot, int step, int vertex) {
    for (Visit visit : visitsTo(vertex)) {
      if (visit.step >= step) {
        return false;
      }
      if (visit.robot != robot) {
        return true;
      }
    }
    return false;
  }

  private boolean isLeft(int vertex, int t) {
    int other = occupant[vertex];
    return other == NONE
        || (goes(other, t) && vertexOf(other, done[other] + 1) != vertexOf(other, done[other]));
  }
}
