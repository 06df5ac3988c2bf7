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
 * nearer to its goal for {@value #MAX_STEPS_WITHOUT_PROGRESS} steps looks for another way and lets
 * all others go first for a few steps, how many is up to chance. If it has not even left its cell
 * for long, it may instead, by chance, go before all others: of a jam in which nobody moves, one
 * draws clear. And who has lost patience {@value #MAX_SETBACKS} times is at its wits' end: it and
 * those around it are sent on errands, to anywhere near for a few steps, so that no order in which
 * they stand is kept.
 */
final class RobotProgress {
  private static final int MAX_STEPS_WITHOUT_PROGRESS = 8;
  private static final int LONGEST_YIELD = 8;
  private static final int LONG_ON_VERTEX = 16;
  private static final int LONGEST_INSISTENCE = 16;
  private static final int MAX_SETBACKS = 12;
  private static final int LONGEST_DETOUR = 24;
  private static final int BEHIND_ALL = -1;
  private static final int BEFORE_ALL = Integer.MAX_VALUE / 2;
  private static final int[] NO_EDGES = {};

  /** Where it is. */
  private int state = NONE;

  private int vertex = NONE;

  /** For how many steps it has been on that vertex. */
  private int stepsOnVertex;

  /** A vertex, or {@code NONE} where it has none that it could reach. */
  private int goal = NONE;

  /** A vertex to go to before, or {@code NONE}; and for how many steps at most. */
  private int detour = NONE;

  private int detourStepsLeft;

  /** Costs to the target by state; null until they have been found. */
  private char @Nullable [] distances;

  /** The edges that {@link Guidance} was told of. */
  private int[] edges = NO_EDGES;

  /** What it meant to do from the last step on. */
  private int @Nullable [] operation;

  private int stepsTravelled;
  private int leastDistance;
  private int stepsWithoutProgress;
  private boolean needsOtherPath;
  private int setbacks;

  /** Steps for which it has another priority than its own, and which one. */
  private int exceptionStepsLeft;

  private int exceptionalPriority;

  int state() {
    return state;
  }

  int goal() {
    return goal;
  }

  /** Where it is going now: a vertex, or {@code NONE}. */
  int target() {
    return detour == NONE ? goal : detour;
  }

  char @Nullable [] distances() {
    return distances;
  }

  /** The edges that are announced for it, to withdraw them. */
  int[] takeEdges() {
    int[] taken = edges;
    edges = NO_EDGES;
    return taken;
  }

  int @Nullable [] operation() {
    return operation;
  }

  void setOperation(int[] newOperation) {
    operation = newOperation;
  }

  void setGoal(int newGoal) {
    goal = newGoal;
    stepsTravelled = 0;
    setbacks = 0;
    exceptionStepsLeft = 0;
    needsOtherPath = false;
    detour = NONE;
    distances = null;
  }

  boolean isStuck() {
    return setbacks >= MAX_SETBACKS;
  }

  void startDetour(int nearbyVertex) {
    detour = nearbyVertex;
    detourStepsLeft = LONGEST_DETOUR;
    exceptionalPriority = BEFORE_ALL;
    exceptionStepsLeft = LONGEST_DETOUR;
    setbacks = 0;
    distances = null;
  }

  private void endDetour() {
    detour = NONE;
    exceptionStepsLeft = 0;
    distances = null;
  }

  /** The roads have changed, and with them all numbers of states. */
  void forgetGraph() {
    distances = null;
    edges = NO_EDGES;
    goal = NONE;
    detour = NONE;
    operation = null;
  }

  /** Whether it has no way to its goal, or not one that it gets on with. */
  boolean needsPath() {
    return target() != NONE && (needsOtherPath || !hasPath());
  }

  boolean hasPath() {
    return distances != null && distances[state] != DistanceTables.UNREACHABLE;
  }

  void setPath(char[] newDistances, int[] newEdges) {
    distances = newDistances;
    edges = newEdges;
    leastDistance = DistanceTables.UNREACHABLE;
    stepsWithoutProgress = 0;
    needsOtherPath = false;
  }

  void advance(int newState, int newVertex, SplittableRandom random) {
    stepsOnVertex = newVertex == vertex ? stepsOnVertex + 1 : 0;
    state = newState;
    vertex = newVertex;
    exceptionStepsLeft = Math.max(0, exceptionStepsLeft - 1);
    if (detour != NONE && (vertex == detour || detourStepsLeft-- == 0)) {
      endDetour();
    }
    if (distances == null || vertex == goal || detour != NONE) {
      return;
    }
    stepsTravelled++;
    stepsWithoutProgress++;
    if (distances[state] < leastDistance) {
      leastDistance = distances[state];
      stepsWithoutProgress = 0;
    }
    if (stepsWithoutProgress > MAX_STEPS_WITHOUT_PROGRESS) {
      recordSetback(random);
    }
  }

  private void recordSetback(SplittableRandom random) {
    boolean insists = stepsOnVertex > LONG_ON_VERTEX && random.nextBoolean();
    exceptionalPriority = insists ? BEFORE_ALL : BEHIND_ALL;
    exceptionStepsLeft = 1 + random.nextInt(insists ? LONGEST_INSISTENCE : LONGEST_YIELD);
    stepsWithoutProgress = 0;
    setbacks++;
    needsOtherPath = true;
  }

  /**
   * @param urgency a head start, in steps
   * @return the more, the earlier its turn
   */
  int priority(int urgency) {
    int own = Math.min(BEFORE_ALL, stepsTravelled + Math.max(0, urgency));
    return exceptionStepsLeft > 0 ? exceptionalPriority : own;
  }
}
