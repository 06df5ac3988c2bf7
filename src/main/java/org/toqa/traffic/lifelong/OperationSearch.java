package org.toqa.traffic.lifelong;

import static org.toqa.traffic.RoadGraph.NONE;

import java.util.BitSet;
import java.util.SplittableRandom;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.mapf.StateGraph;

/**
 * Chooses an operation, some steps long, for every robot: priority inheritance with backtracking
 * over operations instead of single steps.
 *
 * <p>Idea: as in PIBT, robots choose in the order of their priority, and whoever blocks the choice
 * has to choose anew, itself pushing others. But what they choose are all uses of the next few
 * steps, so that a robot turns round in time, or backs out of an aisle, which no single step would
 * pay for. An operation may conflict with one other robot at most. Everybody always has an
 * operation, the rest of the last one if nothing else, so there is a valid plan at any time.
 *
 * <p>Afterwards robots picked by chance, of those that others keep from the best they could do
 * alone, choose again, pushing whomever, where that makes all of them together better off; what a
 * robot loses or gains counts the more, the longer it has been on its vertex. Where robots fill
 * almost all vertices, these chains and rings are what moves them, and more time finds more of
 * them.
 *
 * <p>Cost: listing a robot's operations, some hundred, is a tree walk that is cut where it meets a
 * second robot. A robot is asked {@value #MOST_VISITS} times at most for each that begins. Robots
 * exchange until the deadline, or until {@value #EFFORT_IN_VAIN_PER_ROBOT} operations for each that
 * could be better off were looked at in vain: who meets nobody costs one listing.
 *
 * <p>E. Yukhnevich and A. Andreychuk, "Enhancing PIBT via multi-action operations", 2025.
 */
final class OperationSearch {
  private static final int MOST_VISITS = 10;

  // Efforts are operations looked at, whole and in part.

  /** What robots exchange at most. */
  private static final long EXCHANGE_EFFORT_PER_ROBOT = 50_000;

  /** After so much without success, hardly any is left to be found. */
  private static final long EFFORT_IN_VAIN_PER_ROBOT = 5_000;

  private static final int LONGEST_CHAIN = 200;

  // A choice as one number, best first: cost, slowness, blocking robot + 1, actions.
  private static final int ACTION_BITS = 3;
  private static final int CODE_BITS = 15;
  private static final int ROBOT_BITS = 16;
  private static final int SLOWNESS_BITS = 8;
  private static final int ROBOT_SHIFT = CODE_BITS;
  private static final int SLOWNESS_SHIFT = ROBOT_SHIFT + ROBOT_BITS;
  private static final int COST_SHIFT = SLOWNESS_SHIFT + SLOWNESS_BITS;
  private static final int SLOWEST = (1 << SLOWNESS_BITS) - 1;

  /** The longest operation that a choice has room for. */
  private static final int MAX_DEPTH = CODE_BITS / ACTION_BITS;

  private final StateGraph graph;
  private final Operations operations;
  private final SplittableRandom random;
  private final boolean mayRotate;
  private final int depth;

  private SearchTask task =
      SearchTask.of(new int[0], new char[0][], new int[0], new BitSet(), new int[0], new int[0]);

  private int[] visits = new int[0];
  private int[] visitedIn = new int[0];
  private int round;
  private boolean[] isInChain = new boolean[0];

  /** Operations looked at so far, whole and in part: the time it takes, without a clock. */
  private long effort;

  /** The robots that wait for each other's choice, and for each its choices and its last one. */
  private final int[] chain = new int[LONGEST_CHAIN];

  private final long[][] choices = new long[LONGEST_CHAIN][];
  private final int[][] formers = new int[LONGEST_CHAIN][];
  private int listed;

  /** The rank that began; only robots behind it can be pushed. */
  private int beginner;

  private boolean isExchange;

  /** How many robots chose anew in the last chain, but for one. */
  private int lastLevel;

  /** By robot: the least cost that its operation could have, whoever is in the way. */
  private int[] leastCosts = new int[0];

  /** The robots whose operations cost more than that, in any order, and by robot its place. */
  private int[] unsatisfied = new int[0];

  private int[] places = new int[0];
  private int unsatisfiedCount;

  private Deadline deadline = Deadline.none();

  /**
   * @param mayRotate whether robots may drive round in a full ring, all at once
   */
  OperationSearch(
      StateGraph graph, Operations operations, boolean mayRotate, SplittableRandom random) {
    this.graph = graph;
    this.operations = operations;
    this.mayRotate = mayRotate;
    this.random = random;
    this.depth = operations.depth();
    if (depth > MAX_DEPTH) {
      throw new IllegalArgumentException(
          "An operation has at most " + MAX_DEPTH + " steps, not " + depth + ".");
    }
  }

  /** Gives the robots better operations; what they have is valid before and after. */
  void improve(SearchTask newTask, Deadline newDeadline) {
    task = newTask;
    deadline = newDeadline;
    if (visits.length != task.robots()) {
      visits = new int[task.robots()];
      visitedIn = new int[task.robots()];
      isInChain = new boolean[task.robots()];
    }
    effort = 0;
    chooseInOrder();
    if (task.fixed().cardinality() < task.robots()) {
      exchange();
    }
  }

  private void chooseInOrder() {
    isExchange = false;
    round++;
    for (int k = 0; k < task.robots() && !deadline.isPassed(); k++) {
      beginner = k;
      begin(task.order()[k]);
    }
  }

  private void exchange() {
    isExchange = true;
    beginner = NONE;
    findUnsatisfied();
    long last = effort + EXCHANGE_EFFORT_PER_ROBOT * task.robots();
    long lastInVain = effort + EFFORT_IN_VAIN_PER_ROBOT * unsatisfiedCount;
    while (unsatisfiedCount > 0 && effort < Math.min(last, lastInVain) && !deadline.isPassed()) {
      round++;
      effort++;
      if (begin(unsatisfied[random.nextInt(unsatisfiedCount)])) {
        for (int k = 0; k <= lastLevel; k++) {
          updateUnsatisfied(chain[k]);
        }
        lastInVain = effort + EFFORT_IN_VAIN_PER_ROBOT * unsatisfiedCount;
      }
    }
  }

  /** Looks for each robot at the best that it could do if it were alone. */
  private void findUnsatisfied() {
    if (leastCosts.length != task.robots()) {
      leastCosts = new int[task.robots()];
      unsatisfied = new int[task.robots()];
      places = new int[task.robots()];
    }
    unsatisfiedCount = 0;
    for (int robot : task.order()) {
      places[robot] = NONE;
      leastCosts[robot] =
          task.fixed().get(robot)
              ? cost(robot)
              : leastCost(robot, operations.state(robot, 0), 0, StateGraph.WAIT);
      updateUnsatisfied(robot);
    }
  }

  private void updateUnsatisfied(int robot) {
    int place = places[robot];
    if (cost(robot) > leastCosts[robot] && place == NONE) {
      places[robot] = unsatisfiedCount;
      unsatisfied[unsatisfiedCount++] = robot;
    } else if (cost(robot) <= leastCosts[robot] && place != NONE) {
      int last = unsatisfied[--unsatisfiedCount];
      unsatisfied[place] = last;
      places[last] = place;
      places[robot] = NONE;
    }
  }

  /**
   * The least cost of the robot's operations, whoever is in the way.
   *
   * @param state after {@code t} steps
   * @param former the last action
   */
  private int leastCost(int robot, int state, int t, int former) {
    if (t > 0 && graph.vertex(state) == task.goals()[robot]) {
      return t * Guidance.STEP;
    }
    if (t == depth) {
      return depth * Guidance.STEP + task.distances()[robot][state];
    }
    int least = Integer.MAX_VALUE;
    int actions = t < task.delays()[robot] ? 1 : graph.actionCount();
    for (int action = StateGraph.WAIT; action < actions; action++) {
      int next = graph.successor(state, action);
      if (next == NONE
          || (t > task.delays()[robot] && graph.isRedundantPair(former, action))
          || isClosed(state, action)) {
        continue;
      }
      least = Math.min(least, leastCost(robot, next, t + 1, action));
    }
    return least;
  }

  private boolean isClosed(int state, int action) {
    int direction = graph.direction(state, action);
    return direction != NONE && operations.isClosed(graph.vertex(state), direction);
  }

  private boolean begin(int robot) {
    if (task.fixed().get(robot)) {
      return false;
    }
    operations.take(robot);
    boolean isChosen = choose(robot, 0, 0);
    if (!isChosen) {
      operations.put(robot);
    }
    return isChosen;
  }

  /**
   * Finds an operation for a robot that is taken off, pushing others. Where there is none, or no
   * time left, answers false and leaves everything as it was.
   *
   * @param worse by how much the robots before it in the chain are worse off than they were
   */
  private boolean choose(int robot, int level, int worse) {
    visits[robot] = visits(robot) + 1;
    visitedIn[robot] = round;
    isInChain[robot] = true;
    chain[level] = robot;
    int[] operation = operations.of(robot);
    int[] former = keep(operation, level);
    int cost = isExchange ? cost(robot) : 0;
    int count = list(robot, level);
    long[] list = choices[level];
    boolean isChosen = false;
    for (int k = 0; k < count && !isChosen && !deadline.isPassed(); k++) {
      long choice = takeBest(list, k, count);
      int other = (int) (choice >>> ROBOT_SHIFT & ((1 << ROBOT_BITS) - 1)) - 1;
      int nowWorse = worse + task.weights()[robot] * ((int) (choice >>> COST_SHIFT) - cost);
      if (isExchange && nowWorse >= (other == NONE ? 0 : mostGain(other))) {
        break;
      }
      if (other != NONE && !isPushable(other)) {
        continue;
      }
      decode(choice, operation);
      isChosen = other == NONE ? settle(robot, level) : push(robot, other, level, nowWorse);
    }
    isInChain[robot] = false;
    if (!isChosen) {
      System.arraycopy(former, 0, operation, 0, former.length);
    }
    return isChosen;
  }

  /** Ends the chain: no other robot blocks this one. */
  private boolean settle(int robot, int level) {
    operations.put(robot);
    lastLevel = level;
    if (mayRotate) {
      return true;
    }
    for (int k = 0; k <= level; k++) {
      if (operations.closesRing(chain[k])) {
        operations.take(robot);
        return false;
      }
    }
    return true;
  }

  private boolean push(int robot, int other, int level, int worse) {
    if (level + 1 == LONGEST_CHAIN) {
      return false;
    }
    operations.take(other);
    operations.put(robot);
    if (choose(other, level + 1, worse)) {
      return true;
    }
    operations.take(robot);
    operations.put(other);
    return false;
  }

  private int visits(int robot) {
    return visitedIn[robot] == round ? visits[robot] : 0;
  }

  private boolean isPushable(int robot) {
    return !task.fixed().get(robot)
        && !isInChain[robot]
        && task.ranks()[robot] > beginner
        && visits(robot) < MOST_VISITS;
  }

  private int[] keep(int[] operation, int level) {
    if (formers[level] == null) {
      formers[level] = new int[depth + 1];
    }
    System.arraycopy(operation, 0, formers[level], 0, depth + 1);
    return formers[level];
  }

  /** Moves the best of the choices from {@code k} on to {@code k}. */
  private static long takeBest(long[] list, int k, int count) {
    int best = k;
    for (int j = k + 1; j < count; j++) {
      best = list[j] < list[best] ? j : best;
    }
    long choice = list[best];
    list[best] = list[k];
    list[k] = choice;
    return choice;
  }

  private void decode(long choice, int[] operation) {
    for (int t = 1; t <= depth; t++) {
      operation[t] = graph.successor(operation[t - 1], action((int) choice, t - 1));
    }
  }

  /** Waiting comes last, so that of two choices that are equal otherwise the livelier is taken. */
  private int digit(int action, int t) {
    return Math.floorMod(action - 1, graph.actionCount()) << (t * ACTION_BITS);
  }

  private int action(int code, int t) {
    int digit = code >>> (t * ACTION_BITS) & ((1 << ACTION_BITS) - 1);
    return (digit + 1) % graph.actionCount();
  }

  /** What the robot's operation leaves to be done, and the time it takes itself. */
  private int cost(int robot) {
    int[] operation = operations.of(robot);
    for (int t = 1; t <= depth; t++) {
      if (graph.vertex(operation[t]) == task.goals()[robot]) {
        return t * Guidance.STEP;
      }
    }
    return depth * Guidance.STEP + task.distances()[robot][operation[depth]];
  }

  /** By how much another operation could be better, at most. */
  private int mostGain(int robot) {
    return task.weights()[robot] * Math.max(0, cost(robot) - leastCosts[robot]);
  }

  /** Lists the operations of a robot that conflict with one other at most. */
  private int list(int robot, int level) {
    if (choices[level] == null) {
      int most = 1;
      for (int t = 0; t < depth; t++) {
        most *= graph.actionCount();
      }
      choices[level] = new long[most];
    }
    listed = 0;
    list(robot, choices[level], operations.state(robot, 0), 0, NONE, 0, 0, NONE);
    return listed;
  }

  /**
   * @param state after {@code t} steps
   * @param inWay the robot that these steps meet, or {@code NONE}
   * @param code the actions so far
   * @param sum of the costs to go after each of them
   * @param arrival the step that led to the goal, or {@code NONE}
   */
  private void list(
      int robot, long[] into, int state, int t, int inWay, int code, int sum, int arrival) {
    effort++;
    if (t == depth) {
      into[listed++] = choice(robot, task.distances()[robot][state], inWay, code, sum, arrival);
      return;
    }
    int vertex = graph.vertex(state);
    boolean mayGo = t >= task.delays()[robot];
    for (int action = 0; action < graph.actionCount(); action++) {
      int next = graph.successor(state, action);
      if (next == NONE
          || (!mayGo && action != StateGraph.WAIT)
          || (t > task.delays()[robot] && graph.isRedundantPair(action(code, t - 1), action))) {
        continue; // what it waits until it is there is no choice, and makes nothing redundant
      }
      int there = graph.vertex(next);
      if (isClosed(state, action)) {
        continue;
      }
      int direction = graph.direction(state, action);
      int met = operations.inWay(vertex, there, direction, t);
      if (met == Operations.SEVERAL
          || (met != NONE && met != inWay && (inWay != NONE || !isPushable(met)))) {
        continue;
      }
      boolean arrives = arrival == NONE && there == task.goals()[robot];
      int arrived = arrives ? t + 1 : arrival;
      list(
          robot,
          into,
          next,
          t + 1,
          met == NONE ? inWay : met,
          code | digit(action, t),
          arrived == NONE ? sum + task.distances()[robot][next] : sum,
          arrived);
    }
  }

  private long choice(int robot, int toGo, int inWay, int code, int sum, int arrival) {
    int cost;
    int slowness;
    if (arrival != NONE) {
      cost = arrival * Guidance.STEP;
      slowness = movesFrom(arrival, code);
    } else {
      cost = depth * Guidance.STEP + toGo;
      int lag = (sum - depth * toGo) / Guidance.STEP + SLOWEST / 4;
      slowness = task.goals()[robot] == NONE ? movesFrom(0, code) : Math.clamp(lag, 0, SLOWEST);
    }
    return (long) cost << COST_SHIFT
        | (long) slowness << SLOWNESS_SHIFT
        | (long) (inWay + 1) << ROBOT_SHIFT
        | code;
  }

  private int movesFrom(int step, int code) {
    int moves = 0;
    for (int t = step; t < depth; t++) {
      moves += action(code, t) == StateGraph.WAIT ? 0 : 1;
    }
    return moves;
  }
}
