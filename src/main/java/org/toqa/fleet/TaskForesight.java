package org.toqa.fleet;

import java.util.ArrayList;
import java.util.List;
import org.toqa.allocation.Allocator;
import org.toqa.allocation.Decision;
import org.toqa.allocation.Situation;
import org.toqa.allocation.TeamSize;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Inflation;
import org.toqa.grid.OccupancyGrid;
import org.toqa.mission.Mission;
import org.toqa.mission.TransportTask;
import org.toqa.planning.HeadingAStar;
import org.toqa.planning.PlanResult;

/** Tells what would become of a task that nobody has asked for yet. It plans: give it a thread. */
final class TaskForesight {
  private final Allocator allocator;
  private final FloorMap floor;

  TaskForesight(Allocator allocator, FloorMap floor) {
    this.allocator = allocator;
    this.floor = floor;
  }

  /**
   * @param situation of the floor, where this task is the only one that waits
   */
  TaskPreview of(TransportTask task, Situation situation) {
    Decision decision = allocator.allocate(situation).getFirst();
    List<String> chosen = chosen(decision);
    int robots =
        chosen.isEmpty() ? TeamSize.of(task.load(), situation.robots()).orElse(0) : chosen.size();
    List<Vec2> way = way(task);
    return new TeamRoom(floor.grid())
        .objection(Mission.queued(task), robots)
        .map(noRoom -> new TaskPreview(robots, List.of(), noRoom, way))
        .orElseGet(() -> new TaskPreview(robots, chosen, decision.why(), way));
  }

  private static List<String> chosen(Decision decision) {
    return switch (decision) {
      case Decision.Assigned assigned -> assigned.robots();
      case Decision.Waits _ -> List.of();
    };
  }

  private List<Vec2> way(TransportTask task) {
    OccupancyGrid grid = Inflation.of(floor.grid(), OrderCheck.SMALLEST_RADIUS);
    Vec2 start = task.start().position();
    Vec2 goal = task.goal().position();
    PlanResult planned = new HeadingAStar().plan(grid, grid.cellAt(start), grid.cellAt(goal));
    if (!(planned instanceof PlanResult.Found(var path))) {
      return List.of();
    }
    List<Waypoint> bends = path.waypoints(grid);
    List<Vec2> way = new ArrayList<>(List.of(start));
    bends.subList(0, bends.size() - 1).forEach(bend -> way.add(bend.position()));
    way.add(goal);
    return way;
  }
}
