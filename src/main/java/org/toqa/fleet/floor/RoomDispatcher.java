package org.toqa.fleet.floor;

import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.robot.RobotMessage;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.Role;
import org.toqa.link.message.AgentMessage.RoomUse;

/**
 * Lends robots that drive alone room beside their paths, to drive round what they see there. It is
 * theirs until they say, after they have taken it, that they have it no more; or until their drive
 * is over. So nobody is let in there by a message that was on its way.
 */
final class RoomDispatcher {
  private static final Logger log = LoggerFactory.getLogger(RoomDispatcher.class);

  private final FloorState state;

  RoomDispatcher(FloorState state) {
    this.state = state;
  }

  /**
   * Takes in what a robot says that drives as it was told and knows where it is; before what it
   * sees becomes known.
   */
  void stateReported(FloorRobot robot, AgentMessage.State said) {
    String name = robot.name();
    if (state.traffic.hasRoom(name)) {
      if (robot.room.isTaken() && said.room() != RoomUse.HELD) {
        end(robot);
      }
    } else if (isInNeed(robot, said) && state.traffic.lendRoom(name, said.obstacles(), state.now)) {
      robot.room.lend();
      Vec2 seen = said.obstacles().getFirst();
      log.info(
          "{}: is lent room to drive round what it sees at ({}, {}).", name, seen.x(), seen.y());
    }
  }

  private static boolean isInNeed(FloorRobot robot, AgentMessage.State said) {
    return said.room() == RoomUse.WANTED
        && said.role() == Role.ALONE
        && said.mode() == Mode.DRIVING
        && !said.obstacles().isEmpty()
        && !robot.hold.isHeld()
        && !robot.drive.isCancelling();
  }

  /** The room that it says it has when it connects. */
  void connected(FloorRobot robot, Hello hello) {
    if (hello.room() != null) {
      state.traffic.adoptRoom(robot.name(), hello.room());
      robot.room.take();
    }
  }

  void taken(FloorRobot robot) {
    robot.room.take();
  }

  void refused(FloorRobot robot) {
    if (state.traffic.hasRobot(robot.name()) && state.traffic.hasRoom(robot.name())) {
      state.traffic.giveUpZone(robot.name());
      end(robot);
    }
  }

  private void end(FloorRobot robot) {
    state.traffic.returnRoom(robot.name());
    robot.agent.tell(new RobotMessage.RoomReturned());
  }
}
