package org.toqa.app.plan;

import java.util.List;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.toqa.app.command.Arguments;
import org.toqa.app.command.CommandOutput;
import org.toqa.app.command.MoveSet;
import org.toqa.app.command.MovesOption;
import org.toqa.app.command.PlaceArgument;
import org.toqa.app.command.RequiredMapOption;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.grid.Cell;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Inflation;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DriveSpeeds;
import org.toqa.motion.SegmentFitter;
import org.toqa.planning.Path;
import org.toqa.planning.PlanResult;
import org.toqa.planning.PlanResult.Found;
import org.toqa.planning.PlanResult.NotFound;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code toqa plan}: one path on a map. */
@Command(
    name = "plan",
    description = "Plan a path on a map and print its cost, cells and trajectory segments.",
    footer = {
      "",
      "X and Y are in metres in the map frame (x east, y north); a MovingAI map has",
      "cells of 1 m and its origin at the lower left corner. The path leads from the",
      "centre of the cell at --from to the centre of the cell at --to. DEG is the",
      "heading of the robot at the start in degrees counter-clockwise from east; the",
      "robot turns on the spot toward its first move.",
      "",
      "The cost is in cells: 1 or the square root of 2 for a move, 1/2 for each 45",
      "degrees turned on the spot between start and goal. A segment has v (metres per",
      "second), w (radians per second, positive to the left) and t (seconds). Cells",
      "are column,row; row 0 is the top of the map.",
      "",
      "JSON: found, reason (START_BLOCKED, GOAL_BLOCKED, NO_PATH, or null), cost,",
      "length (metres driven), seconds, turnsOnSpot, start, cells, segments. If there",
      "is no path, the command prints the reason to standard error and exits 1."
    })
public final class PlanCommand implements Callable<Integer> {
  /** Cells; more than any map has on a side that is worth planning on. */
  private static final int MAX_MARGIN = 1000;

  @Spec private CommandSpec spec = CommandSpec.create();

  @Mixin private RequiredMapOption map = new RequiredMapOption();

  @Option(
      names = "--from",
      required = true,
      paramLabel = "X,Y[,DEG]",
      converter = PlaceArgument.PoseConverter.class,
      description = "Start, and optionally the robot's heading (default: toward its first move).")
  private PlaceArgument from = new PlaceArgument(Vec2.ZERO, null);

  @Option(
      names = "--to",
      required = true,
      paramLabel = "X,Y",
      converter = PlaceArgument.PointConverter.class,
      description = "Goal.")
  private PlaceArgument to = new PlaceArgument(Vec2.ZERO, null);

  @Mixin private MovesOption moves = new MovesOption(MoveSet.HEADING);

  @Option(
      names = "--margin",
      defaultValue = "0",
      paramLabel = "CELLS",
      description =
          "Radius of the robot in cells, added around obstacles and the map's border; 0.5 just fits"
              + " an aisle of one cell (default: ${DEFAULT-VALUE}).")
  private double margin;

  @Option(
      names = "--format",
      defaultValue = "table",
      paramLabel = "table|json|svg",
      converter = PlanFormat.Converter.class,
      description = "Output format (default: table).")
  private PlanFormat format = PlanFormat.TABLE;

  @Override
  public Integer call() {
    Arguments arguments = new Arguments(spec);
    CommandOutput output = new CommandOutput(spec);
    if (!(margin >= 0 && margin <= MAX_MARGIN)) {
      throw arguments.invalid("--margin %s: it must be from 0 to %d".formatted(margin, MAX_MARGIN));
    }
    FloorMap floor = arguments.readFloor(map.file());
    OccupancyGrid inflated = Inflation.inflate(floor.grid(), margin * floor.grid().resolution());
    Cell start = inflated.cellAt(from.position());
    Cell goal = inflated.cellAt(to.position());
    PlanResult result = moves.value().planner(expanded -> {}).plan(inflated, start, goal);
    return switch (result) {
      case Found(Path path) -> {
        output.print(format.render(plannedDrive(floor, inflated, path)));
        yield ExitCode.OK;
      }
      case NotFound none -> {
        if (format == PlanFormat.JSON) {
          output.print(PlanJson.of(none));
        }
        output.printError(failureMessage(none, floor.grid()));
        yield ExitCode.SOFTWARE;
      }
    };
  }

  private PlannedDrive plannedDrive(FloorMap floor, OccupancyGrid inflated, Path path) {
    Path.Step first = path.steps().getFirst();
    Vec2 centre = inflated.centre(first.cell());
    @Nullable Double given = from.heading();
    Pose start = new Pose(centre.x(), centre.y(), given == null ? first.heading().angle() : given);
    List<Waypoint> waypoints = path.waypoints(inflated);
    SegmentFitter fitter = new SegmentFitter(DriveSpeeds.DEFAULT, inflated.resolution());
    return new PlannedDrive(floor, inflated, path, fitter.fit(start, waypoints));
  }

  private String failureMessage(NotFound none, OccupancyGrid walls) {
    String why =
        switch (none.reason()) {
          case START_BLOCKED -> "the start" + obstacleMessage(none.where(), from, walls);
          case GOAL_BLOCKED -> "the goal" + obstacleMessage(none.where(), to, walls);
          case NO_PATH -> "obstacles part the goal from the start";
        };
    return "There is no path (%s): %s.".formatted(none.reason(), why);
  }

  private static String obstacleMessage(Cell cell, PlaceArgument spot, OccupancyGrid walls) {
    String place = " at (%s, %s) m ".formatted(spot.position().x(), spot.position().y());
    if (!walls.contains(cell)) {
      return place + "lies off the map";
    }
    return place
        + (walls.isFree(cell) ? "is nearer to an obstacle than the margin" : "lies in an obstacle");
  }
}
