package org.toqa.fleet.floor;

import java.util.List;
import java.util.Optional;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.pattern.StatusReply;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.PendingResume;
import org.toqa.fleet.RobotMove;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.robot.RobotMessage;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Operator commands to a floor's robots: to hold, to go home, to be out of service, to be told. */
final class OperatorCommandHandler {
  /** How far a dock looks, metres: what it corrects is less. */
  private static final double DOCK_RANGE = 0.5;

  private final FloorState state;
  private final FloorReporter reports;
  private final FloorMissions missions;
  private final HoldDispatcher holds;
  private final HomeDispatcher homing;
  private final RobotEventHandler robotEvents;
  private final ActorRef<FloorMessage> self;

  OperatorCommandHandler(
      FloorState state,
      FloorReporter reports,
      FloorMissions missions,
      HoldDispatcher holds,
      HomeDispatcher homing,
      RobotEventHandler robotEvents,
      ActorRef<FloorMessage> self) {
    this.state = state;
    this.reports = reports;
    this.missions = missions;
    this.holds = holds;
    this.homing = homing;
    this.robotEvents = robotEvents;
    this.self = self;
  }

  /** From now on it is spoken to at its new address, and by its new certificate. */
  void robotChanged(FloorMessage.RobotChanged m) {
    FloorRobot robot = state.robots.get(m.robot().name());
    if (robot == null) {
      m.replyTo().tell(StatusReply.success(FloorState.unknownRobot(m.robot().name())));
      return;
    }
    boolean isElsewhere = !m.robot().address().equals(robot.record().address());
    robot.setRecord(m.robot());
    if (isElsewhere || robot.reported.alert() != null) {
      robotEvents.forgetAlert(robot);
      robot.agent.tell(new RobotMessage.Reconnect(m.robot()));
    } else {
      robot.agent.tell(new RobotMessage.RecordChanged(m.robot()));
    }
    reports.send();
    m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(reports.view(robot))));
  }

  void removeRobot(FloorMessage.RemoveRobot m) {
    FloorRobot robot = state.robots.get(m.robot());
    Sentence objection = robot == null ? null : objectionToRemoval(robot, m.move());
    if (robot == null || objection != null) {
      m.replyTo()
          .tell(
              StatusReply.success(
                  objection == null
                      ? FloorState.unknownRobot(m.robot())
                      : new Answer.Conflict<>(objection, null)));
      return;
    }
    state.writer.tryOnce(
        removal(robot, m),
        () -> self.tell(new FloorMessage.RobotRemoved(m)),
        failure -> m.replyTo().tell(StatusReply.error(failure)));
  }

  private Runnable removal(FloorRobot robot, FloorMessage.RemoveRobot m) {
    RobotMove move = m.move();
    if (move == null) {
      EventRecord event =
          state.historyEvent(
              EventKind.ROBOT_REMOVED,
              m.robot(),
              m.user(),
              Phrase.ROBOT_REMOVED.with(m.user(), m.robot()));
      return () -> state.store.removeRobot(m.robot(), List.of(event));
    }
    EventRecord event =
        state.historyEvent(
            EventKind.ROBOT_MOVED,
            m.robot(),
            m.user(),
            Phrase.ROBOT_MOVED.with(m.user(), m.robot(), state.floor.name(), move.floor()));
    double diameter = robot.reported.footprint();
    return () -> state.store.moveRobot(m.robot(), move, diameter, List.of(event));
  }

  private @Nullable Sentence objectionToRemoval(FloorRobot robot, @Nullable RobotMove move) {
    if (robot.record().simulated() && robot.reported.isConnected() && move == null) {
      return Phrase.SIMULATED_CANNOT_BE_REMOVED.with(robot.name());
    }
    if (robot.settings.isInService()) {
      return Phrase.TAKE_OUT_FIRST.with(robot.name());
    }
    if (move != null && robot.record().simulated() && isDriving(robot)) {
      return Phrase.CARRIED_WHEN_ARRIVED.with(robot.name());
    }
    return state
        .missions
        .missionOf(robot.name())
        .map(mission -> Phrase.REMOVE_AFTER_TASK.with(robot.name(), mission.id()))
        .orElse(null);
  }

  void locateRobot(FloorMessage.LocateRobot m) {
    m.replyTo().tell(StatusReply.success(tryLocate(m)));
  }

  private Answer<RobotView> tryLocate(FloorMessage.LocateRobot m) {
    FloorRobot robot = state.robots.get(m.robot());
    if (robot == null) {
      return FloorState.unknownRobot(m.robot());
    }
    if (!robot.reported.isConnected()) {
      return new Answer.Rejected<>(null, Phrase.LOCATE_WHEN_CONNECTED.with(m.robot()));
    }
    if (isDriving(robot)) {
      return new Answer.Rejected<>(null, Phrase.LOCATE_WHEN_ARRIVED.with(m.robot()));
    }
    if (!state.floor.grid().isFree(m.pose().position())) {
      return new Answer.Rejected<>("x", Phrase.CANNOT_STAND_THERE.with());
    }
    Optional<FloorRobot> other = otherAt(robot, m.pose().position());
    if (other.isPresent()) {
      return new Answer.Rejected<>("x", Phrase.LOCATE_TAKEN.with(other.get().name()));
    }
    robotEvents.locate(robot, m.pose());
    Sentence text = Phrase.ROBOT_LOCATED.with(m.user(), m.robot());
    state.addToHistory(
        new EventRecord(
            state.clock.instant(), EventKind.ROBOT_LOCATED, null, m.robot(), m.user(), text));
    return new Answer.Accepted<>(reports.view(robot));
  }

  private static boolean isDriving(FloorRobot robot) {
    return robot.reported.isConnected()
        && (robot.reported.drive() != 0 || robot.drive.order().isPending());
  }

  /** Who says that it stands where the robot is said to be; what a dock corrects does not count. */
  private Optional<FloorRobot> otherAt(FloorRobot robot, Vec2 place) {
    Pose before = robot.reported.pose();
    if (before != null && before.position().distanceTo(place) < DOCK_RANGE) {
      return Optional.empty();
    }
    return state.robots.values().stream()
        .filter(other -> other != robot && other.settings.isInService())
        .filter(other -> other.reported.isConnected() && isWithinReach(robot, other, place))
        .findFirst();
  }

  private static boolean isWithinReach(FloorRobot robot, FloorRobot other, Vec2 place) {
    Pose pose = other.reported.report().localised() ? other.reported.pose() : null;
    double apart = (robot.reported.footprint() + other.reported.footprint()) / 2;
    return pose != null && pose.position().distanceTo(place) < apart;
  }

  void holdRobot(FloorMessage.HoldRobot m) {
    FloorRobot robot = state.robots.get(m.robot());
    if (robot == null) {
      m.replyTo().tell(StatusReply.success(FloorState.unknownRobot(m.robot())));
      return;
    }
    PendingResume resume = robot.settings.resume;
    boolean isAsked = m.hold() == (robot.settings.isHeld() && !resume.isPending());
    List<EventRecord> events = isAsked ? List.of() : List.of(holdEvent(m));
    if (m.hold()) {
      resume.cancel();
      robot.settings.setHeld(true);
      holds.updateHold(robot);
      reports.send();
      RobotView view = reports.view(robot);
      state.writer.write(
          () -> state.store.saveHold(m.robot(), true, events),
          () -> m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(view))),
          refusal -> m.replyTo().tell(StatusReply.error(refusal)));
    } else {
      long number = resume.begin();
      state.writer.write(
          () -> state.store.saveHold(m.robot(), false, events),
          () -> self.tell(new FloorMessage.ResumeStored(m, number)),
          refusal -> self.tell(new FloorMessage.ResumeNotStored(m, number, refusal)));
    }
  }

  /** It stays on hold, and may be let go on anew. */
  void resumeNotStored(FloorMessage.ResumeNotStored m) {
    FloorRobot robot = state.robots.get(m.command().robot());
    if (robot != null) {
      var _ = robot.settings.resume.complete(m.resume());
    }
    m.command().replyTo().tell(StatusReply.error(m.refusal()));
  }

  void resumeStored(FloorMessage.ResumeStored m) {
    FloorRobot robot = state.robots.get(m.command().robot());
    if (robot == null) {
      m.command().replyTo().tell(StatusReply.success(FloorState.unknownRobot(m.command().robot())));
      return;
    }
    if (robot.settings.resume.complete(m.resume())) {
      robot.settings.setHeld(false);
      holds.updateHold(robot);
    }
    reports.send();
    m.command().replyTo().tell(StatusReply.success(new Answer.Accepted<>(reports.view(robot))));
  }

  private EventRecord holdEvent(FloorMessage.HoldRobot m) {
    return m.hold()
        ? state.historyEvent(
            EventKind.ROBOT_HELD,
            m.robot(),
            m.user(),
            Phrase.ROBOT_PUT_ON_HOLD.with(m.user(), m.robot()))
        : state.historyEvent(
            EventKind.ROBOT_RESUMED,
            m.robot(),
            m.user(),
            Phrase.ROBOT_LET_GO_ON.with(m.user(), m.robot()));
  }

  void sendTo(FloorMessage.SendTo m) {
    FloorRobot robot = state.robots.get(m.robot());
    if (robot == null) {
      m.replyTo().tell(StatusReply.success(FloorState.unknownRobot(m.robot())));
      return;
    }
    Sentence objection = homing.objectionToLeave(robot);
    if (objection != null) {
      m.replyTo().tell(StatusReply.success(new Answer.Conflict<>(objection, null)));
      return;
    }
    robot.drive.setGoal(DriveGoal.toPlace(m.place()));
    reports.send();
    m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(reports.view(robot))));
  }

  void sendHome(FloorMessage.SendHome m) {
    FloorRobot robot = state.robots.get(m.robot());
    if (robot == null) {
      m.replyTo().tell(StatusReply.success(FloorState.unknownRobot(m.robot())));
      return;
    }
    Sentence objection = homing.objection(robot);
    if (objection != null) {
      m.replyTo().tell(StatusReply.success(new Answer.Conflict<>(objection, null)));
      return;
    }
    homing.sendHome(robot);
    EventRecord event =
        state.historyEvent(
            EventKind.ROBOT_SENT_HOME,
            m.robot(),
            m.user(),
            Phrase.ROBOT_SENT_HOME.with(m.user(), m.robot()));
    reports.send();
    RobotView view = reports.view(robot);
    state.writer.write(
        () -> state.store.addEvents(List.of(event)),
        () -> m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(view))),
        refusal -> m.replyTo().tell(StatusReply.error(refusal)));
  }

  void setInService(FloorMessage.SetInService m) {
    FloorRobot robot = state.robots.get(m.robot());
    if (robot == null) {
      m.replyTo().tell(StatusReply.success(FloorState.unknownRobot(m.robot())));
      return;
    }
    boolean clears = !m.inService() && state.hasReservedCells(robot);
    if (robot.settings.isInService() == m.inService() && !clears) {
      m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(reports.view(robot))));
      return;
    }
    EventRecord event =
        state.historyEvent(
            m.inService() ? EventKind.ROBOT_IN_SERVICE : EventKind.ROBOT_OUT_OF_SERVICE,
            m.robot(),
            m.user(),
            servicePhrase(m, clears).with(m.user(), m.robot()));
    state.writer.tryOnce(
        () -> {
          if (clears) {
            state.store.saveGone(m.robot(), List.of(event));
          } else {
            state.store.saveService(m.robot(), m.inService(), List.of(event));
          }
        },
        () -> self.tell(new FloorMessage.ServiceStored(m, clears)),
        failure -> m.replyTo().tell(StatusReply.error(failure)));
  }

  private static Phrase servicePhrase(FloorMessage.SetInService m, boolean clears) {
    if (m.inService()) {
      return Phrase.ROBOT_PUT_BACK;
    }
    return clears ? Phrase.LOST_ROBOT_TAKEN_OUT : Phrase.ROBOT_TAKEN_OUT;
  }

  void serviceStored(FloorMessage.SetInService m, boolean clears) {
    FloorRobot robot = state.robots.get(m.robot());
    if (robot == null) {
      m.replyTo().tell(StatusReply.success(FloorState.unknownRobot(m.robot())));
      return;
    }
    robot.settings.setInService(m.inService());
    robot.obedience.reset();
    missions.checkRobot(robot); // while its place is known
    if (clears && state.hasReservedCells(robot)) {
      state.traffic.removeRobot(robot.name());
      robotEvents.forgetPose(robot);
    }
    reports.send();
    m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(reports.view(robot))));
  }
}
