package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Instant;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;
import net.jqwik.api.constraints.LongRange;
import net.jqwik.api.lifecycle.AfterProperty;
import org.toqa.formation.GroupMobility;
import org.toqa.formation.Shape;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Margins;
import org.toqa.grid.OccupancyGrid;
import org.toqa.testbed.Cases;

/** What {@link FormationPaths} promises, leg by leg, a group drives on an empty floor. */
@Tag("full")
class FormationLegsPropertyTest {
  private static final double RESOLUTION = 0.3;
  private static final int COLUMNS = 11;
  private static final int ROWS = 8;
  private static final double LOAD = 0.3;
  private static final double RADIUS = 0.1275;

  private final Cases legs = new Cases("legs of groups");

  @Property(tries = 60, seed = "20261128")
  void eachLegThatIsPromisedIsDrivenAndEndsThere(@ForAll @LongRange(min = 0) long seed) {
    Random random = new Random(seed);
    OccupancyGrid grid = floor(random);
    Shape shape =
        (random.nextBoolean()
                ? new Shape(new Vec2(LOAD, 0), List.of(new Vec2(-LOAD, 0)))
                : new Shape(new Vec2(0, LOAD), List.of(new Vec2(0, -LOAD))))
            .withMobility(GroupMobility.SHIFTING);
    FormationFootprint group = new FormationFootprint(shape, RADIUS, LOAD, LOAD);
    Vec2 object = place(random);
    List<Vec2> stops = Stream.generate(() -> place(random)).limit(3).toList();
    List<FormationPaths> paths =
        stops.stream().map(stop -> new FormationPaths(grid, Margins.USUAL, stop)).toList();
    for (int eighths = 0; eighths < 8; eighths++) { // what one has found out, others may use
      Pose leader = shape.leaderAt(new Pose(object.x(), object.y(), eighths * Math.PI / 4));
      if (group.isClearOf(grid, leader, 0, grid.occupied())) {
        assertDrivenAsPromised(grid, group, leader, stops, paths);
      }
    }
  }

  private void assertDrivenAsPromised(
      OccupancyGrid grid,
      FormationFootprint group,
      Pose from,
      List<Vec2> stops,
      List<FormationPaths> paths) {
    Pose leader = from;
    for (int leg = 0; leg < stops.size(); leg++) {
      Vec2 goal = stops.get(leg);
      Optional<Pose> promised = paths.get(leg).endOfPath(group, leader, true);
      TrafficRobot robot = new TrafficRobot("group", 1, grid, leader, RADIUS, Instant.EPOCH);
      robot.setFormation(group);
      robot.setGoal(goal, null, Instant.EPOCH);
      Optional<Pose> driven =
          robot.isAtGoal()
              ? Optional.of(leader)
              : new FormationPlanner(grid, Margins.USUAL, new SectionFitter())
                  .path(robot, group, goal, grid.occupied(), List.of())
                  .map(sections -> sections.getLast().end());
      Pose where = leader;
      assertEquals(driven.isPresent(), promised.isPresent(), () -> where + " to " + goal);
      if (!legs.count(driven.isPresent())) {
        return;
      }
      assertEquals(0, driven.get().distanceTo(promised.orElseThrow()), 0.01);
      assertEquals(0, Angles.difference(driven.get().theta(), promised.get().theta()), 0.02);
      leader = driven.get();
    }
  }

  @AfterProperty
  void enoughLegsWerePossible() {
    legs.assertPossible(0.2);
  }

  private static OccupancyGrid floor(Random random) {
    BitSet walls = new BitSet();
    int pillars = random.nextInt(9);
    for (int i = 0; i < pillars; i++) {
      walls.set(random.nextInt(COLUMNS * ROWS));
    }
    return new OccupancyGrid(COLUMNS, ROWS, RESOLUTION, Vec2.ZERO, walls);
  }

  private static Vec2 place(Random random) {
    return new Vec2(
        (random.nextInt(COLUMNS) + 0.5) * RESOLUTION, (random.nextInt(ROWS) + 0.5) * RESOLUTION);
  }
}
