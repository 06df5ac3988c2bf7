package org.toqa.fleet;

import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.mission.Phase;
import org.toqa.traffic.floor.RemainingPath;
import org.toqa.wording.Sentence;

/**
 * A robot as readers see it.
 *
 * @param record as it is stored: its name, its floor, and what a person entered of it
 * @param path the rest of its path; {@link RemainingPath#NONE} when it is stopped
 * @param alert why a person must look at it beside its errors: it and the server do not trust each
 *     other, or it cannot reach a charging point; null: nothing is wrong
 */
public record RobotView(
    RobotRecord record,
    RobotCapabilities capabilities,
    RobotState state,
    Work work,
    Telemetry telemetry,
    RemainingPath path,
    @Nullable Sentence alert) {

  /**
   * What a robot does, and for which task.
   *
   * @param task the task it works for, if any
   * @param phase of its task that it is in
   * @param held whether it shall hold: by a person's word, for its task, or since all are paused
   * @param charger the charging point that it charges at, drives to or waits for; null: none
   */
  public record Work(
      @Nullable Long task, Phase phase, boolean held, @Nullable String charger, Sentence doing) {}

  /**
   * What a robot said of itself last.
   *
   * @param pose map frame; null while it was never heard of, and after a person said that it does
   *     not stand there any more
   * @param battery 0 to 1; null while it was never heard of
   * @param lastSeen when that was; null: never
   */
  public record Telemetry(
      @Nullable Pose pose,
      @Nullable Double battery,
      List<Fault> errors,
      @Nullable Instant lastSeen) {

    public Telemetry {
      errors = List.copyOf(errors);
    }

    public Telemetry withBattery(double changed) {
      return new Telemetry(pose, changed, errors, lastSeen);
    }

    public Telemetry withErrors(List<Fault> changed) {
      return new Telemetry(pose, battery, changed, lastSeen);
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

  /** Kilograms that it may carry. */
  public double maxLoad() {
    return capabilities.allowedLoad(record);
  }

  public RobotView withRecord(RobotRecord changed) {
    return new RobotView(changed, capabilities, state, work, telemetry, path, alert);
  }

  public RobotView withCapabilities(RobotCapabilities changed) {
    return new RobotView(record, changed, state, work, telemetry, path, alert);
  }

  public RobotView withWork(Work changed) {
    return new RobotView(record, capabilities, state, changed, telemetry, path, alert);
  }

  public RobotView withTelemetry(Telemetry changed) {
    return new RobotView(record, capabilities, state, work, changed, path, alert);
  }

  public RobotView withPath(RemainingPath changed) {
    return new RobotView(record, capabilities, state, work, telemetry, changed, alert);
  }

  public RobotView withAlert(@Nullable Sentence changed) {
    return new RobotView(record, capabilities, state, work, telemetry, path, changed);
  }
}
