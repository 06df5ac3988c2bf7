package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.DistanceTables;
import org.toqa.traffic.RoadGraph;

/** Shortest ways over lane cells, whoever is there. */
final class LaneWay {
  private LaneWay() {}

  /**
   * What a robot alone would cover on its way to its goal over lane cells that are wide enough for
   * it, in parts; nothing where these do not lead there.
   */
  static List<SweptArea> areas(FreeSpace freeSpace, TrafficRobot robot) {
    Vec2 goal = robot.goal();
    double diameter = 2 * robot.radius();
    if (goal == null || robot.isFormation() || !LaneGrid.hasRoom(freeSpace.grid(), diameter)) {
      return List.of();
    }
    LaneGrid lanes = freeSpace.laneGrid(diameter);
    RoadGraph roads = freeSpace.laneRoads(diameter);
    int start = nearest(lanes, roads, robot.committedEnd().position());
    int end = nearest(lanes, roads, goal);
    if (start == RoadGraph.NONE || end == RoadGraph.NONE || !roads.canReach(start, end)) {
      return List.of();
    }
    List<Vec2> points =
        vertices(roads, start, end).stream()
            .map(vertex -> lanes.lattice().centre(roads.cell(vertex)))
            .toList();
    return IntStream.range(0, points.size())
        .mapToObj(
            i -> SweptArea.along(points.get(Math.max(0, i - 1)), points.get(i), robot.radius()))
        .toList();
  }

  private static int nearest(LaneGrid lanes, RoadGraph roads, Vec2 point) {
    for (Cell cell : lanes.cellsAround(point)) {
      int vertex = roads.vertex(cell);
      if (vertex != RoadGraph.NONE) {
        return vertex;
      }
    }
    return RoadGraph.NONE;
  }

  /** The vertices of a shortest way, in their order; as far as it leads where there is none. */
  static List<Integer> vertices(RoadGraph roads, int from, int to) {
    char[] distances = DistanceTables.of(roads, new int[] {to}, Deadline.none())[0];
    List<Integer> way = new ArrayList<>(List.of(from));
    int at = from;
    while (at != to) {
      int best = at;
      for (int d = 0; d < RoadGraph.DIRECTIONS; d++) {
        int next = roads.neighbour(at, d);
        best = next != RoadGraph.NONE && distances[next] < distances[best] ? next : best;
      }
      if (best == at) {
        return way;
      }
      at = best;
      way.add(at);
    }
    return way;
  }
}
