package org.toqa.fleet.manager;

import java.util.ArrayList;
import java.util.List;
import org.toqa.allocation.AllocationProblem;
import org.toqa.allocation.Allocator;
import org.toqa.allocation.Decision;
import org.toqa.allocation.TeamSize;
import org.toqa.fleet.TaskPreview;
import org.toqa.fleet.floor.TeamRoomCheck;
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
final class TaskPreviewer {
  private final Allocator allocator;
  private final FloorMap floor;

  TaskPreviewer(Allocator allocator, FloorMap floor) {
    this.allocator = allocator;
    this.floor = floor;
  }

  /**
   * @param problem of the floor, where this task is the only one that waits
   */
  TaskPreview preview(TransportTask task, AllocationProblem problem) {
    Decision decision = allocator.allocate(problem).getFirst();
    List<String> chosen = chosen(decision);
    int robots =
        chosen.isEmpty()
            ? TeamSize.smallest(task.load(), problem.robots()).orElse(0)
            : chosen.size();
    List<Vec2> path = path(task);
    return new TeamRoomCheck(floor.grid())
        .objection(Mission.queued(task), robots)
        .map(noRoom -> new TaskPreview(robots, List.of(), noRoom, path))
        .orElseGet(() -> new TaskPreview(robots, chosen, decision.reason(), path));
  }

  private static List<String> chosen(Decision decision) {
    return switch (decision) {
      case Decision.Assigned assigned -> assigned.robots();
      case Decision.Unassigned _ -> List.of();
    };
  }

  private List<Vec2> path(TransportTask task) {
    OccupancyGrid grid = Inflation.inflate(floor.grid(), OrderValidator.SMALLEST_RADIUS);
    Vec2 start = task.start().position();
    Vec2 goal = task.goal().position();
    PlanResult planned = new HeadingAStar().plan(grid, grid.cellAt(start), grid.cellAt(goal));
    if (!(planned instanceof PlanResult.Found(var path))) {
      return List.of();
    }
    List<Waypoint> bends = path.waypoints(grid);
    List<Vec2> points = new ArrayList<>(List.of(start));
    bends.subList(0, bends.size() - 1).forEach(bend -> points.add(bend.position()));
    points.add(goal);
    return points;
  }
}
