package org.toqa.fleet.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.Objects;
import java.util.Optional;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.FleetStore.StoredDrive;
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
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Takes in what a floor's robots say, and tells the traffic and the missions. */
final class RobotEventHandler {
  private static final Duration RETRY_AFTER = Duration.ofSeconds(1);
  private static final Duration STRANGERS_INTERVAL = Duration.ofMinutes(5);

  /** The robot's word for connections that it did not take. */
  private static final String REFUSED = "REFUSED";

  private final FloorState state;
  private final FloorMissions missions;
  private final HoldDispatcher holds;
  private final FloorWatch watch;

  RobotEventHandler(
      FloorState state, FloorMissions missions, HoldDispatcher holding, FloorWatch watch) {
    this.state = state;
    this.missions = missions;
    this.holds = holding;
    this.watch = watch;
  }

  void handle(RobotEvent event) {
    FloorRobot robot = state.robots.get(event.robot());
    if (robot == null) {
      return;
    }
    state.changed = true;
    switch (event) {
      case RobotEvent.Connected m -> connected(robot, m.hello(), m.drive());
      case RobotEvent.Disconnected m -> {
        markSilent(robot);
        robot.connected = false;
      }
      case RobotEvent.LinkRefused m -> {
        markSilent(robot);
        robot.connected = false;
        robot.alert = m.why();
        addToHistory(robot, "robot.link-refused", m.why());
      }
      case RobotEvent.FellSilent m -> {
        markSilent(robot);
        robot.silent = true;
      }
      case RobotEvent.HeardAgain m -> {
        robot.silent = false;
        cancelForeignTask(robot);
      }
      case RobotEvent.StateReported m -> stateReported(robot, m.state());
      case RobotEvent.PhaseEnded m -> phaseEnded(robot, m.end());
      case RobotEvent.DriveBegun m -> driveBegun(robot, m.drive());
      case RobotEvent.DriveAccepted m -> driveAccepted(robot, m.drive());
      case RobotEvent.CommandRejected m -> commandRejected(robot, m);
    }
  }

  private void markSilent(FloorRobot robot) {
    if (robot.isHeard()) {
      robot.silentSince = state.now;
    }
  }

  /** A robot that comes back with a task that it has no more is sent {@code cancel} first. */
  private void cancelForeignTask(FloorRobot robot) {
    Long task = robot.reportedTask;
    if (task != null
        && state.missions.missionOf(robot.name()).filter(m -> m.id() == task).isEmpty()) {
      robot.cancelDrive();
    }
  }

  /** Compares what the robot says with what was stored, and goes on from there. */
  private void connected(FloorRobot robot, Hello hello, Optional<StoredDrive> stored) {
    robot.update(hello, state.clock.instant());
    robot.alert = null;
    robot.drivePending = false;
    robot.cancelling = false;
    robot.toldToHold = false;
    robot.toldToHoldAt = Instant.MIN;
    robot.rejectedChange = null;
    robot.toldDrive = stored.filter(d -> d.seq() == hello.drive()).orElse(null);
    if (!state.formations.isCoveredByLeader(robot.name())) {
      state.traffic.reportStanding(robot.name(), hello.pose(), hello.footprint(), state.now);
      state.traffic.setSpeeds(robot.name(), robot.speeds);
      state.formations.updateTraffic();
      if (robot.toldDrive != null && robot.role != Role.FOLLOWER) {
        resumeDriveInTraffic(
            robot, robot.toldDrive, hello.pose(), hello.segment(), hello.released());
      }
    }
    if (hello.done() != null) {
      phaseEnded(robot, hello.done());
    }
    cancelForeignTask(robot);
    holds.updateHold(robot);
  }

  private void stateReported(FloorRobot robot, AgentMessage.State said) {
    robot.update(said, state.clock.instant());
    recordStrangers(robot);
    RobotEvent.CommandRejected refusal = robot.rejectedChange;
    robot.rejectedChange = null;
    if (refusal != null && Objects.equals(refusal.changing(), said.drive())) {
      abandonCommand(robot, refusal.reason());
    } // else the change and the end of the drive had crossed
    if (state.formations.isCoveredByLeader(robot.name())) {
      boolean isTold = robot.toldDrive != null && said.drive() == robot.toldDrive.seq();
      robot.drivePending &= !isTold;
      robot.cancelling &= said.drive() != 0;
    } else if (robot.toldDrive != null && said.drive() == robot.toldDrive.seq()) {
      robot.drivePending = false;
      if (state.traffic.hasRobot(robot.name())) {
        state.traffic.reportProgress(robot.name(), said.pose(), said.segment(), state.now);
      } else {
        resumeDriveInTraffic(robot, robot.toldDrive, said.pose(), said.segment(), said.released());
      }
    } else if (!robot.drivePending && !isBraking(robot)) {
      if (said.drive() == 0) {
        robot.toldDrive = null;
        robot.cancelling = false;
      }
      state.traffic.reportStanding(robot.name(), said.pose(), robot.footprint, state.now);
    }
    if (said.localised()) {
      state.addToHistory(
          watch.addPercepts(
              robot.name(),
              said.pose().position(),
              said.obstacles(),
              state.robots.keySet(),
              state.now));
    }
  }

  /** Tells the history whom the robot did not let in; of many, a few. */
  private void recordStrangers(FloorRobot robot) {
    Optional<Fault> refusal =
        robot.errors.stream().filter(e -> e.code().equals(REFUSED)).findFirst();
    if (refusal.isPresent() && !robot.strangerNotedAt.plus(STRANGERS_INTERVAL).isAfter(state.now)) {
      robot.strangerNotedAt = state.now;
      addToHistory(
          robot,
          "robot.stranger",
          Phrase.STRANGER_NOT_LET_IN.with(robot.name(), refusal.get().text()));
    } else if (refusal.isEmpty()) {
      robot.strangerNotedAt = Instant.MIN;
    }
  }

  private void addToHistory(FloorRobot robot, String kind, Sentence text) {
    state.addToHistory(state.historyEvent(kind, robot.name(), EventRecord.SYSTEM, text));
  }

  private static boolean isBraking(FloorRobot robot) {
    return robot.mode == Mode.DRIVING || (robot.mode == Mode.HOLDING && robot.moving);
  }

  private void resumeDriveInTraffic(
      FloorRobot robot, StoredDrive drive, Pose pose, int segment, int released) {
    state.traffic.adoptTrajectory(
        robot.name(), pose, robot.footprint, drive.trajectory(), segment, released, state.now);
  }

  private void phaseEnded(FloorRobot robot, PhaseEnd end) {
    Optional<Mission> mission =
        Optional.ofNullable(end.task()).flatMap(task -> state.missions.get(task));
    if (mission.isPresent()
        && (end.phase() == 3 || state.formations.isAtGoal(mission.get(), robot))) {
      missions.applyEvent(
          mission.get().id(), new MissionEvent.PhaseEnded(robot.name(), end.phase()));
    } // else its way was changed meanwhile, or the task has ended
    // written in order: acknowledged only when what follows from the flag is safe
    state.writer.write(() -> {}, () -> robot.agent.tell(new RobotMessage.Acknowledge(end.drive())));
  }

  private void driveBegun(FloorRobot robot, StoredDrive drive) {
    robot.toldDrive = drive;
    if (drive.task() != null) {
      missions.applyEvent(drive.task(), new MissionEvent.DriveStarted(robot.name(), drive.phase()));
    }
  }

  /** A drive may be so short that no state of the robot ever tells of it. */
  private static void driveAccepted(FloorRobot robot, long drive) {
    if (robot.toldDrive != null && robot.toldDrive.seq() == drive) {
      robot.drivePending = false;
      robot.drive = drive;
      robot.reportedTask = robot.toldDrive.task(); // a cancel must name it
    }
  }

  /** A drive may have ended while a change of it was on its way; its next state tells. */
  private void commandRejected(FloorRobot robot, RobotEvent.CommandRejected m) {
    if (m.changing() == null) {
      abandonCommand(robot, m.reason());
    } else {
      robot.rejectedChange = m;
    }
  }

  /** What the robot refused is given up: it stands, and is asked anew a little later. */
  private void abandonCommand(FloorRobot robot, String reason) {
    robot.drivePending = false;
    robot.cancelling = false;
    robot.waitReason = Phrase.REFUSED_A_COMMAND.with(robot.name(), reason);
    robot.notBefore = state.now.plus(RETRY_AFTER);
    if (robot.drive != 0) {
      robot.cancelDrive();
    } else if (robot.pose != null) {
      robot.toldDrive = null;
      state.traffic.reportStanding(robot.name(), robot.pose, robot.footprint, state.now);
    }
  }
}
