package org.toqa.fleet.floor;

import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.toqa.allocation.PathLengths;
import org.toqa.fleet.ChargeRecord.Turn;
import org.toqa.fleet.ChargingRules;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Place;

/** Who charges where, who comes next, and when: an estimate from paths and batteries. */
final class ChargingQueues {
  /** What a robot that nobody can move is taken to keep a charging point for. */
  private static final double BLOCKED_SECONDS = 3600;

  /** Assumed of a robot that has not said what its battery has. */
  private static final double UNKNOWN_BATTERY = 0.5;

  /** Of five percent each. */
  private static final int BATTERY_STEPS = 20;

  private final FloorState state;
  private final ChargingRules rules;
  private final PathLengths distances;

  /**
   * @param seconds until the robot can begin to charge there
   */
  record Choice(Place point, double seconds) {}

  ChargingQueues(FloorState state, ChargingRules rules) {
    this.state = state;
    this.rules = rules;
    this.distances =
        new FloorDistances(state.floor.grid())
            .withoutWaiting(state.runtime.boundedExecutor("distances-" + state.floor.name(), 1));
  }

  /**
   * The point at which the robot can charge soonest; one that does not charge only where there is
   * no other. Empty where it reaches no charging point.
   */
  Optional<Choice> soonest(FloorRobot robot) {
    return soonest(robot, point -> !state.chargers.isFaulty(point))
        .or(() -> soonest(robot, state.chargers::isFaulty));
  }

  private Optional<Choice> soonest(FloorRobot robot, Predicate<Place> isMeant) {
    return state.floor.charging().stream()
        .filter(isMeant)
        .map(point -> new Choice(point, secondsUntilCharging(robot, point)))
        .filter(choice -> Double.isFinite(choice.seconds()))
        .min(Comparator.comparingDouble(Choice::seconds));
  }

  /** Until the robot can begin to charge there, after those that come before it. */
  double secondsUntilCharging(FloorRobot robot, Place point) {
    double free = isBlocked(point, robot) ? BLOCKED_SECONDS : 0;
    for (FloorRobot other : robotsAhead(robot, point)) {
      free = Math.max(free, driveSeconds(other, point)) + chargeSeconds(other);
    }
    return Math.max(free, driveSeconds(robot, point));
  }

  /** The robots that come before it at the point, the first one first. */
  List<FloorRobot> robotsAhead(FloorRobot robot, Place point) {
    return queue(point).takeWhile(other -> other != robot).toList();
  }

  /** Whether another one waits for the point that the robot is at, and could come. */
  boolean isAwaitedByOthers(FloorRobot robot, Place point) {
    return queue(point)
        .anyMatch(other -> other != robot && !isAt(other, point) && !isKeptAway(other, point));
  }

  /**
   * Who has begun stays, also while it makes room for another and may come back; then who stands
   * there, as after a restart, and does not just come by; then who is nearest to empty, and of
   * those alike who came first. Those that a person keeps away come after all others.
   */
  private Stream<FloorRobot> queue(Place point) {
    return state.robots.values().stream()
        .filter(other -> hasTurnAt(other, point) && (other.isFit() || isAt(other, point)))
        .sorted(
            Comparator.comparing((FloorRobot r) -> isKeptAway(r, point))
                .thenComparing(r -> !r.charging.hasBegun())
                .thenComparing(r -> !isAt(r, point) || isGoingElsewhere(r, point))
                .thenComparing(ChargingQueues::batteryStep)
                .thenComparing(r -> r.charging.turn().map(Turn::since).orElseThrow())
                .thenComparing(FloorRobot::name));
  }

  /** Whether it is on hold, or driven by hand, elsewhere. */
  private boolean isKeptAway(FloorRobot robot, Place point) {
    return (robot.hold.isHeld() || robot.manual.isActive()) && !isAt(robot, point);
  }

  private static boolean isGoingElsewhere(FloorRobot robot, Place point) {
    DriveGoal goal = robot.drive.goal();
    return goal != null && !goal.goal().equals(point.position());
  }

  /** Batteries that differ by less are alike, so that two do not change places all the time. */
  private static long batteryStep(FloorRobot robot) {
    double battery = Objects.requireNonNullElse(robot.reported.battery(), UNKNOWN_BATTERY);
    return Math.round(battery * BATTERY_STEPS);
  }

  private static boolean hasTurnAt(FloorRobot robot, Place point) {
    return robot.charging.turn().filter(turn -> turn.point().equals(point.name())).isPresent();
  }

  boolean isAt(FloorRobot robot, Place point) {
    return state.isAt(robot, point.position());
  }

  private boolean isBlocked(Place point, FloorRobot robot) {
    return state.robots.values().stream()
        .anyMatch(other -> other != robot && !other.isFit() && isAt(other, point));
  }

  private double driveSeconds(FloorRobot robot, Place point) {
    return isAt(robot, point)
        ? 0
        : metres(robot, point.position()) / robot.reported.capabilities().speeds().forward();
  }

  /** Of a robot for which another waits. */
  private double chargeSeconds(FloorRobot robot) {
    double battery = Objects.requireNonNullElse(robot.reported.battery(), UNKNOWN_BATTERY);
    return Math.max(0, rules.untilWhileOthersWait() - battery) * rules.toFull().toSeconds();
  }

  private double metres(FloorRobot robot, Vec2 place) {
    Pose pose = robot.reported.pose();
    return pose == null ? Double.POSITIVE_INFINITY : metres(robot, pose.position(), place);
  }

  /**
   * The length of a robot's path, metres, between places in the map frame; infinite without one.
   */
  double metres(FloorRobot robot, Vec2 from, Vec2 to) {
    return distances.lengthsTo(to, robot.reported.footprint()).applyAsDouble(from);
  }

  /** From a place to the charging point nearest to it. */
  double metresToCharger(FloorRobot robot, Vec2 place) {
    return state.floor.charging().stream()
        .mapToDouble(point -> metres(robot, place, point.position()))
        .min()
        .orElse(Double.POSITIVE_INFINITY);
  }
}
