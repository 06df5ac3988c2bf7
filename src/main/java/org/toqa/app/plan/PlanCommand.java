package org.toqa.app.plan;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.toqa.app.command.Arguments;
import org.toqa.app.command.MoveSet;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.grid.Cell;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Inflation;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DriveSpeeds;
import org.toqa.motion.SegmentFitter;
import org.toqa.planning.PlanResult;
import org.toqa.planning.PlanResult.Found;
import org.toqa.planning.PlanResult.NotFound;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code toqa plan}: one way on a map. */
@Command(
    name = "plan",
    description =
        "Plans one way on a map: its cost, its cells, and the segments that a robot drives.",
    footer = {
      "",
      "X and Y are metres in the map's frame (x east, y north); a MovingAI map has",
      "cells of 1 m and its origin at its lower left corner. The way leads from the",
      "middle of the cell at --from to the middle of the cell at --to. DEG is where",
      "the robot faces at the start, degrees counter-clockwise from east; it turns",
      "on the spot to its first leg.",
      "",
      "Cost is in cells: 1 or the square root of 2 for a move, 1/2 for each 45",
      "degrees turned on the spot between start and goal. A segment is v (metres a",
      "second), w (radians a second, positive to the left) and t (seconds). Cells",
      "are column,row; row 0 is the top of the map.",
      "",
      "JSON: found, reason (START_BLOCKED, GOAL_BLOCKED, NO_PATH, or null), cost,",
      "length (metres driven), seconds, turnsOnSpot, start, cells, segments. Where",
      "there is no way, the command says why and exits 1."
    })
public final class PlanCommand implements Callable<Integer> {
  /** Cells; more than any map has on a side that is worth planning on. */
  private static final int MAX_MARGIN = 1000;

  @Spec private CommandSpec spec = CommandSpec.create();

  @Option(
      names = "--map",
      required = true,
      paramLabel = "FILE",
      description = "The yaml file of a map_server pair, or a MovingAI map.")
  private Path map = Path.of("");

  @Option(
      names = "--from",
      required = true,
      paramLabel = "X,Y[,DEG]",
      converter = PlaceArgument.PoseConverter.class,
      description = "The start, and where the robot faces (default: to its first leg).")
  private PlaceArgument from = new PlaceArgument(Vec2.ZERO, null);

  @Option(
      names = "--to",
      required = true,
      paramLabel = "X,Y",
      converter = PlaceArgument.PointConverter.class,
      description = "The goal.")
  private PlaceArgument to = new PlaceArgument(Vec2.ZERO, null);

  @Option(
      names = "--moves",
      defaultValue = "heading",
      paramLabel = "octile|heading",
      converter = MoveSet.Converter.class,
      description = "Any of eight moves, or what a robot drives in arcs (default: heading).")
  private MoveSet moves = MoveSet.HEADING;

  @Option(
      names = "--margin",
      defaultValue = "0",
      paramLabel = "CELLS",
      description =
          "The robot's radius, by which obstacles and the map's border grow; 0.5 lets it just"
              + " pass an aisle of one cell (default: ${DEFAULT-VALUE}).")
  private double margin;

  @Option(
      names = "--format",
      defaultValue = "table",
      paramLabel = "table|json|svg",
      converter = PlanFormat.Converter.class,
      description = "For people, for programs, or a picture (default: table).")
  private PlanFormat format = PlanFormat.TABLE;

  @Override
  public Integer call() {
    Arguments arguments = new Arguments(spec);
    if (!(margin >= 0 && margin <= MAX_MARGIN)) {
      throw arguments.invalid("--margin %s: it must be from 0 to %d".formatted(margin, MAX_MARGIN));
    }
    FloorMap floor = arguments.readFloor(map);
    OccupancyGrid inflated = Inflation.inflate(floor.grid(), margin * floor.grid().resolution());
    Cell start = inflated.cellAt(from.position());
    Cell goal = inflated.cellAt(to.position());
    PlanResult result = moves.planner(expanded -> {}).plan(inflated, start, goal);
    return switch (result) {
      case Found(org.toqa.planning.Path path) -> {
        spec.commandLine().getOut().println(format.render(plannedDrive(floor, inflated, path)));
        yield ExitCode.OK;
      }
      case NotFound none -> {
        if (format == PlanFormat.JSON) {
          spec.commandLine().getOut().println(PlanJson.of(none));
        }
        spec.commandLine().getErr().println("toqa: " + failureMessage(none, floor.grid()));
        yield ExitCode.SOFTWARE;
      }
    };
  }

  private PlannedDrive plannedDrive(
      FloorMap floor, OccupancyGrid inflated, org.toqa.planning.Path path) {
    org.toqa.planning.Path.Step first = path.steps().getFirst();
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
    return "There is no way (%s): %s.".formatted(none.reason(), why);
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
