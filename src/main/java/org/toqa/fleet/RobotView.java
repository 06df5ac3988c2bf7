package org.toqa.fleet;

import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.arm.JointAngles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.ArmState;
import org.toqa.link.message.AgentMessage.CameraView;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.NetworkRoute;
import org.toqa.mission.Phase;
import org.toqa.traffic.floor.PathDeviation;
import org.toqa.traffic.floor.RemainingPath;
import org.toqa.wording.Sentence;

/**
 * A robot as readers see it.
 *
 * @param record as it is stored: its name, its floor, and what a person entered of it
 * @param path the rest of its path; {@link RemainingPath#NONE} when it is stopped
 * @param alert why a person must look at it beside its errors: it and the server do not trust each
 *     other, or it cannot reach a charging point; null: nothing is wrong
 * @param unreachable why it is not heard, and what to do; null: it is, or has not been tried yet
 */
public record RobotView(
    RobotRecord record,
    RobotCapabilities capabilities,
    RobotState state,
    Work work,
    Telemetry telemetry,
    RemainingPath path,
    @Nullable Sentence alert,
    @Nullable Sentence unreachable) {

  /** So many range sensors are shown at most. */
  private static final int MOST_RANGES = 16;

  /**
   * What a robot does, and for which task.
   *
   * @param task the task it works for, if any
   * @param phase of its task that it is in
   * @param held whether it shall hold: by a person's word, for its task, or since all are paused
   * @param charger the charging point that it charges at, drives to or waits for; null: none
   * @param driver the name of who drives it by hand; null: it drives by itself
   */
  public record Work(
      @Nullable Long task,
      Phase phase,
      boolean held,
      @Nullable String charger,
      Sentence doing,
      @Nullable String driver) {

    /** Of one that drives by itself. */
    public Work(
        @Nullable Long task, Phase phase, boolean held, @Nullable String charger, Sentence doing) {
      this(task, phase, held, charger, doing, null);
    }
  }

  /**
   * What a robot said of itself last.
   *
   * @param pose map frame, where it was when it knew that last; null while it never did, and after
   *     a person said that it does not stand there any more
   * @param battery 0 to 1; null while it was never heard of
   * @param lastSeen when that was; null: never
   */
  public record Telemetry(
      @Nullable Pose pose,
      @Nullable Double battery,
      Readings readings,
      List<Fault> errors,
      @Nullable Instant lastSeen) {

    public Telemetry {
      errors = List.copyOf(errors);
    }

    public Telemetry withBattery(double changed) {
      return new Telemetry(pose, changed, readings, errors, lastSeen);
    }

    public Telemetry withErrors(List<Fault> changed) {
      return new Telemetry(pose, battery, readings, changed, lastSeen);
    }
  }

  /**
   * What changes all the time, rounded to what a person can read: hundredths.
   *
   * @param speed metres a second, forward; null: not known
   * @param turnRate radians a second, counter-clockwise; null: not known
   * @param ranges metres, of its range sensors from right to left; empty: it has none, or they are
   *     not known
   * @param placeError metres off its place beside its leader; null: it does not follow
   * @param measuredLoad kilograms that it bears, as it measures; null: nothing, or it has no scale
   * @param arm null: it has none
   * @param camera what it sees; null: it has none, or sees nothing at all
   * @param networkRoute to the server in an ad hoc network; null: it is in none, or knows none
   * @param sideways metres a second, to the left; null: not known
   */
  public record Readings(
      @Nullable Double speed,
      @Nullable Double turnRate,
      List<Double> ranges,
      @Nullable Double placeError,
      @Nullable Double measuredLoad,
      @Nullable ArmState arm,
      @Nullable CameraView camera,
      @Nullable NetworkRoute networkRoute,
      @Nullable Double sideways) {

    /** Of a robot in no ad hoc network, which does not go sideways. */
    public Readings(
        @Nullable Double speed,
        @Nullable Double turnRate,
        List<Double> ranges,
        @Nullable Double placeError,
        @Nullable Double measuredLoad,
        @Nullable ArmState arm,
        @Nullable CameraView camera) {
      this(
          speed,
          turnRate,
          ranges,
          placeError,
          measuredLoad,
          arm,
          camera,
          null,
          speed == null ? null : 0.0);
    }

    /** Of a robot without an arm and cameras, which does not go sideways. */
    public Readings(
        @Nullable Double speed,
        @Nullable Double turnRate,
        List<Double> ranges,
        @Nullable Double placeError,
        @Nullable Double measuredLoad) {
      this(speed, turnRate, ranges, placeError, measuredLoad, null, null);
    }

    public static final Readings NONE = new Readings(null, null, List.of(), null, null);

    public Readings {
      ranges = List.copyOf(ranges);
    }

    public static Readings of(AgentMessage.State state) {
      Double error = state.placeError();
      Double load = state.measuredLoad();
      return new Readings(
          rounded(state.twist().v()),
          rounded(state.twist().w()),
          state.ranges().stream().limit(MOST_RANGES).map(Readings::rounded).toList(),
          error == null ? null : rounded(error),
          load == null ? null : rounded(load),
          rounded(state.arm()),
          state.camera(),
          rounded(state.networkRoute()),
          rounded(state.twist().u()));
    }

    private static @Nullable NetworkRoute rounded(@Nullable NetworkRoute route) {
      return route == null
          ? null
          : new NetworkRoute(route.nextHop(), route.metric(), rounded(route.quality()));
    }

    /** Metres a second in whatever direction it goes, below 0 backward; null: not known. */
    public @Nullable Double actualSpeed() {
      return speed == null || sideways == null || sideways == 0
          ? speed
          : Double.valueOf(Math.hypot(speed, sideways));
    }

    private static @Nullable ArmState rounded(@Nullable ArmState arm) {
      if (arm == null) {
        return null;
      }
      Double load = arm.load();
      return new ArmState(
          new JointAngles(rounded(arm.joints().shoulder()), rounded(arm.joints().elbow())),
          load == null ? null : rounded(load),
          arm.act(),
          arm.step());
    }

    private static double rounded(double value) {
      return Math.round(100 * value) / 100.0;
    }
  }

  public String name() {
    return record.name();
  }

  public String floor() {
    return record.floor();
  }

  /** Why its own hardware has stopped it, until a person clears that. */
  public List<Fault> stops() {
    return telemetry.errors().stream().filter(Fault::clearable).toList();
  }

  /** Metres a second at which it drives straight on. */
  public double speed() {
    return capabilities.speeds().forward();
  }

  /** The rest of its path as a line, metres, map frame; empty when it is stopped. */
  public List<Vec2> pathPoints() {
    return path.points();
  }

  /** How many of {@link #pathPoints} it may already drive to. */
  public int releasedPoints() {
    return path.released();
  }

  /**
   * Metres that it is to the left of its path, below 0 to the right; null while it has none that it
   * may drive.
   */
  public @Nullable Double crossTrack() {
    PathDeviation deviation = path.deviation();
    return deviation == null ? null : deviation.crossTrack();
  }

  /** Radians that it faces further counter-clockwise than its path; null likewise. */
  public @Nullable Double headingError() {
    PathDeviation deviation = path.deviation();
    return deviation == null ? null : deviation.heading();
  }

  /** Whether it is known what it can carry: it was connected once, or is the server's own. */
  public boolean isLoadKnown() {
    return record.simulated() || capabilities.isLoadKnown();
  }

  /** Kilograms that it may carry. */
  public double maxLoad() {
    return capabilities.allowedLoad(record);
  }

  public RobotView withRecord(RobotRecord changed) {
    return new RobotView(changed, capabilities, state, work, telemetry, path, alert, unreachable);
  }

  public RobotView withCapabilities(RobotCapabilities changed) {
    return new RobotView(record, changed, state, work, telemetry, path, alert, unreachable);
  }

  public RobotView withWork(Work changed) {
    return new RobotView(record, capabilities, state, changed, telemetry, path, alert, unreachable);
  }

  public RobotView withTelemetry(Telemetry changed) {
    return new RobotView(record, capabilities, state, work, changed, path, alert, unreachable);
  }

  public RobotView withPath(RemainingPath changed) {
    return new RobotView(record, capabilities, state, work, telemetry, changed, alert, unreachable);
  }

  public RobotView withUnreachable(@Nullable Sentence changed) {
    return new RobotView(record, capabilities, state, work, telemetry, path, alert, changed);
  }

  public RobotView withAlert(@Nullable Sentence changed) {
    return new RobotView(record, capabilities, state, work, telemetry, path, changed, unreachable);
  }
}
