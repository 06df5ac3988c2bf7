package org.toqa.planning.smooth;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.random.RandomGenerator;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.planning.smooth.SmoothResult.Found;
import org.toqa.planning.smooth.SmoothResult.NotFound;
import org.toqa.planning.smooth.SmoothResult.Reason;

/** One run of the planner, from the first sample to the answer. */
final class PlanningRun {
  /** Iterations before a lattice is searched again; each further time so many times more. */
  private static final int CHANCE = 500;

  private static final int PATIENCE = 4;

  /** Iterations of the tree between two looks at its paths. */
  private static final int BURST = 64;

  /** Paths of the tree that are looked at after each burst, beside its shortest one. */
  private static final int LOOKS = 3;

  /** Iterations of the swarm after each burst. */
  private static final int MOVES = 2;

  /** A swarm that has moved so often is spread out anew. */
  private static final int SWARM_LIFE = 30;

  /** Way points of the first particles where the swarm is alone (the paper has 11 and 12). */
  private static final int WAY_POINTS_ALONE = 6;

  /** By how much a path may be longer than the best one before it is pulled taut. */
  private static final double WORTH_PULLING = 1.004;

  private static final int ROUNDS = 6;

  private final DiscSpace space;
  private final Vec2 from;
  private final Vec2 to;
  private final WayPoints ends;
  private final SmoothMethod method;
  private final PlanningBudget budget;
  private final RandomGenerator random;
  private final PathShortener shortener;
  private final RandomTree tree;
  private final FirstPathFinder firstPathFinder;
  private final List<WayPath.Progress> progress = new ArrayList<>();
  private long iterations;
  private long nextSearch;
  private @Nullable WayPoints best;
  private double bestLength = Double.POSITIVE_INFINITY;

  /** Of the best path before its corners were cut: what other paths are compared with. */
  private @Nullable WayPoints bestCorners;

  private double bestCornersLength = Double.POSITIVE_INFINITY;
  private @Nullable ParticleSwarm swarm;
  private int swarmAge;

  PlanningRun(
      DiscSpace space, Vec2 from, Vec2 to, SmoothMethod method, long seed, PlanningBudget budget) {
    this.space = space;
    this.from = from;
    this.to = to;
    this.method = method;
    this.budget = budget;
    this.random = new SplittableRandom(seed);
    this.ends =
        new WayPoints()
            .add(space.toCellsX(from.x()), space.toCellsY(from.y()))
            .add(space.toCellsX(to.x()), space.toCellsY(to.y()));
    this.shortener = new PathShortener(space, budget::isTimeOver);
    this.tree = new RandomTree(space, ends, random);
    this.firstPathFinder = new FirstPathFinder(space, ends, budget);
  }

  SmoothResult plan() {
    switch (method) {
      case RRT_STAR -> growAlone();
      case PARTICLE_SWARM -> swarmAlone();
      case HYBRID -> growAndSwarm();
    }
    if (best != null) {
      return new Found(new WayPath(inMetres(best), progress));
    }
    return new NotFound(firstPathFinder.isParted() ? Reason.NO_PATH : Reason.OUT_OF_TIME);
  }

  private void growAlone() {
    nextSearch = CHANCE;
    while (!isSpent() && !firstPathFinder.isParted()) {
      findFirstPath();
      growBurst();
      if (tree.hasPath()) {
        keep(tree.path());
      }
    }
  }

  private void swarmAlone() {
    WayPoints straight = new WayPoints().add(ends.x(0), ends.y(0));
    for (int i = 1; i <= WAY_POINTS_ALONE; i++) {
      double share = i / (WAY_POINTS_ALONE + 1.0);
      straight.add(
          ends.x(0) + share * (ends.x(1) - ends.x(0)), ends.y(0) + share * (ends.y(1) - ends.y(0)));
    }
    straight.add(ends.x(1), ends.y(1));
    double spread = Math.max(space.width(), space.height()) / 3.0;
    while (!isSpent()) {
      ParticleSwarm alone = new ParticleSwarm(space, straight, spread, random);
      for (int age = 0; age < 2 * SWARM_LIFE && !isSpent(); age++) {
        iterations++;
        alone.move();
      }
      WayPoints path = alone.best();
      if (path.isFreeIn(space)) {
        improve(path);
      }
    }
  }

  private void growAndSwarm() {
    while (!isSpent() && !firstPathFinder.isParted()) {
      findFirstPath();
      growBurst();
      if (tree.hasPath()) {
        improve(tree.path());
        lookAtOthers();
      }
      moveSwarm();
    }
    if (best != null) {
      WayPoints taut = best.copy();
      shortener.pullTaut(taut, ROUNDS);
      keep(taut);
    }
  }

  private void growBurst() {
    for (int i = 0; i < BURST; i++) {
      if (isSpent()) {
        return;
      }
      iterations++;
      tree.grow();
    }
  }

  private boolean isSpent() {
    return budget.isSpent(iterations);
  }

  private void findFirstPath() {
    if (tree.hasPath() || iterations < nextSearch || !firstPathFinder.canGoOn()) {
      return;
    }
    nextSearch = Math.max(CHANCE, PATIENCE * iterations);
    WayPoints path = firstPathFinder.search();
    if (path != null && method == SmoothMethod.HYBRID) {
      improve(path);
    } else if (path != null) {
      keep(path);
      tree.insert(path, budget::isTimeOver);
    }
  }

  /** Looks at paths that are no part of the shortest one: round other sides they may be shorter. */
  private void lookAtOthers() {
    for (int i = 0; i < LOOKS && !isSpent(); i++) {
      int seer = tree.randomSeer();
      if (seer >= 0) {
        improve(tree.pathTo(seer).add(ends.x(1), ends.y(1)));
      }
      int point = tree.randomPoint();
      if (point >= 0 && bestCorners != null) {
        improve(joined(point, bestCorners));
      }
    }
  }

  /** The tree's path to a point, and from there on the best one, from where it is seen; or that. */
  private WayPoints joined(int point, WayPoints others) {
    for (int i = others.size() - 1; i > 0; i--) {
      if (space.isFree(tree.x(point), tree.y(point), others.x(i), others.y(i))) {
        WayPoints path = tree.pathTo(point);
        for (int j = i; j < others.size(); j++) {
          path.add(others.x(j), others.y(j));
        }
        return path;
      }
    }
    return others;
  }

  private void moveSwarm() {
    if (bestCorners == null || bestCorners.size() < 3) {
      return;
    }
    if (swarm == null || swarmAge >= SWARM_LIFE) {
      double spread = 0.1 * bestCornersLength / bestCorners.size() + space.radiusInCells();
      swarm = new ParticleSwarm(space, bestCorners, spread, random);
      swarmAge = 0;
    }
    boolean isShorter = false;
    for (int i = 0; i < MOVES && !isSpent(); i++) {
      iterations++;
      swarmAge++;
      isShorter |= swarm.move();
    }
    if (isShorter) {
      WayPoints path = swarm.best();
      if (path.isFreeIn(space)) {
        improve(path);
      }
    }
  }

  /** Shortens a free path, and pulls it taut if it may become the best one. */
  private void improve(WayPoints path) {
    if (path == bestCorners || path.length() > 1.2 * bestLength) {
      return;
    }
    WayPoints corners = path.copy();
    shortener.shorten(corners);
    double length = corners.length();
    if (length > WORTH_PULLING * bestCornersLength
        || Math.abs(length - bestCornersLength) < 1e-5 * bestCornersLength) {
      return;
    }
    WayPoints taut = corners.copy();
    shortener.pullTaut(taut, ROUNDS);
    if (keep(taut)) {
      bestCorners = corners;
      bestCornersLength = length;
      swarm = null;
      tree.setBest(bestLength);
      tree.insert(corners, budget::isTimeOver);
    }
  }

  /** Keeps a free path if it is the shortest so far. */
  private boolean keep(WayPoints path) {
    double length = path.length();
    if (!(length < bestLength)) {
      return false;
    }
    best = path;
    bestLength = length;
    if (method == SmoothMethod.RRT_STAR) {
      tree.setBest(length);
    }
    progress.add(new WayPath.Progress(iterations, length * space.grid().resolution()));
    return true;
  }

  /** With start and goal exactly as they were given. */
  private List<Vec2> inMetres(WayPoints path) {
    List<Vec2> points = new ArrayList<>();
    points.add(from);
    for (int i = 1; i + 1 < path.size(); i++) {
      points.add(space.toMetres(path.x(i), path.y(i)));
    }
    points.add(to);
    return points;
  }
}
