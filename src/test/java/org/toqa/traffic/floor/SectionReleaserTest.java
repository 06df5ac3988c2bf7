package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.mapf.LacamJointPlanner;

/** How far ahead of a robot that nobody hinders its path is released. */
class SectionReleaserTest {
  private static final int CELLS = 24;
  private static final double SECONDS_AHEAD = 3;

  /** In large cells a section is much more than three seconds, in small ones much less. */
  @ParameterizedTest
  @ValueSource(doubles = {0.3, 1.0})
  void aRobotHasThreeSecondsAheadAndNotMuchMore(double cell) {
    OccupancyGrid unit = OccupancyGrid.parse(".".repeat(CELLS));
    OccupancyGrid grid = new OccupancyGrid(CELLS, 1, cell, Vec2.ZERO, unit.occupied());
    FloorTraffic traffic = new FloorTraffic(grid, new LacamJointPlanner(), Deadline::none);
    Instant now = Instant.EPOCH;
    Vec2 at = grid.centre(new Cell(0, 0));
    traffic.reportStanding("a", new Pose(at.x(), at.y(), 0), 0.255, now);
    traffic.setMovable("a", true);
    traffic.setGoal("a", grid.centre(new Cell(CELLS - 1, 0)), now);

    DriveCommand.Begin begin =
        assertInstanceOf(DriveCommand.Begin.class, traffic.decide(now).getFirst());
    Trajectory trajectory = begin.trajectory();
    int released = begin.released();
    List<Integer> ahead = new ArrayList<>();
    for (int completed = 0; completed < count(trajectory); completed++) {
      now = now.plus(Duration.ofMillis(500));
      traffic.reportProgress("a", trajectory.poseAfter(completed), completed, now);
      for (DriveCommand command : traffic.decide(now)) {
        released = assertInstanceOf(DriveCommand.Release.class, command).released();
      }
      ahead.add(released - completed);
      if (released < count(trajectory)) {
        double seconds = seconds(trajectory, completed, released);
        assertTrue(seconds >= SECONDS_AHEAD, completed + ": " + seconds + " s");
        // one section less would be too little: what is over is no more than that
        boolean isNeeded = seconds(trajectory, completed, released - 1) < SECONDS_AHEAD;
        assertTrue(isNeeded, completed + ": " + seconds + " s in " + ahead);
      }
    }
    assertEquals(count(trajectory), released);
    assertTrue(ahead.getFirst() < count(trajectory), "all was released at once");
  }

  /** In large cells it comes up to their border, while the other is still in the next one. */
  @Test
  void whoFollowsSetsOutWithTheOneBeforeIt() {
    OccupancyGrid grid = OccupancyGrid.parse(".".repeat(CELLS));
    FloorTraffic traffic = new FloorTraffic(grid, new LacamJointPlanner(), Deadline::none);
    for (int i = 0; i < 2; i++) {
      String name = i == 0 ? "behind" : "before";
      Vec2 at = grid.centre(new Cell(i, 0));
      traffic.reportStanding(name, new Pose(at.x(), at.y(), 0), 0.255, Instant.EPOCH);
      traffic.setMovable(name, true);
      traffic.setGoal(name, grid.centre(new Cell(i + 20, 0)), Instant.EPOCH);
    }
    Map<String, DriveCommand> commands = new HashMap<>();
    traffic.decide(Instant.EPOCH).forEach(command -> commands.put(command.robot(), command));
    assertEquals(Set.of("before", "behind"), commands.keySet());
    DriveCommand.Begin behind = assertInstanceOf(DriveCommand.Begin.class, commands.get("behind"));
    // half of a cell of 1 m
    assertEquals(0.5, behind.trajectory().poseAfter(behind.released()).x() - 0.5, 1e-6);
  }

  private static int count(Trajectory trajectory) {
    return trajectory.segments().size();
  }

  private static double seconds(Trajectory trajectory, int from, int to) {
    return trajectory.segments().subList(from, to).stream().mapToDouble(Segment::t).sum();
  }
}
