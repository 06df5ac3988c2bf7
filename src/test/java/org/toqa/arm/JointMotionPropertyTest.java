package org.toqa.arm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.toqa.geometry.Pose;

/** From any stand to any other, tick by tick. */
class JointMotionPropertyTest {

  private static final double TICK = 0.02;
  private static final Arm ARM = ArmsForTests.free(0.3, 0.25, new Pose(0, 0, 0));

  @Provide
  Arbitrary<JointAngles> stands() {
    Arbitrary<Double> angles = Arbitraries.doubles().between(-3.14, 3.14).ofScale(15);
    return Combinators.combine(angles, angles).as(JointAngles::new);
  }

  @Property(tries = 200)
  void endsItsMotionWithItsTrajectory(
      @ForAll("stands") JointAngles from, @ForAll("stands") JointAngles to) {
    JointMotion motion = new JointMotion(ARM, from);
    motion.setGoal(to);
    double duration = JointTrajectory.between(ARM, from, to).duration();
    for (double t = 0; t <= duration + TICK; t += TICK) {
      motion.advance(TICK, true, motion.now().angles());
    }
    assertTrue(motion.isAtGoal());
    assertEquals(0, motion.now().angles().minus(to).largest(), 1e-9);
  }

  /** What stopped them stopped them at once: they go on from there. */
  @Property(tries = 50)
  void goesOnFromWhereTheJointsStandAfterAHalt(
      @ForAll("stands") JointAngles from, @ForAll("stands") JointAngles to) {
    JointMotion motion = new JointMotion(ARM, from);
    motion.setGoal(to);
    JointAngles stand = from;
    for (int i = 0; i < 10; i++) {
      motion.advance(TICK, true, stand);
      stand = motion.now().angles();
    }
    for (int i = 0; i < 200; i++) {
      motion.advance(TICK, false, stand);
    }
    motion.advance(TICK, true, stand);
    assertEquals(0, motion.now().angles().minus(stand).largest(), 0.01 + 1e-9);
  }
}
