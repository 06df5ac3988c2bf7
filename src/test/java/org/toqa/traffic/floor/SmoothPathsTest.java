package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Area;
import org.toqa.grid.Direction;
import org.toqa.grid.Disc;
import org.toqa.grid.FloorMap;
import org.toqa.grid.FloorReader;
import org.toqa.grid.Margins;
import org.toqa.grid.MoveRules;
import org.toqa.grid.Moves;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.OneWay;
import org.toqa.grid.Place;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;
import org.toqa.planning.exact.ShortestDiscPath;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.mapf.LacamJointPlanner;

/** What robots drive alone on a floor that is set to smooth moves. */
class SmoothPathsTest {
  private static final double RADIUS = 0.1275;
  private static final Vec2 START = new Vec2(1.05, 1.05);
  private static final Vec2 GOAL = new Vec2(4.95, 1.05);

  /** A hall of 6 m by 4 m with a wall in its middle, open above. */
  private static final OccupancyGrid HALL = hall();

  private static OccupancyGrid hall() {
    BitSet occupied = new BitSet();
    IntStream.range(25, 40).forEach(row -> occupied.set(row * 60 + 28, row * 60 + 32));
    return new OccupancyGrid(60, 40, 0.1, Vec2.ZERO, occupied);
  }

  private static FloorTraffic traffic(OccupancyGrid grid, Moves moves) {
    return new FloorTraffic(
        grid,
        Margins.USUAL,
        moves,
        new LacamJointPlanner(),
        FloorTraffic::rollingPlanner,
        Deadline::none,
        Runnable::run);
  }

  /** What a robot is told that faces east at a start. */
  private static Trajectory told(
      FloorTraffic traffic, Vec2 from, Vec2 to, @Nullable Double facing) {
    traffic.reportStanding("r", new Pose(from.x(), from.y(), 0), 2 * RADIUS, Instant.EPOCH);
    traffic.setMovable("r", true);
    traffic.setGoal("r", to, facing, Instant.EPOCH);
    return traffic.decide(Instant.EPOCH).stream()
        .filter(command -> command.robot().equals("r"))
        .map(command -> ((DriveCommand.Begin) command).trajectory())
        .findFirst()
        .orElseThrow();
  }

  private static Trajectory told(OccupancyGrid grid, Moves moves) {
    return told(traffic(grid, moves), START, GOAL, null);
  }

  private static List<Vec2> points(Trajectory trajectory) {
    List<Vec2> points = new ArrayList<>();
    Pose pose = trajectory.start();
    for (Segment segment : trajectory.segments()) {
      for (int i = 0; i < 20; i++) {
        points.add(pose.advanced(segment.twist(), segment.t() * i / 20).position());
      }
      pose = pose.advanced(segment.twist(), segment.t());
    }
    points.add(pose.position());
    return points;
  }

  private static double leastGap(OccupancyGrid grid, BitSet cells, Trajectory driven) {
    return points(driven).stream()
            .mapToDouble(
                at ->
                    cells.stream()
                        .mapToDouble(cell -> Disc.distanceToCell(grid, at, grid.cell(cell)))
                        .min()
                        .orElseThrow())
            .min()
            .orElseThrow()
        - RADIUS;
  }

  /** The exact shortest way of a disc that keeps 0.05 m from walls is the yardstick. */
  @Test
  void aRobotAloneDrivesACurveThatIsHardlyLongerThanTheShortest() {
    Trajectory smooth = told(HALL, Moves.SMOOTH);
    double shortest = new ShortestDiscPath(HALL, RADIUS + 0.05).length(START, GOAL).orElseThrow();

    assertTrue(smooth.length() < 1.01 * shortest, () -> smooth.length() + " of " + shortest);
    assertTrue(smooth.length() < told(HALL, Moves.HEADING).length() - 0.05);
    assertTrue(leastGap(HALL, HALL.occupied(), smooth) > 0.05);
    assertTrue(smooth.end().position().distanceTo(GOAL) < 1e-6);
    assertTrue(
        smooth.segments().stream().skip(1).allMatch(segment -> segment.v() > 0),
        "it turns on the spot on its way");
  }

  @Test
  void itFacesAsItShallAtItsGoal() {
    for (double heading : new double[] {0, Math.PI / 2, Math.PI}) {
      Trajectory smooth = told(traffic(HALL, Moves.SMOOTH), START, GOAL, heading);

      assertEquals(heading, Math.abs(smooth.end().theta()), 1e-6);
      assertTrue(smooth.end().position().distanceTo(GOAL) < 1e-6);
    }
  }

  @Test
  void itGoesRoundOneThatStandsAndWhatRobotsSaw() {
    Vec2 middle = new Vec2(3, 3);
    FloorTraffic traffic = traffic(HALL, Moves.SMOOTH);
    traffic.reportStanding("lost", new Pose(3, 1.9, 0), 2 * RADIUS, Instant.EPOCH);
    BitSet seen = new BitSet();
    seen.set(HALL.index(HALL.cellAt(middle)));
    traffic.setObstacles(seen, Map.of());

    Trajectory smooth = told(traffic, START, GOAL, null);

    double others =
        points(smooth).stream()
                .mapToDouble(at -> at.distanceTo(new Vec2(3, 1.9)))
                .min()
                .orElseThrow()
            - 2 * RADIUS;
    assertTrue(others > 0.1 - 1e-3, () -> "other robot: " + others);
    assertTrue(leastGap(HALL, seen, smooth) > 0.05);
    assertTrue(isSmooth(smooth), smooth::toString);
  }

  /** Where the shortest curve leads against a direction, it drives as on any other floor. */
  @Test
  void againstADirectionItDrivesNoCurve() {
    Area strip = new Area(new Vec2(2.5, 1.5), 1, 1);
    OccupancyGrid directed =
        HALL.withRules(
            new MoveRules(List.of(new OneWay(strip, Direction.WEST)), List.of(), List.of()));

    Trajectory driven = told(directed, Moves.SMOOTH);

    assertEquals(told(directed, Moves.HEADING), driven);
    DrivenFloor floor = new DrivenFloor(directed, Moves.SMOOTH, 1);
    floor.putAt("r", START, 2 * RADIUS);
    floor.sendTo("r", GOAL);
    floor.drive(Duration.ofMinutes(2)); // which looks at directions itself
    assertTrue(floor.areAllArrived(), () -> floor.reasons().toString());
  }

  @Test
  void theSameEventsGiveTheSameRun() {
    assertEquals(told(HALL, Moves.SMOOTH), told(HALL, Moves.SMOOTH));
  }

  /** In cells of 0.30 m, most of its stations beside walls. */
  @Test
  void inTheLabAllDrivesAreCurves() throws Exception {
    FloorMap lab = FloorReader.read(Path.of("maps/lab.yaml"));
    List<Vec2> stations = lab.stations().stream().map(Place::position).toList();
    for (int i = 0; i < stations.size(); i++) {
      Vec2 from = stations.get(i);
      Vec2 to = stations.get((i + 5) % stations.size());

      Trajectory smooth = told(traffic(lab.grid(), Moves.SMOOTH), from, to, null);

      double longest = 1.2 * told(traffic(lab.grid(), Moves.HEADING), from, to, null).duration();
      String way = from + " to " + to;
      assertTrue(isSmooth(smooth), way);
      assertTrue(smooth.duration() < longest, way);
      assertTrue(leastGap(lab.grid(), lab.grid().occupied(), smooth) > 0.02, way);
    }
  }

  /** Whether it leads straight in a direction that is none of the eight, somewhere. */
  private static boolean isSmooth(Trajectory trajectory) {
    Pose pose = trajectory.start();
    for (Segment segment : trajectory.segments()) {
      double eighths = pose.theta() / (Math.PI / 4);
      if (segment.v() > 0 && segment.w() == 0 && Math.abs(eighths - Math.rint(eighths)) > 0.01) {
        return true;
      }
      pose = pose.advanced(segment.twist(), segment.t());
    }
    return false;
  }
}
