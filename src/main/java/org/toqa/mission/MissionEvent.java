package org.toqa.mission;

import java.time.Instant;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.toqa.wording.Sentence;

/** What can happen to a mission. An event that is repeated or comes too late changes nothing. */
public sealed interface MissionEvent {

  /** What one of the mission's robots does, or what becomes of it. */
  sealed interface OfRobot extends MissionEvent {
    String robot();
  }

  /** The robot was told to drive the phase. */
  record DriveStarted(String robot, Phase phase) implements OfRobot {}

  /**
   * The robot has driven the phase to its end.
   *
   * @param stop the number, from 0, of the stop where it has come; see {@link
   *     Mission#stopNumber(Phase)}
   * @param at since when a wait there counts
   */
  record PhaseEnded(String robot, Phase phase, int stop, Instant at) implements OfRobot {

    /** Of a mission from start to goal, where nobody waits. */
    public PhaseEnded(String robot, Phase phase) {
      this(robot, phase, phase == Phase.TO_GOAL ? 1 : 0, Instant.EPOCH);
    }
  }

  /**
   * The time is over that the robots were to wait.
   *
   * @param stop the number of the stop, from 0
   */
  record WaitEnded(int stop) implements MissionEvent {}

  /**
   * The robot has charged as far as was ordered.
   *
   * @param stop the number of the stop, from 0
   * @param battery what it has, of 0 to 1
   */
  record ChargeEnded(int stop, double battery) implements MissionEvent {}

  /** The robot, driving home, was given another task. */
  record Retasked(String robot) implements OfRobot {}

  /**
   * Another robot takes the task over before the load is picked up.
   *
   * @param robot the one that had it
   */
  record Exchanged(String robot, String newRobot, Sentence why) implements OfRobot {}

  /** The robot, which shall set the load down, has stopped. */
  record Stopped(String robot, TaskPlace place) implements OfRobot {}

  /**
   * Nothing was heard of the robot for a few seconds.
   *
   * @param place where it was last, if that is known
   */
  record RobotLost(String robot, @Nullable TaskPlace place) implements OfRobot {}

  /**
   * The robot cannot go on: it says so, or it is lost for too long.
   *
   * @param why a clause about the robot, such as {@code reports an error}
   * @param place where it was last, if that is known
   */
  record RobotFailed(String robot, Sentence why, @Nullable TaskPlace place) implements OfRobot {}

  /** A person took the robot out of service. */
  record RobotWithdrawn(String robot, @Nullable TaskPlace place) implements OfRobot {}

  /**
   * The robot must charge, and does no more for the mission.
   *
   * @param why a clause, such as {@code its battery has 18 %}
   */
  record ChargingRequired(String robot, Sentence why) implements OfRobot {}

  /**
   * The robot's arm did not do what it should at the end of the phase.
   *
   * @param why a clause about the robot
   */
  record ActFailed(String robot, Phase phase, Sentence why, @Nullable TaskPlace place)
      implements OfRobot {}

  /** The robot, which was in trouble, can go on. */
  record RobotRecovered(String robot) implements OfRobot {}

  /**
   * The load that the mission left on the floor is carried away for another task.
   *
   * @param byTask the id of that one
   */
  record LoadFetched(long byTask) implements MissionEvent {}

  /** What a person wants of the task; {@link Mission#objectionTo} tells whether it can be. */
  sealed interface OperatorCommand extends MissionEvent {
    String user();

    /** The same, given while it is so with the mission's load on board. */
    default OperatorCommand given(LoadState now) {
      return this;
    }
  }

  /**
   * What the floor knows of a load on board.
   *
   * @param place where it is; null where nobody knows
   * @param driving those of its robots that are heard, and drive or would drive on
   */
  record LoadState(@Nullable TaskPlace place, Set<String> driving) {
    static final LoadState UNKNOWN = new LoadState(null, Set.of());

    public LoadState {
      driving = Set.copyOf(driving);
    }
  }

  /**
   * @param choice what becomes of a load that is on board; null where nobody said it
   */
  record Cancel(String user, @Nullable LoadChoice choice, LoadState load)
      implements OperatorCommand {
    public Cancel(String user, @Nullable LoadChoice choice) {
      this(user, choice, LoadState.UNKNOWN);
    }

    @Override
    public Cancel given(LoadState now) {
      return new Cancel(user, choice, now);
    }
  }

  /** The robots shall stop where they are. */
  record Hold(String user) implements OperatorCommand {}

  /**
   * The robots may go on; a leg that is not on hold may begin without the one before it.
   *
   * @param fromHoldOnly whether it is meant for what is on hold alone
   */
  record Resume(String user, boolean fromHoldOnly) implements OperatorCommand {
    public Resume(String user) {
      this(user, false);
    }
  }

  /**
   * @param priority higher is served first; 0 is usual
   * @param seen the priority that the user has seen: another one than that is not changed; null:
   *     whatever it is
   */
  record Prioritise(String user, int priority, @Nullable Integer seen) implements OperatorCommand {
    public Prioritise(String user, int priority) {
      this(user, priority, null);
    }
  }

  /**
   * Something else is ordered of a task that waits.
   *
   * @param order what is wanted now; its user and the moment it came stay those of the task
   * @param seen what the user has seen of the task: if anything of its order is not so any more,
   *     nothing is changed; null: whatever it is
   */
  record Edit(String user, TransportTask order, @Nullable TransportTask seen)
      implements OperatorCommand {}

  /**
   * The robots, which wait at a stop, may drive on.
   *
   * @param stop the number, from 0, of the one that the user has seen: at another one they stay;
   *     null: whichever it is
   */
  record GoOn(String user, @Nullable Integer stop) implements OperatorCommand {}

  record Answer(String user, Reply reply, LoadState load) implements OperatorCommand {
    public Answer(String user, Reply reply) {
      this(user, reply, LoadState.UNKNOWN);
    }

    @Override
    public Answer given(LoadState now) {
      return new Answer(user, reply, now);
    }
  }

  /**
   * It is another user's from now on.
   *
   * @param newUser his name
   * @param newOwner the id of his account
   */
  record HandOver(String user, String newUser, long newOwner) implements OperatorCommand {}

  /**
   * A person says that the load which the ended mission left on the floor lies elsewhere.
   *
   * @param place off walls
   */
  record MoveLoad(String user, TaskPlace place) implements OperatorCommand {}

  /**
   * A person says that the load which the ended mission left on the floor is not there any more.
   */
  record RemoveLoad(String user) implements OperatorCommand {}
}
