package org.toqa.link;

import java.util.Optional;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.CameraView;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.NetworkRoute;
import org.toqa.link.message.AgentMessage.Speed;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Which figures of a robot cannot be true, so that nothing is believed of such a message. */
final class RobotFigures {
  /** A robot's sensors see at most so far, metres. */
  private static final double MAX_SENSOR_RANGE = 30;

  /** From the map's origin, metres. */
  private static final double MAX_COORDINATE = 100_000;

  /**
   * Metres a second that a robot says that it can drive: as much as our daemon's file and one over
   * HTTP may say, of whose wheels a fifth is kept.
   */
  private static final double LEAST_SPEED = 0.008;

  private static final double MOST_SPEED = 5;

  /** Radians a second, of the same, with wheels 5 m apart. */
  private static final double LEAST_TURN_RATE = 0.003;

  private static final double MOST_TURN_RATE = 20;

  /** How fast one can be said to be, metres a second, radians a second. */
  private static final double MAX_TWIST = 100;

  /** Kilograms on board. */
  private static final double MAX_LOAD = 10_000;

  /** Metres, diameter. */
  private static final double NARROWEST = 0.05;

  /** Metres that cameras see. */
  private static final double MAX_VIEW = 1_000;

  private static final int MAX_BOXES = 200;

  /** Characters of an address in a network. */
  private static final int MAX_ADDRESS = 64;

  private static final int MAX_METRIC = 65_535;

  private RobotFigures() {}

  /**
   * What is wrong with the capabilities that a robot tells, with all of them.
   *
   * @param widestRobot diameter that a robot has at most, metres
   */
  static Optional<Sentence> objection(Hello hello, double widestRobot) {
    if (hello.footprint() > widestRobot) {
      return Optional.of(Phrase.IS_TOO_WIDE.with(hello.robot(), hello.footprint(), widestRobot));
    }
    boolean isPossible =
        isFrom(0, hello.maxLoad(), MAX_LOAD)
            && isFrom(LEAST_SPEED, hello.maxSpeed(), MOST_SPEED)
            && isFrom(LEAST_TURN_RATE, hello.maxTurnRate(), MOST_TURN_RATE)
            && hello.footprint() >= NARROWEST
            && isFrom(0, hello.sensorRange(), MAX_SENSOR_RANGE);
    return isPossible
        ? Optional.empty()
        : Optional.of(
            Phrase.CANNOT_BE_TRUE.with(
                hello.robot(),
                hello.maxLoad(),
                hello.maxSpeed(),
                hello.maxTurnRate(),
                hello.footprint(),
                hello.sensorRange()));
  }

  private static boolean isFrom(double least, double value, double most) {
    return value >= least && value <= most;
  }

  /**
   * What is wrong with a message.
   *
   * @return a sentence
   */
  static Optional<String> objection(AgentMessage message) {
    return switch (message) {
      case Hello hello when !isOnEarth(hello.pose()) -> Optional.of(farAway("pose", "hello"));
      case State state -> objection(state);
      default -> Optional.empty();
    };
  }

  private static Optional<String> objection(State state) {
    if (!isOnEarth(state.pose())) {
      return Optional.of(farAway("pose", "state"));
    }
    if (!state.obstacles().stream().allMatch(RobotFigures::isOnEarth)) {
      return Optional.of(farAway("obstacle", "state"));
    }
    if (!(state.battery() >= 0 && state.battery() <= 1)) {
      return Optional.of("The battery of the state is not from 0 to 1.");
    }
    Speed twist = state.twist();
    if (Math.max(Math.hypot(twist.v(), twist.u()), Math.abs(twist.w())) > MAX_TWIST) {
      return Optional.of("The twist of the state is faster than any robot.");
    }
    if (!state.ranges().stream().allMatch(range -> range >= 0)) {
      return Optional.of("A range of the state is less than 0.");
    }
    CameraView camera = state.camera();
    if (camera != null && !isSane(camera)) {
      return Optional.of(
          "The camera of the state has a range that is not from 0 to 1,000 m, more than 200 boxes,"
              + " or one without a number or far away.");
    }
    NetworkRoute route = state.networkRoute();
    if (route != null && !isSane(route)) {
      return Optional.of(
          "The networkRoute of the state has a nextHop of more than 64 characters, a metric that is"
              + " not from 0 to 65,535, or a quality that is not from 0 to 1.");
    }
    Double placeError = state.placeError();
    if (placeError != null && !(placeError >= 0)) {
      return Optional.of("The placeError of the state is less than 0.");
    }
    Double load = state.measuredLoad();
    return load == null || (load >= 0 && load <= MAX_LOAD)
        ? Optional.empty()
        : Optional.of("The measuredLoad of the state is not from 0 to 10,000 kg.");
  }

  private static boolean isSane(CameraView camera) {
    return camera.range() >= 0
        && camera.range() <= MAX_VIEW
        && camera.boxes().size() <= MAX_BOXES
        && camera.boxes().stream().allMatch(seen -> seen.box() > 0 && isOnEarth(seen.place()));
  }

  private static boolean isSane(NetworkRoute route) {
    return route.nextHop().length() <= MAX_ADDRESS
        && route.metric() >= 0
        && route.metric() <= MAX_METRIC
        && route.quality() >= 0
        && route.quality() <= 1;
  }

  private static String farAway(String what, String message) {
    return "The %s of the %s is more than 100 km from the map's origin.".formatted(what, message);
  }

  private static boolean isOnEarth(Pose pose) {
    return isOnEarth(pose.position());
  }

  private static boolean isOnEarth(Vec2 point) {
    return Math.max(Math.abs(point.x()), Math.abs(point.y())) <= MAX_COORDINATE;
  }
}
