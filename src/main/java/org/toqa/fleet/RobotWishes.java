package org.toqa.fleet;

import java.util.List;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.pattern.StatusReply;
import org.jspecify.annotations.Nullable;

/** What people want of a floor's robots: to stand, to go home, to be out of service, to be told. */
final class RobotWishes {
  private final FloorState state;
  private final FloorReports reports;
  private final FloorMissions missions;
  private final Holding holding;
  private final Homing homing;
  private final ActorRef<FloorMessage> self;

  RobotWishes(
      FloorState state,
      FloorReports reports,
      FloorMissions missions,
      Holding holding,
      Homing homing,
      ActorRef<FloorMessage> self) {
    this.state = state;
    this.reports = reports;
    this.missions = missions;
    this.holding = holding;
    this.homing = homing;
    this.self = self;
  }

  /** From now on it is spoken to at its new address, and by its new certificate. */
  void changed(FloorMessage.RobotChanged m) {
    FloorRobot robot = state.robots.get(m.robot().name());
    if (robot == null) {
      m.replyTo().tell(StatusReply.success(FloorState.unknown(m.robot().name())));
      return;
    }
    boolean isElsewhere = !m.robot().address().equals(robot.record.address());
    robot.change(m.robot());
    if (isElsewhere || robot.alert != null) {
      robot.alert = null;
      robot.agent.tell(new RobotMessage.Reconnect(m.robot()));
    }
    reports.send();
    m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(reports.view(robot))));
  }

  void remove(FloorMessage.RemoveRobot m) {
    FloorRobot robot = state.robots.get(m.robot());
    String objection = robot == null ? null : objectionToRemoval(robot);
    if (robot == null || objection != null) {
      m.replyTo()
          .tell(
              StatusReply.success(
                  objection == null
                      ? FloorState.unknown(m.robot())
                      : new Answer.Conflict<>(objection, null)));
      return;
    }
    EventRecord event =
        state.event("robot.removed", m.robot(), m.user(), m.user() + " removed " + m.robot());
    state.writer.tryOnce(
        () -> state.store.removeRobot(m.robot(), List.of(event)),
        () -> self.tell(new FloorMessage.RobotRemoved(m)),
        failure -> m.replyTo().tell(StatusReply.error(failure)));
  }

  private @Nullable String objectionToRemoval(FloorRobot robot) {
    if (robot.record.simulated()) {
      return "%s is simulated: start the server with fewer simulated robots."
          .formatted(robot.name());
    }
    if (robot.inService) {
      return "Take %s out of service first; then it can be removed.".formatted(robot.name());
    }
    return state
        .missions
        .of(robot.name())
        .map(
            mission ->
                "%s works for task %d. Cancel the task, or let it end, and remove the robot then."
                    .formatted(robot.name(), mission.id()))
        .orElse(null);
  }

  void locate(FloorMessage.Locate m) {
    m.replyTo().tell(StatusReply.success(located(m)));
  }

  private Answer<RobotView> located(FloorMessage.Locate m) {
    FloorRobot robot = state.robots.get(m.robot());
    if (robot == null) {
      return FloorState.unknown(m.robot());
    }
    if (!robot.connected) {
      return new Answer.Refused<>(null, m.robot() + " is not connected; try again when it is.");
    }
    if (robot.drive != 0 || robot.driveUnderway) {
      return new Answer.Refused<>(
          null,
          m.robot() + " is on its way; say where it is when it has arrived, or cancel its task.");
    }
    if (!state.floor.grid().isFree(m.pose().position())) {
      return new Answer.Refused<>(
          "x", "A robot cannot stand there: that is a wall or off the map.");
    }
    robot.agent.tell(new RobotMessage.Locate(m.pose()));
    String text = m.user() + " said where " + m.robot() + " is";
    state.note(
        new EventRecord(state.clock.instant(), "robot.located", null, m.robot(), m.user(), text));
    return new Answer.Accepted<>(reports.view(robot));
  }

  void hold(FloorMessage.HoldRobot m) {
    FloorRobot robot = state.robots.get(m.robot());
    if (robot == null) {
      m.replyTo().tell(StatusReply.success(FloorState.unknown(m.robot())));
      return;
    }
    List<EventRecord> events = robot.held == m.hold() ? List.of() : List.of(event(m));
    robot.held = m.hold();
    holding.holdOrGoOn(robot);
    reports.send();
    RobotView view = reports.view(robot);
    state.writer.write(
        () -> state.store.saveHold(m.robot(), m.hold(), events),
        () -> m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(view))));
  }

  private EventRecord event(FloorMessage.HoldRobot m) {
    return m.hold()
        ? state.event(
            "robot.held", m.robot(), m.user(), m.user() + " put " + m.robot() + " on hold")
        : state.event(
            "robot.resumed", m.robot(), m.user(), m.user() + " let " + m.robot() + " go on");
  }

  void sendHome(FloorMessage.SendHome m) {
    FloorRobot robot = state.robots.get(m.robot());
    if (robot == null) {
      m.replyTo().tell(StatusReply.success(FloorState.unknown(m.robot())));
      return;
    }
    String objection = homing.objection(robot);
    if (objection != null) {
      m.replyTo().tell(StatusReply.success(new Answer.Conflict<>(objection, null)));
      return;
    }
    homing.sendHome(robot);
    EventRecord event =
        state.event(
            "robot.sent-home", m.robot(), m.user(), m.user() + " sent " + m.robot() + " home");
    reports.send();
    RobotView view = reports.view(robot);
    state.writer.write(
        () -> state.store.addEvents(List.of(event)),
        () -> m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(view))));
  }

  void serve(FloorMessage.Serve m) {
    FloorRobot robot = state.robots.get(m.robot());
    if (robot == null) {
      m.replyTo().tell(StatusReply.success(FloorState.unknown(m.robot())));
      return;
    }
    boolean clears = !m.inService() && state.isKept(robot);
    if (robot.inService == m.inService() && !clears) {
      m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(reports.view(robot))));
      return;
    }
    EventRecord event =
        state.event(
            m.inService() ? "robot.in-service" : "robot.out-of-service",
            m.robot(),
            m.user(),
            sentence(m, clears));
    state.writer.tryOnce(
        () -> state.store.saveService(m.robot(), m.inService(), List.of(event)),
        () -> self.tell(new FloorMessage.ServiceStored(m, clears)),
        failure -> m.replyTo().tell(StatusReply.error(failure)));
  }

  private static String sentence(FloorMessage.Serve m, boolean clears) {
    if (m.inService()) {
      return m.user() + " put " + m.robot() + " back in service";
    }
    return m.user()
        + " took "
        + m.robot()
        + " out of service"
        + (clears ? "; it does not stand any more where it was lost" : "");
  }

  void serviceStored(FloorMessage.Serve m, boolean clears) {
    FloorRobot robot = state.robots.get(m.robot());
    if (robot == null) {
      m.replyTo().tell(StatusReply.success(FloorState.unknown(m.robot())));
      return;
    }
    robot.inService = m.inService();
    missions.watch(robot); // while its place is known
    if (clears && state.isKept(robot)) {
      state.traffic.leaves(robot.name());
      robot.pose = null;
      robot.driveUnderway = false;
    }
    reports.send();
    m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(reports.view(robot))));
  }
}
