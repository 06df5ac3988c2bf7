package org.toqa.traffic.mapf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.OptionalInt;
import java.util.Random;
import java.util.Set;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.toqa.traffic.MotionModel;
import org.toqa.traffic.RandomFloors;
import org.toqa.traffic.RandomFloors.Floor;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.Spacing;

/** The search by intervals against one that tries every state at every time. */
class SafeIntervalSearchPropertyTest {

  @Provide
  Arbitrary<Floor> floors() {
    return RandomFloors.strewn(6, 0.3, 8);
  }

  @Property(tries = 250)
  void findsTheQuickestRouteAroundTheOthers(
      @ForAll("floors") Floor floor, @ForAll MotionModel model, @ForAll Random random) {
    RoadGraph roads = new RoadGraph(floor.grid());
    StateGraph graph = new StateGraph(roads, model);
    int start = graph.state(roads.vertex(floor.starts().getFirst()), random.nextInt(4));
    int goal = roads.vertex(floor.goals().getFirst());
    ReservationTable timetable = new ReservationTable(roads, 100);
    List<int[]> others = others(roads, floor, random);
    others.forEach(timetable::add);

    int[] route =
        new SafeIntervalSearch(graph, timetable)
            .path(start, goal, StateDistances.to(graph, goal), timetable.end());

    OptionalInt earliest = earliest(graph, start, goal, others, timetable.end());
    if (earliest.isEmpty()) {
      assertNull(route);
    } else {
      assertNotNull(route);
      assertEquals(earliest.getAsInt(), route.length - 1);
      int[] driven = vertices(graph, route);
      others.forEach(
          other -> assertFalse(VertexPaths.hasConflict(Spacing.none(roads), other, driven)));
    }
  }

  @Property(tries = 100)
  void whatIsRemovedLeavesNoTrace(@ForAll("floors") Floor floor, @ForAll Random random) {
    RoadGraph roads = new RoadGraph(floor.grid());
    ReservationTable timetable = new ReservationTable(roads, 100);
    List<int[]> routes = others(roads, floor, random);
    routes.forEach(timetable::add);

    routes.forEach(timetable::remove);

    for (int v = 0; v < roads.vertexCount(); v++) {
      assertEquals(timetable.end(), timetable.nextTaken(v, 0));
      for (int d = 0; d < RoadGraph.DIRECTIONS; d++) {
        assertEquals(63, timetable.nextFreeEdge(v, d, 63));
      }
    }
  }

  /** Robots that walk at random without colliding, and then stay. */
  private static List<int[]> others(RoadGraph roads, Floor floor, Random random) {
    List<int[]> routes = new ArrayList<>();
    for (int robot = 1; robot < floor.starts().size(); robot++) {
      int[] route = walk(roads, roads.vertex(floor.starts().get(robot)), random);
      if (routes.stream()
          .noneMatch(other -> VertexPaths.hasConflict(Spacing.none(roads), other, route))) {
        routes.add(route);
      }
    }
    return routes;
  }

  private static int[] walk(RoadGraph roads, int start, Random random) {
    int[] route = new int[1 + random.nextInt(80)];
    route[0] = start;
    for (int t = 1; t < route.length; t++) {
      int next = roads.neighbour(route[t - 1], random.nextInt(4));
      route[t] = next == RoadGraph.NONE || random.nextInt(3) == 0 ? route[t - 1] : next;
    }
    return route;
  }

  private static OptionalInt earliest(
      StateGraph graph, int start, int goal, List<int[]> others, int end) {
    Set<Integer> reached = new HashSet<>();
    if (isFree(graph.vertex(start), 0, others)) {
      reached.add(start);
    }
    for (int t = 0; t < end; t++) {
      for (int state : reached) {
        if (graph.vertex(state) == goal && staysFree(goal, t, end, others)) {
          return OptionalInt.of(t);
        }
      }
      Set<Integer> next = new HashSet<>();
      for (int state : reached) {
        for (int action = 0; action < graph.actionCount(); action++) {
          int to = graph.successor(state, action);
          if (to != RoadGraph.NONE && isOpen(graph.vertex(state), graph.vertex(to), t, others)) {
            next.add(to);
          }
        }
      }
      reached = next;
    }
    return OptionalInt.empty();
  }

  private static boolean staysFree(int vertex, int from, int end, List<int[]> others) {
    for (int t = from; t < end; t++) {
      if (!isFree(vertex, t, others)) {
        return false;
      }
    }
    return true;
  }

  private static boolean isFree(int vertex, int time, List<int[]> others) {
    return others.stream().noneMatch(other -> VertexPaths.at(other, time) == vertex);
  }

  private static boolean isOpen(int from, int to, int time, List<int[]> others) {
    return isFree(to, time + 1, others)
        && others.stream()
            .noneMatch(o -> VertexPaths.at(o, time) == to && VertexPaths.at(o, time + 1) == from);
  }

  private static int[] vertices(StateGraph graph, int[] route) {
    return Arrays.stream(route).map(graph::vertex).toArray();
  }
}
