package org.toqa.traffic.lifelong;

import static org.toqa.traffic.RoadGraph.NONE;

import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import org.toqa.traffic.DistanceTables;

/**
 * What a planner remembers of a robot from step to step.
 *
 * <p>Its priority grows with every step that it is on its path to a goal, and as it comes nearer
 * ({@link RobotPriority}). But where robots block each other, the more important may be just the
 * one that has to back out. So who has not come nearer to its goal for {@value
 * #MAX_STEPS_WITHOUT_PROGRESS} steps looks for another path and lets all others go first for a few
 * steps, how many is up to chance. If it has not even left its cell for long, it may instead, by
 * chance, go before all others: of a jam in which nobody moves, one draws clear. And who has had
 * {@value #MAX_SETBACKS} such setbacks is stuck: it and those around it are sent on detours, to
 * anywhere near for a few steps, so that no order in which they are is kept.
 */
final class RobotProgress {
  private static final int MAX_STEPS_WITHOUT_PROGRESS = 8;
  private static final int LONGEST_YIELD = 8;
  private static final int LONG_ON_VERTEX = 16;
  private static final int LONGEST_INSISTENCE = 16;
  private static final int MAX_SETBACKS = 12;
  private static final int MAX_WEIGHT = 32;

  /** Steps on a vertex after which a robot counts for one more. */
  private static final int STEPS_PER_WEIGHT = 10;

  private static final int LONGEST_DETOUR = 24;
  private static final int[] NO_EDGES = {};

  /** Where it is. */
  private int state = NONE;

  private int vertex = NONE;

  /** For how many steps it has been on that vertex. */
  private int stepsOnVertex;

  /** A vertex, or {@code NONE} where it has none that it could reach. */
  private int goal = NONE;

  private final Detour detour = new Detour();
  private final RobotPriority priority = new RobotPriority();

  /** Costs to the target by state; null until they have been found. */
  private char @Nullable [] distances;

  /** The edges that {@link Guidance} was told of. */
  private int[] edges = NO_EDGES;

  /** In which plan its path was found. */
  private int pathPlan;

  /** What it was going to do from the last step on. */
  private int @Nullable [] operation;

  private int leastDistance;
  private int stepsWithoutProgress;
  private boolean needsOtherPath;
  private int setbacks;

  int state() {
    return state;
  }

  int goal() {
    return goal;
  }

  /** Where it is going now: a vertex, or {@code NONE}. */
  int target() {
    return detour.isActive() ? detour.vertex() : goal;
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

  /** It stays where it is. */
  void forgetOperation() {
    operation = null;
  }

  void setGoal(int newGoal) {
    goal = newGoal;
    priority.restart();
    setbacks = 0;
    needsOtherPath = false;
    detour.end();
    distances = null;
  }

  boolean isStuck() {
    return setbacks >= MAX_SETBACKS;
  }

  void startDetour(int nearbyVertex) {
    detour.start(nearbyVertex, LONGEST_DETOUR);
    priority.goBeforeAll(LONGEST_DETOUR);
    setbacks = 0;
    distances = null;
  }

  private void endDetour() {
    detour.end();
    priority.endException();
    distances = null;
  }

  /** The roads have changed, and with them all numbers of states. */
  void forgetGraph() {
    distances = null;
    edges = NO_EDGES;
    goal = NONE;
    detour.end();
    operation = null;
  }

  /** Whether it has no path to its goal, or none that it gets on with. */
  boolean needsPath() {
    return target() != NONE && (needsOtherPath || !hasPath());
  }

  boolean hasPath() {
    return distances != null && distances[state] != DistanceTables.UNREACHABLE;
  }

  /**
   * @param plan in which it was found, counted from 1
   */
  void setPath(char[] newDistances, int[] newEdges, int plan) {
    distances = newDistances;
    edges = newEdges;
    pathPlan = plan;
    leastDistance = DistanceTables.UNREACHABLE;
    stepsWithoutProgress = 0;
    needsOtherPath = false;
  }

  /** Another path to the same target: what it has come nearer so far still counts. */
  void renewPath(char[] newDistances, int[] newEdges, int plan) {
    if (distances != null && leastDistance != DistanceTables.UNREACHABLE) {
      leastDistance += newDistances[state] - distances[state];
    }
    distances = newDistances;
    edges = newEdges;
    pathPlan = plan;
  }

  int pathPlan() {
    return pathPlan;
  }

  void advance(int newState, int newVertex, int steps, SplittableRandom random) {
    state = newState;
    for (int step = 0; step < steps; step++) {
      countStep(newVertex, random);
    }
    vertex = newVertex;
  }

  private void countStep(int newVertex, SplittableRandom random) {
    stepsOnVertex = newVertex == vertex ? stepsOnVertex + 1 : 0;
    vertex = newVertex;
    priority.countStep();
    if (detour.countStep(vertex)) {
      endDetour();
    }
    if (distances == null || vertex == goal || detour.isActive()) {
      return;
    }
    priority.countStepTravelled();
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
    if (insists) {
      priority.goBeforeAll(1 + random.nextInt(LONGEST_INSISTENCE));
    } else {
      priority.goBehindAll(1 + random.nextInt(LONGEST_YIELD));
    }
    stepsWithoutProgress = 0;
    setbacks++;
    needsOtherPath = true;
  }

  /** What a step of its counts for beside one of another robot: more, while it waits for long. */
  int weight() {
    return target() == NONE || vertex == goal
        ? 1
        : Math.min(MAX_WEIGHT, 1 + stepsOnVertex / STEPS_PER_WEIGHT);
  }

  /**
   * @param urgency a head start, in steps
   * @return the more, the earlier its turn
   */
  int priority(int urgency) {
    char[] known = distances;
    int toGo = known == null ? DistanceTables.UNREACHABLE : known[state];
    return priority.value(urgency, toGo);
  }
}
