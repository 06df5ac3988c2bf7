package org.toqa.driving;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.motion.DifferentialLimits;
import org.toqa.motion.WheelCommand;

class WheelTrackerPropertyTest {
  private static final DifferentialLimits LIMITS = DifferentialLimits.DEFAULT;
  private static final double LAG = 0.05;

  /** A body whose motors lag, in steps of a hundredth of a sample. */
  private static final class Body {
    private Pose pose;
    private Twist twist = Twist.ZERO;

    Body(Pose pose) {
      this.pose = pose;
    }

    void drive(WheelCommand command) {
      double seconds = WheelCommand.SAMPLE / 100;
      double share = 1 - Math.exp(-seconds / LAG);
      for (int i = 0; i < 100; i++) {
        twist =
            new Twist(
                twist.vx() + share * (command.v() - twist.vx()),
                0,
                twist.w() + share * (command.w() - twist.w()));
        pose = pose.advanced(twist, seconds);
      }
    }
  }

  @Property(tries = 100, edgeCases = EdgeCasesMode.NONE)
  void aRobotComesOntoItsReferenceAndStaysThereThoughItsAnswersAreLate(
      @ForAll @DoubleRange(min = -0.04, max = 0.04) double ahead,
      @ForAll @DoubleRange(min = -0.04, max = 0.04) double beside,
      @ForAll @DoubleRange(min = -0.3, max = 0.3) double turned,
      @ForAll @DoubleRange(min = 0.1, max = 0.35) double speed,
      @ForAll @DoubleRange(min = -0.8, max = 0.8) double turn,
      @ForAll @IntRange(min = 0, max = 6) int late) {
    Body body = new Body(new Pose(ahead, beside, turned));
    WheelTracker tracker = new WheelTracker(LIMITS, LAG);
    Pose reference = new Pose(0, 0, 0);
    Twist twist = new Twist(speed, 0, turn);
    List<Pose> answers = new ArrayList<>();
    for (int i = 0; i < 300; i++) {
      answers.add(body.pose);
      int answered = Math.max(0, i - late);
      Pose predicted = tracker.predicted(answered, answers.get(answered));
      assertEquals(0, predicted.distanceTo(body.pose), 0.002, "predicted from what was told");
      WheelCommand command = tracker.next(reference, twist, twist, answered, answers.get(answered));
      assertTrue(Math.abs(command.left().speed()) <= LIMITS.wheelSpeed() + 1e-12);
      assertTrue(Math.abs(command.right().speed()) <= LIMITS.wheelSpeed() + 1e-12);
      body.drive(command);
      reference = reference.advanced(twist, WheelCommand.SAMPLE);
    }
    // 9 s are many time constants of the law
    assertEquals(0, reference.distanceTo(body.pose), 0.003);
  }
}
