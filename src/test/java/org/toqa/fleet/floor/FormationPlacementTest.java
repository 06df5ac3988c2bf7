package org.toqa.fleet.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collections;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.RobotCapabilities;
import org.toqa.formation.GroupMobility;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.FloorMap;
import org.toqa.grid.FloorReader;
import org.toqa.grid.Margins;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.motion.Trajectory;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.floor.FloorTraffic;
import org.toqa.traffic.mapf.LacamJointPlanner;

@Tag("full")
class FormationPlacementTest {
  private static final double RADIUS = RobotCapabilities.UNKNOWN.footprint() / 2;

  /** Metres and radians; three times what a robot takes for standing on its place. */
  private static final double OFF_PLACE = 0.003;

  private static final double OFF_HEADING = 0.006;

  private static FloorMap lab;
  private static FormationPlacement places;

  @BeforeAll
  static void readTheLab() throws Exception {
    lab = FloorReader.read(Path.of("maps", "lab.yaml"));
    places = new FormationPlacement(lab.grid(), Margins.USUAL);
  }

  /** From each station to two others and to each from two; {@code -Dtoqa.stations=all}: to all. */
  @Test
  void threeRobotsCarryBetweenNearlyAllStationsOfTheLab() {
    List<Place> stations = lab.stations();
    boolean isWhole = "all".equals(System.getProperty("toqa.stations"));
    int[] others =
        isWhole
            ? IntStream.range(1, stations.size()).toArray()
            : new int[] {1, stations.size() / 2};
    List<String> refused = new ArrayList<>();
    for (int i = 0; i < stations.size(); i++) {
      for (int other : others) {
        Place start = stations.get(i);
        Place goal = stations.get((i + other) % stations.size());
        Optional<Formation> found = round(start, goal, 3);
        found.ifPresent(FormationPlacementTest::assertEvenAndApart);
        if (found.isEmpty()) {
          refused.add(start.name() + " to " + goal.name());
        }
      }
    }
    int pairs = stations.size() * others.length;
    assertTrue(refused.size() <= 0.02 * pairs, refused.size() + " of " + pairs + ": " + refused);
  }

  /** Each carries the same share, and can come to its place when the others are there. */
  private static void assertEvenAndApart(Formation formation) {
    List<Vec2> holds = formation.holds(Collections.nCopies(3, 4.0)).orElseThrow();
    assertEquals(0, holds.stream().reduce(Vec2.ZERO, Vec2::plus).norm(), 1e-6, "its middle");
    for (int i = 0; i < 3; i++) {
      for (int other = 0; other < i; other++) {
        double apart = formation.pose(i).distanceTo(formation.pose(other)) - 2 * RADIUS;
        assertTrue(apart >= 2 * Trajectory.MAX_DEVIATION - 1e-9, formation::toString);
      }
    }
  }

  /** The same walls in cells of 5 cm: every pose that is free there is free here. */
  @Test
  void aTeamHasNoLessRoomWhereCellsAreSmall() {
    OccupancyGrid coarse = lab.grid();
    int parts = (int) Math.round(coarse.resolution() / 0.05);
    OccupancyGrid fine = divided(coarse, parts);
    FormationPlacement finePlaces = new FormationPlacement(fine, Margins.USUAL);
    int paths = 0;
    for (int i = 0; i < lab.stations().size() && paths < 3; i++) {
      Place start = lab.stations().get(i);
      Place goal = lab.stations().get((i + 5) % lab.stations().size());
      if (round(start, goal, 2).isPresent()) {
        paths++;
        assertTrue(
            finePlaces
                .find(
                    start.position(),
                    List.of(goal.position()),
                    2,
                    null,
                    RADIUS,
                    GroupMobility.SHIFTING)
                .isPresent(),
            start + " to " + goal);
      }
    }
    assertTrue(paths > 0);
  }

  private static OccupancyGrid divided(OccupancyGrid grid, int parts) {
    int width = grid.width() * parts;
    BitSet occupied = new BitSet();
    for (int row = 0; row < grid.height() * parts; row++) {
      for (int column = 0; column < width; column++) {
        Cell cell = new Cell(column / parts, row / parts);
        occupied.set(row * width + column, !grid.isFree(cell));
      }
    }
    return new OccupancyGrid(
        width, grid.height() * parts, grid.resolution() / parts, grid.origin(), occupied);
  }

  /** No robot is exactly where it was sent. */
  @Test
  void whatIsPromisedIsKeptWhereverTheLeaderComesToStand() {
    Random random = new Random(7);
    int kept = 0;
    while (kept < 25) {
      Place start = lab.stations().get(random.nextInt(lab.stations().size()));
      Place goal = lab.stations().get(random.nextInt(lab.stations().size()));
      Optional<Formation> formation =
          start.equals(goal) ? Optional.empty() : round(start, goal, 2 + random.nextInt(3));
      if (formation.isPresent()) {
        Pose leader = beside(formation.get().pose(0), random);
        assertNull(
            waitingReason(formation.get(), leader, goal),
            start + " to " + goal + " from " + leader);
        kept++;
      }
    }
  }

  private static Optional<Formation> round(Place start, Place goal, int robots) {
    return places.find(
        start.position(), List.of(goal.position()), robots, null, RADIUS, GroupMobility.SHIFTING);
  }

  private static Pose beside(Pose place, Random random) {
    return place.compose(
        new Pose(
            OFF_PLACE * random.nextGaussian() / 2,
            OFF_PLACE * random.nextGaussian() / 2,
            OFF_HEADING * random.nextDouble(-1, 1)));
  }

  private static @Nullable String waitingReason(Formation formation, Pose leader, Place goal) {
    FloorTraffic traffic = new FloorTraffic(lab.grid(), new LacamJointPlanner(), Deadline::none);
    traffic.reportStanding("leader", leader, 2 * RADIUS, Instant.EPOCH);
    traffic.setFormation("leader", formation.group());
    traffic.setMovable("leader", true);
    traffic.setGoal("leader", goal.position(), Instant.EPOCH);
    traffic.decide(Instant.EPOCH);
    return Objects.toString(traffic.waitReason("leader"), null);
  }
}
