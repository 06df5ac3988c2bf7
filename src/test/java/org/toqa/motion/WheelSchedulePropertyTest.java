package org.toqa.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.EdgeCasesMode;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.PlaneCurve;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

class WheelSchedulePropertyTest {
  private static final DifferentialLimits LIMITS = DifferentialLimits.DEFAULT;

  /** x grows evenly, y is a sum of two waves: curvature and its change are known to be bounded. */
  private record Waves(double end, double high, double low) implements PlaneCurve {
    @Override
    public Vec2 position(double u) {
      return new Vec2(0.2 * u, high * Math.sin(u) + low * Math.cos(2 * u));
    }

    @Override
    public Vec2 velocity(double u) {
      return new Vec2(0.2, high * Math.cos(u) - 2 * low * Math.sin(2 * u));
    }

    @Override
    public Vec2 acceleration(double u) {
      return new Vec2(0, -high * Math.sin(u) - 4 * low * Math.cos(2 * u));
    }
  }

  @Provide
  Arbitrary<PlaneCurve> curves() {
    return Combinators.combine(
            Arbitraries.doubles().between(0.5, 12),
            Arbitraries.doubles().between(-0.3, 0.3),
            Arbitraries.doubles().between(-0.1, 0.1))
        .as(Waves::new);
  }

  @Property(tries = 200, edgeCases = EdgeCasesMode.NONE)
  void limitsHoldAtEachMoment(@ForAll("curves") PlaneCurve curve) {
    ArcLength along = new ArcLength(curve);
    VelocityProfile profile =
        new VelocityPlanner(LIMITS.wheelSpeed(), LIMITS.acceleration(), LIMITS.jerk())
            .plan(along.total(), s -> LIMITS.speedAt(curve.curvature(along.parameterAt(s))));
    double[] speeds = profile.speeds();
    double h = profile.step();
    for (int i = 0; i < speeds.length; i++) {
      double place = profile.distances()[i];
      double limit = LIMITS.speedAt(curve.curvature(along.parameterAt(place)));
      assertTrue(speeds[i] <= limit * 1.002, "speed");
      if (i >= 1) {
        assertTrue(Math.abs(speeds[i] - speeds[i - 1]) / h <= LIMITS.acceleration() * 1.01);
      }
      if (i >= 2) {
        double jerk = (speeds[i] - 2 * speeds[i - 1] + speeds[i - 2]) / (h * h);
        assertTrue(Math.abs(jerk) <= LIMITS.jerk() * 1.02, () -> "jerk " + jerk);
      }
    }
    assertEquals(0, speeds[0]);
    assertEquals(0, speeds[speeds.length - 1], 1e-9);
    assertEquals(along.total(), profile.distanceAt(profile.duration()), 1e-9);
  }

  @Property(tries = 200, edgeCases = EdgeCasesMode.NONE)
  void wheelsAreWithinTheirLimitsAndLeadToTheEnd(@ForAll("curves") PlaneCurve curve) {
    double heading = curve.velocity(0).angle();
    double last = curve.velocity(curve.end()).angle();
    WheelSchedule schedule = WheelSchedule.of(heading, List.of(curve), last, LIMITS);
    for (WheelCommand command : schedule.commands()) {
      for (WheelCommand.Wheel wheel : List.of(command.left(), command.right())) {
        assertTrue(Math.abs(wheel.speed()) <= LIMITS.wheelSpeed() + 1e-12);
        assertTrue(wheel.amplitude() >= 0 && wheel.amplitude() <= 255);
        assertTrue(wheel.pulseMilliseconds() <= 33);
        assertEquals(wheel.speed() >= 0, wheel.isForward());
      }
      assertEquals(command.v(), (command.left().speed() + command.right().speed()) / 2, 1e-12);
      assertEquals(
          command.w(), (command.right().speed() - command.left().speed()) / LIMITS.track(), 1e-9);
    }
    Vec2 start = curve.position(0);
    Pose end = schedule.end(new Pose(start.x(), start.y(), heading));
    // samples of 30 ms, each with one (v, w)
    assertEquals(0, end.position().distanceTo(curve.position(curve.end())), 0.01);
  }

  @Property(tries = 200, edgeCases = EdgeCasesMode.NONE)
  void biarcsAreWithinAMillimetreOfTheCurve(@ForAll("curves") PlaneCurve curve) {
    double heading = curve.velocity(0).angle();
    Trajectory trajectory = new BiarcFitter(DriveSpeeds.DEFAULT).fit(heading, List.of(curve));
    List<Vec2> driven = new ArrayList<>();
    Pose pose = trajectory.start();
    for (Segment segment : trajectory.segments()) {
      int count = (int) Math.ceil(segment.length() / 0.001);
      for (int i = 0; i < count; i++) {
        driven.add(pose.advanced(segment.twist(), segment.t() * i / count).position());
      }
      pose = pose.advanced(segment.twist(), segment.t());
    }
    driven.add(pose.position());
    int next = 0;
    for (double u = 0; u <= curve.end(); u += 0.01) {
      Vec2 point = curve.position(u);
      double nearest = Double.POSITIVE_INFINITY;
      for (int i = Math.max(0, next - 50); i < Math.min(driven.size(), next + 200); i++) {
        if (driven.get(i).distanceTo(point) < nearest) {
          nearest = driven.get(i).distanceTo(point);
          next = i;
        }
      }
      // points of the arcs are at most 1 mm apart
      assertTrue(nearest <= Math.hypot(0.001, 0.0005), "off the curve");
    }
    assertEquals(0, pose.position().distanceTo(curve.position(curve.end())), 1e-6);
  }

  @Test
  void aTurnOnTheSpotTurnsBothWheelsAgainstEachOther() {
    WheelSchedule schedule = WheelSchedule.of(0, List.of(), Math.PI / 2, LIMITS);
    Pose end = schedule.end(new Pose(1, 2, 0));
    assertEquals(Math.PI / 2, end.theta(), 0.01);
    assertEquals(0, end.position().distanceTo(new Vec2(1, 2)), 1e-9);
    assertTrue(schedule.commands().stream().allMatch(c -> c.v() == 0));
    assertTrue(schedule.commands().stream().allMatch(c -> c.left().speed() == -c.right().speed()));
  }

  @Test
  void theSignalOfAWheelIsThatOfThePaper() {
    // half of 0.52 m/s: 15 of 30 ms, 127.5 rounded up, 128 * 33 / 255 ms
    WheelCommand.Wheel wheel = WheelCommand.Wheel.of(-0.26, 0.52);
    assertEquals(0.015, wheel.onSeconds(), 1e-12);
    assertEquals(128, wheel.amplitude());
    assertEquals(16.565, wheel.pulseMilliseconds(), 1e-3);
    assertEquals(false, wheel.isForward());
  }

  @Test
  void limitsArePositive() {
    assertThrows(IllegalArgumentException.class, () -> new DifferentialLimits(0.52, 0, 1, 1, 1));
  }
}
