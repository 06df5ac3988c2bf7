package org.toqa.traffic.lifelong;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.Heading;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.GridPose;
import org.toqa.traffic.MotionModel;
import org.toqa.traffic.RoadGraph;

/** Robots on all cells but a few, as in a sliding puzzle, get goal after goal. */
@Tag("full")
class PackedFloorTest {
  private static final OccupancyGrid GRID =
      OccupancyGrid.parse(
          "........",
          "..#.....",
          "......#.",
          "........",
          ".#......",
          "....#...",
          "........",
          "........");
  private static final int ROBOTS = 58; // on 60 free cells
  private static final int STEPS = 100;

  @ParameterizedTest
  @EnumSource
  void allGetOnAndManyGoalsAreReached(MotionModel model) {
    Random random = new Random(3);
    List<Cell> cells = cells(random);
    Drive drive =
        new Drive(
            GRID,
            model,
            new RollingHorizonPlanner(model, true, 1),
            cells.subList(0, ROBOTS),
            goals(cells, random));
    int[] lastMoves = new int[ROBOTS];
    int longest = 0;
    int reached = 0;

    for (int step = 1; step <= STEPS; step++) {
      List<GridPose> before = IntStream.range(0, ROBOTS).mapToObj(drive::stance).toList();
      drive.step();
      for (int robot = 0; robot < ROBOTS; robot++) {
        if (!drive.stance(robot).cell().equals(before.get(robot).cell())) {
          lastMoves[robot] = step;
        }
        longest = Math.max(longest, step - lastMoves[robot]);
        if (drive.isArrived(robot)) {
          reached++;
          drive.headFor(robot, anyOther(cells, drive.stance(robot).cell(), random));
        }
      }
    }

    assertTrue(longest < 50, "a robot has stayed for " + longest + " steps");
    int least = model == MotionModel.CLASSIC ? 420 : 140;
    assertTrue(reached >= least, "reached " + reached);
  }

  @Test
  void plansReachLessFarWhileTheRoadsArePacked() {
    RoadGraph roads = new RoadGraph(GRID);
    RollingHorizonPlanner planner = new RollingHorizonPlanner(MotionModel.TURNS, true, 1);
    Random random = new Random(5);
    List<Cell> cells = cells(random);

    int[] steps = {40, ROBOTS, 40};
    int[] planned =
        Arrays.stream(steps)
            .map(
                robots ->
                    planner
                        .plan(snapshot(roads, cells, robots), Deadline.none())
                        .paths()
                        .getFirst()
                        .poses()
                        .size())
            .toArray();

    assertEquals(List.of(6, 4, 6), Arrays.stream(planned).boxed().toList());
  }

  private static TrafficSnapshot snapshot(RoadGraph roads, List<Cell> cells, int robots) {
    return new TrafficSnapshot(
        roads,
        IntStream.range(0, robots)
            .mapToObj(
                r ->
                    new PlannedRobot(
                        "r" + r,
                        new GridPose(cells.get(r), Heading.EAST),
                        cells.get((r + 7) % robots),
                        0))
            .toList());
  }

  private static List<Cell> cells(Random random) {
    RoadGraph roads = new RoadGraph(GRID);
    List<Cell> cells =
        new ArrayList<>(IntStream.range(0, roads.vertexCount()).mapToObj(roads::cell).toList());
    Collections.shuffle(cells, random);
    return cells;
  }

  private static List<Cell> goals(List<Cell> cells, Random random) {
    return cells.subList(0, ROBOTS).stream().map(cell -> anyOther(cells, cell, random)).toList();
  }

  private static Cell anyOther(List<Cell> cells, Cell but, Random random) {
    Cell cell = but;
    while (cell.equals(but)) {
      cell = cells.get(random.nextInt(cells.size()));
    }
    return cell;
  }
}
