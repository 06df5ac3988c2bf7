package org.toqa.app.bench;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.toqa.app.command.Arguments;
import org.toqa.grid.Cell;
import org.toqa.planning.Heading;
import org.toqa.traffic.GridPose;
import org.toqa.traffic.RoadGraph;

/** Where robots begin, and where they go. */
record Workload(List<GridPose> starts, GoalSource goals) {

  Workload {
    starts = List.copyOf(starts);
  }

  /** How many robots there can be, so that each can have a goal elsewhere. */
  static int most(RoadGraph roads) {
    return roads.largestPartSize() - 1;
  }

  /**
   * Starts and goals by chance in the largest connected part, starts all different.
   *
   * @param robots from 1 to {@link #most}
   */
  static Workload random(RoadGraph roads, int robots, long seed) {
    List<Cell> cells =
        IntStream.range(0, roads.vertexCount())
            .filter(roads::isInLargestPart)
            .mapToObj(roads::cell)
            .toList();
    Random random = new Random(seed);
    List<Cell> shuffled = new ArrayList<>(cells);
    Collections.shuffle(shuffled, random);
    List<GridPose> starts =
        shuffled.subList(0, robots).stream()
            .map(cell -> new GridPose(cell, Heading.EAST.turned(2 * random.nextInt(4))))
            .toList();
    return new Workload(starts, GoalSource.random(cells, random));
  }

  /**
   * Starts and goals of a file, as {@link RobotGoals} reads it.
   *
   * @param robots so many of its first ones; null: all
   * @throws picocli.CommandLine.ParameterException the file cannot be read, or has fewer
   */
  static Workload listed(
      Path file, @Nullable Integer robots, RoadGraph roads, Arguments arguments) {
    List<RobotGoals> all = RobotGoals.read(file, roads, arguments);
    int count = robots == null ? all.size() : robots;
    arguments.requireBetween("--robots", count, 1, all.size());
    List<RobotGoals> lists = all.subList(0, count);
    return new Workload(lists.stream().map(RobotGoals::start).toList(), GoalSource.ofLists(lists));
  }
}
