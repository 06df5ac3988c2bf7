package org.toqa.traffic.mapf;

import static org.toqa.traffic.RoadGraph.DIRECTIONS;
import static org.toqa.traffic.RoadGraph.NONE;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.toqa.traffic.MotionModel;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.Spacing;

/**
 * Makes a plan better until the time is up, by large neighbourhood search.
 *
 * <p>Idea: take the paths of a few robots that delay each other out of the plan, and put them in
 * again one after the other, each as quick as the rest allows ({@link SafeIntervalSearch}); keep
 * what is not worse. The few are a delayed robot and those it meets on shorter paths, or any few.
 * How many, and which of the two, is chosen by what has paid so far.
 *
 * <p>Cost: the plan is valid after every step, so it can stop at any time.
 *
 * <p>J. Li et al., "Anytime multi-agent path finding via large neighborhood search", IJCAI 2021.
 */
final class NeighbourhoodSearch {
  private static final int[] SIZES = {2, 4, 8, 16};
  private static final int CHOICES = 2 * SIZES.length;
  private static final double DECAY = 0.98;
  private static final int WALKS = 10;

  private final RoadGraph roads;
  private final Spacing spacing;
  private final char[][] distances;
  private final int[][] paths;
  private final ReservationTable reservations;
  private final SafeIntervalSearch search;
  private final SplittableRandom random;

  /** The robots taken out at present, and their paths before. */
  private final int[] group;

  private final int[][] former;
  private final boolean[] isInGroup;
  private int groupSize;

  private long cost;

  /** Steps gained for each method of choosing a group, and the work spent on it. */
  private final double[] gains = new double[CHOICES];

  private final double[] efforts = new double[CHOICES];

  /** Robots that got new paths together. */
  record Change(int[] robots, int[][] paths) {}

  /**
   * @param paths the plan, a path a robot; changed in place
   */
  NeighbourhoodSearch(
      RoadGraph roads,
      Spacing spacing,
      char[][] distances,
      int[][] paths,
      SplittableRandom random) {
    this.roads = roads;
    this.spacing = spacing;
    this.distances = distances;
    this.paths = paths;
    this.random = random;
    int last = Arrays.stream(paths).mapToInt(path -> path.length).max().orElse(0);
    reservations = ReservationTable.of(roads, spacing, last + last / 4);
    for (int[] path : paths) {
      reservations.add(path);
    }
    search = new SafeIntervalSearch(new StateGraph(roads, MotionModel.CLASSIC), reservations);
    group = new int[paths.length];
    former = new int[paths.length][];
    cost = VertexPaths.sumOfCosts(paths);
    isInGroup = new boolean[paths.length];
    Arrays.fill(gains, 1);
    Arrays.fill(efforts, 1);
  }

  /**
   * Goes on while the budget lasts, or until the sum of costs has come down to the lower bound.
   *
   * @param lowerBound steps, of all robots together
   */
  void improve(long lowerBound, SearchBudget budget) {
    while (cost > lowerBound && budget.takeIteration()) {
      iterate();
    }
  }

  /**
   * Goes on for so much work, while the budget lasts, or until the sum of costs has come down to
   * the lower bound; answers what it has changed, in that order.
   *
   * @param effort as {@link SafeIntervalSearch#effort} counts it
   */
  List<Change> improveFor(long effort, long lowerBound, SearchBudget budget) {
    List<Change> changes = new ArrayList<>();
    long end = search.effort() + effort;
    while (cost > lowerBound && search.effort() < end && budget.takeIteration()) {
      if (iterate()) {
        changes.add(
            new Change(
                Arrays.copyOf(group, groupSize),
                Arrays.stream(group, 0, groupSize)
                    .mapToObj(robot -> paths[robot])
                    .toArray(int[][]::new)));
      }
    }
    return changes;
  }

  /** Takes over what was found for a plan that was a little different, where it fits and pays. */
  void adopt(Change change) {
    long gain = 0;
    groupSize = change.robots().length;
    for (int k = 0; k < groupSize; k++) {
      int robot = change.robots()[k];
      group[k] = robot;
      former[k] = paths[robot];
      reservations.remove(former[k]);
      gain += former[k].length - change.paths()[k].length;
    }
    int taken = 0;
    while (gain >= 0 && taken < groupSize && reservations.admits(change.paths()[taken])) {
      paths[group[taken]] = change.paths()[taken];
      reservations.add(change.paths()[taken]);
      taken++;
    }
    if (taken < groupSize) {
      restore(taken);
    } else {
      cost -= gain;
    }
  }

  /** Takes over a whole plan. */
  void follow(NeighbourhoodSearch other) {
    groupSize = 0;
    for (int robot = 0; robot < paths.length; robot++) {
      if (paths[robot] != other.paths[robot]) {
        group[groupSize++] = robot;
        reservations.remove(paths[robot]);
      }
    }
    for (int k = 0; k < groupSize; k++) {
      paths[group[k]] = other.paths[group[k]];
      reservations.add(paths[group[k]]);
    }
    cost = other.cost;
  }

  /** The sum of costs, steps. */
  long cost() {
    return cost;
  }

  /** Answers whether robots have got other paths, which may be as long as before. */
  private boolean iterate() {
    int choice = chooseByGain();
    long effortBefore = search.effort();
    chooseGroup(Math.min(paths.length, SIZES[choice / 2]), choice % 2 == 0);
    int gain = replanGroup();
    cost -= Math.max(0, gain);
    gains[choice] = DECAY * gains[choice] + Math.max(0, gain);
    efforts[choice] = DECAY * efforts[choice] + (search.effort() - effortBefore) / 1000.0;
    return gain >= 0;
  }

  /** By chance, in proportion to what has been gained for the work. */
  private int chooseByGain() {
    double sum = 0;
    for (int k = 0; k < CHOICES; k++) {
      sum += rate(k);
    }
    double left = random.nextDouble() * sum;
    int choice = 0;
    while (choice < CHOICES - 1 && (left -= rate(choice)) > 0) {
      choice++;
    }
    return choice;
  }

  private double rate(int choice) {
    return (gains[choice] + 0.01) / (efforts[choice] + 0.01);
  }

  private void chooseGroup(int size, boolean isAroundDelay) {
    groupSize = 0;
    if (isAroundDelay) {
      addAroundDelay(size);
    }
    while (groupSize < size) {
      add(random.nextInt(paths.length));
    }
    for (int k = groupSize - 1; k > 0; k--) {
      int other = random.nextInt(k + 1);
      int robot = group[k];
      group[k] = group[other];
      group[other] = robot;
    }
    for (int k = 0; k < groupSize; k++) {
      isInGroup[group[k]] = false;
    }
  }

  private void add(int robot) {
    if (!isInGroup[robot]) {
      isInGroup[robot] = true;
      group[groupSize++] = robot;
    }
  }

  /** A robot with much delay, and whom it meets where it tries to be quicker. */
  private void addAroundDelay(int size) {
    int seed = random.nextInt(paths.length);
    for (int k = 0; k < 3; k++) {
      int other = random.nextInt(paths.length);
      seed = delay(other) > delay(seed) ? other : seed;
    }
    add(seed);
    for (int k = 0; k < WALKS && groupSize < size; k++) {
      walk(group[random.nextInt(groupSize)], size);
    }
  }

  /** Leaves a robot's path at some moment and goes on at random, only where that is quicker. */
  private void walk(int robot, int size) {
    int[] path = paths[robot];
    int t = random.nextInt(path.length);
    int v = path[t];
    while (groupSize < size && v != NONE) {
      v = quickerStep(robot, v, ++t, path.length - 1);
      if (v != NONE && reservations.isTaken(v, t)) {
        addRobotAt(v, t);
      }
    }
  }

  private int quickerStep(int robot, int from, int time, int arrival) {
    int step = NONE;
    int options = 0;
    for (int d = 0; d <= DIRECTIONS; d++) {
      int v = d == DIRECTIONS ? from : roads.neighbour(from, d);
      if (v != NONE && time + distances[robot][v] < arrival && random.nextInt(++options) == 0) {
        step = v;
      }
    }
    return step;
  }

  /** Whoever is on a vertex at a time, or too near to it. */
  private void addRobotAt(int vertex, int time) {
    for (int robot = 0; robot < paths.length; robot++) {
      if (spacing.isTooNear(VertexPaths.at(paths[robot], time), vertex)) {
        add(robot);
        return;
      }
    }
  }

  private int delay(int robot) {
    return paths[robot].length - 1 - shortest(robot);
  }

  private int shortest(int robot) {
    return distances[robot][paths[robot][0]];
  }

  /** Answers the steps gained; below 0 where nothing has been replanned. */
  private int replanGroup() {
    int costBefore = 0;
    int toGo = 0;
    for (int k = 0; k < groupSize; k++) {
      int robot = group[k];
      former[k] = paths[robot];
      reservations.remove(former[k]);
      costBefore += former[k].length - 1;
      toGo += shortest(robot);
    }
    int costAfter = 0;
    for (int k = 0; k < groupSize; k++) {
      int robot = group[k];
      int[] old = former[k];
      toGo -= shortest(robot);
      int latest = costBefore - costAfter - toGo;
      int[] path = search.path(old[0], old[old.length - 1], distances[robot], latest);
      if (path == null) {
        restore(k);
        return -1;
      }
      costAfter += path.length - 1;
      paths[robot] = path;
      reservations.add(path);
    }
    return costBefore - costAfter;
  }

  /** Puts the former paths back, after the first {@code replanned} have got others. */
  private void restore(int replanned) {
    for (int k = 0; k < replanned; k++) {
      reservations.remove(paths[group[k]]);
    }
    for (int k = 0; k < groupSize; k++) {
      paths[group[k]] = former[k];
      reservations.add(former[k]);
    }
  }
}
