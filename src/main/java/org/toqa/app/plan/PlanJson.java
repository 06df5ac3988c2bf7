package org.toqa.app.plan;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.grid.Cell;
import org.toqa.motion.Segment;
import org.toqa.planning.Path;
import org.toqa.planning.PlanResult.NotFound;
import org.toqa.planning.PlanResult.Reason;
import tools.jackson.databind.json.JsonMapper;

/**
 * A plan for programs.
 *
 * @param reason why there is no path; null where there is one
 * @param cost in cells: 1 or sqrt 2 for a move, 1/2 for each 45 degrees turned on the spot
 * @param length metres driven
 * @param seconds that the drive takes
 * @param turnsOnSpot how often the robot turns on the spot between start and goal
 * @param start pose at the start of the first segment; metres and radians, map frame
 * @param cells columns and rows, row 0 at the top, in the order of the path
 * @param segments v in metres a second, w in radians a second, positive to the left, t in seconds
 */
record PlanJson(
    boolean found,
    @Nullable Reason reason,
    @Nullable Double cost,
    @Nullable Double length,
    @Nullable Double seconds,
    @Nullable Integer turnsOnSpot,
    @Nullable Pose start,
    List<int[]> cells,
    List<Segment> segments) {

  static String of(PlannedDrive drive) {
    Path path = drive.path();
    return text(
        new PlanJson(
            true,
            null,
            path.cost(),
            drive.trajectory().length(),
            drive.trajectory().duration(),
            path.turnsOnSpot(),
            drive.trajectory().start(),
            path.cells().stream().map(PlanJson::columnAndRow).toList(),
            drive.trajectory().segments()));
  }

  static String of(NotFound none) {
    return text(
        new PlanJson(false, none.reason(), null, null, null, null, null, List.of(), List.of()));
  }

  private static int[] columnAndRow(Cell cell) {
    return new int[] {cell.column(), cell.row()};
  }

  private static String text(PlanJson plan) {
    return JsonMapper.shared().writeValueAsString(plan);
  }
}
