package org.toqa.traffic.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.function.DoubleFunction;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.grid.Cell;
import org.toqa.planning.Heading;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.GridPose;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.lifelong.LifelongPlan;
import org.toqa.traffic.lifelong.LifelongPlanner;
import org.toqa.traffic.lifelong.PlannedRobot;
import org.toqa.traffic.lifelong.TrafficSnapshot;

/**
 * Plans the next steps of many robots on lane cells from where their released paths end, and again
 * as they drive on. It remembers who has waited for how long and who goes round what, as long as
 * the lanes are the same.
 */
final class NextStepsPlanner {
  private static final int MOST_STEPS = 5;

  /** So many steps of a plan are left to a robot on its way to where it begins, and more. */
  private static final int MOST_DELAY = 2;

  /** Steps of a head start over all that have not stood so long. */
  private static final int FIRST = 1_000_000;

  private final DoubleFunction<LifelongPlanner> planners;
  private @Nullable LaneGrid lanes;
  private @Nullable LifelongPlanner planner;
  private Instant lastStep = Instant.MIN;

  /**
   * @param planners a planner of robots that keep apart so many cells
   */
  NextStepsPlanner(DoubleFunction<LifelongPlanner> planners) {
    this.planners = planners;
  }

  /**
   * @param roads all lane cells that could be driven if no robot were on the floor
   * @param open those that can be driven now
   * @param starts by robot: its lane cell, all different
   * @param goals by robot: a lane cell
   * @param leftOnly lane cells that nobody enters, but for those in one of them; bits by index
   * @return the vertices of all robots after each step, the starts first
   */
  List<int[]> plan(
      LaneGrid laneGrid,
      RoadGraph roads,
      RoadGraph open,
      List<TrafficRobot> robots,
      List<Cell> starts,
      List<Cell> goals,
      BitSet leftOnly,
      Instant now,
      Deadline deadline) {
    LifelongPlanner lifelong = planner;
    double step = stepSeconds(laneGrid, robots);
    if (lifelong == null || lanes != laneGrid) {
      lifelong = planners.apply(laneGrid.apart());
      planner = lifelong;
      lanes = laneGrid;
      lastStep = now;
    }
    List<PlannedRobot> planned =
        IntStream.range(0, robots.size())
            .mapToObj(i -> planned(robots.get(i), starts.get(i), goals.get(i), step, now))
            .toList();
    BitSet closed = closed(roads, open, leftOnly);
    LifelongPlan plan =
        lifelong.plan(new TrafficSnapshot(roads, planned, closed, takeSteps(step, now)), deadline);
    return steps(roads, plan, robots.size());
  }

  /** What a step to the next cell takes. */
  private static double stepSeconds(LaneGrid laneGrid, List<TrafficRobot> robots) {
    double speed =
        robots.stream().mapToDouble(robot -> robot.speeds().forward()).max().orElseThrow();
    return laneGrid.lattice().resolution() / speed;
  }

  /** How many steps have passed since this was last asked. */
  private int takeSteps(double step, Instant now) {
    long nanos = Math.round(step * Duration.ofSeconds(1).toNanos());
    long passed = Duration.between(lastStep, now).toNanos() / nanos;
    lastStep = passed > MOST_STEPS ? now : lastStep.plusNanos(passed * nanos);
    return (int) Math.min(MOST_STEPS, passed);
  }

  private static PlannedRobot planned(
      TrafficRobot robot, Cell start, Cell goal, double step, Instant now) {
    Pose end = robot.committedEnd();
    Instant since = robot.waiting.since();
    double waited = since == null ? 0 : Duration.between(since, now).toMillis() / 1000.0;
    boolean isFirst = RightOfWay.isWaitingLong(robot, now);
    return new PlannedRobot(
        robot.name,
        new GridPose(start, Heading.nearest(end.theta())),
        goal,
        (int) (waited / step) + (isFirst ? FIRST : 0),
        false,
        (int) Math.min(MOST_DELAY, Math.round(secondsUntilThere(robot) / step)));
  }

  /** Seconds at the planned speed until it is where it is planned from. */
  private static double secondsUntilThere(TrafficRobot robot) {
    Drive drive = robot.drive;
    ReservedPath path = drive.path();
    return path == null
        ? 0
        : Allocation.secondsAhead(robot)
            + path.sections().subList(drive.released(), drive.committed()).stream()
                .mapToDouble(Section::duration)
                .sum();
  }

  /** The edges that can be driven at times, but not now. */
  private static BitSet closed(RoadGraph roads, RoadGraph open, BitSet leftOnly) {
    BitSet closed = new BitSet();
    for (int vertex = 0; vertex < roads.vertexCount(); vertex++) {
      int now = open.vertex(roads.columnOf(vertex), roads.rowOf(vertex));
      for (int d = 0; d < RoadGraph.DIRECTIONS; d++) {
        int next = now == RoadGraph.NONE ? RoadGraph.NONE : open.neighbour(now, d);
        boolean isOpen =
            next != RoadGraph.NONE
                && (!isAmong(open, next, leftOnly) || isAmong(open, now, leftOnly));
        closed.set(
            vertex * RoadGraph.DIRECTIONS + d,
            !isOpen && roads.neighbour(vertex, d) != RoadGraph.NONE);
      }
    }
    return closed;
  }

  private static boolean isAmong(RoadGraph roads, int vertex, BitSet cells) {
    return cells.get(roads.grid().index(roads.cell(vertex)));
  }

  private static List<int[]> steps(RoadGraph roads, LifelongPlan plan, int robots) {
    List<int[]> steps = new ArrayList<>();
    int longest = IntStream.range(0, robots).map(i -> plan.path(i).poses().size()).max().orElse(1);
    for (int step = 0; step < longest; step++) {
      int[] places = new int[robots];
      for (int robot = 0; robot < robots; robot++) {
        List<GridPose> poses = plan.path(robot).poses();
        places[robot] = roads.vertex(poses.get(Math.min(step, poses.size() - 1)).cell());
      }
      steps.add(places);
    }
    return steps;
  }
}
