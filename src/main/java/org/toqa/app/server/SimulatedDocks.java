package org.toqa.app.server;

import java.time.Duration;
import java.util.Optional;
import java.util.stream.Stream;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.manager.AgentFleet;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.grid.Place;
import org.toqa.sim.SimulatedFleet;

/**
 * The docks of a simulated floor: one at every parking and charging point, which measures the true
 * pose of a robot that stands there and tells the fleet, as a dock on a real floor does by the API.
 * Without them the error of odometry would grow without limit.
 */
final class SimulatedDocks {
  static final Duration PERIOD = Duration.ofSeconds(1);

  private static final Logger log = LoggerFactory.getLogger(SimulatedDocks.class);

  /** How far from its point a dock detects a robot, metres. */
  private static final double SENSOR_RANGE = 0.5;

  /** Metres and radians; a smaller difference is not told. */
  private static final double MIN_DRIFT = 0.01;

  private final SimulatedFleet robots;
  private final AgentFleet fleet;

  SimulatedDocks(SimulatedFleet robots, AgentFleet fleet) {
    this.robots = robots;
    this.fleet = fleet;
  }

  /** Tells the fleet the true pose of each robot at a dock that has drifted. */
  void locateStandingRobots() {
    for (RobotView robot : fleet.snapshots().latest().robots()) {
      if (robot.state() == RobotState.IDLE || robot.state() == RobotState.CHARGING) {
        robots.truePose(robot.name()).ifPresent(truth -> locateIfDrifted(robot, truth));
      }
    }
  }

  private void locateIfDrifted(RobotView robot, Pose truth) {
    Pose believed = robot.telemetry().pose();
    Optional<Place> dock =
        docks(robot.floor())
            .filter(d -> d.position().distanceTo(truth.position()) < SENSOR_RANGE)
            .findFirst();
    if (believed == null || dock.isEmpty() || !hasDrifted(believed, truth)) {
      return;
    }
    fleet
        .locateRobot(robot.name(), truth, "The dock " + dock.get().name())
        .whenComplete((answer, failure) -> log.debug("{}: {}", robot.name(), answer, failure));
  }

  private Stream<Place> docks(String floor) {
    return fleet.floors().stream()
        .filter(map -> map.name().equals(floor))
        .flatMap(map -> Stream.concat(map.parking().stream(), map.charging().stream()));
  }

  private static boolean hasDrifted(Pose believed, Pose truth) {
    return believed.distanceTo(truth) > MIN_DRIFT
        || Math.abs(Angles.difference(believed.theta(), truth.theta())) > MIN_DRIFT;
  }
}
