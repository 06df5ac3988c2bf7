package org.toqa.fleet.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.FleetStore.StoredDrive;
import org.toqa.fleet.LastPlace;
import org.toqa.fleet.StoredRobot;
import org.toqa.fleet.robot.RobotEvent;
import org.toqa.fleet.robot.RobotMessage;
import org.toqa.geometry.Pose;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.PhaseEnd;
import org.toqa.link.message.AgentMessage.Role;
import org.toqa.mission.Mission;
import org.toqa.mission.MissionEvent;
import org.toqa.mission.Phase;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Takes in what a floor's robots say, and tells the traffic and the missions. */
final class RobotEventHandler {
  private static final Duration RETRY_AFTER = Duration.ofSeconds(1);
  private static final Duration REFUSALS_INTERVAL = Duration.ofMinutes(5);

  private static final Duration LOCATE_AGAIN_AFTER = Duration.ofSeconds(10);

  /** Metres; a robot that stands and drifts by less is where it was. */
  private static final double SAME_PLACE = 0.02;

  /** The code by which a robot reports connections that it refused. */
  private static final String REFUSED = "REFUSED";

  private final FloorState state;
  private final FloorMissions missions;
  private final HoldDispatcher holds;
  private final FloorWatch watch;
  private final RoomDispatcher rooms;
  private final ArmDispatcher arms;

  RobotEventHandler(
      FloorState state,
      FloorMissions missions,
      HoldDispatcher holding,
      FloorWatch watch,
      ArmDispatcher arms) {
    this.arms = arms;
    this.state = state;
    this.missions = missions;
    this.holds = holding;
    this.watch = watch;
    this.rooms = new RoomDispatcher(state);
  }

  void handle(RobotEvent event) {
    FloorRobot robot = state.robots.get(event.robot());
    if (robot == null) {
      return;
    }
    state.changed = true;
    switch (event) {
      case RobotEvent.Connected m -> connected(robot, m.hello(), m.drive());
      case RobotEvent.Disconnected m -> robot.reported.setDisconnected(m.why(), state.now);
      case RobotEvent.LinkRefused m -> {
        robot.reported.setDisconnected(m.why(), state.now);
        robot.reported.setAlert(m.why());
        addToHistory(robot, EventKind.ROBOT_LINK_REFUSED, m.why());
      }
      case RobotEvent.FellSilent m -> fellSilent(robot, m.fault());
      case RobotEvent.HeardAgain m -> {
        robot.reported.setHeardAgain();
        cancelForeignTask(robot);
      }
      case RobotEvent.StateReported m -> stateReported(robot, m.state());
      case RobotEvent.PhaseEnded m -> phaseEnded(robot, m.end());
      case RobotEvent.Acted m -> arms.ended(robot, m.end());
      case RobotEvent.DriveBegun m -> driveBegun(robot, m.drive());
      case RobotEvent.DriveWithdrawn m -> driveWithdrawn(robot, m.drive());
      case RobotEvent.DriveAccepted m -> driveAccepted(robot, m.drive());
      case RobotEvent.Located _ -> located(robot);
      case RobotEvent.RoomTaken _ -> rooms.taken(robot);
      case RobotEvent.RoomRefused _ -> rooms.refused(robot);
      case RobotEvent.CommandRejected m -> commandRejected(robot, m);
      case RobotEvent.NotAnswering _ -> robot.obedience.recordNoAnswer(state.now);
      case RobotEvent.ClearRejected m -> {
        robot.cleared.settle();
        addToHistory(robot, EventKind.ROBOT_STOP_NOT_CLEARED, m.why());
      }
      case RobotEvent.FloodBegan m -> state.addFlood(robot.name(), m.kind());
      case RobotEvent.FloodEnded m -> addFloodEnd(robot);
    }
  }

  /** What it carries, where it was last known, and how wide it is, until it is heard. */
  void recoverReport(StoredRobot stored) {
    FloorRobot robot = state.robots.get(stored.name());
    if (robot == null) {
      return;
    }
    robot.reported.setCarried(stored.carried());
    Double toldLoad = stored.toldLoad();
    if (toldLoad != null) {
      robot.reported.recover(toldLoad);
    }
    if (stored.place() != null) {
      robot.reported.recover(stored.place());
    }
  }

  /**
   * Until it is heard it stays where it was last known, and keeps all that it may drive. Missions
   * are known before.
   */
  void recoverPlace(StoredRobot stored) {
    FloorRobot robot = state.robots.get(stored.name());
    LastPlace place = stored.place();
    if (robot == null || place == null) {
      return;
    }
    double diameter = state.diameter(robot, place.diameter());
    state.traffic.reportStanding(robot.name(), place.pose(), diameter, state.now);
    if (!place.sinceDriven().segments().isEmpty()) {
      state
          .formations
          .carryingMission(robot.name())
          .filter(mission -> Formations.leader(mission).equals(robot.name()))
          .flatMap(state.formations::of)
          .ifPresent(formation -> state.traffic.setFormation(robot.name(), formation.group()));
      int segments = place.sinceDriven().segments().size();
      state.traffic.adoptTrajectory(
          robot.name(),
          place.pose(),
          place.diameter(),
          place.sinceDriven(),
          0,
          segments,
          state.now);
      if (place.room() != null) {
        state.traffic.adoptRoom(robot.name(), place.room());
      }
    }
    state.traffic.setMovable(robot.name(), false);
  }

  /** The robot has another certificate or address: what was refused was the old one. */
  void forgetAlert(FloorRobot robot) {
    robot.reported.setAlert(null);
  }

  /** A person said of a lost robot that it is not there any more. */
  void forgetPose(FloorRobot robot) {
    robot.reported.forgetPose();
    robot.drive.settle();
    robot.drive.setStoredPlace(null);
  }

  /** A robot that comes back with a task that it has no more is sent {@code cancel} first. */
  private void cancelForeignTask(FloorRobot robot) {
    Long task = robot.reported.report().task();
    if (task != null
        && state.missions.missionOf(robot.name()).filter(m -> m.id() == task).isEmpty()) {
      robot.cancelDrive();
    }
  }

  /** Compares what the robot says with what was stored, and goes on from there. */
  private void connected(FloorRobot robot, Hello hello, Optional<StoredDrive> stored) {
    boolean saysAnotherLoad = robot.reported.capabilities().maxLoad() != hello.maxLoad();
    robot.reported.connected(hello, state.clock.instant());
    if (saysAnotherLoad) {
      state.writer.write(() -> state.store.saveToldLoad(robot.name(), hello.maxLoad()), () -> {});
    }
    Optional<StoredDrive> drive = stored.filter(d -> d.seq() == hello.drive());
    robot.drive.reconnect(drive, stored.map(StoredDrive::seq).orElse(0L));
    if (!state.formations.isCoveredByLeader(robot.name())) {
      reportStanding(robot);
      state.formations.updateTraffic();
      if (drive.isPresent()
          && robot.reported.report().localised()
          && hello.role() != Role.FOLLOWER) {
        resumeDriveInTraffic(robot, drive.get(), hello.pose(), hello.segment(), hello.released());
        rooms.connected(robot, hello);
      }
    }
    if (hello.drive() == 0) {
      storePlace(robot);
    }
    robot.locatedAt = Instant.MIN;
    robot.arm.reconnect(hello.act());
    if (hello.done() != null) {
      phaseEnded(robot, hello.done());
    }
    if (hello.acted() != null) {
      arms.ended(robot, hello.acted());
    }
    cancelForeignTask(robot);
    holds.robotConnected(robot);
  }

  /** To be called at each tick: who was carried here is told where it stands, until it takes it. */
  void locateCarried(FloorRobot robot) {
    Pose pose = robot.reported.pose();
    if (robot.reported.isCarried()
        && robot.hasStopped()
        && pose != null
        && robot.locatedAt.plus(LOCATE_AGAIN_AFTER).isBefore(state.now)) {
      locate(robot, pose);
    }
  }

  void locate(FloorRobot robot, Pose pose) {
    robot.locatedAt = state.now;
    robot.agent.tell(new RobotMessage.Locate(pose));
  }

  private void located(FloorRobot robot) {
    if (robot.reported.isCarried()) {
      robot.reported.setCarried(false);
      state.writer.write(() -> state.store.saveLocated(robot.name()), () -> {});
    }
  }

  private void fellSilent(FloorRobot robot, @Nullable String fault) {
    robot.reported.setSilent(
        fault == null ? null : Phrase.SAYS_WRONG_STATE.with(robot.name(), fault), state.now);
  }

  private void stateReported(FloorRobot robot, AgentMessage.State said) {
    robot.reported.setReport(said, state.clock.instant());
    robot.arm.setRunning(said.arm() == null ? null : said.arm().act());
    recordRefusedConnections(robot);
    recordLastingStops(robot, said);
    RobotEvent.CommandRejected refusal = robot.reported.takeRejectedChange();
    if (refusal != null && Objects.equals(refusal.changing(), said.drive())) {
      abandonCommand(robot, refusal.reason());
    } // else the change and the end of the drive had crossed
    if (state.formations.isCoveredByLeader(robot.name())) {
      robot.drive.settle(said.drive());
      if (said.drive() == 0) {
        robot.drive.endCancelling();
      }
    } else if (robot.drive.settle(said.drive())) {
      if (robot.reported.report().localised()) {
        reportProgress(robot, said);
      }
    } else if (!robot.drive.order().isPending() && !isBraking(robot)) {
      if (said.drive() == 0) {
        robot.drive.end();
        storePlace(robot);
      }
      reportStanding(robot);
    }
    if (robot.reported.report().localised()) {
      state.addRobotLines(
          watch.addPercepts(robot.name(), said.pose().position(), said.obstacles(), state.now));
    }
  }

  private void reportProgress(FloorRobot robot, AgentMessage.State said) {
    if (state.traffic.hasRobot(robot.name())) {
      state.traffic.reportProgress(robot.name(), said.pose(), said.segment(), state.now);
      rooms.stateReported(robot, said);
    } else {
      resumeDriveInTraffic(
          robot,
          robot.drive.order().storedDrive().orElseThrow(),
          said.pose(),
          said.segment(),
          said.released());
    }
  }

  /**
   * It has no path any more. One that does not know where it is may be anywhere on what it had:
   * that stays its own as it was, as of a robot that is not heard, until it is localised.
   */
  private void reportStanding(FloorRobot robot) {
    Pose pose = robot.reported.pose();
    boolean isKnown = robot.reported.report().localised() || !state.traffic.hasRobot(robot.name());
    if (pose != null && isKnown) {
      state.traffic.reportStanding(robot.name(), pose, state.diameter(robot), state.now);
    }
  }

  /** So that who starts before the robot is heard again knows where it is. */
  private void storePlace(FloorRobot robot) {
    Pose pose = robot.reported.pose();
    if (pose == null || !robot.reported.report().localised()) {
      return;
    }
    Pose stored = robot.drive.storedPlace();
    boolean isElsewhere = stored == null || stored.distanceTo(pose) > SAME_PLACE;
    if (isElsewhere && robot.storing.takesPlace()) {
      robot.drive.setStoredPlace(pose);
      String name = robot.name();
      double diameter = state.diameter(robot);
      long drive = robot.drive.lastNumber();
      state.writer.write(() -> state.store.savePlace(name, pose, diameter, drive), () -> {});
    }
  }

  /** To be called at each tick. */
  void updateStoreLimit(FloorRobot robot) {
    if (robot.storing.detectRecovery()) {
      addFloodEnd(robot);
    }
  }

  private void addFloodEnd(FloorRobot robot) {
    state.addSystemLine(
        EventKind.ROBOT_SENDS_NORMALLY, robot.name(), Phrase.SENDS_NORMALLY.with(robot.name()));
  }

  private void recordLastingStops(FloorRobot robot, AgentMessage.State said) {
    List<String> lasting = robot.cleared.takeLasting(said.errors(), state.now);
    if (!lasting.isEmpty()) {
      addToHistory(
          robot,
          EventKind.ROBOT_STOP_NOT_CLEARED,
          Phrase.STOP_LASTS.with(robot.name(), String.join(", ", lasting)));
    }
  }

  /** Tells the history whom the robot did not let in; of many, a few. */
  private void recordRefusedConnections(FloorRobot robot) {
    Optional<Fault> refusal =
        robot.reported.report().errors().stream().filter(e -> e.code().equals(REFUSED)).findFirst();
    Instant notedAt = robot.reported.refusalNotedAt();
    if (refusal.isPresent() && !notedAt.plus(REFUSALS_INTERVAL).isAfter(state.now)) {
      robot.reported.setRefusalNotedAt(state.now);
      addToHistory(
          robot,
          EventKind.ROBOT_CONNECTION_REFUSED,
          Phrase.STRANGER_NOT_LET_IN.with(robot.name(), refusal.get().text()));
    } else if (refusal.isEmpty()) {
      robot.reported.setRefusalNotedAt(Instant.MIN);
    }
  }

  private void addToHistory(FloorRobot robot, EventKind kind, Sentence text) {
    if (state.mayAddLine(robot.name())) {
      state.addSystemLine(kind, robot.name(), text);
    }
  }

  private static boolean isBraking(FloorRobot robot) {
    LastReport report = robot.reported.report();
    return report.mode() == Mode.DRIVING || (report.mode() == Mode.HOLDING && report.moving());
  }

  private void resumeDriveInTraffic(
      FloorRobot robot, StoredDrive drive, Pose pose, int segment, int released) {
    state.traffic.adoptTrajectory(
        robot.name(),
        pose,
        state.diameter(robot),
        drive.trajectory(),
        segment,
        released,
        state.now);
  }

  private void phaseEnded(FloorRobot robot, PhaseEnd end) {
    Optional<Mission> mission =
        Optional.ofNullable(end.task()).flatMap(task -> state.missions.get(task));
    Optional<Phase> phase = Phase.of(end.phase());
    if (mission.isPresent()
        && phase.isPresent()
        && (phase.get() == Phase.HOME || state.formations.isAtGoal(mission.get(), robot))
        && !isForArm(mission.get(), robot)) {
      missions.phaseEnded(
          mission.get().id(), robot.name(), phase.get(), mission.get().stopNumber(phase.get()));
    } // else its drive was changed meanwhile, or the task has ended
    // written in order: acknowledged only when what follows from the flag is safe
    state.writer.write(() -> {}, () -> robot.agent.tell(new RobotMessage.Acknowledge(end.drive())));
  }

  /** Whether its arm ends the phase, which it is told when it stands there. */
  private static boolean isForArm(Mission mission, FloorRobot robot) {
    return mission.armTask(robot.name()).isPresent() && robot.reported.capabilities().arm() != null;
  }

  private void driveBegun(FloorRobot robot, StoredDrive drive) {
    robot.drive.setBegun(drive);
    if (drive.task() != null) {
      missions.applyEvent(drive.task(), new MissionEvent.DriveStarted(robot.name(), drive.phase()));
    }
  }

  /** It was cancelled in time: the robot has what it had before, and stands where it does. */
  private void driveWithdrawn(FloorRobot robot, long drive) {
    if (!robot.drive.order().isOf(drive)) {
      return;
    }
    if (robot.reported.drive() != 0) {
      robot.drive.settle();
    } else {
      robot.drive.end();
      reportStanding(robot);
    }
  }

  /** A drive may be so short that no state of the robot ever tells of it. */
  private static void driveAccepted(FloorRobot robot, long drive) {
    robot.obedience.reset();
    if (robot.drive.settle(drive)) {
      Long task = robot.drive.order().storedDrive().orElseThrow().task();
      robot.reported.setDrive(drive, task); // a cancel must name it
    }
  }

  /** A drive may have ended while a change of it was being sent; its next state tells. */
  private void commandRejected(FloorRobot robot, RobotEvent.CommandRejected m) {
    if (m.isDrive()) {
      robot.obedience.recordRefusal(m.reason(), state.now);
    }
    if (m.changing() == null) {
      abandonCommand(robot, m.reason());
    } else {
      robot.reported.setRejectedChange(m);
    }
  }

  /** What the robot refused is given up: it is stopped, and is asked anew a little later. */
  private void abandonCommand(FloorRobot robot, String reason) {
    robot.drive.abandonCommand(
        state.now.plus(RETRY_AFTER), Phrase.REFUSED_A_COMMAND.with(robot.name(), reason));
    if (robot.reported.drive() != 0) {
      robot.cancelDrive();
    } else {
      robot.drive.end();
      reportStanding(robot);
    }
  }
}
