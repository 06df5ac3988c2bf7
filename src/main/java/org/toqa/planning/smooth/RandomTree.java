package org.toqa.planning.smooth;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.random.RandomGenerator;
import org.toqa.planning.smooth.Passages.Passage;

/**
 * Informed RRT*: a tree of free lines from the start, grown toward random points, in which each
 * point hangs where its path from the start is shortest (Karaman and Frazzoli, "Sampling-based
 * algorithms for optimal motion planning", 2011; Gammell, Srinivasa and Barfoot, "Informed RRT*",
 * 2014). A point may also hang from the ancestors of its neighbours (Jeong, Lee and Kim,
 * "Quick-RRT*", 2019), so that paths are nearly taut with few points.
 *
 * <p>An iteration costs about the logarithm of the number of points; of the lines that would
 * shorten a path only those are looked at that are tried in the order of what they save.
 */
final class RandomTree {
  private static final int NONE = -1;
  private static final int START = 0;

  /** How often the goal itself is the point to grow toward, until it is reached. */
  private static final double GOAL_BIAS = 0.05;

  /** The longest new line as a share of the grid's longer side, until the goal is reached. */
  private static final double STEP = 0.25;

  /** How often a narrow passage is tried, while there are some. */
  private static final double PASSAGE_BIAS = 0.2;

  /** The same until the goal is reached. */
  private static final double PASSAGE_BIAS_AT_FIRST = 0.45;

  /** How often a line that is not free is halved. */
  private static final int HALVINGS = 3;

  /** How many parents are tried for a new point. */
  private static final int MOST_TRIES = 10;

  /** Generations above a neighbour that are tried as parents. */
  private static final int GENERATIONS = 2;

  /** Paths through the goal's neighbours are told as long as they are not longer than this. */
  private static final double WORTH_A_LOOK = 1.08;

  private final DiscSpace space;
  private final InformedSampler sampler;

  /** Narrow ones that the tree has not gone through. */
  private final List<Passage> passages;

  private final Retraction retraction;
  private final RandomGenerator random;
  private final double goalX;
  private final double goalY;
  private final PointTree points = new PointTree();
  private int[] parent = new int[256];
  private int[] firstChild = new int[256];
  private int[] next = new int[256];
  private double[] cost = new double[256];

  /** By point: the number of the last search that had it among its candidates. */
  private int[] seen = new int[256];

  private int search;
  private int[] candidates = new int[256];
  private double[] candidateCosts = new double[256];
  private int candidateCount;

  /** Points from which the goal is seen. */
  private int[] seers = new int[64];

  private int seerCount;

  /** How many points lie where paths may still become shorter. */
  private int useful;

  private double best = Double.POSITIVE_INFINITY;

  RandomTree(DiscSpace space, WayPoints ends, RandomGenerator random) {
    this.space = space;
    this.random = random;
    this.sampler = new InformedSampler(space, ends, random);
    this.retraction = new Retraction(space);
    this.passages = new ArrayList<>(space.passages());
    this.goalX = ends.x(1);
    this.goalY = ends.y(1);
    add(ends.x(0), ends.y(0), NONE);
  }

  int size() {
    return points.size();
  }

  double x(int point) {
    return points.x(point);
  }

  double y(int point) {
    return points.y(point);
  }

  /** Whether a point is known from which the goal is seen. */
  boolean hasPath() {
    return seerCount > 0;
  }

  /** A path of so many cells is known. */
  void setBest(double length) {
    if (length < best) {
      best = length;
      sampler.setBest(length);
      useful = 0;
      for (int i = 0; i < points.size(); i++) {
        useful += sampler.mayShorten(points.x(i), points.y(i)) ? 1 : 0;
      }
    }
  }

  /** One iteration. */
  void grow() {
    if (!passages.isEmpty()
        && random.nextDouble() < (hasPath() ? PASSAGE_BIAS : PASSAGE_BIAS_AT_FIRST)) {
      goThroughPassage();
      return;
    }
    double x;
    double y;
    if (!hasPath() && random.nextDouble() < GOAL_BIAS) {
      x = goalX;
      y = goalY;
    } else {
      sampler.draw();
      x = sampler.x();
      y = sampler.y();
    }
    if (space.isFree(x, y)) {
      growToward(x, y);
    } else if (retraction.retract(x, y)) {
      growToward(retraction.x(), retraction.y());
    }
  }

  private void growToward(double x, double y) {
    if (hasPath()) {
      connect(x, y);
    } else {
      extend(x, y);
    }
  }

  /** Takes some passage, from whichever side it is seen. */
  private void goThroughPassage() {
    int index = random.nextInt(passages.size());
    Passage passage = passages.get(index);
    boolean forward = random.nextBoolean();
    double nearX = forward ? passage.fromX() : passage.toX();
    double nearY = forward ? passage.fromY() : passage.toY();
    double farX = forward ? passage.toX() : passage.fromX();
    double farY = forward ? passage.toY() : passage.fromY();
    boolean isUseless = !sampler.mayShorten(nearX, nearY) || !sampler.mayShorten(farX, farY);
    int near = isUseless ? NONE : connect(nearX, nearY);
    if (near != NONE) {
      int neighbours = points.findWithin(farX, farY, reach());
      rewire(add(farX, farY, near), neighbours);
    }
    if (isUseless || near != NONE) {
      passages.set(index, passages.getLast());
      passages.removeLast();
    }
  }

  /** Grows from the nearest point, as far as it goes. */
  private void extend(double x, double y) {
    int nearest = points.nearest(x, y);
    double nearX = points.x(nearest);
    double nearY = points.y(nearest);
    double distance = WayPoints.distance(nearX, nearY, x, y);
    if (distance == 0) {
      return;
    }
    double share = Math.min(1, STEP * Math.max(space.width(), space.height()) / distance);
    for (int i = 0; i <= HALVINGS; i++) {
      double atX = nearX + share * (x - nearX);
      double atY = nearY + share * (y - nearY);
      if (space.isFree(nearX, nearY, atX, atY)) {
        add(atX, atY, nearest); // to arrive comes first; paths are shortened once there is one
        return;
      }
      share /= 2;
    }
  }

  /**
   * Adds a free point where its path is shortest, and leads its neighbours through it.
   *
   * @return the point; none if no neighbour is seen from it
   */
  private int connect(double x, double y) {
    int neighbours = points.findWithin(x, y, reach());
    collectCandidates(x, y, neighbours);
    int chosen = firstFree(x, y);
    if (chosen == NONE) {
      return NONE;
    }
    int added = add(x, y, chosen);
    rewire(added, neighbours);
    return added;
  }

  /**
   * Cells in which other points are neighbours: as few as keep RRT* optimal.
   *
   * <p>r = gamma (log n / n)^(1/2), gamma^2 = 6 area / pi (Karaman and Frazzoli, theorem 38)
   */
  private double reach() {
    double n = Math.max(2, useful);
    return Math.sqrt(6 / Math.PI * sampler.area() * Math.log(n) / n);
  }

  private void collectCandidates(double x, double y, int neighbours) {
    search++;
    candidateCount = 0;
    if (neighbours == 0) {
      addFamily(points.nearest(x, y), x, y);
    }
    for (int i = 0; i < neighbours; i++) {
      addFamily(points.found(i), x, y);
    }
  }

  private void addFamily(int point, double x, double y) {
    int member = point;
    for (int generation = 0; generation <= GENERATIONS && member != NONE; generation++) {
      if (seen[member] == search) {
        return;
      }
      seen[member] = search;
      if (candidateCount == candidates.length) {
        candidates = Arrays.copyOf(candidates, 2 * candidateCount);
        candidateCosts = Arrays.copyOf(candidateCosts, 2 * candidateCount);
      }
      candidates[candidateCount] = member;
      candidateCosts[candidateCount++] = cost[member] + distanceTo(member, x, y);
      member = parent[member];
    }
  }

  /** The candidate with the shortest path, of those from which there is a free line. */
  private int firstFree(double x, double y) {
    for (int tries = 0; tries < MOST_TRIES && candidateCount > 0; tries++) {
      int least = 0;
      for (int i = 1; i < candidateCount; i++) {
        if (candidateCosts[i] < candidateCosts[least]) {
          least = i;
        }
      }
      int candidate = candidates[least];
      if (space.isFree(points.x(candidate), points.y(candidate), x, y)) {
        return candidate;
      }
      candidateCount--;
      candidates[least] = candidates[candidateCount];
      candidateCosts[least] = candidateCosts[candidateCount];
    }
    return NONE;
  }

  private void rewire(int point, int neighbours) {
    for (int i = 0; i < neighbours; i++) {
      int other = points.found(i);
      if (other != START && !leadFrom(parent[point], other)) {
        leadFrom(point, other);
      }
    }
  }

  /** Hangs a point from another one, if that shortens its path and the line is free. */
  private boolean leadFrom(int from, int point) {
    double through = cost[from] + distanceTo(from, points.x(point), points.y(point));
    if (through >= cost[point] - 1e-9
        || !space.isFree(points.x(from), points.y(from), points.x(point), points.y(point))) {
      return false;
    }
    unlink(point);
    link(point, from);
    lower(point, cost[point] - through);
    return true;
  }

  private void lower(int point, double saved) {
    cost[point] -= saved;
    for (int child = firstChild[point]; child != NONE; child = next[child]) {
      lower(child, saved);
    }
  }

  private int add(double x, double y, int from) {
    int added = points.add(x, y);
    if (added == parent.length) {
      parent = Arrays.copyOf(parent, 2 * added);
      firstChild = Arrays.copyOf(firstChild, 2 * added);
      next = Arrays.copyOf(next, 2 * added);
      cost = Arrays.copyOf(cost, 2 * added);
      seen = Arrays.copyOf(seen, 2 * added);
    }
    firstChild[added] = NONE;
    next[added] = NONE;
    parent[added] = NONE;
    useful += sampler.mayShorten(x, y) ? 1 : 0;
    if (from != NONE) {
      link(added, from);
      cost[added] = cost[from] + distanceTo(from, x, y);
    }
    double through = cost[added] + WayPoints.distance(x, y, goalX, goalY);
    if (through <= WORTH_A_LOOK * best && space.isFree(x, y, goalX, goalY)) {
      if (seerCount == seers.length) {
        seers = Arrays.copyOf(seers, 2 * seerCount);
      }
      seers[seerCount++] = added;
    }
    return added;
  }

  private void link(int point, int from) {
    parent[point] = from;
    next[point] = firstChild[from];
    firstChild[from] = point;
  }

  private void unlink(int point) {
    int from = parent[point];
    if (firstChild[from] == point) {
      firstChild[from] = next[point];
      return;
    }
    int before = firstChild[from];
    while (next[before] != point) {
      before = next[before];
    }
    next[before] = next[point];
  }

  private double distanceTo(int point, double x, double y) {
    return WayPoints.distance(points.x(point), points.y(point), x, y);
  }

  /**
   * Takes a free path from start to goal over: its points, but the ends, become the tree's.
   *
   * @param isOver whether there is no time to lead others through them
   */
  void insert(WayPoints path, BooleanSupplier isOver) {
    int from = START;
    for (int i = 1; i + 1 < path.size(); i++) {
      int neighbours = isOver.getAsBoolean() ? 0 : points.findWithin(path.x(i), path.y(i), reach());
      from = add(path.x(i), path.y(i), from);
      rewire(from, neighbours);
    }
  }

  /** The shortest path to the goal; there must be one. */
  WayPoints path() {
    int last = seers[0];
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < seerCount; i++) {
      double through = cost[seers[i]] + distanceTo(seers[i], goalX, goalY);
      if (through < least) {
        least = through;
        last = seers[i];
      }
    }
    return pathTo(last).add(goalX, goalY);
  }

  /** Some point from which the goal is seen, with a path that may be worth a look; else none. */
  int randomSeer() {
    int seer = seers[random.nextInt(seerCount)];
    return cost[seer] + distanceTo(seer, goalX, goalY) < WORTH_A_LOOK * best ? seer : NONE;
  }

  /** Some point on a path that may be worth a look; else none. */
  int randomPoint() {
    int point = random.nextInt(points.size());
    return cost[point] + distanceTo(point, goalX, goalY) < WORTH_A_LOOK * best ? point : NONE;
  }

  /** The path from the start to a point. */
  WayPoints pathTo(int point) {
    WayPoints path = new WayPoints();
    for (int at = point; at != NONE; at = parent[at]) {
      path.add(points.x(at), points.y(at));
    }
    path.reverse();
    return path;
  }
}
