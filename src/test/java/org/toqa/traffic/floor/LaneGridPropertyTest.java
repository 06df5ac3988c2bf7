package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.BitSet;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.Size;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Margins;
import org.toqa.grid.OccupancyGrid;
import org.toqa.traffic.RoadGraph;

class LaneGridPropertyTest {
  private static final double DIAMETER = 0.255;
  private static final double RADIUS = DIAMETER / 2;

  private final OccupancyGrid floor = DrivenFloor.draw("......", ".#....", "......", "....#.");
  private final LaneGrid lanes = LaneGrid.of(floor, DIAMETER, Margins.USUAL.robot());

  /** Planners ask for the edge back wherever there is one. */
  @Property(tries = 300)
  void lanesBesideOthersCanBeDrivenBothWays(
      @ForAll @Size(min = 1, max = 3) List<@DoubleRange(min = 0, max = 1) Double> claimedAt,
      @ForAll @Size(max = 4) List<@DoubleRange(min = 0, max = 1) Double> standingAt) {
    List<SweptArea> claimed =
        claimedAt.stream().map(at -> SweptArea.at(point(at), RADIUS)).toList();
    List<Pose> standing =
        standingAt.stream().map(this::point).map(at -> new Pose(at.x(), at.y(), 0)).toList();
    RoadGraph roads = lanes.roads(new OccupiedSpace(floor, new BitSet(), claimed), standing);
    for (int vertex = 0; vertex < roads.vertexCount(); vertex++) {
      for (int direction = 0; direction < RoadGraph.DIRECTIONS; direction++) {
        int next = roads.neighbour(vertex, direction);
        if (next != RoadGraph.NONE) {
          assertEquals(vertex, roads.neighbour(next, RoadGraph.opposite(direction)));
        }
      }
    }
  }

  /**
   * @param share of all there is, in reading order and finely
   */
  private Vec2 point(double share) {
    double width = floor.width() * floor.resolution();
    double along = share * floor.height();
    return new Vec2(
        (along - Math.floor(along)) * width,
        Math.min(along, floor.height() - 0.01) * floor.resolution());
  }
}
