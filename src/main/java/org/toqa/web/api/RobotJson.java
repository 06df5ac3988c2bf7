package org.toqa.web.api;

import java.time.Instant;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.toqa.arm.Arm;
import org.toqa.arm.ArmStep;
import org.toqa.arm.JointAngles;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.ArmState;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.NetworkRoute;
import org.toqa.wording.Sentence;

/** A robot on the wire; flat, its path as it is drawn. */
public record RobotJson(
    String name,
    String floor,
    RobotState state,
    @Nullable Pose pose,
    @Nullable Double battery,
    @Nullable Long task,
    int phase,
    double maxLoad,
    double footprint,
    double speed,
    String host,
    int port,
    @Nullable String parking,
    boolean simulated,
    List<Vec2> route,
    int released,
    List<Fault> errors,
    Sentence doing,
    @Nullable Instant lastSeen,
    boolean held,
    @Nullable String charger,
    @Nullable String fingerprint,
    @Nullable Sentence alert,
    @Nullable String gateway,
    @Nullable Sentence unreachable,
    @Nullable TwistJson twist,
    List<Double> ranges,
    @Nullable Double placeError,
    @Nullable Double measuredLoad,
    @Nullable ArmJson arm,
    double sensorRange,
    @Nullable Double toldLoad,
    String link,
    String kind,
    double track,
    @Nullable DeviationJson deviation,
    @Nullable String driver,
    @Nullable NetworkRoute networkRoute) {

  /** Metres a second forward, radians a second counter-clockwise, metres a second to the left. */
  private record TwistJson(double v, double w, double u) {
    static @Nullable TwistJson of(RobotView.Readings readings) {
      Double v = readings.speed();
      Double w = readings.turnRate();
      Double u = readings.sideways();
      return v == null || w == null ? null : new TwistJson(v, w, u == null ? 0 : u);
    }
  }

  /** Metres to the left of its path, radians counter-clockwise; to be read, so rounded. */
  private record DeviationJson(double crossTrack, double heading) {
    static @Nullable DeviationJson of(RobotView view) {
      Double crossTrack = view.crossTrack();
      Double heading = view.headingError();
      return crossTrack == null || heading == null
          ? null
          : new DeviationJson(rounded(crossTrack), rounded(heading));
    }

    private static double rounded(double value) {
      return Math.round(1000 * value) / 1000.0;
    }
  }

  /**
   * An arm of two links: metres, kilograms, radians.
   *
   * @param base its shoulder, in the robot's frame
   * @param joints null: not known now
   * @param load in its hand; null: nothing
   * @param step of what it does; null: it does nothing
   */
  private record ArmJson(
      double upperLink,
      double foreLink,
      Pose base,
      double maxLoad,
      @Nullable JointAngles joints,
      @Nullable Double load,
      @Nullable ArmStep step) {
    static @Nullable ArmJson of(RobotView view) {
      Arm arm = view.capabilities().arm();
      ArmState now = view.telemetry().readings().arm();
      return arm == null
          ? null
          : new ArmJson(
              arm.upperLink(),
              arm.foreLink(),
              arm.base(),
              arm.maxLoad(),
              now == null ? null : now.joints(),
              now == null ? null : now.load(),
              now == null ? null : now.step());
    }
  }

  public static RobotJson of(RobotView view) {
    RobotRecord stored = view.record();
    RobotView.Work work = view.work();
    RobotView.Telemetry seen = view.telemetry();
    SimplifiedPath path = SimplifiedPath.of(view.pathPoints(), view.releasedPoints());
    return new RobotJson(
        view.name(),
        view.floor(),
        view.state(),
        seen.pose(),
        seen.battery(),
        work.task(),
        work.phase().number(),
        view.maxLoad(),
        view.capabilities().footprint(),
        view.speed(),
        stored.host(),
        stored.port(),
        stored.parking(),
        stored.simulated(),
        path.points(),
        path.released(),
        seen.errors(),
        work.doing(),
        seen.lastSeen(),
        work.held(),
        work.charger(),
        Objects.toString(stored.fingerprint(), null),
        view.alert(),
        stored.gateway(),
        view.unreachable(),
        TwistJson.of(seen.readings()),
        seen.readings().ranges(),
        seen.readings().placeError(),
        seen.readings().measuredLoad(),
        ArmJson.of(view),
        view.capabilities().sensorRange(),
        view.capabilities().isLoadKnown() ? view.capabilities().maxLoad() : null,
        stored.isHttp() ? "http" : "toqa",
        view.capabilities().kindWord(),
        view.capabilities().track(),
        DeviationJson.of(view),
        work.driver(),
        seen.readings().networkRoute());
  }
}
