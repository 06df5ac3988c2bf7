package org.toqa.arm;

import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import org.toqa.geometry.Pose;

/** Arms of many shapes. */
final class ArmsForTests {
  private ArmsForTests() {}

  /** Joints that turn all round. */
  static Arm free(double upper, double fore, Pose base) {
    return new Arm(
        upper,
        fore,
        base,
        new JointLimits(-Math.PI, Math.PI, 1.5, 4),
        new JointLimits(-Math.PI, Math.PI, 2, 5),
        3,
        JointAngles.ZERO);
  }

  static Arbitrary<Pose> bases() {
    return Combinators.combine(
            Arbitraries.doubles().between(-0.3, 0.3).ofScale(9),
            Arbitraries.doubles().between(-0.3, 0.3).ofScale(9),
            Arbitraries.doubles().between(-3.14, 3.14).ofScale(9))
        .as(Pose::new);
  }

  static Arbitrary<JointLimits> joints() {
    return Combinators.combine(
            Arbitraries.doubles().between(-3.1, -0.1).ofScale(9),
            Arbitraries.doubles().between(0.1, 3.1).ofScale(9),
            Arbitraries.doubles().between(0.2, 3).ofScale(9),
            Arbitraries.doubles().between(0.5, 20).ofScale(9))
        .as(JointLimits::new);
  }

  static Arbitrary<Arm> limited() {
    return Combinators.combine(
            Arbitraries.doubles().between(0.1, 1).ofScale(9),
            Arbitraries.doubles().between(0.1, 1).ofScale(9),
            bases(),
            joints(),
            joints())
        .as(
            (upper, fore, base, shoulder, elbow) ->
                new Arm(upper, fore, base, shoulder, elbow, 3, JointAngles.ZERO));
  }
}
