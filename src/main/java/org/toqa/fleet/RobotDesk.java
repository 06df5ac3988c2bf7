package org.toqa.fleet;

import java.util.List;
import java.util.Optional;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.pattern.StatusReply;
import org.toqa.wording.Phrase;

/** Takes what people want of robots: checks it, stores it, and tells their floors. */
final class RobotDesk {
  private final FleetState fleet;
  private final FleetPicture picture;
  private final OrderCheck check;
  private final RobotIntake intake;
  private final ActorRef<ManagerMessage> self;

  RobotDesk(
      FleetState fleet,
      FleetPicture picture,
      OrderCheck check,
      RobotIntake intake,
      ActorRef<ManagerMessage> self) {
    this.fleet = fleet;
    this.picture = picture;
    this.check = check;
    this.intake = intake;
    this.self = self;
  }

  void addRobot(ManagerMessage.AddRobot m) {
    Answer<RobotRecord> checked = check.robot(m.order(), List.copyOf(fleet.robots.values()));
    if (checked instanceof Answer.Accepted<RobotRecord>(RobotRecord robot)) {
      take(robot, m);
    } else {
      m.replyTo().tell(StatusReply.success(checked.refusal()));
    }
  }

  private void take(RobotRecord robot, ManagerMessage.AddRobot m) {
    fleet.robots.put(robot.name(), robot); // the name and its parking point are taken from now on
    intake.take(
        robot,
        m.order().code(),
        new RobotIntake.Wish(
            m.user(),
            "robot.added",
            Phrase.ROBOT_ADDED.with(m.user(), robot.name()),
            new RobotAsker(
                m.replyTo(),
                stored -> self.tell(new ManagerMessage.RobotStored(stored, m.replyTo())),
                () -> self.tell(new ManagerMessage.RobotNotStored(robot.name())))));
  }

  void pair(ManagerMessage.PairRobot m) {
    RobotRecord robot = fleet.robots.get(m.robot());
    if (robot == null) {
      m.replyTo().tell(StatusReply.success(FloorState.unknown(m.robot())));
      return;
    }
    PairingOrder order = m.order();
    intake.take(
        robot.at(order.host(), order.port()),
        order.code(),
        new RobotIntake.Wish(
            m.user(),
            "robot.paired",
            Phrase.ROBOT_PAIRED.with(m.user(), robot.name()),
            new RobotAsker(
                m.replyTo(),
                stored -> self.tell(new ManagerMessage.RobotChanged(stored, m.replyTo())),
                () -> {})));
  }

  void change(ManagerMessage.ChangeRobot m) {
    RobotRecord robot = fleet.robots.get(m.robot());
    if (robot == null) {
      m.replyTo().tell(StatusReply.success(FloorState.unknown(m.robot())));
      return;
    }
    Answer<RobotRecord> checked =
        check.change(robot, m.change(), List.copyOf(fleet.robots.values()));
    if (!(checked instanceof Answer.Accepted<RobotRecord>(RobotRecord wished))) {
      m.replyTo().tell(StatusReply.success(checked.refusal()));
      return;
    }
    fleet.robots.put(wished.name(), wished); // its parking point is taken from now on
    intake.take(
        wished,
        null,
        new RobotIntake.Wish(
            m.user(),
            "robot.changed",
            Phrase.ROBOT_CHANGED.with(m.user(), robot.name()),
            new RobotAsker(
                m.replyTo(),
                stored -> self.tell(new ManagerMessage.RobotChanged(stored, m.replyTo())),
                () -> self.tell(new ManagerMessage.RobotNotChanged(robot)))));
  }

  void changed(ManagerMessage.RobotChanged m) {
    fleet.robots.put(m.robot().name(), m.robot());
    fleet.due.add(m.robot().floor()); // who was too weak or too far away may not be any more
    tellFloorOf(
        m.robot().name(), m.replyTo(), new FloorMessage.RobotChanged(m.robot(), m.replyTo()));
  }

  /** Whoever removed the robot does not find it in the picture. */
  void removed(ManagerMessage.RobotRemoved m) {
    fleet.robots.remove(m.robot().name());
    picture.publish();
    m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(m.robot())));
  }

  void robotStored(ManagerMessage.RobotStored m) {
    fleet.robots.put(m.robot().name(), m.robot());
    fleet
        .floorAgent(m.robot().floor())
        .ifPresent(f -> f.tell(new FloorMessage.RobotJoined(m.robot(), m.replyTo())));
  }

  /** Whoever asked for the robot finds it in the picture. */
  void joined(ManagerMessage.RobotJoined m) {
    picture.publish();
    m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(m.robot())));
  }

  void locate(ManagerMessage.Locate m) {
    tellFloorOf(
        m.robot(),
        m.replyTo(),
        new FloorMessage.Locate(m.robot(), m.pose(), m.user(), m.replyTo()));
  }

  void serve(ManagerMessage.Serve m) {
    tellFloorOf(
        m.robot(),
        m.replyTo(),
        new FloorMessage.Serve(m.robot(), m.inService(), m.user(), m.replyTo()));
  }

  void tellFloorOf(
      String robot, ActorRef<StatusReply<Answer<RobotView>>> replyTo, FloorMessage message) {
    Optional.ofNullable(fleet.robots.get(robot))
        .map(RobotRecord::floor)
        .flatMap(fleet::floorAgent)
        .ifPresentOrElse(
            floor -> floor.tell(message),
            () ->
                replyTo.tell(
                    StatusReply.success(new Answer.Unknown<>(Phrase.NO_SUCH_ROBOT.with(robot)))));
  }
}
