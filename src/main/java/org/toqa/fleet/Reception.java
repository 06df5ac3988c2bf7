package org.toqa.fleet;

import java.time.Duration;
import java.time.Instant;
import java.util.Objects;
import java.util.Optional;
import org.toqa.fleet.FleetStore.StoredDrive;
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
final class Reception {
  private static final Duration RETRY_AFTER = Duration.ofSeconds(1);
  private static final Duration REFUSALS_EVERY = Duration.ofMinutes(5);

  /** The robot's word for connections that it did not take. */
  private static final String REFUSED = "REFUSED";

  private final FloorState state;
  private final FloorMissions missions;
  private final Holding holding;
  private final FloorWatch watch;

  Reception(FloorState state, FloorMissions missions, Holding holding, FloorWatch watch) {
    this.state = state;
    this.missions = missions;
    this.holding = holding;
    this.watch = watch;
  }

  void fromRobot(FloorMessage.FromRobot message) {
    FloorRobot robot = state.robots.get(message.robot());
    if (robot == null) {
      return;
    }
    state.changed = true;
    switch (message) {
      case FloorMessage.Connected m -> connected(robot, m.hello(), m.drive());
      case FloorMessage.Disconnected m -> {
        fallsSilent(robot);
        robot.connected = false;
      }
      case FloorMessage.LinkRefused m -> {
        fallsSilent(robot);
        robot.connected = false;
        robot.alert = m.why();
        note(robot, "robot.link-refused", m.why());
      }
      case FloorMessage.Silent m -> {
        fallsSilent(robot);
        robot.silent = true;
      }
      case FloorMessage.HeardAgain m -> {
        robot.silent = false;
        disown(robot);
      }
      case FloorMessage.Heard m -> heard(robot, m.state());
      case FloorMessage.PhaseEnded m -> phaseEnded(robot, m.end());
      case FloorMessage.DriveBegun m -> driveBegun(robot, m.drive());
      case FloorMessage.DriveTaken m -> driveTaken(robot, m.drive());
      case FloorMessage.Rejected m -> rejected(robot, m);
    }
  }

  private void fallsSilent(FloorRobot robot) {
    if (robot.isHeard()) {
      robot.quietSince = state.now;
    }
  }

  /** A robot that comes back with a task that it has no more is sent {@code cancel} first. */
  private void disown(FloorRobot robot) {
    Long task = robot.reportedTask;
    if (task != null && state.missions.of(robot.name()).filter(m -> m.id() == task).isEmpty()) {
      robot.cancelDrive();
    }
  }

  /** Compares what the robot says with what was stored, and goes on from there. */
  private void connected(FloorRobot robot, Hello hello, Optional<StoredDrive> stored) {
    robot.hear(hello, state.clock.instant());
    robot.alert = null;
    robot.driveUnderway = false;
    robot.cancelling = false;
    robot.toldToHold = false;
    robot.toldToHoldAt = Instant.MIN;
    robot.refusedChange = null;
    robot.told = stored.filter(d -> d.seq() == hello.drive()).orElse(null);
    if (!state.formations.isCovered(robot.name())) {
      state.traffic.stands(robot.name(), hello.pose(), hello.footprint(), state.now);
      state.traffic.drivesAt(robot.name(), robot.speeds);
      state.formations.tellTraffic();
      if (robot.told != null && robot.role != Role.FOLLOWER) {
        isOnItsWay(robot, robot.told, hello.pose(), hello.segment(), hello.released());
      }
    }
    if (hello.done() != null) {
      phaseEnded(robot, hello.done());
    }
    disown(robot);
    holding.holdOrGoOn(robot);
  }

  private void heard(FloorRobot robot, AgentMessage.State said) {
    robot.hear(said, state.clock.instant());
    noteStrangers(robot);
    FloorMessage.Rejected refusal = robot.refusedChange;
    robot.refusedChange = null;
    if (refusal != null && Objects.equals(refusal.changing(), said.drive())) {
      refused(robot, refusal.reason());
    } // else the change and the end of the drive had crossed
    if (state.formations.isCovered(robot.name())) {
      boolean isTold = robot.told != null && said.drive() == robot.told.seq();
      robot.driveUnderway &= !isTold;
      robot.cancelling &= said.drive() != 0;
    } else if (robot.told != null && said.drive() == robot.told.seq()) {
      robot.driveUnderway = false;
      if (state.traffic.knows(robot.name())) {
        state.traffic.moved(robot.name(), said.pose(), said.segment(), state.now);
      } else {
        isOnItsWay(robot, robot.told, said.pose(), said.segment(), said.released());
      }
    } else if (!robot.driveUnderway && !isBraking(robot)) {
      if (said.drive() == 0) {
        robot.told = null;
        robot.cancelling = false;
      }
      state.traffic.stands(robot.name(), said.pose(), robot.footprint, state.now);
    }
    if (said.localised()) {
      state.note(
          watch.see(
              robot.name(),
              said.pose().position(),
              said.obstacles(),
              state.robots.keySet(),
              state.now));
    }
  }

  /** Tells the history whom the robot did not let in; of many, a few. */
  private void noteStrangers(FloorRobot robot) {
    Optional<Fault> refusal =
        robot.errors.stream().filter(e -> e.code().equals(REFUSED)).findFirst();
    if (refusal.isPresent() && !robot.refusalNoted.plus(REFUSALS_EVERY).isAfter(state.now)) {
      robot.refusalNoted = state.now;
      note(
          robot,
          "robot.stranger",
          Phrase.STRANGER_NOT_LET_IN.with(robot.name(), refusal.get().text()));
    } else if (refusal.isEmpty()) {
      robot.refusalNoted = Instant.MIN;
    }
  }

  private void note(FloorRobot robot, String kind, Sentence text) {
    state.note(state.event(kind, robot.name(), EventRecord.SYSTEM, text));
  }

  private static boolean isBraking(FloorRobot robot) {
    return robot.mode == Mode.DRIVING || (robot.mode == Mode.HOLDING && robot.moving);
  }

  private void isOnItsWay(
      FloorRobot robot, StoredDrive drive, Pose pose, int segment, int released) {
    state.traffic.drives(
        robot.name(), pose, robot.footprint, drive.way(), segment, released, state.now);
  }

  private void phaseEnded(FloorRobot robot, PhaseEnd end) {
    Optional<Mission> mission =
        Optional.ofNullable(end.task()).flatMap(task -> state.missions.get(task));
    if (mission.isPresent()
        && (end.phase() == 3 || state.formations.isAtGoal(mission.get(), robot))) {
      missions.happened(mission.get().id(), new MissionEvent.PhaseEnded(robot.name(), end.phase()));
    } // else its way was changed meanwhile, or the task has ended
    // written in order: acknowledged only when what follows from the flag is safe
    state.writer.write(() -> {}, () -> robot.agent.tell(new RobotMessage.Acknowledge(end.drive())));
  }

  private void driveBegun(FloorRobot robot, StoredDrive drive) {
    robot.told = drive;
    if (drive.task() != null) {
      missions.happened(drive.task(), new MissionEvent.DriveStarted(robot.name(), drive.phase()));
    }
  }

  /** A drive may be so short that no state of the robot ever tells of it. */
  private static void driveTaken(FloorRobot robot, long drive) {
    if (robot.told != null && robot.told.seq() == drive) {
      robot.driveUnderway = false;
      robot.drive = drive;
      robot.reportedTask = robot.told.task(); // a cancel must name it
    }
  }

  /** A drive may have ended while a change of it was on its way; its next state tells. */
  private void rejected(FloorRobot robot, FloorMessage.Rejected m) {
    if (m.changing() == null) {
      refused(robot, m.reason());
    } else {
      robot.refusedChange = m;
    }
  }

  /** What the robot refused is given up: it stands, and is asked anew a little later. */
  private void refused(FloorRobot robot, String reason) {
    robot.driveUnderway = false;
    robot.cancelling = false;
    robot.trouble = Phrase.REFUSED_A_COMMAND.with(robot.name(), reason);
    robot.notBefore = state.now.plus(RETRY_AFTER);
    if (robot.drive != 0) {
      robot.cancelDrive();
    } else if (robot.pose != null) {
      robot.told = null;
      state.traffic.stands(robot.name(), robot.pose, robot.footprint, state.now);
    }
  }
}
