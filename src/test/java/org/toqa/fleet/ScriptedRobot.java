package org.toqa.fleet;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.function.Function;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.toqa.arm.Arm;
import org.toqa.arm.ArmStep;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.link.RobotLink;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.Ack;
import org.toqa.link.message.AgentMessage.ActEnd;
import org.toqa.link.message.AgentMessage.ActFailure;
import org.toqa.link.message.AgentMessage.Acted;
import org.toqa.link.message.AgentMessage.ArmState;
import org.toqa.link.message.AgentMessage.Done;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.Reject;
import org.toqa.link.message.AgentMessage.RoomUse;
import org.toqa.link.message.AgentMessage.Speed;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.message.ServerMessage.AckActed;
import org.toqa.link.message.ServerMessage.AckDone;
import org.toqa.link.message.ServerMessage.Act;
import org.toqa.link.message.ServerMessage.Cancel;
import org.toqa.link.message.ServerMessage.Clear;
import org.toqa.link.message.ServerMessage.Command;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.link.message.ServerMessage.Extend;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.Hold;
import org.toqa.link.message.ServerMessage.Lead;
import org.toqa.link.message.ServerMessage.Locate;
import org.toqa.link.message.ServerMessage.Ping;
import org.toqa.link.message.ServerMessage.Release;
import org.toqa.link.message.ServerMessage.Resume;
import org.toqa.link.message.ServerMessage.Room;
import org.toqa.motion.DriveKind;
import org.toqa.motion.PassingRoom;
import org.toqa.motion.Segment;
import org.toqa.wording.Sentence;

/**
 * A robot at the other end of the link, without a link: it answers by the contract, drives one
 * released segment at each step of the test, and sees what the test lets it see. In a formation a
 * follower is where its leader takes it, and the leader is stopped while a follower does not
 * follow.
 */
public final class ScriptedRobot {
  static final double FOOTPRINT = 0.255;
  static final double MAX_SPEED = 0.5;
  static final double MAX_LOAD = 5;
  static final double MAX_TURN_RATE = 3.5;

  private final String name;
  private final ScriptedCondition condition = new ScriptedCondition();
  private final ScriptedDrive drive = new ScriptedDrive();
  private final ScriptedFormation formation = new ScriptedFormation(peer -> this);
  private final List<Command> obeyed = new ArrayList<>();
  private Pose pose;
  private int steps;
  private @Nullable Arm arm;
  private @Nullable Act act;
  private @Nullable ActEnd acted;
  private boolean held;
  private RobotLink.@Nullable Listener listener;
  private boolean connected;
  private long lastSeq;

  ScriptedRobot(String name, Vec2 at) {
    this.name = name;
    this.pose = new Pose(at.x(), at.y(), 0);
  }

  /** How it finds the robots that it carries together with. */
  synchronized void setPeers(Function<String, ScriptedRobot> byName) {
    formation.setPeers(byName);
  }

  synchronized void setObstacles(Vec2... points) {
    condition.obstacles = List.of(points);
  }

  /** It sees that on its path, and could pass it with room beside that. */
  synchronized void wantRoom(Vec2... seen) {
    setObstacles(seen);
    condition.roomUse = RoomUse.WANTED;
  }

  /** It is past that, or never took any room. */
  synchronized void returnRoom() {
    setObstacles();
    condition.roomUse = RoomUse.NONE;
    condition.room = null;
  }

  /** It finds its own way through free zones; before it connects. */
  synchronized void setFreeZones(boolean itDoes) {
    condition.freeZones = itDoes;
  }

  synchronized boolean hasRefusedRoom() {
    return condition.hasRefusedRoom;
  }

  synchronized void refuseRoom() {
    condition.refusesRoom = true;
  }

  /**
   * @param share of 0 to 1
   */
  synchronized void setBattery(double share) {
    condition.battery = share;
  }

  /** It drives a segment only after so many steps. */
  synchronized void setStepsPerSegment(int stepsForOne) {
    condition.stepsPerSegment = stepsForOne;
  }

  /**
   * To be said before the server hears of it.
   *
   * @param diameter metres
   */
  synchronized void setFootprint(double diameter) {
    condition.footprint = diameter;
  }

  /** To be said before the server hears of it. */
  synchronized void setKind(DriveKind kind) {
    condition.kind = kind;
  }

  /**
   * To be said before the server hears of it.
   *
   * @param speed metres a second; what is faster it refuses
   */
  synchronized void setMaxSpeed(double speed) {
    condition.maxSpeed = speed;
  }

  /**
   * To be said before the server hears of it.
   *
   * @param kilograms that it carries
   */
  synchronized void setMaxLoad(double kilograms) {
    condition.maxLoad = kilograms;
  }

  /** Likewise, in radians a second. */
  synchronized void setMaxTurnRate(double rate) {
    condition.maxTurnRate = rate;
  }

  /** From now on it says nothing, and drives nothing. */
  synchronized void fallSilent() {
    condition.mute = true;
  }

  /** From now on the server does not hear it, nor it the server; it drives on all the same. */
  synchronized void loseServer() {
    condition.isOutOfReach = true;
  }

  synchronized void findServer() {
    condition.isOutOfReach = false;
  }

  /** Its body is powered up anew: it has no drive, and does not know any more where it is. */
  synchronized void forgetPlace() {
    forgetPlace(new Pose(0, 0, 0));
  }

  /**
   * The same.
   *
   * @param odometry the pose that it reports then, in no frame that anybody knows
   */
  synchronized void forgetPlace(Pose odometry) {
    driveBlindly(odometry);
    drive.abandon();
    formation.cancel();
  }

  /** It does not know any more where it is, and drives on all the same, as none should. */
  synchronized void driveBlindly(Pose odometry) {
    condition.odometry = odometry;
  }

  /** It finds out by itself where it is. */
  synchronized void findPlace() {
    condition.odometry = null;
  }

  synchronized void speakAgain() {
    condition.mute = false;
  }

  /** It speaks, and does not move though it may. */
  synchronized void setStuck(boolean stuck) {
    condition.stuck = stuck;
  }

  /** Its drive is at an end a moment before it hears the next change of that. */
  synchronized void endBeforeNextChange() {
    condition.endsBeforeNextChange = true;
  }

  synchronized boolean isAwaitingChange() {
    return condition.endsBeforeNextChange;
  }

  /** It comes aside by so much, metres on the map, and stands until it has a new drive. */
  synchronized void shove(Vec2 by) {
    pose = new Pose(pose.x() + by.x(), pose.y() + by.y(), pose.theta());
    condition.offPath = true;
  }

  /** From now on its body cannot drive. */
  synchronized void breakDown(String code) {
    condition.fault = new Fault(code, "It cannot drive.");
  }

  /** Its body has stopped itself, until that is cleared. */
  synchronized void stopItself(String code) {
    condition.fault = new Fault(code, "It has stopped itself.", true);
  }

  /** From now on it does not hear that a formation has ended. */
  synchronized void missEnd() {
    condition.missesEnd = true;
  }

  /** Its followers will not be where it is told that they are. */
  synchronized void loseFollowers() {
    formation.loseFollowers();
  }

  /** From now on it follows nobody. */
  synchronized void stay() {
    condition.stays = true;
  }

  /** From now on it answers such commands with {@code reject}. */
  synchronized void refuse(Predicate<Command> commands) {
    condition.refused = commands;
  }

  /**
   * From now on it reports, but hears no command.
   *
   * @param overThisConnectionOnly as where one half of that is dead
   */
  synchronized void goDeaf(boolean overThisConnectionOnly) {
    condition.deaf = true;
    condition.hearsOverAnother = overThisConnectionOnly;
  }

  /**
   * Its states cannot be understood.
   *
   * @param fault what is wrong with them; null: they can again
   */
  synchronized void setStateFault(@Nullable String fault) {
    condition.stateFault = fault;
  }

  /** As one does whose stops have just changed. */
  synchronized void refuseToClear() {
    condition.refusesClear = true;
  }

  /** So many commands to clear do not reach it. */
  synchronized void loseClears(int number) {
    condition.lostClears = number;
  }

  /** It has an arm, that acts until {@link #endAct}. */
  synchronized void setArm(Arm mounted) {
    arm = mounted;
  }

  /** What its arm does; null: nothing. */
  synchronized @Nullable Act act() {
    return act;
  }

  /** Its arm ends what it does, and says so until that is acknowledged. */
  synchronized void endAct(@Nullable ActFailure failure, @Nullable Double weight) {
    Act ended = Objects.requireNonNull(act);
    acted = new ActEnd(ended.seq(), ended.task(), ended.phase(), ended.action(), failure, weight);
    act = null;
  }

  /** Its daemon is started anew: the arm does not go on by itself. */
  synchronized void forgetAct() {
    act = null;
  }

  synchronized boolean hasUnacknowledgedAct() {
    return acted != null;
  }

  synchronized void repair() {
    condition.fault = null;
  }

  /** What stopped its body is over at the robot: it has no drive any more. */
  synchronized void endStop() {
    condition.fault = null;
    drive.abandon();
  }

  synchronized boolean isHeld() {
    return held;
  }

  /** Falls silent for good with its connection; what comes next begins with a hello. */
  synchronized void loseConnection() {
    condition.mute = true;
    connected = false;
    Objects.requireNonNull(listener).disconnected(Sentence.verbatim("cut"));
  }

  /** All that it was told and did, in order, without pings. */
  synchronized List<Command> obeyed() {
    return List.copyOf(obeyed);
  }

  synchronized boolean isDriving() {
    return drive.number() != 0;
  }

  synchronized Vec2 position() {
    return pose.position();
  }

  synchronized RobotLink link(RobotLink.Listener heard) {
    listener = heard;
    connected = false;
    condition.deaf &= !condition.hearsOverAnother;
    return new RobotLink() {
      @Override
      public void send(ServerMessage message) {
        hear(message);
      }

      @Override
      public void close() {
        closed(heard);
      }
    };
  }

  private synchronized void closed(RobotLink.Listener heard) {
    listener = heard.equals(listener) ? null : listener;
  }

  synchronized boolean hasUnacknowledgedEnd() {
    return drive.done() != null;
  }

  /** A moment of its life: a segment, and what it says then. */
  synchronized void step() {
    if (condition.mute || listener == null) {
      return;
    }
    if (!connected) {
      connected = true;
      listener.connected(hello());
      return;
    }
    steps++;
    boolean mayMove =
        condition.canMove()
            && !held
            && steps % condition.stepsPerSegment == 0
            && formation.missing() == null;
    keepPlace();
    Pose next = mayMove ? drive.nextPose() : null;
    pose = next == null ? pose : next;
    if (!held && drive.isAtGoal()) {
      drive.end();
      formation.endLeading();
    }
    if (condition.isOutOfReach) {
      return;
    }
    String stateFault = condition.stateFault;
    if (stateFault == null) {
      listener.received(state());
    } else {
      listener.passedOver(0, 1);
      listener.misunderstood(stateFault);
    }
    Done done = drive.done();
    if (done != null) {
      listener.received(done);
    }
    if (acted != null) {
      listener.received(Acted.of(acted));
    }
  }

  synchronized boolean isKeepingPlace(long task) {
    return formation.isFollowing(task) && !condition.mute && !held && condition.fault == null;
  }

  ScriptedFormation formation() {
    return formation;
  }

  private synchronized Pose pose() {
    return pose;
  }

  private boolean isLocalised() {
    return condition.odometry == null;
  }

  private Pose reportedPose() {
    return Objects.requireNonNullElse(condition.odometry, pose);
  }

  private void keepPlace() {
    Follow order = formation.following();
    if (order == null) {
      return;
    }
    ScriptedRobot leader = formation.leader();
    pose = leader.pose().compose(new Pose(order.offset().x(), order.offset().y(), 0));
    if (formation.hasLeaderEnded() && !condition.missesEnd) {
      drive.end();
      formation.endFollowing();
    }
  }

  private synchronized void hear(ServerMessage message) {
    if (!connected || condition.deaf || condition.isOutOfReach) {
      return;
    }
    if (message instanceof Clear && condition.lostClears-- > 0) {
      return;
    }
    if (message instanceof AckActed(long seq)) {
      acted = acted != null && acted.act() == seq ? null : acted;
    } else if (message instanceof AckDone ack) {
      drive.acknowledge(ack);
    } else if (message instanceof Command command) {
      if (message instanceof Ping || command.seq() <= lastSeq) {
        say(new Ack(command.seq()));
        return;
      }
      lastSeq = command.seq();
      boolean isChange = command instanceof Extend || command instanceof Release;
      if (isChange && (condition.endsBeforeNextChange || !drive.hasTrajectory())) {
        condition.endsBeforeNextChange = false;
        drive.abandon();
        say(new Reject(command.seq(), "There is no such drive any more; the robot has none."));
        return;
      }
      if (command instanceof Clear && condition.refusesClear) {
        say(new Reject(command.seq(), "What stops the robot has changed."));
        return;
      }
      if (command instanceof Room && condition.refusesRoom) {
        condition.hasRefusedRoom = true;
        say(new Reject(command.seq(), "There is no drive any more."));
        return;
      }
      if (condition.refused.test(command)) {
        say(new Reject(command.seq(), "No."));
        return;
      }
      if (!isLocalised() && isDriveOrder(command)) {
        say(new Reject(command.seq(), "The robot does not know where it is."));
        return;
      }
      if (isTooFast(command)) {
        say(new Reject(command.seq(), "The robot cannot drive so fast."));
        return;
      }
      obey(command);
      say(new Ack(command.seq()));
    }
  }

  private static boolean isDriveOrder(Command command) {
    return command instanceof Drive || command instanceof Lead || command instanceof Follow;
  }

  private boolean isTooFast(Command command) {
    List<Segment> segments =
        switch (command) {
          case Drive d -> d.segments();
          case Extend e -> e.segments();
          default -> List.of();
        };
    return !segments.stream().allMatch(condition::canDrive)
        || formation.followers().stream()
            .anyMatch(follower -> !segments.stream().allMatch(follower.condition::canDrive));
  }

  private void obey(Command command) {
    obeyed.add(command);
    switch (command) {
      case Lead l -> formation.lead(l);
      case Follow f -> {
        if (!condition.stays) {
          formation.follow(f);
          drive.follow(f);
        }
      }
      case Act a -> {
        act = a;
        acted = null;
      }
      case Hold h -> held = true;
      case Clear c -> {
        condition.fault = null;
        drive.abandon();
        formation.cancel();
      }
      case Resume r -> held = false;
      case Drive d -> {
        acted = null;
        condition.offPath = false;
        drive.start(d);
      }
      case Extend e -> drive.extend(e);
      case Release r -> drive.release(r);
      case Room r -> {
        condition.room = new PassingRoom(r.from(), r.to(), r.left(), r.right(), r.zone());
        condition.roomUse = RoomUse.HELD;
      }
      case Locate l -> {
        pose = l.pose();
        condition.odometry = null;
      }
      case Cancel c -> {
        if (Objects.equals(c.task(), drive.task())) {
          drive.cancel();
          formation.cancel();
        }
      }
      default -> {}
    }
  }

  private void say(AgentMessage message) {
    if (!condition.mute && listener != null) {
      listener.received(message);
    }
  }

  private Mode mode() {
    if (condition.fault != null) {
      return Mode.ERROR;
    }
    if (held) {
      return Mode.HOLDING;
    }
    if (formation.following() != null) {
      return Mode.FOLLOWING;
    }
    return drive.number() == 0 ? Mode.IDLE : Mode.DRIVING;
  }

  private Hello hello() {
    return new Hello(
        AgentMessage.VERSION,
        name,
        condition.maxLoad,
        condition.maxSpeed,
        condition.maxTurnRate,
        condition.footprint,
        condition.sensorRange,
        condition.kind.word(),
        0,
        isLocalised(),
        reportedPose(),
        mode(),
        drive.task(),
        drive.phase(),
        formation.role(),
        drive.number(),
        drive.segment(),
        drive.released(),
        lastSeq,
        null,
        arm,
        act == null ? null : act.seq(),
        acted,
        condition.room,
        condition.freeZones,
        true);
  }

  private State state() {
    return new State(
        0,
        isLocalised(),
        reportedPose(),
        new Speed(0, 0),
        mode(),
        drive.task(),
        drive.phase(),
        formation.role(),
        drive.number(),
        drive.segment(),
        drive.released(),
        condition.battery,
        List.of(),
        condition.obstacles,
        null,
        null,
        arm == null
            ? null
            : new ArmState(
                arm.rest(),
                null,
                act == null ? null : act.seq(),
                act == null ? null : ArmStep.REACH),
        condition.roomUse,
        condition.faults(formation.stopReason()));
  }
}
