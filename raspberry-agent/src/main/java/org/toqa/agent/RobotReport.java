package org.toqa.agent;

import java.util.List;
import java.util.stream.Stream;
import org.toqa.agent.chassis.ChassisReading;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.Role;
import org.toqa.link.message.AgentMessage.Speed;
import org.toqa.link.message.AgentMessage.State;

/**
 * A robot at one instant, as its messages tell it.
 *
 * @param pose map frame
 * @param segment how many segments of the drive are completed
 * @param released how many may be driven
 * @param obstacles points where something stands in its way, map frame
 */
record RobotReport(
    AgentConfig config,
    JournalEntry memory,
    ChassisReading body,
    boolean localised,
    Pose pose,
    Mode mode,
    Role role,
    int segment,
    int released,
    List<Vec2> obstacles,
    List<Fault> errors) {

  Hello hello() {
    return new Hello(
        AgentMessage.VERSION,
        config.name(),
        config.maxLoad(),
        config.limits().speed(),
        config.footprint(),
        localised,
        pose,
        mode,
        memory.task(),
        memory.phase(),
        role,
        memory.drive(),
        segment,
        released,
        memory.lastSeq(),
        memory.done());
  }

  /**
   * @param stamp milliseconds since 1970
   * @param notes what else the server is to know
   */
  State state(long stamp, List<Fault> notes) {
    return new State(
        stamp,
        localised,
        pose,
        new Speed(body.twist().vx(), body.twist().w()),
        mode,
        memory.task(),
        memory.phase(),
        role,
        memory.drive(),
        segment,
        released,
        body.battery(),
        body.ranges(),
        obstacles,
        Stream.concat(errors.stream(), notes.stream()).toList());
  }
}
