package org.toqa.app.bench;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.toqa.allocation.AllocationTask;
import org.toqa.fleet.floor.FloorDistances;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.motion.DriveSpeeds;
import org.toqa.traffic.RoadGraph;

/**
 * Robots of different strength and speed, and tasks that arrive at random, by seed.
 *
 * @param grid inflated by the robots' radius
 * @param robots by their parking places; every third carries {@link #STRONG_MAX_LOAD}, the others
 *     {@link #USUAL_MAX_LOAD}
 * @param jobs in the order in which they arrive
 */
record AllocationWorkload(
    OccupancyGrid grid,
    FloorDistances distances,
    List<RobotSpec> robots,
    List<AllocationTask> jobs) {
  /** Kilograms. */
  private static final double USUAL_MAX_LOAD = 5;

  private static final double STRONG_MAX_LOAD = 10;

  /** Of the loads, those that only a strong robot can carry. */
  private static final double HEAVY_SHARE = 0.2;

  /** Of each robot, metres (Tanta). */
  static final double DIAMETER = 0.255;

  /** Places between which things are carried, where the map names none. */
  private static final int PLACES = 40;

  static final Instant BEGIN = Instant.parse("2026-01-01T08:00:00Z");

  /**
   * @param maxLoad kilograms
   * @param speed metres a second
   * @param home where it parks, and begins; metres, map frame
   */
  record RobotSpec(String name, double maxLoad, double speed, Vec2 home) {}

  /**
   * @param grid inflated by the robots' radius
   * @param robots how many, at least 1
   * @param tasks how many
   * @param pressure the work as a share of the robots' capacity, above 0 and 1 where they are fully
   *     used, if each drives to its next load half as far as with it
   * @param slow the share of the robots that drive at half speed, 0 to 1
   * @throws IllegalArgumentException the floor has too few places; says so
   */
  static AllocationWorkload of(
      FloorMap floor,
      OccupancyGrid grid,
      int robots,
      int tasks,
      double pressure,
      double slow,
      long seed) {
    Random random = new Random(seed);
    RoadGraph roads = new RoadGraph(grid);
    List<Vec2> anywhere =
        new ArrayList<>(
            IntStream.range(0, roads.vertexCount())
                .filter(roads::isInLargestPart)
                .mapToObj(v -> grid.centre(roads.cell(v)))
                .toList());
    Collections.shuffle(anywhere, random);
    List<Vec2> places = reachable(floor.stations(), anywhere);
    List<Vec2> homes =
        Stream.concat(reachable(floor.parking(), anywhere).stream(), anywhere.stream())
            .distinct()
            .limit(robots)
            .toList();
    if (places.size() < 2) {
      places = anywhere.subList(0, Math.min(PLACES, anywhere.size()));
    }
    if (places.size() < 2 || homes.size() < robots) {
      throw new IllegalArgumentException("the map has too few free cells for that");
    }
    FloorDistances distances = new FloorDistances(floor.grid());
    double interval = taskSeconds(distances, places) / (robots * pressure);
    return new AllocationWorkload(
        grid, distances, robotSpecs(homes, slow), jobs(places, tasks, interval, random));
  }

  private static List<Vec2> reachable(List<Place> named, List<Vec2> anywhere) {
    return named.stream().map(Place::position).filter(anywhere::contains).toList();
  }

  private static List<RobotSpec> robotSpecs(List<Vec2> homes, double slow) {
    double usual = DriveSpeeds.DEFAULT.forward();
    return IntStream.range(0, homes.size())
        .mapToObj(
            i -> {
              boolean isSlow = Math.floor((i + 1) * slow) > Math.floor(i * slow);
              return new RobotSpec(
                  "r" + (i + 1),
                  i % 3 == 0 ? STRONG_MAX_LOAD : USUAL_MAX_LOAD,
                  isSlow ? usual / 2 : usual,
                  homes.get(i));
            })
        .toList();
  }

  /** Seconds that one robot needs for a task: to the load half as far as with it. */
  private static double taskSeconds(FloorDistances distances, List<Vec2> places) {
    double sum = 0;
    for (Vec2 from : places) {
      sum += places.stream().mapToDouble(distances.lengthsTo(from, DIAMETER)).sum();
    }
    double mean = sum / (places.size() * (places.size() - 1.0));
    return 1.5 * mean / DriveSpeeds.DEFAULT.forward();
  }

  private static List<AllocationTask> jobs(
      List<Vec2> places, int tasks, double interval, Random random) {
    List<AllocationTask> jobs = new ArrayList<>();
    double seconds = 0;
    for (int id = 1; id <= tasks; id++) {
      seconds -= interval * Math.log(1 - random.nextDouble()); // a Poisson process
      Vec2 start = places.get(random.nextInt(places.size()));
      Vec2 goal = start;
      while (goal.equals(start)) {
        goal = places.get(random.nextInt(places.size()));
      }
      double load =
          random.nextDouble() < HEAVY_SHARE
              ? USUAL_MAX_LOAD + (STRONG_MAX_LOAD - USUAL_MAX_LOAD) * random.nextDouble()
              : USUAL_MAX_LOAD * random.nextDouble();
      Instant at = BEGIN.plus(Duration.ofMillis(Math.round(seconds * 1000)));
      jobs.add(new AllocationTask(id, load, start, goal, at));
    }
    return jobs;
  }
}
