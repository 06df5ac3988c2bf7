package org.toqa.driving;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.toqa.avoidance.Encounter;
import org.toqa.avoidance.MovingDisc;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DifferentialLimits;
import org.toqa.planning.smooth.DiscSpace;
import org.toqa.planning.smooth.curve.SplineFitter;

class DetourPlannerTest {
  private static final double RADIUS = 0.1;
  private static final OccupancyGrid ROOM =
      new OccupancyGrid(300, 200, 0.01, Vec2.ZERO, new BitSet());

  /** Three metres straight through the room. */
  private static final DrivenLine LINE =
      DrivenLine.of(
          new SplineFitter(DiscSpace.of(ROOM, RADIUS))
              .fit(List.of(new Vec2(0.2, 1), new Vec2(2.8, 1)))
              .pieces());

  private static DetourPlanner planner(OccupancyGrid grid) {
    return new DetourPlanner(grid, RADIUS, 0.02, DifferentialLimits.DEFAULT, 1);
  }

  @Test
  void whoWouldBeMetIsDrivenRoundAndTheLineIsReachedAgain() {
    // at x = 1.5 after about 3 s, when the robot is there
    List<MovingDisc> discs =
        List.of(new MovingDisc(new Vec2(1.5, 1.25), new Vec2(0, -0.08), 0.1, 0));
    DetourPlanner planner = planner(ROOM);
    Encounter meeting = planner.encounter(LINE, 0, 0, discs).orElseThrow();

    DrivenLine detour = planner.plan(LINE, 0, 0, meeting, discs).orElseThrow();

    assertEquals(1.5, meeting.place().x(), 0.3);
    assertTrue(planner.encounter(detour, 0, 0, discs).isEmpty(), "nobody is met on it");
    assertEquals(LINE.at(0), detour.at(0));
    assertEquals(0, detour.at(detour.length()).distanceTo(LINE.at(LINE.length())), 1e-9);
    assertTrue(detour.length() > LINE.length());
    assertTrue(detour.length() < 1.2 * LINE.length(), "a detour of " + detour.length());
    for (double s = 0; s < detour.length(); s += 0.01) {
      assertTrue(
          Math.abs(detour.curvature(s)) < 16, "bends of " + detour.curvature(s) + " at " + s);
    }
  }

  @Test
  void whoMeetsNobodyIsLeftAlone() {
    List<MovingDisc> discs = List.of(new MovingDisc(new Vec2(1.5, 1.3), new Vec2(0, 0.1), 0.1, 0));

    assertTrue(planner(ROOM).encounter(LINE, 0, 0, discs).isEmpty());
  }

  @Test
  void inAnAisleWithoutRoomThereIsNoDetour() {
    BitSet walls = new BitSet();
    for (int column = 0; column < 300; column++) {
      for (int row = 0; row < 200; row++) {
        walls.set(row * 300 + column, Math.abs(row - 99.5) > 14);
      }
    }
    OccupancyGrid aisle = new OccupancyGrid(300, 200, 0.01, Vec2.ZERO, walls);
    List<MovingDisc> discs = List.of(new MovingDisc(new Vec2(2.2, 1), new Vec2(-0.1, 0), 0.1, 0));
    DetourPlanner planner = planner(aisle);
    Encounter meeting = planner.encounter(LINE, 0, 0, discs).orElseThrow();

    Optional<DrivenLine> detour = planner.plan(LINE, 0, 0, meeting, discs);

    assertTrue(detour.isEmpty());
  }
}
