package org.toqa.fleet.floor;

import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.LastPlace;
import org.toqa.fleet.RobotCapabilities;
import org.toqa.fleet.robot.RobotEvent.CommandRejected;
import org.toqa.geometry.Pose;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.motion.DriveSpeeds;
import org.toqa.wording.Sentence;

/** What a robot has said of itself. Only {@link RobotEventHandler} changes it. */
final class ReportedState {
  private Contact contact;
  private LastReport report = LastReport.NONE;
  private RobotCapabilities capabilities = RobotCapabilities.UNKNOWN;
  private @Nullable Sentence alert;
  private @Nullable Sentence unreachable;
  private @Nullable CommandRejected rejectedChange;
  private Instant refusalNotedAt = Instant.MIN;
  private boolean carried;

  /**
   * @param now since when it is not heard
   */
  ReportedState(Instant now) {
    contact = new Contact.Disconnected(now);
  }

  Contact contact() {
    return contact;
  }

  boolean isHeard() {
    return contact instanceof Contact.Heard;
  }

  boolean isConnected() {
    return contact.isConnected();
  }

  LastReport report() {
    return report;
  }

  /** Map frame, where it was when it knew that last; null while nobody knows that. */
  @Nullable Pose pose() {
    return report.pose();
  }

  /** 0 to 1; null while it has not said it. */
  @Nullable Double battery() {
    return report.battery();
  }

  Mode mode() {
    return report.mode();
  }

  boolean isMoving() {
    return report.moving();
  }

  /** The number of the drive that it has, 0 without one. */
  long drive() {
    return report.drive();
  }

  RobotCapabilities capabilities() {
    return capabilities;
  }

  /** Its diameter, metres. */
  double footprint() {
    return capabilities.footprint();
  }

  /** Why it and the server do not trust each other; null: they do, or never met. */
  @Nullable Sentence alert() {
    return alert;
  }

  /** Why it is not heard, and what to do; null: it is, or nothing is known yet. */
  @Nullable Sentence unreachable() {
    return unreachable;
  }

  /** When the history was last told whom it did not let in. */
  Instant refusalNotedAt() {
    return refusalNotedAt;
  }

  /** Whether the place that it says is of the floor that it was carried away from. */
  boolean isCarried() {
    return carried;
  }

  void setCarried(boolean isSo) {
    carried = isSo;
  }

  void connected(Hello hello, Instant now) {
    contact = new Contact.Heard();
    report = report.with(hello, hello.localised() && !carried, now);
    capabilities =
        new RobotCapabilities(
            hello.footprint(),
            DriveSpeeds.DEFAULT.atMost(hello.maxSpeed(), hello.maxTurnRate()),
            hello.maxLoad(),
            hello.sensorRange(),
            hello.driveKind(),
            Math.clamp(hello.track(), 0, hello.footprint()),
            hello.arm(),
            hello.freeZones(),
            hello.shifts());
    alert = null;
    unreachable = null;
    rejectedChange = null;
  }

  /** Where it was when it was heard last, before this server began. */
  void recover(LastPlace place) {
    report = report.withPose(place.pose());
    capabilities = capabilities.withFootprint(place.diameter());
  }

  /**
   * @param maxLoad kilograms that it said it carries, before this server began
   */
  void recover(double maxLoad) {
    capabilities = capabilities.withMaxLoad(maxLoad);
  }

  void setReport(AgentMessage.State state, Instant now) {
    setHeardAgain();
    report = report.with(state, state.localised() && !carried, now);
  }

  void setHeardAgain() {
    contact = contact.heardAgain();
    unreachable = isHeard() ? null : unreachable;
  }

  /**
   * @param why what is wrong with what it says instead; null: it says nothing
   * @param now of the time that ticks bring
   */
  void setSilent(@Nullable Sentence why, Instant now) {
    contact = contact.fallenSilent(now);
    unreachable = why == null ? unreachable : why;
  }

  /**
   * @param now of the time that ticks bring
   */
  void setDisconnected(Sentence why, Instant now) {
    contact = contact.disconnected(now);
    unreachable = why;
  }

  /** It has taken this drive, though no report tells of it yet. */
  void setDrive(long drive, @Nullable Long task) {
    report = report.withDrive(drive, task);
  }

  /** A person has said that it is not there any more. */
  void forgetPose() {
    report = report.withPose(null);
  }

  void setAlert(@Nullable Sentence why) {
    alert = why;
  }

  void setRefusalNotedAt(Instant at) {
    refusalNotedAt = at;
  }

  /** A change of its drive was refused; its next report tells whether it still drives that. */
  void setRejectedChange(CommandRejected rejection) {
    rejectedChange = rejection;
  }

  @Nullable CommandRejected takeRejectedChange() {
    CommandRejected taken = rejectedChange;
    rejectedChange = null;
    return taken;
  }
}
