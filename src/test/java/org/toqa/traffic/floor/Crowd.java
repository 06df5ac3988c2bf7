package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.IntStream;
import org.toqa.formation.Shape;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;

/**
 * Many robots in a hall with pillars, some of them large, slow or in groups, all a little beside
 * where they take themselves to be, that get goal after goal while plans come late, wheels stop and
 * turn again, robots are lost and found, and obstacles come and go. Nothing may touch; then, when
 * they get their last goals and nothing else happens, each arrives or says for whom it waits that
 * stays.
 */
final class Crowd {
  private static final Duration PLANNING = Duration.ofMillis(10);
  private static final Duration LATEST_PLAN = Duration.ofMillis(300);
  private static final Duration TROUBLES = Duration.ofSeconds(20);

  /** Nobody stands so long short of its goal without a word why. */
  private static final Duration UNNAMED = Duration.ofSeconds(10);

  /** By then all have arrived, or only wait for one that stays: wheels turn half of the time. */
  private static final Duration LIMIT = Duration.ofMinutes(20);

  /** Who has stood so long goes first. */
  private static final Duration FIRST_AFTER = Duration.ofSeconds(20);

  /** So long it goes first, and so long does each that stood before it. */
  private static final Duration TURN = Duration.ofSeconds(60);

  /** Until who may go has got that far, metres and time, it is not said to go. */
  private static final double GOING = 0.3;

  /** Who has not got so far for so long stands. */
  private static final Duration STANDING = Duration.ofSeconds(5);

  private static final Duration LATE = Duration.ofSeconds(20);

  private static final int CELLS_A_ROBOT = 25;
  private static final double ERROR = 0.015;
  private static final double LARGE = 0.55;
  private static final double SLOW = 0.1;
  private static final double LOAD = 0.3;

  /** Metres between the middles of places of groups and large robots and any others. */
  private static final double APART = 1.3;

  private static final FormationFootprint GROUP =
      new FormationFootprint(
          new Shape(new Vec2(LOAD, 0), List.of(new Vec2(-LOAD, 0))),
          DrivenFloor.DIAMETER / 2,
          LOAD,
          LOAD);

  private final Random random;
  private final DrivenFloor floor;
  private final List<Vec2> middles;

  /** By robot, where it has room. */
  private final Map<String, List<Vec2>> places = new HashMap<>();

  private final Map<String, Instant> named = new HashMap<>();
  private final Map<String, Pose> seen = new HashMap<>();
  private final Map<String, Stand> stands = new HashMap<>();
  private final BitSet obstacles = new BitSet();

  /** Where a robot has been since then, and how many stood before it. */
  private record Stand(Vec2 place, Instant since, long before) {}

  private Crowd(long seed, int robots) {
    random = new Random(seed);
    int width = (int) Math.ceil(Math.sqrt(robots * CELLS_A_ROBOT * 1.5));
    int height = robots * CELLS_A_ROBOT / width + 1;
    BitSet pillars = new BitSet();
    IntStream.range(0, width * height).forEach(i -> pillars.set(i, random.nextInt(20) == 0));
    OccupancyGrid hall = new OccupancyGrid(width, height, DrivenFloor.CELL, Vec2.ZERO, pillars);
    middles = FloorTrafficPropertyTest.largestPart(hall).stream().map(hall::centre).toList();
    floor = new DrivenFloor(hall, seed, LATEST_PLAN, PLANNING);
    for (int i = 0; i < robots; i++) {
      add(i);
    }
    takePlaces().forEach(this::put);
    floor.mostError = ERROR;
  }

  /** Of 25 robots one leads a group, and two are large. */
  private void add(int i) {
    boolean isGroup = i % 25 == 3;
    boolean isLarge = i % 12 == 5;
    String name = (isGroup ? "g" : isLarge ? "l" : "r") + i;
    places.put(name, middles.stream().filter(place -> hasRoom(name, place)).toList());
  }

  private boolean hasRoom(String robot, Vec2 place) {
    return switch (robot.charAt(0)) {
      case 'g' ->
          GROUP.discs(GROUP.shape().leaderAt(new Pose(place.x(), place.y(), 0))).stream()
              .allMatch(floor::isOffTheWalls);
      case 'l' -> floor.isOffTheWalls(new PlacedDisc(place, LARGE / 2 + ERROR));
      default -> true;
    };
  }

  /** A place for each robot, none too near to another's; those that need much choose first. */
  private Map<String, Vec2> takePlaces() {
    Map<String, Vec2> taken = new HashMap<>();
    places.keySet().stream()
        .sorted((a, b) -> Boolean.compare(a.charAt(0) == 'r', b.charAt(0) == 'r'))
        .forEach(
            robot -> {
              List<Vec2> free = new ArrayList<>(places.getOrDefault(robot, List.of()));
              free.removeIf(
                  place ->
                      taken.entrySet().stream()
                          .anyMatch(
                              other ->
                                  other.getValue().distanceTo(place)
                                      < apart(robot, other.getKey())));
              if (!free.isEmpty()) {
                taken.put(robot, free.get(random.nextInt(free.size())));
              }
            });
    return taken;
  }

  private static double apart(String one, String two) {
    return one.charAt(0) == 'r' && two.charAt(0) == 'r' ? DrivenFloor.CELL - 1e-3 : APART;
  }

  private void put(String robot, Vec2 place) {
    switch (robot.charAt(0)) {
      case 'g' -> {
        Pose leader = GROUP.shape().leaderAt(new Pose(place.x(), place.y(), 0));
        floor.putAt(robot, leader, DrivenFloor.DIAMETER);
        floor.lead(robot, GROUP);
      }
      case 'l' -> floor.putAt(robot, place, LARGE);
      default -> floor.putAt(robot, place, DrivenFloor.DIAMETER);
    }
    if (random.nextInt(6) == 0 && robot.charAt(0) != 'g') {
      floor.setMaxSpeed(robot, SLOW);
    }
  }

  /** Whether there was room for most of so many robots. */
  static boolean drive(long seed, int robots) {
    Crowd crowd = new Crowd(seed, robots);
    if (crowd.floor.bodies.size() < 0.8 * robots) {
      return false;
    }
    crowd.driveThroughTroubles();
    crowd.driveToLastGoals();
    return true;
  }

  private void driveThroughTroubles() {
    List<String> robots = List.copyOf(floor.bodies.keySet());
    for (Instant end = floor.now.plus(TROUBLES); floor.now.isBefore(end); ) {
      for (String robot : robots) {
        if (floor.isArrived(robot) && random.nextInt(20) == 0) {
          List<Vec2> all = places.getOrDefault(robot, List.of());
          floor.sendTo(robot, all.get(random.nextInt(all.size())));
        }
      }
      trouble(robots.get(random.nextInt(robots.size())));
      floor.step();
      listen();
    }
  }

  private void trouble(String robot) {
    if (random.nextInt(20) == 0) {
      floor.body(robot).isStuck ^= true;
    }
    if (random.nextInt(80) == 0) {
      floor.lose(robot);
    }
    if (random.nextInt(20) == 0 && !floor.lost.isEmpty()) {
      floor.find(floor.lost.iterator().next());
    }
    if (random.nextInt(100) == 0) {
      int cell = floor.grid.index(floor.grid.cellAt(middles.get(random.nextInt(middles.size()))));
      if (floor.traffic.robotsAt(cell).isEmpty()) {
        obstacles.set(cell);
        floor.traffic.setObstacles(obstacles, Map.of());
      }
    }
  }

  private void driveToLastGoals() {
    obstacles.clear();
    floor.traffic.setObstacles(obstacles, Map.of());
    floor.bodies.values().forEach(body -> body.isStuck = false);
    takePlaces()
        .forEach(
            (robot, place) -> {
              if (floor.bodies.containsKey(robot)) {
                floor.sendTo(robot, place);
              }
            });
    Instant end = floor.now.plus(LIMIT);
    while (floor.now.isBefore(end) && !floor.bodies.keySet().stream().allMatch(this::isSettled)) {
      floor.step();
      listen();
      watchStands();
    }
    for (String robot : floor.bodies.keySet()) {
      assertTrue(isSettled(robot), () -> robot + " of " + floor.reasons());
    }
  }

  private boolean isSettled(String robot) {
    return floor.isArrived(robot) || floor.waitsForOneThatStays(robot);
  }

  /** Nobody stands for longer than it takes those to go that stood before it, and itself. */
  private void watchStands() {
    floor.bodies.forEach(
        (robot, body) -> {
          Vec2 at = body.pose.position();
          Stand stand = stands.get(robot);
          if (stand == null || stand.place.distanceTo(at) > GOING || isSettled(robot)) {
            stand = new Stand(at, floor.now, stand == null ? floor.bodies.size() : standing());
            stands.put(robot, stand);
          }
          Instant end = stand.since.plus(FIRST_AFTER).plus(TURN.multipliedBy(stand.before + 1));
          assertTrue(
              !end.plus(LATE).isBefore(floor.now),
              () -> robot + " stands as if forgotten: " + floor.reasons());
        });
  }

  private long standing() {
    return stands.values().stream()
        .filter(stand -> stand.since.plus(STANDING).isBefore(floor.now))
        .count();
  }

  /** Who stands and can move says why. */
  private void listen() {
    floor.bodies.forEach(
        (robot, body) -> {
          boolean isStanding = body.pose.equals(seen.put(robot, body.pose));
          boolean isNamed =
              !isStanding
                  || floor.isArrived(robot)
                  || body.isStuck
                  || floor.lost.contains(robot)
                  || floor.traffic.waitReason(robot) != null;
          Instant since = isNamed ? floor.now : named.getOrDefault(robot, floor.now);
          named.put(robot, since);
          assertTrue(
              !since.plus(UNNAMED).isBefore(floor.now),
              () -> robot + " stands without a word at " + body.pose + " for " + body.goal);
        });
  }
}
