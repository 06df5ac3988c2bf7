package org.toqa.avoidance.fouragents;

import java.util.List;
import java.util.Optional;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

/**
 * Drives a robot to a point among known static and unknown moving obstacles: perception tells what
 * is there, and of navigation, static and dynamic avoidance the one whose utility is highest drives
 * ({@link Utilities#choose}). Reactive: nothing is planned, so a dead end may hold it for ever.
 *
 * <p>Source: Ayedi, Boujelben, Rekik 2018 (Khepera II, four agents in one robot); its equations are
 * lost in our copy and taken from what it builds on.
 */
public final class FourAgents {
  private final FourAgentsSettings settings;
  private final Perception perception;
  private final Navigation navigation;
  private final StaticAvoidance staticAvoidance;
  private final DynamicAvoidance dynamicAvoidance;

  public FourAgents(FourAgentsSettings settings) {
    this.settings = settings;
    double wheelSpeed = settings.body().wheelSpeed();
    this.perception = new Perception(settings.ring(), settings.tolerance());
    this.navigation = new Navigation(wheelSpeed, settings.arrival());
    this.staticAvoidance = new StaticAvoidance(settings);
    this.dynamicAvoidance = new DynamicAvoidance(wheelSpeed, settings.danger());
  }

  /**
   * What is kept from one step to the next.
   *
   * @param driving who drives
   * @param encounter of static avoidance, as long as something is in the way
   */
  public record State(DrivingAgent driving, Optional<Encounter> encounter) {
    /** Before the first step. */
    public static final State START = new State(DrivingAgent.NAVIGATION, Optional.empty());
  }

  /**
   * What is known at a step.
   *
   * @param robot where it is, map frame
   * @param ranges metres from the rim, one a sensor of {@link RangeRing}
   * @param target metres, map frame
   * @param known obstacles that stand
   * @param seconds since the last step
   */
  public record Input(
      Pose robot, List<Double> ranges, Vec2 target, List<StaticObstacle> known, double seconds) {}

  /** What to do, why, and what to keep. */
  public record Decision(State state, WheelVelocities wheels, Utilities utilities) {}

  /** One step. The wheels' limits are kept, their acceleration is the body's business. */
  public Decision step(State state, Input input) {
    Percept percept = perception.percept(input.ranges(), input.robot(), input.known());
    Vec2 position = input.robot().position();
    boolean isRounding = state.encounter().isPresent();
    Optional<StaticAvoidance.Threat> threat =
        staticAvoidance.threat(position, input.target(), input.known(), isRounding);
    Utilities utilities =
        new Utilities(
            Utilities.navigation(
                position.distanceTo(input.target()), settings.arrival(), settings.cruise()),
            threat.map(StaticAvoidance.Threat::utility).orElse(0.0),
            Utilities.dynamicAvoidance(percept.unknown(), settings.danger()));
    DrivingAgent driving = utilities.choose(state.driving(), settings.hysteresis());
    Optional<Encounter> kept = threat.isPresent() ? state.encounter() : Optional.empty();
    return switch (driving) {
      case NAVIGATION -> new Decision(new State(driving, kept), navigate(input), utilities);
      case DYNAMIC_AVOIDANCE ->
          new Decision(
              new State(driving, kept), dynamicAvoidance.velocities(percept.ranges()), utilities);
      case STATIC_AVOIDANCE -> goRound(kept, threat, input, utilities);
    };
  }

  private WheelVelocities navigate(Input input) {
    Vec2 seen = input.target().minus(input.robot().position()).rotated(-input.robot().theta());
    return navigation.velocities(seen.norm(), seen.angle());
  }

  private Decision goRound(
      Optional<Encounter> kept,
      Optional<StaticAvoidance.Threat> threat,
      Input input,
      Utilities utilities) {
    if (threat
        .isEmpty()) { // its utility is 0, and navigation's never: it drives for this step only
      return new Decision(new State(DrivingAgent.NAVIGATION, kept), navigate(input), utilities);
    }
    StaticAvoidance.Result result =
        staticAvoidance.drive(kept, threat.get(), input.robot(), input.target(), input.seconds());
    return new Decision(
        new State(DrivingAgent.STATIC_AVOIDANCE, Optional.of(result.encounter())),
        result.wheels(),
        utilities);
  }

  /**
   * What navigation alone would do.
   *
   * @param distance metres to the target
   * @param angle radians from the heading to the target, counter-clockwise, in (-pi, pi]
   */
  public WheelVelocities towardTarget(double distance, double angle) {
    return navigation.velocities(distance, angle);
  }

  /**
   * What dynamic avoidance alone would do.
   *
   * @param ranges metres from the rim, one a sensor of {@link RangeRing}
   */
  public WheelVelocities awayFrom(List<Double> ranges) {
    return dynamicAvoidance.velocities(ranges);
  }

  /** Rules of the navigation controller. */
  int navigationRules() {
    return navigation.ruleCount();
  }

  /** Rules of the hierarchy of dynamic avoidance. */
  public int dynamicRules() {
    return dynamicAvoidance.ruleCount();
  }
}
