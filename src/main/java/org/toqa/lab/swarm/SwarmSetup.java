package org.toqa.lab.swarm;

import java.util.ArrayList;
import java.util.List;
import org.toqa.formation.swarm.ShapeKeeping;
import org.toqa.geometry.Vec2;
import org.toqa.lab.experiment.Parameter;
import org.toqa.lab.experiment.Run;

/**
 * What the paper leaves open, and what it leaves out.
 *
 * @param robotRadius metres
 * @param lidarRange metres from the robot's middle
 * @param outward radians that the side lidars look outward
 * @param view radians that a lidar sees to either side of where it looks
 * @param apart metres between neighbours in the shape: whole squares of the maps
 * @param targetRadius metres from the target within which the leader is there
 * @param delay steps by which what the observers see is late
 * @param rangeNoise standard deviation of ranges, a share
 * @param actuatorNoise standard deviation of each step of a robot in both directions, a share of it
 * @param isChanging whether an obstacle appears on the way
 * @param keeping how each robot keeps its place
 * @param hasMemory whether loops are left by memory
 */
record SwarmSetup(
    double robotRadius,
    double lidarRange,
    double outward,
    double view,
    double apart,
    double targetRadius,
    int delay,
    double rangeNoise,
    double actuatorNoise,
    boolean isChanging,
    ShapeKeeping keeping,
    boolean hasMemory) {

  /** Robots in a row of the square that they form; nine as published. */
  private static final int ROW = 3;

  /** An obstacle that is there as soon as the leader is beyond this, metres from the left. */
  static final double CHANGE_AT = 840;

  private static final Vec2 CHANGE_LEAST = new Vec2(1120, 520);
  private static final Vec2 CHANGE_MOST = new Vec2(1160, 680);

  static final Parameter LIDAR_RANGE =
      new Parameter("lidar-range", 120, 20, 500, "m", "how far a lidar sees");

  static final Parameter ROBOT_RADIUS =
      new Parameter("robot-radius", 6, 1, 19, "m", "half a robot's width");

  static final Parameter OUTWARD =
      new Parameter("outward", 20, 0, 60, "degrees", "that the side lidars look outward");

  static final Parameter VIEW =
      new Parameter(
          "view", 30, 0, 90, "degrees", "that a lidar sees to either side of where it looks");

  static final Parameter APART =
      new Parameter("apart", 40, 40, 100, "m", "between neighbours in the shape; twenties");

  static final Parameter TARGET_RADIUS =
      new Parameter("target-radius", 60, 5, 160, "m", "from the target that counts as there");

  static final List<Parameter> PARAMETERS =
      List.of(LIDAR_RANGE, ROBOT_RADIUS, OUTWARD, VIEW, APART, TARGET_RADIUS);

  /** As published, with the run's values for what is not. */
  static SwarmSetup of(Run run) {
    return new SwarmSetup(
        run.value(ROBOT_RADIUS),
        run.value(LIDAR_RANGE),
        Math.toRadians(run.value(OUTWARD)),
        Math.toRadians(run.value(VIEW)),
        SwarmMap.CELL * Math.rint(run.value(APART) / SwarmMap.CELL),
        run.value(TARGET_RADIUS),
        0,
        0,
        0,
        false,
        ShapeKeeping.NONE,
        false);
  }

  /** The same with what the paper names as its limits. */
  SwarmSetup under(int steps, double ranges, double actuators, boolean change) {
    return new SwarmSetup(
        robotRadius,
        lidarRange,
        outward,
        view,
        apart,
        targetRadius,
        steps,
        ranges,
        actuators,
        change,
        keeping,
        hasMemory);
  }

  /** The same with robots that drive back to their places, clear of what is near them. */
  SwarmSetup keepingShape() {
    return led(new ShapeKeeping(0.2, 0.5, 2 * robotRadius), hasMemory);
  }

  /** The same with loops that are left by memory. */
  SwarmSetup remembering() {
    return led(keeping, true);
  }

  private SwarmSetup led(ShapeKeeping shape, boolean byMemory) {
    return new SwarmSetup(
        robotRadius,
        lidarRange,
        outward,
        view,
        apart,
        targetRadius,
        delay,
        rangeNoise,
        actuatorNoise,
        isChanging,
        shape,
        byMemory);
  }

  /** The robots' places from the leader: a square. */
  List<Vec2> places() {
    List<Vec2> places = new ArrayList<>();
    for (int i = 0; i < ROW * ROW; i++) {
      places.add(new Vec2((i / ROW - 1) * apart, (i % ROW - 1) * apart));
    }
    return places;
  }

  /** The map as it is once the leader was beyond {@link #CHANGE_AT}. */
  SwarmMap changed(SwarmMap map) {
    return isChanging ? map.with(CHANGE_LEAST, CHANGE_MOST) : map;
  }
}
