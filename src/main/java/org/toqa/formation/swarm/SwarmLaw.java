package org.toqa.formation.swarm;

import java.util.random.RandomGenerator;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Vec2;

/**
 * How a swarm turns: all robots drive at the same constant speed in the same direction, which
 * changes by a fixed angle w a step at most.
 *
 * <table>
 *   <caption>The turn, by who sees an obstacle</caption>
 *   <tr><td>left, or left and middle</td><td>right</td></tr>
 *   <tr><td>right, or right and middle</td><td>left</td></tr>
 *   <tr><td>all, or middle</td><td>as in the last step if that was left or right, else toward the
 *       target; if that is straight on, left or right at random</td></tr>
 *   <tr><td>left and right</td><td>straight on: the paper is silent</td></tr>
 *   <tr><td>none</td><td>toward the target</td></tr>
 * </table>
 *
 * <p>Against endless loops the opposite turn is taken with a small probability (epsilon-greedy).
 * The target is straight on where it is within half of w: a turn would lead farther from it.
 *
 * @param turnStep w, radians
 * @param epsilonSeen probability of the opposite turn where an obstacle is seen: 0.001 as published
 * @param epsilonFree the same where none is seen: 0.01
 */
public record SwarmLaw(double turnStep, double epsilonSeen, double epsilonFree) {

  /** As published. */
  public static SwarmLaw published(double turnStep) {
    return new SwarmLaw(turnStep, 0.001, 0.01);
  }

  /**
   * The swarm's motion.
   *
   * @param direction radians, counter-clockwise from map east, in (-pi, pi]
   * @param last the turn of the last step
   */
  public record Motion(double direction, Turn last) {
    /** Straight on in a direction. */
    public static Motion straight(double direction) {
      return new Motion(Angles.normalise(direction), Turn.STRAIGHT);
    }
  }

  /**
   * The next step.
   *
   * @param toTarget from the virtual leader, metres, map frame
   * @param random where the law needs chance
   */
  public Motion next(Motion motion, Sightings seen, Vec2 toTarget, RandomGenerator random) {
    Turn turn = turn(motion, seen, toTarget, random);
    double epsilon = seen.any() ? epsilonSeen : epsilonFree;
    if (random.nextDouble() < epsilon) {
      turn = turn.opposite();
    }
    return new Motion(Angles.normalise(motion.direction() + turn.sign() * turnStep), turn);
  }

  private Turn turn(Motion motion, Sightings seen, Vec2 toTarget, RandomGenerator random) {
    if (!seen.any()) {
      return toward(motion, toTarget);
    }
    if (seen.left() != seen.right()) {
      return seen.left() ? Turn.RIGHT : Turn.LEFT;
    }
    if (!seen.middle()) {
      return Turn.STRAIGHT;
    }
    if (motion.last() != Turn.STRAIGHT) {
      return motion.last();
    }
    Turn toward = toward(motion, toTarget);
    if (toward != Turn.STRAIGHT) {
      return toward;
    }
    return random.nextBoolean() ? Turn.LEFT : Turn.RIGHT;
  }

  private Turn toward(Motion motion, Vec2 toTarget) {
    double off = Angles.difference(motion.direction(), toTarget.angle());
    if (Math.abs(off) <= turnStep / 2) {
      return Turn.STRAIGHT;
    }
    return off > 0 ? Turn.LEFT : Turn.RIGHT;
  }
}
