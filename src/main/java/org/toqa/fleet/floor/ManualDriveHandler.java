package org.toqa.fleet.floor;

import java.time.Duration;
import java.util.UUID;
import org.apache.pekko.pattern.StatusReply;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.ManualAnswer;
import org.toqa.fleet.ManualOrder;
import org.toqa.fleet.floor.ManualControl.Session;
import org.toqa.geometry.Twist;
import org.toqa.traffic.floor.ManualStep;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Lets a person drive a robot by hand.
 *
 * <ol>
 *   <li>The first order begins it, where nobody drives the robot and it has no task and may drive;
 *       from then on it is given none. What it drives is ended first.
 *   <li>Each order is a step that the traffic grants or refuses, so short that the robot stands
 *       within half a second when no other comes: the robot needs nobody to stop it.
 *   <li>It is over when the person says so, when nothing was heard from him for {@link
 *       #LAPSES_AFTER}, and when the robot is held or cannot drive.
 * </ol>
 */
final class ManualDriveHandler {
  /** The robot stands long before: then it is anybody's again. */
  static final Duration LAPSES_AFTER = Duration.ofSeconds(10);

  /**
   * The robot stands by then, unless its step waits for the store: that shall not move it when the
   * store answers and nobody is there any more.
   */
  private static final Duration STANDS_WITHIN = Duration.ofMillis(500);

  /** Seconds of driving that a robot has which stands: it has still to speed up. */
  private static final double AHEAD_FROM_STANDING = 0.2;

  /** The same of one that drives. */
  private static final double AHEAD = 0.3;

  private final FloorState state;
  private final FloorReporter reports;
  private final DriveDispatcher drives;

  ManualDriveHandler(FloorState state, FloorReporter reports, DriveDispatcher drives) {
    this.state = state;
    this.reports = reports;
    this.drives = drives;
  }

  void drive(FloorMessage.DriveByHand m) {
    m.replyTo().tell(StatusReply.success(obey(m)));
  }

  private Answer<ManualAnswer> obey(FloorMessage.DriveByHand m) {
    FloorRobot robot = state.robots.get(m.robot());
    if (robot == null) {
      return FloorState.unknownRobot(m.robot());
    }
    ManualOrder order = m.order();
    Session session = robot.manual.session();
    if (session != null && !(session.lease().equals(order.lease()) && isOf(session, m.user()))) {
      return conflict(Phrase.DRIVEN_BY_ANOTHER.with(robot.name(), session.user()));
    }
    Sentence objection = objection(robot);
    if (objection != null) {
      return conflict(objection);
    }
    if (session == null && order.lease() != null) {
      return conflict(Phrase.MANUAL_DRIVE_IS_OVER.with(robot.name()));
    }
    if (session == null) {
      session = begin(robot, order, m.user());
    } else if (order.number() <= session.number()) {
      return answer(robot, session, null);
    } else {
      session = session.renewed(order, state.now);
      robot.manual.setSession(session);
    }
    return answer(robot, session, order.isStop() ? stop(robot) : step(robot, order));
  }

  private static boolean isOf(Session session, String user) {
    return session.user().equals(user);
  }

  private static Answer<ManualAnswer> conflict(Sentence sentence) {
    return new Answer.Conflict<>(sentence, null);
  }

  private static Answer<ManualAnswer> answer(
      FloorRobot robot, Session session, @Nullable Sentence refusal) {
    boolean isDriving = session.isReady() && !robot.isStanding() && !robot.drive.isCancelling();
    return new Answer.Accepted<>(
        new ManualAnswer(session.lease(), session.user(), isDriving, refusal));
  }

  /** Why nobody can drive it by hand now; null: somebody can. */
  private @Nullable Sentence objection(FloorRobot robot) {
    Sentence ofTask =
        state
            .missions
            .missionOf(robot.name())
            .map(mission -> Phrase.MANUAL_DRIVE_AFTER_TASK.with(robot.name(), mission.id()))
            .orElse(null);
    if (ofTask != null) {
      return ofTask;
    }
    if (robot.hold.isHeld()) {
      return robot.settings.isHeld()
          ? Phrase.LET_IT_GO_ON_FIRST.with(robot.name())
          : robot.hold.reason();
    }
    return robot.isFit() && state.traffic.hasRobot(robot.name())
        ? null
        : Phrase.CANNOT_DRIVE_NOW.with(robot.name());
  }

  private Session begin(FloorRobot robot, ManualOrder order, String user) {
    Session session =
        new Session(UUID.randomUUID(), user, order.number(), state.now, robot.isStanding());
    robot.manual.setSession(session);
    robot.drive.dropGoalWithoutTask();
    takeFromTraffic(robot);
    if (!session.isReady()) {
      stop(robot);
    }
    state.addToHistory(
        state.historyEvent(
            EventKind.ROBOT_MANUAL_BEGAN,
            robot.name(),
            user,
            Phrase.MANUAL_DRIVE_BEGAN.with(user, robot.name())));
    reports.send();
    return session;
  }

  private void takeFromTraffic(FloorRobot robot) {
    state.traffic.setGoal(robot.name(), null, state.now);
    state.traffic.setMovable(robot.name(), false);
  }

  private static @Nullable Sentence stop(FloorRobot robot) {
    if (robot.reported.drive() != 0 || robot.drive.order().isPending()) {
      robot.cancelDrive();
    }
    return null;
  }

  /** Why it does not go on; null: it does, or is still busy with what it was told before. */
  private @Nullable Sentence step(FloorRobot robot, ManualOrder order) {
    Session session = robot.manual.session();
    if (session == null || !session.isReady()) {
      return null;
    }
    boolean isStanding = robot.isStanding();
    if (!isStanding && !isOnItsDrive(robot)) {
      return null;
    }
    takeFromTraffic(robot);
    ManualStep step =
        state.traffic.takeManualStep(
            robot.name(), slowed(robot, order), isStanding ? AHEAD_FROM_STANDING : AHEAD);
    return switch (step) {
      case ManualStep.Granted(var command) -> {
        drives.sendDecision(robot, command);
        state.changed = true;
        yield null;
      }
      case ManualStep.NotNeeded() -> null;
      case ManualStep.Refused(var reason, var other) -> sentence(reason, other);
    };
  }

  /** Whether it has taken its drive and may be told how that goes on. */
  private static boolean isOnItsDrive(FloorRobot robot) {
    return robot.drive.order() instanceof DriveOrder.Driving driving
        && driving.drive().seq() == robot.reported.drive();
  }

  /** No faster than the robot can drive, on the same curve. */
  private static Twist slowed(FloorRobot robot, ManualOrder order) {
    var speeds = robot.reported.capabilities().speeds();
    double share =
        Math.min(
            speeds.forward() / Math.abs(order.speed()),
            speeds.spotRate() / Math.abs(order.turnRate()));
    return share < 1 ? order.twist().times(share) : order.twist();
  }

  private static Sentence sentence(ManualStep.Reason reason, @Nullable String other) {
    return switch (reason) {
      case WALL -> Phrase.WALL_IN_THE_WAY.with();
      case OBSTACLE -> Phrase.OBSTACLE_IN_THE_WAY.with();
      case ROBOT -> Phrase.ROBOT_IN_THE_WAY.with(String.valueOf(other));
      case DIRECTION -> Phrase.NOT_IN_THIS_DIRECTION.with();
    };
  }

  void end(FloorMessage.EndManualDrive m) {
    FloorRobot robot = state.robots.get(m.robot());
    if (robot == null) {
      m.replyTo().tell(StatusReply.success(FloorState.unknownRobot(m.robot())));
      return;
    }
    Session session = robot.manual.session();
    if (session != null && session.lease().equals(m.lease()) && isOf(session, m.user())) {
      end(robot, session, Phrase.MANUAL_DRIVE_ENDED.with(session.user(), robot.name()));
      reports.send();
    }
    m.replyTo().tell(StatusReply.success(new Answer.Accepted<>(reports.view(robot))));
  }

  /** To be called at each tick. */
  void update(FloorRobot robot) {
    Session session = robot.manual.session();
    if (session == null) {
      return;
    }
    Sentence objection = objection(robot);
    if (objection == null && session.heardAt().plus(LAPSES_AFTER).isBefore(state.now)) {
      objection = Phrase.NOTHING_HEARD_OF_DRIVER.with();
    }
    if (objection != null) {
      end(
          robot,
          session,
          Phrase.MANUAL_DRIVE_BROKEN_OFF.with(session.user(), robot.name(), objection));
    } else if (!session.isReady()) {
      awaitStanding(robot, session);
    } else if (session.heardAt().plus(STANDS_WITHIN).isBefore(state.now)) {
      stop(robot);
    }
  }

  private static void awaitStanding(FloorRobot robot, Session session) {
    if (robot.isStanding()) {
      robot.manual.setSession(session.ready());
    } else {
      stop(robot);
    }
  }

  private void end(FloorRobot robot, Session session, Sentence text) {
    robot.manual.setSession(null);
    stop(robot);
    String who = text.phrase() == Phrase.MANUAL_DRIVE_ENDED ? session.user() : EventRecord.SYSTEM;
    state.addToHistory(state.historyEvent(EventKind.ROBOT_MANUAL_ENDED, robot.name(), who, text));
    state.changed = true;
  }
}
