package org.toqa.avoidance;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;

/** A robot of 0.2 m radius that drives 2 m to the east, or round a corner. */
class PassageTest {
  private static final double RADIUS = 0.2;
  private static final double INFINITE = Double.POSITIVE_INFINITY;
  private static final Corridor EAST = new Corridor(List.of(new Pose(1, 1, 0), new Pose(3, 1, 0)));

  @Test
  void whatStandsInTheMiddleIsStoppedBefore() {
    Vec2 thing = new Vec2(2, 1.05);

    // 1 m along, less 0.2 m of robot
    assertEquals(new Passage(List.of(thing), List.of(), 0.8), rounded(through(thing)));
  }

  @Test
  void wallsBesideTheWayAndThingsBehindItsEndAndBehindTheRobotAreOfNoConcern() {
    assertEquals(
        new Passage(List.of(), List.of(), INFINITE),
        through(new Vec2(2, 1.2101), new Vec2(2, 0.7899), new Vec2(3.2101, 1), new Vec2(0.95, 1)));
  }

  @Test
  void whatIsALittleTooNearIsPassed() {
    Vec2 thing = new Vec2(2, 1.205); // 0.005 m beside the robot's width

    assertEquals(new Passage(List.of(), List.of(thing), INFINITE), through(thing));
  }

  @Test
  void whatIsTooNearOnBothSidesIsPassedOnlyWhereTheRobotFits() {
    Vec2 left = new Vec2(2, 1.202); // 0.008 m too near
    Vec2 right = new Vec2(2.1, 0.799); // 0.009 m
    Vec2 within = new Vec2(2.1, 0.801); // 0.011 m, and within the robot's width

    assertEquals(new Passage(List.of(), List.of(left, right), INFINITE), through(left, right));
    assertEquals(new Passage(List.of(within), List.of(left), 0.9), rounded(through(left, within)));
  }

  @Test
  void theWayIsMeasuredRoundItsCorners() {
    List<Pose> bend = new ArrayList<>();
    Pose pose = new Pose(0, 0, 0);
    for (int i = 0; i <= 50; i++) {
      bend.add(pose.advanced(new Twist(1, 0, 1), i * Math.PI / 100));
    }

    // a quarter of a circle of 1 m round (0, 1), which ends in (1, 1); 60 degrees along it
    Vec2 thing = new Vec2(Math.sin(Math.PI / 3), 1 - Math.cos(Math.PI / 3));
    Passage passage =
        Passage.through(new Corridor(bend), List.of(thing), RADIUS, Sidestep.MAX_OFFSET);

    assertEquals(Math.PI / 3 - 0.2, passage.ahead(), 0.01);
    assertEquals(Math.PI / 3 - 0.38, passage.freeDistance(), 0.01); // 0.18 m before it
    assertEquals(List.of(thing), passage.blocking());
  }

  private static Passage through(Vec2... seen) {
    return Passage.through(EAST, List.of(seen), RADIUS, Sidestep.MAX_OFFSET);
  }

  private static Passage rounded(Passage passage) {
    return new Passage(
        passage.blocking(), passage.beside(), Math.round(passage.ahead() * 1e9) / 1e9);
  }
}
