package org.toqa.arm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.Scale;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

class InverseKinematicsPropertyTest {
  /** Radians between the stands that the slow check tries. */
  private static final double STEP = 0.02;

  @Provide
  Arbitrary<Pose> bases() {
    return ArmsForTests.bases();
  }

  @Provide
  Arbitrary<Arm> limited() {
    return ArmsForTests.limited();
  }

  @Property(tries = 500)
  void handIsAtTheTargetWithEitherElbowWhereverTheLinksReach(
      @ForAll @Scale(9) @DoubleRange(min = 0.05, max = 2) double upper,
      @ForAll @Scale(9) @DoubleRange(min = 0.05, max = 2) double fore,
      @ForAll("bases") Pose base,
      @ForAll @Scale(9) @DoubleRange(min = 0, max = 1) double share,
      @ForAll @Scale(9) @DoubleRange(min = -3.14, max = 3.14) double bearing) {
    Arm arm = ArmsForTests.free(upper, fore, base);
    double distance = arm.nearest() + share * (arm.farthest() - arm.nearest());
    Vec2 target = base.position().plus(new Vec2(distance, 0).rotated(bearing));

    List<JointAngles> ways =
        assertInstanceOf(Reach.Within.class, InverseKinematics.solve(arm, target)).ways();

    for (JointAngles way : ways) {
      // within 1e-9 m of the edges the target itself may be so far outside
      assertEquals(0, arm.handAt(way).distanceTo(target), 1e-7);
      assertTrue(arm.allows(way));
    }
    if (share > 0.01 && share < 0.99) {
      assertEquals(2, ways.size());
      assertEquals(ways.get(0).elbow(), -ways.get(1).elbow(), 1e-12);
      assertTrue(Math.abs(ways.get(0).elbow()) > 1e-3, "one elbow is left, the other right");
    }
  }

  @Property(tries = 300)
  void placeBeyondTheLinksIsNamed(
      @ForAll @Scale(9) @DoubleRange(min = 0.05, max = 2) double upper,
      @ForAll @Scale(9) @DoubleRange(min = 0.05, max = 2) double fore,
      @ForAll("bases") Pose base,
      @ForAll @Scale(9) @DoubleRange(min = 1e-6, max = 1e6) double beyond,
      @ForAll @Scale(9) @DoubleRange(min = -3.14, max = 3.14) double bearing) {
    Arm arm = ArmsForTests.free(upper, fore, base);
    assertEquals(Reach.Reason.TOO_FAR, reason(arm, arm.farthest() + beyond, bearing));
    double inside = arm.nearest() - beyond;
    if (inside > 0) {
      assertEquals(Reach.Reason.TOO_NEAR, reason(arm, inside, bearing));
    }
  }

  private static Reach.Reason reason(Arm arm, double distance, double bearing) {
    Vec2 target = arm.base().position().plus(new Vec2(distance, 0).rotated(bearing));
    return assertInstanceOf(Reach.Outside.class, InverseKinematics.solve(arm, target)).reason();
  }

  @Test
  void shoulderItselfIsReachedByLinksOfTheSameLengthAlone() {
    Arm alike = ArmsForTests.free(0.3, 0.3, new Pose(0.1, 0, 0));
    Vec2 shoulder = new Vec2(0.1, 0);
    for (JointAngles way :
        assertInstanceOf(Reach.Within.class, InverseKinematics.solve(alike, shoulder)).ways()) {
      assertEquals(0, alike.handAt(way).distanceTo(shoulder), 1e-9);
    }
    Arm other = ArmsForTests.free(0.3, 0.2, new Pose(0.1, 0, 0));
    assertEquals(
        new Reach.Outside(Reach.Reason.TOO_NEAR, 0), InverseKinematics.solve(other, shoulder));
  }

  /** An independent check: tries all stands, 0.02 rad apart. */
  @Property(tries = 12, edgeCases = EdgeCasesMode.NONE)
  void whatTryingAllStandsFindsIsReached(
      @ForAll("limited") Arm arm,
      @ForAll @Scale(9) @DoubleRange(min = -1.5, max = 1.5) double x,
      @ForAll @Scale(9) @DoubleRange(min = -1.5, max = 1.5) double y) {
    Vec2 target = new Vec2(x, y);
    double nearest = Double.MAX_VALUE;
    JointLimits shoulder = arm.shoulder();
    JointLimits elbow = arm.elbow();
    for (double s = shoulder.least(); s <= shoulder.most(); s += STEP) {
      for (double e = elbow.least(); e <= elbow.most(); e += STEP) {
        double cos = Math.cos(arm.base().theta() + s);
        double sin = Math.sin(arm.base().theta() + s);
        double foreCos = Math.cos(arm.base().theta() + s + e);
        double foreSin = Math.sin(arm.base().theta() + s + e);
        double handX = arm.base().x() + arm.upperLink() * cos + arm.foreLink() * foreCos;
        double handY = arm.base().y() + arm.upperLink() * sin + arm.foreLink() * foreSin;
        nearest = Math.min(nearest, Math.hypot(handX - x, handY - y));
      }
    }
    // a stand between those tried is within STEP of one in each joint
    double gap = STEP * (arm.upperLink() + 2 * arm.foreLink());
    switch (InverseKinematics.solve(arm, target)) {
      case Reach.Within(List<JointAngles> ways) -> {
        assertTrue(nearest <= gap, "reached, but no stand comes nearer than " + nearest);
        for (JointAngles way : ways) {
          assertTrue(arm.allows(way));
          assertEquals(0, arm.handAt(way).distanceTo(target), 1e-7);
        }
      }
      case Reach.Outside _ ->
          assertTrue(nearest > 1e-6, "not reached, but a stand comes as near as " + nearest);
    }
  }

  /** A stand that is allowed leads to a place that is reached: nothing is refused wrongly. */
  @Property(tries = 500)
  void placeOfEachAllowedStandIsReached(
      @ForAll("limited") Arm arm,
      @ForAll @Scale(9) @DoubleRange(min = 0, max = 1) double shoulderShare,
      @ForAll @Scale(9) @DoubleRange(min = 0, max = 1) double elbowShare) {
    JointAngles stand =
        new JointAngles(
            arm.shoulder().least()
                + shoulderShare * (arm.shoulder().most() - arm.shoulder().least()),
            arm.elbow().least() + elbowShare * (arm.elbow().most() - arm.elbow().least()));
    Vec2 hand = arm.handAt(stand);
    if (InverseKinematics.solve(arm, hand) instanceof Reach.Within(List<JointAngles> ways)) {
      assertTrue(ways.stream().anyMatch(way -> arm.handAt(way).distanceTo(hand) < 1e-7));
    } else {
      // rounding may put what stands at a limit beyond it, by no more than the bend's square root
      assertTrue(
          shoulderShare < 1e-6
              || shoulderShare > 1 - 1e-6
              || elbowShare < 1e-6
              || elbowShare > 1 - 1e-6
              || Math.abs(stand.elbow()) < 1e-6,
          () -> "refused " + stand);
    }
  }

  @Property(tries = 200)
  void robotThatFacesAsFoundReaches(
      @ForAll("limited") Arm arm,
      @ForAll @Scale(9) @DoubleRange(min = -2.5, max = 2.5) double x,
      @ForAll @Scale(9) @DoubleRange(min = -2.5, max = 2.5) double y) {
    Vec2 stand = new Vec2(3, 4);
    Vec2 target = stand.plus(new Vec2(x, y));
    switch (ArmStance.find(arm, stand, target)) {
      case ArmStance.Facing(double heading) -> {
        Vec2 seen =
            new Pose(stand.x(), stand.y(), heading)
                .relative(new Pose(target.x(), target.y(), 0))
                .position();
        assertInstanceOf(Reach.Within.class, InverseKinematics.solve(arm, seen));
      }
      case ArmStance.None(Reach.Reason reason, double distance) -> {
        if (reason == Reach.Reason.TOO_FAR) {
          assertTrue(distance > arm.farthest());
        }
        for (int degrees = 0; degrees < 360; degrees += 7) {
          Vec2 seen = new Vec2(x, y).rotated(Math.toRadians(degrees));
          double off = InverseKinematics.solve(arm, seen) instanceof Reach.Within ? 1 : 0;
          assertTrue(off == 0 || reason == Reach.Reason.JOINT_LIMITS, "a heading helps");
        }
      }
    }
  }
}
