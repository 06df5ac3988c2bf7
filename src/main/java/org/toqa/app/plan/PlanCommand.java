package org.toqa.app.plan;

import java.util.List;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.toqa.app.command.Arguments;
import org.toqa.app.command.CommandOutput;
import org.toqa.app.command.MoveSet;
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
import org.toqa.planning.smooth.DiscSpace;
import org.toqa.planning.smooth.PlanningBudget;
import org.toqa.planning.smooth.SmoothMethod;
import org.toqa.planning.smooth.SmoothPlanner;
import org.toqa.planning.smooth.SmoothResult;
import org.toqa.planning.smooth.WayPath;
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
      "is no path, the command prints the reason to standard error and exits 1.",
      "",
      "With --moves smooth the path is a curve from --from to --to itself, and",
      "--margin is the radius of the disc that follows it. The table and JSON also",
      "have what the two wheels of a differential robot do in samples of 30 ms: v, w,",
      "and for each wheel its speed, T_on, ISPA (0 to 255), pulse and direction; the",
      "picture has the speeds over time. JSON: found, reason (also OUT_OF_TIME),",
      "length, seconds, maxCurvature (radians per metre), turnsOnSpot, start, path,",
      "segments, wheels, and polynomial, the y(x) of lowest degree that touches",
      "nothing, or null: from, to, and bulge c: y is the straight line plus t (1 - t)",
      "(c0 + c1 t + c2 t^2), t from 0 at from to 1 at to."
    })
public final class PlanCommand implements Callable<Integer> {
  /** Cells; more than any map has on a side that is worth planning on. */
  private static final int MAX_MARGIN = 1000;

  /** Of the tree and the swarm: the same arguments give the same plan. */
  private static final int SMOOTH_ITERATIONS = 4000;

  private static final long SMOOTH_SEED = 1;

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

  @Option(
      names = "--moves",
      defaultValue = "heading",
      paramLabel = "octile|heading|smooth",
      converter = PlanMoves.Converter.class,
      description =
          "octile: moves to any of the eight neighbours; heading: moves that a robot can drive in"
              + " arcs; smooth: a curve in the plane (default: ${DEFAULT-VALUE}).")
  private PlanMoves moves = PlanMoves.HEADING;

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
    if (moves == PlanMoves.SMOOTH && margin == 0) {
      throw arguments.invalid("--moves smooth needs a --margin above 0, the radius of the robot");
    }
    FloorMap floor = arguments.readFloor(map.file());
    if (moves == PlanMoves.SMOOTH) {
      return planSmooth(floor, output);
    }
    OccupancyGrid inflated = Inflation.inflate(floor.grid(), margin * floor.grid().resolution());
    Cell start = inflated.cellAt(from.position());
    Cell goal = inflated.cellAt(to.position());
    PlanResult result = gridMoves().planner(expanded -> {}).plan(inflated, start, goal);
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

  private MoveSet gridMoves() {
    return moves == PlanMoves.OCTILE ? MoveSet.OCTILE : MoveSet.HEADING;
  }

  private int planSmooth(FloorMap floor, CommandOutput output) {
    DiscSpace space = DiscSpace.of(floor.grid(), margin * floor.grid().resolution());
    SmoothResult result =
        new SmoothPlanner(SmoothMethod.HYBRID, SMOOTH_SEED)
            .plan(
                space,
                from.position(),
                to.position(),
                PlanningBudget.iterations(SMOOTH_ITERATIONS));
    return switch (result) {
      case SmoothResult.Found(WayPath path) -> {
        output.print(format.render(SmoothDrive.of(floor, space, path, from.heading())));
        yield ExitCode.OK;
      }
      case SmoothResult.NotFound(SmoothResult.Reason reason) -> {
        if (format == PlanFormat.JSON) {
          output.print(SmoothJson.of(reason));
        }
        output.printError(failureMessage(reason, floor.grid()));
        yield ExitCode.SOFTWARE;
      }
    };
  }

  private String failureMessage(SmoothResult.Reason reason, OccupancyGrid walls) {
    String why =
        switch (reason) {
          case START_BLOCKED ->
              "the start" + obstacleMessage(walls.cellAt(from.position()), from, walls);
          case GOAL_BLOCKED -> "the goal" + obstacleMessage(walls.cellAt(to.position()), to, walls);
          case NO_PATH -> "obstacles part the goal from the start";
          case OUT_OF_TIME -> "none was found in time";
        };
    return "There is no path (%s): %s.".formatted(reason, why);
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
          case GAVE_UP -> "the planner found none, though there may be one";
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
