package org.toqa.avoidance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;

/** A robot on a straight path of 3 m. */
class SidestepPropertyTest {
  private static final double TICK = 0.02;
  private static final double SPEED = 0.25;
  private static final double END = 3;

  @Example
  void whoSeesNothingStaysExactlyOnTheWay() {
    Sidestep sidestep = new Sidestep();
    Pose pose = new Pose(1, 2, 0.3);
    Twist twist = new Twist(0.2, 0, 0.5);

    sidestep.step(pose, SPEED, List.of(), END, TICK);

    assertSame(pose, sidestep.beside(pose));
    assertSame(twist, sidestep.beside(twist));
  }

  @Property
  void theRobotGivesWayWithinItsRoomAndComesBack(
      @ForAll @DoubleRange(min = 0.8, max = 2.5) double x,
      @ForAll @DoubleRange(min = 0.05, max = 0.2) double aside,
      @ForAll boolean onLeft) {
    Vec2 thing = new Vec2(x, onLeft ? aside : -aside);
    Sidestep sidestep = new Sidestep();
    double most = 0;
    for (double at = 0; at < END; at += SPEED * TICK) {
      boolean isAhead = x > at && x - at < 0.5;
      sidestep.step(
          new Pose(at, 0, 0), SPEED, isAhead ? List.of(thing) : List.of(), END - at, TICK);
      double away = onLeft ? -sidestep.offset() : sidestep.offset();
      assertTrue(away >= 0, "towards it by " + -away);
      most = Math.max(most, away);
    }
    assertTrue(most > 0.005 && most <= Sidestep.MAX_OFFSET, "aside by " + most);
    assertEquals(0, sidestep.offset(), 0.001);
  }

  @Property
  void besideAWayThatTurnsTheRobotDrivesTheParallelOne(
      @ForAll @DoubleRange(min = -1.5, max = 1.5) double turnRate) {
    Sidestep sidestep = new Sidestep();
    while (sidestep.offset() > -Sidestep.MAX_OFFSET) {
      sidestep.step(new Pose(0, 0, 0), SPEED, List.of(new Vec2(0.2, 0.1)), END, TICK);
    }
    sidestep.step(new Pose(0, 0, 0), SPEED, List.of(new Vec2(0.2, 0.1)), END, TICK);
    Twist onWay = new Twist(SPEED, 0, turnRate);

    Pose driven = sidestep.beside(new Pose(0, 0, 0)).advanced(sidestep.beside(onWay), 0.1);

    Pose wanted = sidestep.beside(new Pose(0, 0, 0).advanced(onWay, 0.1));
    assertEquals(0, driven.distanceTo(wanted), 1e-12);
  }
}
