package org.toqa.planning;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.BitSet;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.Disc;
import org.toqa.grid.FloorMap;
import org.toqa.grid.FloorReader;
import org.toqa.grid.Inflation;
import org.toqa.grid.MapFormatException;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.motion.DriveSpeeds;
import org.toqa.motion.SegmentFitter;
import org.toqa.motion.Trajectory;
import org.toqa.planning.PlanResult.Found;

/** The shipped floor is one on which robots can work. */
class LabMapTest {
  private static final double ROBOT_RADIUS = 0.1275;

  private final FloorMap lab;

  LabMapTest() throws MapFormatException {
    lab = FloorReader.read(java.nio.file.Path.of("maps", "lab.yaml"));
  }

  private List<Place> places() {
    return Stream.of(lab.stations(), lab.parking(), lab.charging()).flatMap(List::stream).toList();
  }

  @Test
  void labHasTheSizeAndThePlacesOfAWorkingFloor() {
    assertEquals(0.30, lab.grid().resolution());
    assertEquals(20, lab.grid().width() * 0.30, 0.2);
    assertEquals(12, lab.grid().height() * 0.30, 0.2);
    assertTrue(lab.stations().size() >= 8);
    assertTrue(lab.parking().size() >= 8);
    assertTrue(lab.charging().size() >= 2);
  }

  @Test
  void placesAreCentresOfCells() {
    for (Place place : places()) {
      Vec2 centre = lab.grid().centre(lab.grid().cellAt(place.position()));
      assertEquals(0, centre.distanceTo(place.position()), 1e-9, place.name());
    }
  }

  @Test
  void parkedRobotsStandApartAndLeaveRoomToPass() {
    List<Place> stands = Stream.concat(lab.parking().stream(), lab.charging().stream()).toList();
    BitSet occupied = lab.grid().occupied();
    for (Place a : stands) {
      for (Place b : stands) {
        assertTrue(a.equals(b) || a.position().distanceTo(b.position()) >= 0.6, a + " " + b);
      }
      occupied.set(lab.grid().index(lab.grid().cellAt(a.position())));
    }
    // with a robot on every stand, each of them can still leave and all stations stay connected
    OccupancyGrid crowded = lab.grid().withOccupied(occupied);
    PathPlanner planner = new HeadingAStar();
    Cell station = crowded.cellAt(lab.stations().getFirst().position());
    for (Place other : lab.stations()) {
      Cell goal = crowded.cellAt(other.position());
      assertInstanceOf(Found.class, planner.plan(crowded, station, goal), other.name());
    }
    for (Place stand : stands) {
      Cell start = crowded.cellAt(stand.position());
      BitSet others = crowded.occupied();
      others.clear(crowded.index(start));
      OccupancyGrid leaving = crowded.withOccupied(others);
      assertInstanceOf(Found.class, planner.plan(leaving, start, station), stand.name());
    }
  }

  @Test
  void everyPlaceIsReachedFromEveryOtherWithoutTouchingAWall() {
    OccupancyGrid inflated = Inflation.inflate(lab.grid(), ROBOT_RADIUS);
    PathPlanner planner = new HeadingAStar();
    SegmentFitter fitter = new SegmentFitter(DriveSpeeds.DEFAULT, lab.grid().resolution());
    Disc robot = new Disc(ROBOT_RADIUS);
    for (Place from : places()) {
      for (Place to : places()) {
        Cell start = inflated.cellAt(from.position());
        Cell goal = inflated.cellAt(to.position());
        Path path =
            assertInstanceOf(Found.class, planner.plan(inflated, start, goal), from + " " + to)
                .path();
        Pose pose = new Pose(from.position().x(), from.position().y(), 0);
        Trajectory trajectory = fitter.fit(pose, path.waypoints(inflated));
        assertEquals(0, trajectory.end().position().distanceTo(to.position()), 1e-3);
        for (double t = 0; t < trajectory.duration(); t += 0.1) {
          Vec2 centre = trajectory.poseAt(t).position();
          assertTrue(robot.isFreeAt(lab.grid(), centre), () -> from + " " + to + " " + centre);
        }
      }
    }
  }

  @Test
  void labHasTwoPassagesOfOneCell() {
    for (Cell narrow : List.of(new Cell(22, 9), new Cell(62, 23))) {
      assertTrue(lab.grid().isFree(narrow));
      boolean runsEast = lab.grid().isFree(narrow.column() + 1, narrow.row());
      for (int side : new int[] {-1, 1}) {
        assertFalse(
            runsEast
                ? lab.grid().isFree(narrow.column(), narrow.row() + side)
                : lab.grid().isFree(narrow.column() + side, narrow.row()));
      }
    }
  }
}
