package org.toqa.fleet.dispatch;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.pattern.StatusReply;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.PairingOrder;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.StoredRobot;
import org.toqa.fleet.floor.FloorEvent;
import org.toqa.fleet.floor.FloorMessage;
import org.toqa.fleet.floor.FloorState;
import org.toqa.fleet.robot.RobotAgents;
import org.toqa.wording.Phrase;

/** Handles orders and commands of robots: checks them, stores them, and tells their floors. */
final class RobotCommandHandler {
  private final DispatchState state;
  private final SnapshotPublisher snapshotPublisher;
  private final OrderValidator validator;
  private final RobotRegistrar registrar;
  private final ActorRef<DispatchMessage> self;
  private final RobotAgents robotAgents;

  /** Names of robots that are being added. */
  private final Set<String> joining = new HashSet<>();

  RobotCommandHandler(
      DispatchState state,
      SnapshotPublisher snapshotPublisher,
      OrderValidator validator,
      RobotRegistrar registrar,
      ActorRef<DispatchMessage> self,
      RobotAgents robotAgents) {
    this.state = state;
    this.snapshotPublisher = snapshotPublisher;
    this.validator = validator;
    this.registrar = registrar;
    this.self = self;
    this.robotAgents = robotAgents;
  }

  void addRobot(DispatchMessage.AddRobot m) {
    Answer<RobotRecord> checked =
        validator.checkRobot(m.order(), List.copyOf(state.robots.values()));
    if (checked instanceof Answer.Accepted<RobotRecord>(RobotRecord robot)) {
      register(robot, m);
    } else {
      m.notAdded().run();
      m.replyTo().tell(StatusReply.success(checked.asRejection()));
    }
  }

  private void register(RobotRecord robot, DispatchMessage.AddRobot m) {
    state.robots.put(robot.name(), robot); // the name and its parking point are taken from now on
    joining.add(robot.name());
    registrar.add(
        robot,
        m.order().code(),
        new RobotRegistrar.Request(
            m.user(),
            EventKind.ROBOT_ADDED,
            Phrase.ROBOT_ADDED.with(m.user(), robot.name()),
            new RegistrationReply(
                m.replyTo(),
                stored -> self.tell(new DispatchMessage.RobotStored(stored, m.replyTo())),
                () -> {
                  self.tell(new DispatchMessage.RobotNotStored(robot.name()));
                  m.notAdded().run();
                })));
  }

  void robotNotStored(String robot) {
    joining.remove(robot);
    state.robots.remove(robot);
  }

  /** Null where there is none, or where it is still being added. */
  private @Nullable RobotRecord storedRobot(String name) {
    return joining.contains(name) ? null : state.robots.get(name);
  }

  void pairRobot(DispatchMessage.PairRobot m) {
    RobotRecord robot = storedRobot(m.robot());
    if (robot == null) {
      m.replyTo().tell(StatusReply.success(FloorState.unknownRobot(m.robot())));
      return;
    }
    PairingOrder order = m.order();
    registrar.pair(
        robot.withAddress(order.host(), order.port()),
        order.code(),
        pairingRequest(m),
        shown -> self.tell(new DispatchMessage.RobotPaired(m, robot, shown)));
  }

  /** What else was changed of the robot while it was being paired stays. */
  void robotPaired(DispatchMessage.RobotPaired m) {
    DispatchMessage.PairRobot request = m.request();
    RobotRecord robot = storedRobot(request.robot());
    if (robot == null) {
      request.replyTo().tell(StatusReply.success(FloorState.unknownRobot(request.robot())));
    } else if (!robot.address().equals(m.before().address())) {
      request.replyTo().tell(StatusReply.success(new Answer.Outdated<>()));
    } else {
      PairingOrder order = request.order();
      update(
          robot,
          robot.withAddress(order.host(), order.port()).withFingerprint(m.fingerprint()),
          pairingRequest(request));
    }
  }

  private RobotRegistrar.Request pairingRequest(DispatchMessage.PairRobot m) {
    return new RobotRegistrar.Request(
        m.user(),
        EventKind.ROBOT_PAIRED,
        Phrase.ROBOT_PAIRED.with(m.user(), m.robot()),
        updateReply(m.robot(), m.replyTo()));
  }

  void changeRobot(DispatchMessage.ChangeRobot m) {
    RobotRecord robot = storedRobot(m.robot());
    if (robot == null) {
      m.replyTo().tell(StatusReply.success(FloorState.unknownRobot(m.robot())));
      return;
    }
    if (m.seen() != null && !m.seen().equals(robot.toChange())) {
      m.replyTo().tell(StatusReply.success(new Answer.Outdated<>()));
      return;
    }
    Answer<RobotRecord> checked =
        validator.checkChange(robot, m.change(), List.copyOf(state.robots.values()));
    if (!(checked instanceof Answer.Accepted<RobotRecord>(RobotRecord changed))) {
      m.replyTo().tell(StatusReply.success(checked.asRejection()));
      return;
    }
    update(
        robot,
        changed,
        new RobotRegistrar.Request(
            m.user(),
            EventKind.ROBOT_CHANGED,
            Phrase.ROBOT_CHANGED.with(m.user(), robot.name()),
            updateReply(m.robot(), m.replyTo())));
  }

  private void update(RobotRecord before, RobotRecord after, RobotRegistrar.Request request) {
    state.robots.put(after.name(), after); // its parking point is taken from now on
    registrar.update(before, after, request);
  }

  private RegistrationReply updateReply(
      String robot, ActorRef<StatusReply<Answer<RobotView>>> replyTo) {
    return new RegistrationReply(
        replyTo,
        stored -> self.tell(new DispatchMessage.RobotChanged(stored, replyTo)),
        () ->
            registrar.reread(
                robot,
                stored ->
                    self.tell(
                        new DispatchMessage.RobotReread(
                            robot, stored == null ? null : stored.record()))));
  }

  void robotReread(DispatchMessage.RobotReread m) {
    if (m.stored() == null) {
      state.robots.remove(m.robot());
    } else {
      state.robots.put(m.robot(), m.stored());
    }
  }

  void robotChanged(DispatchMessage.RobotChanged m) {
    state.robots.put(m.robot().name(), m.robot());
    state.isRoundDue = true; // who was too weak or too far away may not be any more
    forwardToFloor(
        m.robot().name(), m.replyTo(), new FloorMessage.RobotChanged(m.robot(), m.replyTo()));
  }

  /** Whoever removed the robot does not find it in the snapshot. */
  void robotRemoved(FloorEvent.RobotRemoved m) {
    state.robots.remove(m.robot().name());
    snapshotPublisher.publish();
    m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(m.robot())));
  }

  void robotStored(DispatchMessage.RobotStored m) {
    joining.remove(m.robot().name());
    state.robots.put(m.robot().name(), m.robot());
    state.floorAgent.tell(new FloorMessage.AddRobot(StoredRobot.added(m.robot()), m.replyTo()));
  }

  /** It comes as it would after a restart: what people have said of it stays. */
  void takeRobot(DispatchMessage.TakeRobot m) {
    String robot = m.robot().name();
    state.robots.put(robot, m.robot());
    joining.add(robot);
    registrar.reread(robot, stored -> self.tell(new DispatchMessage.RobotTaken(m, stored)));
  }

  void robotTaken(DispatchMessage.RobotTaken m) {
    String robot = m.request().robot().name();
    StoredRobot stored = m.stored();
    if (stored == null) {
      robotNotStored(robot);
      m.request().replyTo().tell(StatusReply.success(FloorState.unknownRobot(robot)));
      return;
    }
    joining.remove(robot);
    state.robots.put(robot, stored.record());
    state.floorAgent.tell(new FloorMessage.AddRobot(stored, m.request().replyTo()));
  }

  /** Whoever asked for the robot finds it in the snapshot. */
  void robotJoined(FloorEvent.RobotJoined m) {
    snapshotPublisher.publish();
    m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(m.robot())));
  }

  void locateRobot(DispatchMessage.LocateRobot m) {
    forwardToFloor(
        m.robot(),
        m.replyTo(),
        new FloorMessage.LocateRobot(m.robot(), m.pose(), m.user(), m.replyTo()));
  }

  void holdRobot(DispatchMessage.HoldRobot m) {
    forwardToFloor(
        m.robot(),
        m.replyTo(),
        new FloorMessage.HoldRobot(m.robot(), m.hold(), m.user(), m.replyTo()));
    if (m.hold()) {
      robotAgents.hold(robot -> robot.name().equals(m.robot()));
    }
  }

  void setInService(DispatchMessage.SetInService m) {
    forwardToFloor(
        m.robot(),
        m.replyTo(),
        new FloorMessage.SetInService(m.robot(), m.inService(), m.user(), m.replyTo()));
  }

  <T> void forwardToFloor(
      String robot, ActorRef<StatusReply<Answer<T>>> replyTo, FloorMessage message) {
    if (state.robots.containsKey(robot)) {
      state.floorAgent.tell(message);
    } else {
      replyTo.tell(StatusReply.success(new Answer.Unknown<>(Phrase.NO_SUCH_ROBOT.with(robot))));
    }
  }
}
