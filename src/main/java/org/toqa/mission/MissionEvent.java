package org.toqa.mission;

import org.jspecify.annotations.Nullable;
import org.toqa.wording.Sentence;

/** What can happen to a mission. An event that is repeated or comes too late changes nothing. */
public sealed interface MissionEvent {

  /** A word for programs that read the history. */
  String kind();

  /** What one of the mission's robots does, or what becomes of it. */
  sealed interface OfRobot extends MissionEvent {
    String robot();
  }

  /** The robot was sent its way for the phase. */
  record DriveStarted(String robot, int phase) implements OfRobot {
    @Override
    public String kind() {
      return "task.started";
    }
  }

  /** The robot has driven the phase to its end. */
  record PhaseEnded(String robot, int phase) implements OfRobot {
    @Override
    public String kind() {
      return switch (phase) {
        case 1 -> "task.at-object";
        case 2 -> "task.delivered";
        default -> "task.parked";
      };
    }
  }

  /** The robot, on its way home, was given another task. */
  record Retasked(String robot) implements OfRobot {
    @Override
    public String kind() {
      return "task.retasked";
    }
  }

  /**
   * Another robot takes the task over before the load is picked up.
   *
   * @param robot the one that had it
   */
  record Exchanged(String robot, String newRobot, Sentence why) implements OfRobot {
    @Override
    public String kind() {
      return "task.exchanged";
    }
  }

  /** The robot, which shall set the load down, has come to a stand. */
  record Stopped(String robot, TaskPlace place) implements OfRobot {
    @Override
    public String kind() {
      return "task.set-down";
    }
  }

  /**
   * Nothing was heard of the robot for a few seconds.
   *
   * @param place where it was last, if that is known
   */
  record RobotLost(String robot, @Nullable TaskPlace place) implements OfRobot {
    @Override
    public String kind() {
      return "task.robot-lost";
    }
  }

  /**
   * The robot cannot go on: it says so, or it is lost for too long.
   *
   * @param why a clause about the robot, such as {@code reports an error}
   * @param place where it was last, if that is known
   */
  record RobotFailed(String robot, Sentence why, @Nullable TaskPlace place) implements OfRobot {
    @Override
    public String kind() {
      return "task.robot-failed";
    }
  }

  /** A person took the robot out of service. */
  record RobotWithdrawn(String robot, @Nullable TaskPlace place) implements OfRobot {
    @Override
    public String kind() {
      return "task.robot-withdrawn";
    }
  }

  /**
   * The robot must charge, and does no more for the mission.
   *
   * @param why a clause, such as {@code its battery has 18 %}
   */
  record ChargingRequired(String robot, Sentence why) implements OfRobot {
    @Override
    public String kind() {
      return "task.robot-charges";
    }
  }

  /** The robot, which was in trouble, can go on. */
  record RobotRecovered(String robot) implements OfRobot {
    @Override
    public String kind() {
      return "task.robot-back";
    }
  }

  /** What a person wants of the task; {@link Mission#objectionTo} tells whether it can be. */
  sealed interface OperatorCommand extends MissionEvent {
    String user();
  }

  /**
   * @param choice what becomes of a load that is on board; null where nobody said it
   */
  record Cancel(String user, @Nullable LoadChoice choice) implements OperatorCommand {
    @Override
    public String kind() {
      return "task.cancelled";
    }
  }

  /** The robots shall stop where they are. */
  record Hold(String user) implements OperatorCommand {
    @Override
    public String kind() {
      return "task.held";
    }
  }

  record Resume(String user) implements OperatorCommand {
    @Override
    public String kind() {
      return "task.resumed";
    }
  }

  /**
   * @param priority higher is served first; 0 is usual
   */
  record Prioritise(String user, int priority) implements OperatorCommand {
    @Override
    public String kind() {
      return "task.prioritised";
    }
  }

  record Answer(String user, Reply reply) implements OperatorCommand {
    @Override
    public String kind() {
      return "task.answered";
    }
  }
}
