package org.toqa.planning.smooth;

import java.util.random.RandomGenerator;

/**
 * Moves the way points of a path by a swarm of such paths (Kennedy and Eberhart, "Particle swarm
 * optimization", 1995; the constants are those of Clerc and Kennedy, "The particle swarm", 2002). A
 * particle has the coordinates of a few way points that follow each other; the others stay. Its
 * cost is the path's length, and ten times the length of what is not free; a path that is too long
 * already is not looked at further.
 */
final class ParticleSwarm {
  private static final int PARTICLES = 20;

  /** As many way points as the paper moves. */
  private static final int MOST_WAY_POINTS = 12;

  // w = chi, c1 = c2 = 2.05 chi, chi = 0.72984   (Clerc and Kennedy, 2002, section V)
  private static final double INERTIA = 0.72984;
  private static final double ATTRACTION = 1.49617;

  /** Cost of a cell that is not free, in cells. */
  private static final double PENALTY = 10;

  private final DiscSpace space;
  private final RandomGenerator random;
  private final WayPoints path;
  private final int first;
  private final int dimensions;
  private final double[][] positions;
  private final double[][] velocities;
  private final double[][] bests;
  private final double[] bestCosts;
  private int leader;

  /**
   * @param path of at least three points; it is taken as it is and is one of the particles
   * @param spread cells by which the way points of the farthest particle are moved at first, the
   *     standard deviation
   */
  ParticleSwarm(DiscSpace space, WayPoints path, double spread, RandomGenerator random) {
    this.space = space;
    this.random = random;
    this.path = path.copy();
    int inner = path.size() - 2;
    int moved = Math.min(inner, MOST_WAY_POINTS);
    this.first = 1 + random.nextInt(inner - moved + 1);
    this.dimensions = 2 * moved;
    this.positions = new double[PARTICLES][dimensions];
    this.velocities = new double[PARTICLES][dimensions];
    this.bests = new double[PARTICLES][];
    this.bestCosts = new double[PARTICLES];
    for (int particle = 0; particle < PARTICLES; particle++) {
      scatter(particle, spread * particle / (PARTICLES - 1));
    }
  }

  private void scatter(int particle, double deviation) {
    double[] position = positions[particle];
    for (int d = 0; d < dimensions; d++) {
      int index = first + d / 2;
      double centre = d % 2 == 0 ? path.x(index) : path.y(index);
      position[d] = onGrid(centre + deviation * random.nextGaussian(), d);
      velocities[particle][d] = deviation / 2 * random.nextGaussian();
    }
    bests[particle] = position.clone();
    bestCosts[particle] = cost(position, Double.POSITIVE_INFINITY);
    leader = bestCosts[particle] < bestCosts[leader] ? particle : leader;
  }

  private double onGrid(double coordinate, int dimension) {
    return Math.clamp(coordinate, 0, dimension % 2 == 0 ? space.width() : space.height());
  }

  /**
   * One iteration of the swarm.
   *
   * @return whether its best path became shorter
   */
  boolean move() {
    double before = bestCosts[leader];
    for (int particle = 0; particle < PARTICLES; particle++) {
      move(particle);
    }
    return bestCosts[leader] < before;
  }

  private void move(int particle) {
    double[] position = positions[particle];
    double[] velocity = velocities[particle];
    double[] own = bests[particle];
    double[] shared = bests[leader];
    for (int d = 0; d < dimensions; d++) {
      // v = w v + c1 r1 (own best - x) + c2 r2 (swarm's best - x)
      velocity[d] =
          INERTIA * velocity[d]
              + ATTRACTION * random.nextDouble() * (own[d] - position[d])
              + ATTRACTION * random.nextDouble() * (shared[d] - position[d]);
      position[d] = onGrid(position[d] + velocity[d], d);
    }
    double cost = cost(position, bestCosts[particle]);
    if (cost < bestCosts[particle]) {
      bestCosts[particle] = cost;
      System.arraycopy(position, 0, own, 0, dimensions);
      leader = cost < bestCosts[leader] ? particle : leader;
    }
  }

  private double cost(double[] position, double limit) {
    apply(position);
    double length = path.length();
    double cost = length;
    for (int i = first; i <= first + dimensions / 2 && cost < limit; i++) {
      cost += PENALTY * blockedLength(i);
    }
    return cost;
  }

  private void apply(double[] position) {
    for (int d = 0; d < dimensions; d += 2) {
      path.set(first + d / 2, position[d], position[d + 1]);
    }
  }

  /** About how much of a leg is not free, in cells; 0 just if all of it is free. */
  private double blockedLength(int index) {
    double fromX = path.x(index - 1);
    double fromY = path.y(index - 1);
    double alongX = path.x(index) - fromX;
    double alongY = path.y(index) - fromY;
    if (space.isFree(fromX, fromY, path.x(index), path.y(index))) {
      return 0;
    }
    double length = path.leg(index);
    int samples = (int) Math.min(64, Math.ceil(length / Math.max(1, space.radiusInCells()))) + 1;
    int blocked = 1;
    for (int i = 0; i <= samples; i++) {
      double share = (double) i / samples;
      blocked += space.isFree(fromX + share * alongX, fromY + share * alongY) ? 0 : 1;
    }
    return length * blocked / samples + 1;
  }

  /** The best path of all so far. */
  WayPoints best() {
    apply(bests[leader]);
    return path.copy();
  }
}
