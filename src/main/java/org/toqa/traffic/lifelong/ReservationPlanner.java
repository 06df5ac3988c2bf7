package org.toqa.traffic.lifelong;

import static org.toqa.traffic.RoadGraph.NONE;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.MotionModel;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.mapf.ReservationTable;
import org.toqa.traffic.mapf.SafeIntervalSearch;
import org.toqa.traffic.mapf.StateDistances;
import org.toqa.traffic.mapf.StateGraph;

/**
 * The baseline: first come, first served. A robot reserves its whole path in space and time when it
 * gets a goal, around what others have reserved; where there is none it stays and asks again every
 * step. Nobody makes room, so idle robots block aisles and two can block each other for ever. It
 * knows of no fixed robots.
 *
 * <p>D. Silver, "Cooperative pathfinding", AIIDE 2005.
 */
public final class ReservationPlanner implements LifelongPlanner {
  private static final int HORIZON = 4;

  private final MotionModel model;
  private final Map<String, Reservation> reservations = new HashMap<>();
  private @Nullable StateGraph lastGraph;

  public ReservationPlanner(MotionModel model) {
    this.model = model;
  }

  /** A robot's path from the present step on; its last state is kept for ever. */
  private static final class Reservation {
    int goal = NONE;
    char @Nullable [] distances;
    int[] path;

    Reservation(int state) {
      path = new int[] {state};
    }

    /** Its state after so many steps, at least 0. */
    int after(int steps) {
      return path[Math.min(steps, path.length - 1)];
    }
  }

  @Override
  public LifelongPlan plan(TrafficSnapshot snapshot, Deadline deadline) {
    StateGraph graph = graphOf(snapshot.roads());
    ActiveRobots active = ActiveRobots.of(snapshot, graph);
    List<Reservation> present = advance(snapshot, active);
    ReservationTable table = new ReservationTable(snapshot.roads(), tableLength(present));
    present.forEach(reservation -> table.add(vertices(graph, reservation.path)));
    SafeIntervalSearch search = new SafeIntervalSearch(graph, table);
    for (int k = 0; k < present.size() && !deadline.isPassed(); k++) {
      reserve(present.get(k), active.goal(k), graph, table, search);
    }
    return active.toPlan(HORIZON, (k, step) -> present.get(k).after(step), k -> true);
  }

  private StateGraph graphOf(RoadGraph roads) {
    StateGraph last = lastGraph;
    if (last != null && last.roads() == roads) {
      return last;
    }
    reservations.clear();
    StateGraph graph = new StateGraph(roads, model);
    lastGraph = graph;
    return graph;
  }

  /** One step on; if a robot is not where it reserved to be, all reservations are void. */
  private List<Reservation> advance(TrafficSnapshot snapshot, ActiveRobots active) {
    Map<String, Reservation> former = new HashMap<>(reservations);
    reservations.clear();
    List<Reservation> present = new ArrayList<>();
    boolean isObeyed = true;
    for (int k = 0; k < active.size(); k++) {
      String name = snapshot.robots().get(active.robot(k)).name();
      int state = active.state(k);
      Reservation reservation = former.getOrDefault(name, new Reservation(state));
      isObeyed &= reservation.after(1) == state && (former.isEmpty() || former.containsKey(name));
      present.add(reservation);
      reservations.put(name, reservation);
    }
    for (int k = 0; k < present.size(); k++) {
      Reservation reservation = present.get(k);
      if (isObeyed) {
        reservation.path =
            Arrays.copyOfRange(
                reservation.path,
                Math.min(1, reservation.path.length - 1),
                reservation.path.length);
      } else {
        reservation.path = new int[] {active.state(k)};
        reservation.goal = NONE;
      }
    }
    return present;
  }

  private static int tableLength(List<Reservation> present) {
    int longest = present.stream().mapToInt(reservation -> reservation.path.length).max().orElse(0);
    return 2 * longest + 512;
  }

  private static void reserve(
      Reservation reservation,
      int goal,
      StateGraph graph,
      ReservationTable table,
      SafeIntervalSearch search) {
    int state = reservation.path[0];
    boolean ends = graph.vertex(reservation.path[reservation.path.length - 1]) == goal;
    if (goal == NONE || (reservation.goal == goal && ends)) {
      return;
    }
    char[] distances = reservation.distances;
    if (reservation.goal != goal || distances == null) {
      distances = StateDistances.to(graph, goal);
      reservation.goal = goal;
      reservation.distances = distances;
    }
    table.remove(vertices(graph, reservation.path));
    int[] path = search.path(state, goal, distances, table.end());
    reservation.path = path == null ? reservation.path : path;
    table.add(vertices(graph, reservation.path));
  }

  private static int[] vertices(StateGraph graph, int[] path) {
    return Arrays.stream(path).map(graph::vertex).toArray();
  }
}
