package org.toqa.traffic.lifelong;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.toqa.grid.OccupancyGrid;
import org.toqa.traffic.DistanceTables;
import org.toqa.traffic.MotionModel;
import org.toqa.traffic.RandomFloors;
import org.toqa.traffic.RandomFloors.Floor;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.mapf.StateDistances;
import org.toqa.traffic.mapf.StateGraph;

class GuidancePropertyTest {

  @Provide
  Arbitrary<Floor> floors() {
    return RandomFloors.strewn(8, 0.4, 4);
  }

  @Property(tries = 300)
  void withoutTrafficCostsAreSteps(
      @ForAll("floors") Floor floor, @ForAll MotionModel model, @ForAll Random random) {
    StateGraph graph = new StateGraph(new RoadGraph(floor.grid()), model);
    int goal = graph.roads().vertex(floor.goals().getFirst());
    int start = graph.state(graph.roads().vertex(floor.starts().getFirst()), random.nextInt(4));

    char[] costs = new Guidance(graph).distances(start, goal);

    char[] steps = StateDistances.to(graph, goal);
    int known = steps[start] * Guidance.STEP + Guidance.MARGIN;
    for (int state = 0; state < graph.stateCount(); state++) {
      int expected = steps[state] * Guidance.STEP;
      if (steps[state] == DistanceTables.UNREACHABLE) {
        assertEquals(DistanceTables.UNREACHABLE, costs[state]);
      } else if (expected + Guidance.STEP * apart(graph, state, start) <= known) {
        assertEquals(expected, costs[state]);
      } else {
        assertTrue(costs[state] >= expected, "beyond the margin");
      }
    }
  }

  /** The steps between two states on an empty floor. */
  private static int apart(StateGraph graph, int one, int other) {
    RoadGraph roads = graph.roads();
    int from = graph.vertex(one);
    int to = graph.vertex(other);
    return Math.abs(roads.columnOf(from) - roads.columnOf(to))
        + Math.abs(roads.rowOf(from) - roads.rowOf(to));
  }

  @Property(tries = 300)
  void whatIsWithdrawnCountsNoMore(
      @ForAll("floors") Floor floor, @ForAll MotionModel model, @ForAll Random random) {
    StateGraph graph = new StateGraph(new RoadGraph(floor.grid()), model);
    int goal = graph.roads().vertex(floor.goals().getFirst());
    int start = graph.state(graph.roads().vertex(floor.starts().getLast()), random.nextInt(4));
    Guidance guidance = new Guidance(graph);
    char[] before = guidance.distances(start, goal);

    int[] path = guidance.announce(start, before);
    if (before[start] != DistanceTables.UNREACHABLE) {
      assertTrue(path.length <= before[start] / Guidance.STEP);
    }
    guidance.withdraw(path);

    assertEquals(new String(before), new String(guidance.distances(start, goal)));
  }

  @Example
  void ofTwoAislesOneTakesTheOneWithoutOncomingTraffic() {
    StateGraph graph =
        new StateGraph(
            new RoadGraph(OccupancyGrid.parse("......", ".####.", "......")), MotionModel.CLASSIC);
    int west = graph.roads().vertex(0, 1);
    int east = graph.roads().vertex(5, 1);
    Guidance guidance = new Guidance(graph);
    int[] westward = guidance.announce(east, guidance.distances(east, west));
    boolean isNorthTaken = graph.roads().rowOf(westward[1] / RoadGraph.DIRECTIONS) == 0;

    int[] eastward = guidance.announce(west, guidance.distances(west, east));

    int row = graph.roads().rowOf(eastward[1] / RoadGraph.DIRECTIONS);
    assertEquals(isNorthTaken ? 2 : 0, row);
  }
}
