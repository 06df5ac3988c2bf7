package org.toqa.app.bench;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.toqa.grid.Cell;
import org.toqa.statistics.Percentiles;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.GridPose;
import org.toqa.traffic.MotionModel;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.check.TrafficChecker;
import org.toqa.traffic.check.TrafficChecker.Violation;
import org.toqa.traffic.lifelong.LifelongPlan;
import org.toqa.traffic.lifelong.LifelongPlanner;
import org.toqa.traffic.lifelong.PlannedRobot;
import org.toqa.traffic.lifelong.TrafficSnapshot;

/**
 * Robots that do what a planner says, step by step, and go to their next goals as they arrive. A
 * checker that knows no planner looks at every step.
 */
final class TrafficRun {
  /** A robot that has not left its cell for so many steps, short of its goal, is stuck. */
  private static final int STUCK_STEPS = 50;

  private final RoadGraph roads;
  private final LifelongPlanner planner;
  private final TrafficChecker checker;
  private final GoalSource source;
  private final Supplier<Deadline> deadlines;
  private final StepListener listener;
  private final List<GridPose> stances;
  private final List<Cell> goals;

  /** The robots with a goal to reach. */
  private final BitSet robotsWithGoal = new BitSet();

  /** The step of each robot's last move. */
  private final int[] lastMoveSteps;

  private int goalsReached;
  private int collisions;
  private int step;

  /** Is told what happens. */
  interface StepListener {

    /**
     * The stances of all robots, step 0 first.
     *
     * @throws IOException they cannot be written
     */
    void stepTaken(List<GridPose> stances) throws IOException;

    /**
     * A rule was broken.
     *
     * @param step the one in which the robots arrived so, from 0
     */
    void violationFound(int step, Violation violation);
  }

  /**
   * @param goals how many were reached
   * @param collisions how often a rule of the traffic was broken
   * @param stuck robots that have not moved for the last 50 steps, short of their goal
   * @param p50Ms planning time of a step, median, milliseconds
   * @param p99Ms the same, 99th percentile
   * @param goalsPerStep goals reached by all robots together
   * @param steps how many were driven
   */
  record Report(
      int goals,
      int collisions,
      int stuck,
      double p50Ms,
      double p99Ms,
      double goalsPerStep,
      int steps) {}

  /**
   * @param deadlines how long each step may be planned
   */
  TrafficRun(
      RoadGraph roads,
      MotionModel model,
      LifelongPlanner planner,
      List<GridPose> starts,
      GoalSource source,
      Supplier<Deadline> deadlines,
      StepListener listener) {
    this.roads = roads;
    this.planner = planner;
    this.checker = new TrafficChecker(roads.grid(), model);
    this.source = source;
    this.deadlines = deadlines;
    this.listener = listener;
    this.stances = new ArrayList<>(starts);
    this.goals = new ArrayList<>();
    this.lastMoveSteps = new int[starts.size()];
    for (int robot = 0; robot < starts.size(); robot++) {
      goals.add(starts.get(robot).cell());
      assignNextGoal(robot);
    }
  }

  /**
   * Ends after so many steps, at the deadline, or when all robots have reached their last goals.
   *
   * @throws IOException the listener cannot write
   */
  Report run(int steps, Deadline end) throws IOException {
    double[] millis = new double[steps];
    recordViolations(checker.checkPlaces(stances));
    listener.stepTaken(stances);
    while (step < steps && !end.isPassed() && !isDone()) {
      long begin = System.nanoTime();
      LifelongPlan plan = planner.plan(scene(), deadlines.get());
      millis[step++] = (System.nanoTime() - begin) / 1e6;
      drive(plan);
      listener.stepTaken(stances);
    }
    Percentiles timings = new Percentiles(Arrays.copyOf(millis, step));
    return new Report(
        goalsReached,
        collisions,
        stuckRobots(),
        timings.percentile(0.50),
        timings.percentile(0.99),
        step == 0 ? 0 : (double) goalsReached / step,
        step);
  }

  /** Sends it to its next goal; a robot that has reached all keeps its last one. */
  private void assignNextGoal(int robot) {
    Optional<Cell> next = source.next(robot, goals.get(robot));
    robotsWithGoal.set(robot, next.isPresent());
    next.ifPresent(goal -> goals.set(robot, goal));
  }

  private boolean isDone() {
    return IntStream.range(0, goals.size()).allMatch(this::isAtGoal);
  }

  private boolean isAtGoal(int robot) {
    return stances.get(robot).cell().equals(goals.get(robot));
  }

  private TrafficSnapshot scene() {
    return new TrafficSnapshot(
        roads,
        IntStream.range(0, stances.size())
            .mapToObj(r -> new PlannedRobot("r" + r, stances.get(r), goals.get(r), 0))
            .toList());
  }

  private void drive(LifelongPlan plan) {
    List<GridPose> before = List.copyOf(stances);
    for (int robot = 0; robot < stances.size(); robot++) {
      GridPose next = plan.path(robot).at(1);
      if (!next.cell().equals(before.get(robot).cell())) {
        lastMoveSteps[robot] = step;
      }
      stances.set(robot, next);
      if (robotsWithGoal.get(robot) && isAtGoal(robot)) {
        goalsReached++;
        assignNextGoal(robot);
      }
    }
    recordViolations(checker.check(before, stances));
  }

  private void recordViolations(List<Violation> violations) {
    collisions += violations.size();
    violations.forEach(violation -> listener.violationFound(step, violation));
  }

  private int stuckRobots() {
    return (int)
        IntStream.range(0, stances.size())
            .filter(
                robot -> robotsWithGoal.get(robot) && step - lastMoveSteps[robot] >= STUCK_STEPS)
            .count();
  }
}
