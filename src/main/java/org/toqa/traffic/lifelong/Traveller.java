package org.toqa.traffic.lifelong;

import static org.toqa.traffic.RoadGraph.NONE;

import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import org.toqa.traffic.DistanceTables;

/**
 * What a planner remembers of a robot from step to step.
 *
 * <p>Its priority grows with every step that it is on its way to a goal. But where robots bar each
 * other's way, the more important may be just the one that has to back out. So who has not come
 * nearer to its goal for {@value #PATIENCE} steps looks for another way and lets all others go
 * first for a few steps, how many is up to chance. If it has not even left its cell for long, it
 * may instead, by chance, go before all others: of a jam in which nobody moves, one draws clear.
 */
final class Traveller {
  private static final int PATIENCE = 8;
  private static final int LONGEST_YIELD = 8;
  private static final int LONG = 16;
  private static final int LONGEST_INSISTENCE = 16;
  private static final int BEHIND_ALL = -1;
  private static final int BEFORE_ALL = Integer.MAX_VALUE / 2;
  private static final int[] NOWHERE = {};

  /** Where it is. */
  private int state = NONE;

  private int vertex = NONE;

  /** For how many steps it has been on that vertex. */
  private int stood;

  /** A vertex, or {@code NONE} where it has none that it could reach. */
  private int goal = NONE;

  /** Costs to the goal by state; null until they have been found. */
  private char @Nullable [] distances;

  /** The edges that {@link Guidance} was told of. */
  private int[] way = NOWHERE;

  /** What it meant to do from the last step on. */
  private int @Nullable [] operation;

  private int travelled;
  private int nearest;
  private int stalled;
  private boolean hasLostPatience;

  /** Steps for which it has another priority than its own, and which one. */
  private int exceptional;

  private int exception;

  int state() {
    return state;
  }

  int goal() {
    return goal;
  }

  char @Nullable [] distances() {
    return distances;
  }

  /** The edges that are announced for it, to withdraw them. */
  int[] takeWay() {
    int[] taken = way;
    way = NOWHERE;
    return taken;
  }

  int @Nullable [] operation() {
    return operation;
  }

  void means(int[] newOperation) {
    operation = newOperation;
  }

  void headFor(int newGoal) {
    goal = newGoal;
    travelled = 0;
    exceptional = 0;
    hasLostPatience = false;
    distances = null;
  }

  /** The roads have changed, and with them all numbers of states. */
  void forgetRoads() {
    distances = null;
    way = NOWHERE;
    goal = NONE;
    operation = null;
  }

  /** Whether it has no way to its goal, or not one that it gets on with. */
  boolean seeksWay() {
    return goal != NONE && (hasLostPatience || !knowsWay());
  }

  boolean knowsWay() {
    return distances != null && distances[state] != DistanceTables.UNREACHABLE;
  }

  void learn(char[] newDistances, int[] newWay) {
    distances = newDistances;
    way = newWay;
    nearest = DistanceTables.UNREACHABLE;
    stalled = 0;
    hasLostPatience = false;
  }

  void isAt(int newState, int newVertex, SplittableRandom random) {
    stood = newVertex == vertex ? stood + 1 : 0;
    state = newState;
    vertex = newVertex;
    exceptional = Math.max(0, exceptional - 1);
    if (distances == null || vertex == goal) {
      return;
    }
    travelled++;
    stalled++;
    if (distances[state] < nearest) {
      nearest = distances[state];
      stalled = 0;
    }
    if (stalled > PATIENCE) {
      losePatience(random);
    }
  }

  private void losePatience(SplittableRandom random) {
    boolean insists = stood > LONG && random.nextBoolean();
    exception = insists ? BEFORE_ALL : BEHIND_ALL;
    exceptional = 1 + random.nextInt(insists ? LONGEST_INSISTENCE : LONGEST_YIELD);
    stalled = 0;
    hasLostPatience = true;
  }

  /**
   * @param urgency a head start, in steps
   * @return the more, the earlier its turn
   */
  int priority(int urgency) {
    int own = Math.min(BEFORE_ALL, travelled + Math.max(0, urgency));
    return exceptional > 0 ? exception : own;
  }
}
