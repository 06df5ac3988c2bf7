package org.toqa.formation.swarm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.toqa.geometry.Vec2;

class ShapeKeepingPropertyTest {
  private static final ShapeKeeping KEEPING = new ShapeKeeping(0.2, 0.5, 2);
  private static final Vec2 FORWARD = new Vec2(1, 0);

  /** Each step makes good a fifth of the error, or half a step's length. */
  @Property
  void theShapeErrorShrinksAsTheLawSays(
      @ForAll @DoubleRange(min = -10, max = 10) double x,
      @ForAll @DoubleRange(min = -10, max = 10) double y) {
    List<SwarmRobot> robots = new ArrayList<>();
    robots.add(new SwarmRobot(new Vec2(x, y), Vec2.ZERO));
    robots.add(new SwarmRobot(new Vec2(4 - x, -y), new Vec2(4, 0)));
    for (int step = 0; step < 60; step++) {
      double before = VirtualLeader.shapeError(robots);
      Vec2 leader = VirtualLeader.position(robots);
      robots.replaceAll(
          r ->
              new SwarmRobot(
                  r.position().plus(KEEPING.displacement(r, leader, FORWARD, Vec2.ZERO)),
                  r.wanted()));
      double expected = before - Math.min(0.2 * before, 0.5);
      assertEquals(expected, VirtualLeader.shapeError(robots), 1e-9);
      assertEquals(leader.plus(FORWARD).x(), VirtualLeader.position(robots).x(), 1e-9);
    }
  }

  @Property
  void whatIsNearPushesAwayTheMoreTheNearerItIs(
      @ForAll @DoubleRange(min = 0.01, max = 1.9) double gap,
      @ForAll @DoubleRange(min = -3, max = 3) double angle) {
    SwarmRobot robot = new SwarmRobot(Vec2.ZERO, Vec2.ZERO);
    Vec2 thing = new Vec2(gap, 0).rotated(angle);
    Vec2 push = KEEPING.displacement(robot, Vec2.ZERO, FORWARD, thing).minus(FORWARD);

    assertEquals(1 - gap / 2, push.norm(), 1e-9); // twice half a step where it touches
    assertEquals(0, push.plus(thing.times(push.norm() / gap)).norm(), 1e-9);
  }

  @Example
  void thePublishedLawDrivesAllRobotsAlike() {
    SwarmRobot robot = new SwarmRobot(new Vec2(3, 3), Vec2.ZERO);

    Vec2 step = ShapeKeeping.NONE.displacement(robot, Vec2.ZERO, FORWARD, new Vec2(0.1, 0));

    assertTrue(step.equals(FORWARD));
  }
}
