package org.toqa.agent.control;

import java.util.List;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.ChassisReading;
import org.toqa.agent.config.AgentConfig;
import org.toqa.agent.config.Avoidance;
import org.toqa.agent.storage.JournalEntry;
import org.toqa.avoidance.RangeSensors;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.ArmState;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.NetworkRoute;
import org.toqa.link.message.AgentMessage.Role;
import org.toqa.link.message.AgentMessage.RoomUse;
import org.toqa.link.message.AgentMessage.Speed;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.motion.PassingRoom;

/**
 * A robot at one instant, as its messages report it.
 *
 * @param pose map frame
 * @param segment how many segments of the drive are completed
 * @param released how many may be driven
 * @param obstacles points where something blocks its path, map frame
 * @param room that it was lent beside its path; null: none
 * @param placeError metres off its place beside its leader; null: it does not follow
 * @param arm null: it has none
 */
public record RobotReport(
    AgentConfig config,
    JournalEntry entry,
    ChassisReading reading,
    boolean isLocalised,
    Pose pose,
    Mode mode,
    Role role,
    int segment,
    int released,
    List<Vec2> obstacles,
    RoomUse roomUse,
    @Nullable PassingRoom room,
    @Nullable Double placeError,
    @Nullable ArmState arm,
    List<Fault> errors) {

  public Hello hello() {
    return new Hello(
        AgentMessage.VERSION,
        config.name(),
        config.maxLoad(),
        config.limits().speed(),
        config.limits().turnRate(),
        config.footprint(),
        RangeSensors.FARTHEST,
        config.kind().word(),
        config.chassis().track(config.kind()),
        isLocalised,
        pose,
        mode,
        entry.task(),
        entry.phase(),
        role,
        entry.drive(),
        segment,
        released,
        entry.lastSeq(),
        entry.done(),
        config.arm() == null ? null : config.arm().arm(),
        arm == null ? null : arm.act(),
        entry.acted(),
        room,
        config.avoidance() == Avoidance.FOUR_AGENTS,
        config.canShift());
  }

  /**
   * @param stamp milliseconds since 1970
   * @param notes what else the server is to know
   * @param route to the server in an ad hoc network; null: none is known
   */
  public State state(long stamp, List<Fault> notes, @Nullable NetworkRoute route) {
    return new State(
        stamp,
        isLocalised,
        pose,
        Speed.of(reading.twist()),
        mode,
        entry.task(),
        entry.phase(),
        role,
        entry.drive(),
        segment,
        released,
        reading.battery(),
        reading.ranges(),
        obstacles,
        placeError,
        reading.measuredLoad(),
        arm,
        roomUse,
        reading.camera(),
        route,
        notes.isEmpty() ? errors : Stream.concat(errors.stream(), notes.stream()).toList());
  }
}
