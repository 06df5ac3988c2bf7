package org.toqa.traffic.floor;

import static java.util.Comparator.nullsLast;

import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.MoveRules;
import org.toqa.grid.OccupancyGrid;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.Spacing;

/**
 * A goal for each robot that is planned, all different: the lane cell of its own goal if it can
 * have that, else a place near to it; and for a robot that wants nothing the place where it is,
 * unless another wants that. Whoever has a place or a path to it keeps it, then whoever waits
 * longest chooses.
 */
final class GoalAssignment {
  /** A robot that waits for its place this many lane cells from it is near enough. */
  private static final int NEAR = 4;

  private final FreeSpace freeSpace;

  private final OccupiedSpace occupied;

  private final LaneGrid lanes;
  private final RoadGraph roads;
  private final Spacing spacing;
  private final List<TrafficRobot> planned;
  private final int[] starts;

  /** Where nobody shall stay. */
  private final List<SweptArea> wanted;

  /** What robots will need to get from their lane cells to their goals. */
  private final List<SweptArea> lastLegs = new ArrayList<>();

  private final int[] assigned;

  /** By robot: the vertex of its own goal; where it is, if it wants nothing or has no path. */
  private final int[] own;

  private final Map<Integer, TrafficRobot> taken = new HashMap<>();

  /** By robot: the vertex of its own goal, which another has that has not come there yet. */
  private final Map<Integer, Integer> shared = new HashMap<>();

  /** Where nobody else shall stay, on the path of the only one that gets its goal; else empty. */
  private final Set<Integer> keptFree;

  /** By robot: who has its goal. */
  private final Map<String, String> holders = new HashMap<>();

  /** Those that want to go somewhere and have no path there, whoever made room. */
  private final Set<String> unreachable = new HashSet<>();

  GoalAssignment(
      FreeSpace freeSpace,
      OccupiedSpace occupied,
      LaneGrid lanes,
      RoadGraph roads,
      Spacing spacing,
      List<TrafficRobot> planned,
      int[] starts,
      List<SweptArea> wanted) {
    this(freeSpace, occupied, lanes, roads, spacing, planned, starts, wanted, Set.of());
    for (int i : order(planned)) {
      own[i] = starts[i];
      assign(i, goal(i));
    }
  }

  private GoalAssignment(
      FreeSpace freeSpace,
      OccupiedSpace occupied,
      LaneGrid lanes,
      RoadGraph roads,
      Spacing spacing,
      List<TrafficRobot> planned,
      int[] starts,
      List<SweptArea> wanted,
      Set<Integer> keptFree) {
    this.freeSpace = freeSpace;
    this.occupied = occupied;
    this.lanes = lanes;
    this.roads = roads;
    this.spacing = spacing;
    this.planned = planned;
    this.starts = starts;
    this.wanted = wanted;
    this.keptFree = keptFree;
    this.assigned = new int[planned.size()];
    this.own = new int[planned.size()];
  }

  /** The robots, whoever has waited longest first. */
  List<TrafficRobot> byWaiting() {
    return order(planned).stream().map(planned::get).toList();
  }

  /** Whether it has its own goal by this. */
  boolean canArrive(TrafficRobot robot) {
    int i = planned.indexOf(robot);
    return robot.goal() != null && assigned[i] == own[i] && !unreachable.contains(robot.name);
  }

  /** Whether a robot could get to its goal past another one that stays where it is. */
  boolean isPassable(TrafficRobot robot, String staying) {
    int i = planned.indexOf(robot);
    Set<Integer> closed = new HashSet<>();
    for (int other = 0; other < planned.size(); other++) {
      if (planned.get(other).name.equals(staying)) {
        closed.add(starts[other]);
        Arrays.stream(spacing.near(starts[other])).forEach(closed::add);
      }
    }
    boolean isPlanned = !closed.isEmpty();
    Deque<Integer> reached = new ArrayDeque<>(List.of(starts[i]));
    while (!reached.isEmpty()) {
      int at = reached.remove();
      if (at == own[i]) {
        return isPlanned && canArrive(robot);
      }
      for (int d = 0; d < RoadGraph.DIRECTIONS; d++) {
        int next = roads.neighbour(at, d);
        if (next != RoadGraph.NONE && closed.add(next)) {
          reached.add(next);
        }
      }
    }
    return false;
  }

  /** The goal of one; for each other robot the nearest place that is not on the shortest path. */
  GoalAssignment only(TrafficRobot robot) {
    List<Integer> order = new ArrayList<>(order(planned));
    int first = planned.indexOf(robot);
    int goal = assigned[first];
    GoalAssignment one =
        new GoalAssignment(
            freeSpace,
            occupied,
            lanes,
            roads,
            spacing,
            planned,
            starts,
            wanted,
            Set.copyOf(LaneWay.vertices(roads, starts[first], goal)));
    one.assign(first, goal);
    order.remove(Integer.valueOf(first));
    order.forEach(i -> one.assign(i, one.nearestOpen(starts[i], starts[i])));
    return one;
  }

  /** Who are, or want to be, where the only one has to go that gets its goal. */
  Set<String> makingRoom(TrafficRobot only) {
    int first = planned.indexOf(only);
    Set<Integer> path = Set.copyOf(LaneWay.vertices(roads, starts[first], own[first]));
    return IntStream.range(0, planned.size())
        .filter(i -> planned.get(i) != only && planned.get(i).goal() != null)
        .filter(i -> isNear(path, starts[i]) || isNear(path, own[i]))
        .mapToObj(i -> planned.get(i).name)
        .collect(Collectors.toSet());
  }

  private boolean isNear(Set<Integer> path, int vertex) {
    return path.contains(vertex)
        || Arrays.stream(spacing.near(vertex)).anyMatch(near -> path.contains(near));
  }

  /** Those that have a place or a path to it, then who waits longest, then who wants nothing. */
  private static List<Integer> order(List<TrafficRobot> planned) {
    return IntStream.range(0, planned.size())
        .boxed()
        .sorted(
            Comparator.<Integer, Boolean>comparing(i -> planned.get(i).goal() == null)
                .thenComparing(i -> planned.get(i).needsPath())
                .thenComparing(
                    i -> planned.get(i).waiting.since(),
                    nullsLast(Comparator.<Instant>naturalOrder())))
        .toList();
  }

  private void assign(int i, int vertex) {
    assigned[i] = vertex;
    taken.put(vertex, planned.get(i));
  }

  /** By robot: a vertex, all different. */
  int[] assigned() {
    return assigned;
  }

  /**
   * The same, but several may go to one goal as long as nobody is there: who comes first has it.
   */
  int[] shared() {
    int[] vertices = assigned.clone();
    shared.forEach((i, vertex) -> vertices[i] = vertex);
    return vertices;
  }

  /** How many do not get to their goals by this. */
  int leftOutCount() {
    return unreachable.size() + holders.size();
  }

  /** Tells each robot who has its goal. */
  void recordHolders() {
    planned.forEach(robot -> robot.waiting.setGoalTakenBy(holders.get(robot.name)));
  }

  /** Tells each robot who is at its goal. */
  void recordThere() {
    recordHolders();
    shared.keySet().forEach(i -> planned.get(i).waiting.setGoalTakenBy(null));
  }

  /** The names of those that want to go somewhere and can. */
  Set<String> reaching() {
    return planned.stream()
        .filter(robot -> robot.goal() != null && !unreachable.contains(robot.name))
        .map(robot -> robot.name)
        .collect(Collectors.toSet());
  }

  private int goal(int i) {
    TrafficRobot robot = planned.get(i);
    if (robot.goal() == null) {
      return nearestOpen(starts[i], starts[i]);
    }
    int vertex = approach(robot, robot.goal(), starts[i]);
    if (vertex == RoadGraph.NONE) {
      unreachable.add(robot.name);
      return nearestOpen(starts[i], starts[i]);
    }
    own[i] = vertex;
    TrafficRobot holder = takenBy(vertex);
    if (holder != null) {
      holders.put(robot.name, holder.name);
      if (!holder.isGoal(holder.committedEnd()) && isLeft(vertex)) {
        shared.put(i, vertex);
      }
    }
    if (!isOpen(vertex)) {
      return nearestOpen(vertex, starts[i]);
    }
    lastLegs.add(lastLeg(roads.cell(vertex), robot, robot.goal()));
    return vertex;
  }

  /** Who has a vertex, or one too near to it. */
  private @Nullable TrafficRobot takenBy(int vertex) {
    TrafficRobot robot = taken.get(vertex);
    for (int near : spacing.near(vertex)) {
      robot = robot == null ? taken.get(near) : robot;
    }
    return robot;
  }

  /** What a robot covers between the middle of a lane cell and its goal, or that of its cell. */
  private SweptArea lastLeg(Cell from, TrafficRobot robot, Vec2 goal) {
    return SweptArea.along(lanes.lattice().centre(from), end(goal), robot.radius());
  }

  private Vec2 end(Vec2 goal) {
    OccupancyGrid floor = freeSpace.grid();
    return lanes.isFloorGrid() ? floor.centre(floor.cellAt(goal)) : goal;
  }

  /**
   * The lane cell near its goal from which it can go straight there, as far off the walls as it can
   * be: of those alike the nearest.
   */
  private int approach(TrafficRobot robot, Vec2 goal, int start) {
    int best = RoadGraph.NONE;
    double most = -1;
    for (Cell cell : lanes.cellsAround(goal)) {
      int vertex = roads.vertex(cell);
      if (vertex != RoadGraph.NONE
          && roads.canReach(start, vertex)
          && isInDirection(lanes.lattice().centre(cell), end(goal))
          && occupied.isFree(robot.standingArea(), lastLeg(cell, robot, goal))) {
        Vec2 from = lanes.lattice().centre(cell);
        double kept = freeSpace.keptMargin(from, end(goal), robot.radius());
        if (kept > most && freeSpace.isWideEnough(from, end(goal), robot.radius())) {
          best = vertex;
          most = kept;
        }
      }
    }
    return best;
  }

  /** Else it would come round to the goal for ever, which lies behind where its path ends. */
  private boolean isInDirection(Vec2 from, Vec2 to) {
    return freeSpace.grid().rules().metresAgainst(from, to) <= MoveRules.SLACK;
  }

  /**
   * A vertex near to the wanted one that nobody else goes to. A robot that is near already stays
   * where it is; otherwise waiting robots would change places for ever.
   */
  private int nearestOpen(int to, int start) {
    int[] found = {RoadGraph.NONE};
    roads.visitByDistance(
        to,
        (vertex, steps) -> {
          if (found[0] != RoadGraph.NONE && steps > NEAR) {
            return false;
          }
          if (isOpen(vertex)) {
            found[0] = found[0] == RoadGraph.NONE || vertex == start ? vertex : found[0];
          }
          return found[0] != start;
        });
    return found[0] == RoadGraph.NONE ? start : found[0];
  }

  private boolean isOpen(int vertex) {
    if (takenBy(vertex) != null || keptFree.contains(vertex)) {
      return false;
    }
    SweptArea place = lanes.areaAt(roads.cell(vertex));
    return isLeft(vertex) && lastLegs.stream().allMatch(area -> Clearance.isKept(place, area));
  }

  /** Whether who is there is on nothing that others want to be left. */
  private boolean isLeft(int vertex) {
    SweptArea place = lanes.areaAt(roads.cell(vertex));
    return wanted.stream().allMatch(area -> Clearance.isKept(place, area));
  }
}
