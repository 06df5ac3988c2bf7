package org.toqa.traffic.lifelong;

import static org.toqa.traffic.RoadGraph.NONE;

import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import org.toqa.traffic.DistanceTables;

/**
 * What a planner remembers of a robot from step to step.
 *
 * <p>Its priority grows with every step that it is on its way to a goal. But where two robots bar
 * each other's way, the more important may be just the one that has to back out: so who has not
 * come nearer to its goal for {@value #PATIENCE} steps lets all others go before it for a few
 * steps, how many is up to chance, and then has its former priority again.
 */
final class Traveller {
  private static final int PATIENCE = 8;
  private static final int LONGEST_YIELD = 8;
  private static final int[] NOWHERE = {};

  /** Where it is. */
  private int state;

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
  private int yielding;

  int state() {
    return state;
  }

  int goal() {
    return goal;
  }

  char @Nullable [] distances() {
    return distances;
  }

  int[] way() {
    return way;
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
    yielding = 0;
    forgetWay();
  }

  void forgetWay() {
    distances = null;
    way = NOWHERE;
  }

  /** The roads have changed, and with them all numbers of states. */
  void forgetRoads() {
    forgetWay();
    goal = NONE;
    operation = null;
  }

  /** Whether its way to the goal has to be looked for. */
  boolean isLost() {
    return goal != NONE
        && (distances == null || distances[state] == DistanceTables.UNREACHABLE);
  }

  void learn(char[] newDistances, int[] newWay) {
    distances = newDistances;
    way = newWay;
    nearest = DistanceTables.UNREACHABLE;
    stalled = 0;
  }

  void isAt(int newState, SplittableRandom random) {
    state = newState;
    if (distances == null || distances[state] == 0) {
      return;
    }
    travelled++;
    yielding = Math.max(0, yielding - 1);
    if (distances[state] < nearest) {
      nearest = distances[state];
      stalled = 0;
    } else if (++stalled > PATIENCE) {
      stalled = 0;
      yielding = 1 + random.nextInt(LONGEST_YIELD);
    }
  }

  /**
   * @param urgency a head start, in steps
   * @return the more, the earlier its turn; negative while it lets others go first
   */
  int priority(int urgency) {
    return yielding > 0 ? -1 : travelled + Math.max(0, urgency);
  }
}
