package org.toqa.traffic.mapf;

import static org.toqa.traffic.RoadGraph.DIRECTIONS;
import static org.toqa.traffic.RoadGraph.NONE;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.Spacing;

/**
 * One step for all robots at once on cells that are too narrow for robots side by side: as {@link
 * Pibt}, but who goes to a place sends away all that are too near to it, one after the other, and
 * where one of them finds no place all that was chosen for it is taken back. No robots move in a
 * ring.
 *
 * <p>Cost: with what is taken back at most {@link #CHOICES_EACH} choices a robot and step; whoever
 * has none left stays.
 */
final class SpacedPibt implements StepSearch {
  private static final int CHOICES_EACH = 20;

  private final RoadGraph roads;
  private final Spacing spacing;
  private final char[][] distances;
  private final SplittableRandom random;

  private final int[] from;
  private final int[] to;

  /** Who is on a vertex before the step, and who after. */
  private final int[] before;

  private final int[] after;

  /** Who has chosen, in that order. */
  private final int[] chosen;

  private int chosenCount;
  private int choicesLeft;
  private final StepOrder order;

  /**
   * @param distances a table a robot: steps to its goal
   */
  SpacedPibt(RoadGraph roads, Spacing spacing, char[][] distances, SplittableRandom random) {
    this.roads = roads;
    this.spacing = spacing;
    this.distances = distances;
    this.random = random;
    int robots = distances.length;
    from = new int[robots];
    to = new int[robots];
    chosen = new int[robots];
    before = new int[roads.vertexCount()];
    after = new int[roads.vertexCount()];
    Arrays.fill(to, NONE);
    Arrays.fill(before, NONE);
    Arrays.fill(after, NONE);
    order = new StepOrder(spacing, from, to, before);
  }

  @Override
  public boolean step(int[] places, int[] byPriority, Lacam.Constraints constraints, int[] next) {
    System.arraycopy(places, 0, from, 0, from.length);
    for (int robot = 0; robot < from.length; robot++) {
      before[from[robot]] = robot;
    }
    choicesLeft = CHOICES_EACH * from.length;
    boolean isComplete = applyConstraints(constraints) && chooseInOrder(byPriority);
    if (isComplete) {
      System.arraycopy(to, 0, next, 0, to.length);
    }
    takeBack(0);
    for (int vertex : from) {
      before[vertex] = NONE;
    }
    return isComplete;
  }

  private boolean applyConstraints(Lacam.Constraints constraints) {
    for (Lacam.Constraints c = constraints; c.depth() > 0; c = c.parent()) {
      if (!take(c.robot(), c.place())) {
        return false;
      }
    }
    return true;
  }

  private boolean chooseInOrder(int[] byPriority) {
    for (int robot : byPriority) {
      if (to[robot] == NONE && !choose(robot) && !take(robot, from[robot])) {
        return false;
      }
    }
    return true;
  }

  /** Finds a place for a robot and for all that it sends away. */
  private boolean choose(int robot) {
    for (int place : placesByDistance(robot)) {
      if (choicesLeft-- <= 0) {
        return false;
      }
      int known = chosenCount;
      if (take(robot, place)) {
        if (sendAway(robot, place)) {
          return true;
        }
        takeBack(known);
      }
    }
    return false;
  }

  private boolean sendAway(int robot, int place) {
    if (!sendAway(robot, place, before[place])) {
      return false;
    }
    for (int vertex : spacing.near(place)) {
      if (!sendAway(robot, place, before[vertex])) {
        return false;
      }
    }
    return true;
  }

  private boolean sendAway(int robot, int place, int other) {
    return other == NONE
        || to[other] != NONE
        || spacing.mayBeAt(place, from[other], from[robot], from[other])
        || choose(other);
  }

  /** Whether the robot can go there as far as those are concerned who have chosen; then it does. */
  private boolean take(int robot, int place) {
    if (after[place] != NONE) {
      return false;
    }
    for (int vertex : spacing.near(place)) {
      int other = after[vertex];
      if (other != NONE && !spacing.mayBeAt(place, vertex, from[robot], from[other])) {
        return false;
      }
    }
    to[robot] = place;
    if (order.isInCycle(robot)) {
      to[robot] = NONE;
      return false;
    }
    after[place] = robot;
    chosen[chosenCount++] = robot;
    return true;
  }

  /** Whoever chose after so many has not. */
  private void takeBack(int count) {
    while (chosenCount > count) {
      int robot = chosen[--chosenCount];
      after[to[robot]] = NONE;
      to[robot] = NONE;
    }
  }

  /** Its own place and those beside it, those nearer to its goal first, equal ones by chance. */
  private int[] placesByDistance(int robot) {
    int[] places = new int[DIRECTIONS + 1];
    int[] keys = new int[DIRECTIONS + 1];
    int count = 0;
    for (int d = 0; d <= DIRECTIONS; d++) {
      int place = d == DIRECTIONS ? from[robot] : roads.neighbour(from[robot], d);
      if (place == NONE) {
        continue;
      }
      int key = (distances[robot][place] << Byte.SIZE) | random.nextInt(1 << Byte.SIZE);
      int k = count++;
      while (k > 0 && keys[k - 1] > key) {
        keys[k] = keys[k - 1];
        places[k] = places[k - 1];
        k--;
      }
      keys[k] = key;
      places[k] = place;
    }
    return Arrays.copyOf(places, count);
  }
}
