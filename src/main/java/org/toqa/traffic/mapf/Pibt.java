package org.toqa.traffic.mapf;

import static org.toqa.traffic.RoadGraph.DIRECTIONS;
import static org.toqa.traffic.RoadGraph.NONE;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.toqa.traffic.RoadGraph;

/**
 * One step for all robots at once, by priority inheritance with backtracking (PIBT).
 *
 * <p>Idea: robots choose in the order of their priority, each the neighbour nearest to its goal.
 * Whoever is there must choose next, inheriting the priority; if it finds no place, the chooser
 * takes its next best. A swap that a narrow place calls for is brought about by letting the robots
 * of a pair walk away together until there is room to pass: one pulls the other behind it.
 *
 * <p>Cost: a robot chooses at most once in a step, so a step is linear in the robots.
 *
 * <p>K. Okumura et al., "Priority inheritance with backtracking for iterative multi-agent path
 * finding", AIJ 2022; the swap: K. Okumura, "Improving LaCAM for scalable eventually optimal
 * multi-agent pathfinding", IJCAI 2023.
 */
final class Pibt implements StepSearch {
  /** A robot has four neighbours and its own place to choose from. */
  private static final int CHOICES = DIRECTIONS + 1;

  private static final int CHOICE_BITS = 3;
  private static final int TIE_BITS = 12;

  private final RoadGraph roads;
  private final char[][] distances;
  private final int[] goals;
  private final SplittableRandom random;
  private final boolean mayRotate;

  /** Who is on a vertex before the step, and who after. */
  private final int[] before;

  private final int[] after;

  private final int[] from;
  private final int[] to;

  /** Each robot's choices in the order of its preference, and how far it is through them. */
  private final int[] choices;

  private final int[] choiceCount;
  private final int[] nextChoice;
  private final int[] pulled;
  private final int[] chain;

  /**
   * @param distances a table a robot: steps to its goal
   * @param goals a vertex a robot
   * @param mayRotate whether robots in a ring may all move on at once
   */
  Pibt(
      RoadGraph roads,
      char[][] distances,
      int[] goals,
      SplittableRandom random,
      boolean mayRotate) {
    this.roads = roads;
    this.distances = distances;
    this.goals = goals;
    this.random = random;
    this.mayRotate = mayRotate;
    int robots = goals.length;
    before = new int[roads.vertexCount()];
    after = new int[roads.vertexCount()];
    Arrays.fill(before, NONE);
    Arrays.fill(after, NONE);
    from = new int[robots];
    to = new int[robots];
    choices = new int[robots * CHOICES];
    choiceCount = new int[robots];
    nextChoice = new int[robots];
    pulled = new int[robots];
    chain = new int[robots];
    Arrays.fill(to, NONE);
  }

  @Override
  public boolean step(int[] places, int[] order, Lacam.Constraints constraints, int[] next) {
    System.arraycopy(places, 0, from, 0, from.length);
    for (int robot = 0; robot < from.length; robot++) {
      before[from[robot]] = robot;
    }
    boolean isComplete = applyConstraints(constraints) && chooseInOrder(order);
    if (isComplete) {
      System.arraycopy(to, 0, next, 0, to.length);
    }
    clear();
    return isComplete;
  }

  private void clear() {
    for (int robot = 0; robot < from.length; robot++) {
      before[from[robot]] = NONE;
      if (to[robot] != NONE) {
        after[to[robot]] = NONE;
        to[robot] = NONE;
      }
    }
  }

  private boolean applyConstraints(Lacam.Constraints constraints) {
    for (Lacam.Constraints o = constraints; o.depth() > 0; o = o.parent()) {
      int robot = o.robot();
      int place = o.place();
      int occupant = before[place];
      boolean meets = after[place] != NONE;
      boolean swaps = occupant != NONE && occupant != robot && to[occupant] == from[robot];
      if (meets || swaps || (!mayRotate && closesRing(robot, place))) {
        return false;
      }
      to[robot] = place;
      after[place] = robot;
    }
    return true;
  }

  private boolean chooseInOrder(int[] order) {
    for (int robot : order) {
      if (to[robot] == NONE && !choose(robot)) {
        return false;
      }
    }
    return true;
  }

  /** Priority inheritance as a loop: {@code chain} holds who waits for whom. */
  private boolean choose(int first) {
    int depth = 0;
    chain[0] = first;
    prepare(first);
    while (depth >= 0) {
      int robot = chain[depth];
      int here = from[robot];
      int occupant = NONE;
      boolean isPlaced = false;
      while (!isPlaced && nextChoice[robot] < choiceCount[robot]) {
        int place = choices[robot * CHOICES + nextChoice[robot]++];
        occupant = before[place];
        if (after[place] != NONE
            || (occupant != NONE && to[occupant] == here)
            || (!mayRotate && closesRing(robot, place))) {
          continue;
        }
        after[place] = robot;
        to[robot] = place;
        isPlaced = true;
      }
      if (!isPlaced) {
        after[here] = robot;
        to[robot] = here;
        depth--;
      } else if (occupant != NONE && to[occupant] == NONE) {
        chain[++depth] = occupant;
        prepare(occupant);
      } else {
        pull(depth);
        return true;
      }
    }
    return false;
  }

  /** Whether a robot that goes to a place would follow robots that end up following itself. */
  private boolean closesRing(int robot, int place) {
    int ahead = before[place];
    while (ahead != NONE && ahead != robot && to[ahead] != NONE && to[ahead] != from[ahead]) {
      ahead = before[to[ahead]];
    }
    return ahead == robot && place != from[robot];
  }

  /** Whoever went where it liked best drags along the robot it has to swap with. */
  private void pull(int depth) {
    for (int k = depth; k >= 0; k--) {
      int robot = chain[k];
      int partner = pulled[robot];
      int here = from[robot];
      if (partner != NONE
          && nextChoice[robot] == 1
          && to[partner] == NONE
          && after[here] == NONE
          && to[robot] != here
          && (mayRotate || !closesRing(partner, here))) {
        to[partner] = here;
        after[here] = partner;
      }
    }
  }

  private void prepare(int robot) {
    char[] distance = distances[robot];
    int here = from[robot];
    int base = robot * CHOICES;
    int count = 0;
    long ties = random.nextLong();
    for (int d = 0; d < CHOICES; d++) {
      int place = d == DIRECTIONS ? here : roads.neighbour(here, d);
      if (place == NONE) {
        continue;
      }
      int tie = (int) (ties >>> (d * TIE_BITS)) & ((1 << TIE_BITS) - 1);
      int key = (((distance[place] << TIE_BITS) | tie) << CHOICE_BITS) | d;
      int k = count++;
      while (k > 0 && choices[base + k - 1] > key) {
        choices[base + k] = choices[base + k - 1];
        k--;
      }
      choices[base + k] = key;
    }
    for (int k = 0; k < count; k++) {
      int d = choices[base + k] & ((1 << CHOICE_BITS) - 1);
      choices[base + k] = d == DIRECTIONS ? here : roads.neighbour(here, d);
    }
    choiceCount[robot] = count;
    nextChoice[robot] = 0;
    pulled[robot] = swapPartner(robot, choices[base]);
    if (pulled[robot] != NONE) {
      reverse(base, count);
    }
  }

  private void reverse(int base, int count) {
    for (int low = base, high = base + count - 1; low < high; low++, high--) {
      int kept = choices[low];
      choices[low] = choices[high];
      choices[high] = kept;
    }
  }

  /** The robot that this one must change places with before it can get on, or {@code NONE}. */
  private int swapPartner(int robot, int wanted) {
    int here = from[robot];
    if (wanted == here) {
      return NONE;
    }
    int ahead = before[wanted];
    if (ahead != NONE
        && to[ahead] == NONE
        && mayFollow(wanted, here)
        && isSwapRequired(robot, ahead, here, wanted)
        && isSwapPossible(wanted, here)) {
      return ahead;
    }
    for (int d = 0; d < DIRECTIONS; d++) {
      int beside = roads.predecessor(here, d);
      if (beside == NONE || beside == wanted) {
        continue;
      }
      int follower = before[beside];
      if (follower != NONE
          && isSwapRequired(follower, robot, here, wanted)
          && isSwapPossible(wanted, here)) {
        return follower;
      }
    }
    return NONE;
  }

  private boolean mayFollow(int from, int to) {
    return !roads.isDirected() || roads.hasEdge(from, to);
  }

  /** Whether the pusher, driving the puller before it, meets no branch before their paths cross. */
  private boolean isSwapRequired(int pusher, int puller, int pusherAt, int pullerAt) {
    char[] toPushersGoal = distances[pusher];
    int back = pusherAt;
    int front = pullerAt;
    while (toPushersGoal[front] < toPushersGoal[back]) {
      int exit = onlyExit(front, back);
      if (exit == SEVERAL) {
        return false;
      }
      if (exit == NONE) {
        break;
      }
      back = front;
      front = exit;
    }
    char[] toPullersGoal = distances[puller];
    return toPullersGoal[back] < toPullersGoal[front]
        && (toPushersGoal[back] == 0 || toPushersGoal[front] < toPushersGoal[back]);
  }

  /** Whether walking on from {@code pusherAt} over {@code pullerAt} comes to a branch. */
  private boolean isSwapPossible(int pusherAt, int pullerAt) {
    int back = pusherAt;
    int front = pullerAt;
    int steps = 0;
    while (front != pusherAt && ++steps <= roads.vertexCount()) { // one-way rings lead nowhere else
      int exit = onlyExit(front, back);
      if (exit == SEVERAL) {
        return true;
      }
      if (exit == NONE) {
        return false;
      }
      back = front;
      front = exit;
    }
    return false;
  }

  private static final int SEVERAL = -2;

  /** Where one can go on to from {@code at} without going back, if there is just one place. */
  private int onlyExit(int at, int back) {
    int exit = NONE;
    for (int d = 0; d < DIRECTIONS; d++) {
      int u = roads.neighbour(at, d);
      if (u == NONE || u == back || isParkedInDeadEnd(u)) {
        continue;
      }
      if (exit != NONE) {
        return SEVERAL;
      }
      exit = u;
    }
    return exit;
  }

  private boolean isParkedInDeadEnd(int vertex) {
    int robot = before[vertex];
    return robot != NONE && goals[robot] == vertex && roads.degree(vertex) == 1;
  }
}
