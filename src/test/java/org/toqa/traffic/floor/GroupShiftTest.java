package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.toqa.formation.GroupMobility;
import org.toqa.formation.Shape;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;

/** Groups that are led sideways, over discs that drive exactly as they are told. */
class GroupShiftTest {
  private static final double RADIUS = DrivenFloor.DIAMETER / 2;
  private static final double LENGTH = 0.6;
  private static final double WIDTH = 0.3;

  /** Metres that are free beside where a shift ends. */
  private static final double KEPT = 0.05;

  /** Two passages beside each other that meet in a place too short to turn in. */
  private static final OccupancyGrid OFFSET_DOOR =
      DrivenFloor.draw(
          "################", //
          "#.........######",
          "#.........######",
          "######.........#",
          "######.........#",
          "################");

  private static final Vec2 WEST = new Vec2(1.6, 1.6);
  private static final Vec2 EAST = new Vec2(4.8, 0.8);

  private static FormationFootprint group(GroupMobility mobility) {
    double place = LENGTH / 2 + RADIUS + 0.02;
    Shape shape = new Shape(new Vec2(place, 0), List.of(new Vec2(-place, 0)), mobility);
    return new FormationFootprint(shape, RADIUS, LENGTH, WIDTH);
  }

  private static DrivenFloor floor(OccupancyGrid grid, GroupMobility mobility, Vec2 from, Vec2 to) {
    DrivenFloor floor = new DrivenFloor(grid, 1);
    FormationFootprint group = group(mobility);
    Pose leader = group.shape().leaderAt(new Pose(from.x(), from.y(), 0));
    floor.putAt("group", FormationLattice.of(grid).nearest(leader), DrivenFloor.DIAMETER);
    floor.lead("group", group);
    floor.sendTo("group", to);
    return floor;
  }

  private static Trajectory told(DrivenFloor floor) {
    floor.step();
    return Objects.requireNonNull(floor.body("group").trajectory, () -> floor.reasons().toString());
  }

  @Test
  void anOffsetDoorIsPassedBesideIt() {
    DrivenFloor floor = floor(OFFSET_DOOR, GroupMobility.SHIFTING, WEST, EAST);
    Trajectory trajectory = told(floor);
    assertKeepsClearBesideIt(floor, trajectory);
    floor.drive(Duration.ofMinutes(5));
    assertTrue(floor.isArrived("group"), () -> floor.reasons().toString());
  }

  @Test
  void whoCannotGoSidewaysIsToldThatThereIsNoPath() {
    DrivenFloor floor = floor(OFFSET_DOOR, GroupMobility.FORWARD, WEST, EAST);
    floor.drive(Duration.ofSeconds(5));
    assertTrue(
        floor.reason("group").startsWith("Waiting: the map has no path"), floor.reason("group"));
  }

  /** Its sensors look forward: it is led round, however far that is. */
  @Test
  void nobodyIsShiftedWhoHasAnotherPath() {
    OccupancyGrid hall = DrivenFloor.draw("..........", "..........", "..........", "..........");
    DrivenFloor floor =
        floor(hall, GroupMobility.SHIFTING, new Vec2(2, 0.5), hall.centre(new Cell(5, 1)));
    assertFalse(told(floor).segments().stream().anyMatch(Segment::shifts));
  }

  @Test
  void nobodyIsShiftedTowardWhatWasSeenThere() {
    DrivenFloor floor = floor(OFFSET_DOOR, GroupMobility.SHIFTING, WEST, EAST);
    BitSet seen = new BitSet();
    seen.set(OFFSET_DOOR.index(new Cell(7, 3)));
    floor.traffic.setObstacles(seen, Map.of());
    floor.drive(Duration.ofSeconds(20));
    assertEquals(
        "Waiting: an obstacle blocks the only path at (3.00, 1.00)", floor.reason("group"));
    floor.traffic.setObstacles(new BitSet(), Map.of());
    floor.drive(Duration.ofMinutes(5));
    assertTrue(floor.isArrived("group"), () -> floor.reasons().toString());
  }

  private static void assertKeepsClearBesideIt(DrivenFloor floor, Trajectory trajectory) {
    FormationFootprint group = Objects.requireNonNull(floor.body("group").group);
    int shifts = 0;
    for (int i = 0; i < trajectory.segments().size(); i++) {
      Segment segment = trajectory.segments().get(i);
      if (segment.shifts()) {
        shifts++;
        double beyond = segment.t() + KEPT / segment.speed();
        for (double t = 0; t <= beyond; t += 0.01 / segment.speed()) {
          Pose pose = trajectory.poseAfter(i).advanced(segment.twist(), t);
          assertTrue(group.discs(pose).stream().allMatch(floor::isOffTheWalls), pose::toString);
        }
      }
    }
    assertTrue(shifts > 0, trajectory::toString);
  }
}
