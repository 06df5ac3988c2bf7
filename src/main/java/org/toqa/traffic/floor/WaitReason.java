package org.toqa.traffic.floor;

import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Why a robot does not get on. */
public sealed interface WaitReason {

  /** Begins with a capital letter and ends without a full stop. */
  Sentence sentence();

  /** The robot that it waits for, if it is one. */
  default @Nullable String robot() {
    return null;
  }

  /** Another robot has cells that it needs, and will leave them. */
  record RobotPassing(String robot, Vec2 where) implements WaitReason {
    @Override
    public Sentence sentence() {
      return Phrase.WAITS_TO_PASS.with(robot, Sentence.of(where));
    }
  }

  /** Another robot is where it has to go. */
  record RobotStanding(String robot, Vec2 where) implements WaitReason {
    @Override
    public Sentence sentence() {
      return Phrase.WAITS_FOR_STANDING.with(robot, Sentence.of(where));
    }
  }

  /** Another robot is at its goal on the only path: a group, or one that it made room for. */
  record RobotAtGoal(String robot, Vec2 where) implements WaitReason {
    @Override
    public Sentence sentence() {
      return Phrase.WAITS_FOR_ONE_AT_GOAL.with(robot, Sentence.of(where));
    }
  }

  /** Another robot is there, and cannot be told to make room. */
  record RobotNotMovable(String robot, Vec2 where) implements WaitReason {
    @Override
    public Sentence sentence() {
      return Phrase.WAITS_FOR_FIXED.with(robot, Sentence.of(where));
    }
  }

  /** Another robot has its goal, or comes there first. */
  record GoalTaken(String robot, Vec2 where) implements WaitReason {
    @Override
    public Sentence sentence() {
      return Phrase.WAITS_FOR_PLACE.with(robot, Sentence.of(where));
    }
  }

  /** Something that the map does not show is on its only path. */
  record ObstacleOnPath(Vec2 where) implements WaitReason {
    @Override
    public Sentence sentence() {
      return Phrase.WAITS_FOR_OBSTACLE.with(Sentence.of(where));
    }
  }

  /** The floor itself has no path for a robot of its size. */
  record NoPath(Vec2 goal, double diameter) implements WaitReason {
    @Override
    public Sentence sentence() {
      return Phrase.WAITS_WITHOUT_WAY.with(Sentence.of(goal), diameter);
    }
  }

  /** The floor has a path, but against the direction of an area or of a place. */
  record AgainstOneWay(Vec2 goal, Vec2 where) implements WaitReason {
    @Override
    public Sentence sentence() {
      return Phrase.WAITS_AT_ONE_WAY.with(Sentence.of(goal), Sentence.of(where));
    }
  }

  /** No plan for all robots was found in the time there is; it is tried again. */
  record NoPlan(Vec2 goal) implements WaitReason {
    @Override
    public Sentence sentence() {
      return Phrase.WAITS_WITHOUT_PLAN.with(Sentence.of(goal));
    }
  }
}
