package org.toqa.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;

class SegmentFitterTest {
  private static final Pose EASTWARD = new Pose(0, 0, 0);
  private final SegmentFitter fitter = new SegmentFitter(new DriveSpeeds(0.25, 1.5, 1.0), 0.3);

  private static Waypoint corner(double x, double y) {
    return new Waypoint(new Vec2(x, y), false);
  }

  private static Waypoint spot(double x, double y) {
    return new Waypoint(new Vec2(x, y), true);
  }

  private static void assertSegment(double v, double w, double t, Segment segment) {
    assertEquals(v, segment.v(), 1e-9);
    assertEquals(w, segment.w(), 1e-9);
    assertEquals(t, segment.t(), 1e-9);
  }

  @Test
  void straightAheadIsOneSegment() {
    List<Segment> segments = fitter.fit(EASTWARD, List.of(corner(2, 0))).segments();
    assertEquals(1, segments.size());
    assertSegment(0.25, 0, 8, segments.getFirst()); // 2 m at 0.25 m/s = 8 s
  }

  @Test
  void robotThatFacesElsewhereTurnsFirst() {
    List<Segment> segments =
        fitter.fit(new Pose(0, 0, Math.PI / 2), List.of(corner(1, 0))).segments();
    assertSegment(0, -1, Math.PI / 2, segments.getFirst());
    assertEquals(2, segments.size());
  }

  @Test
  void cornerOf45DegreesIsTheArcOfTheTable() {
    List<Segment> segments =
        fitter.fit(EASTWARD, List.of(corner(0.9, 0), corner(1.8, 0.9))).segments();
    assertEquals(3, segments.size());
    assertSegment(0.25, 0, (0.9 - 0.15) / 0.25, segments.get(0));
    // R = 0.15 m / tan(pi/8) = 0.362 m; w = 0.25 / R = 0.690 rad/s, below the limit
    double rate = 0.25 * Math.tan(Math.PI / 8) / 0.15;
    assertSegment(0.25, rate, Math.PI / 4 / rate, segments.get(1));
    assertSegment(0.25, 0, (0.9 * Math.sqrt(2) - 0.15) / 0.25, segments.get(2));
  }

  @Test
  void tightCornerIsDrivenAtTheRateLimit() {
    Segment arc = fitter.fit(EASTWARD, List.of(corner(1, 0), corner(1, -1))).segments().get(1);
    // R = 0.15 m; 0.25 m/s would need 1.67 rad/s, so 1.5 rad/s * 0.15 m = 0.225 m/s
    assertSegment(0.225, -1.5, Math.PI / 2 / 1.5, arc);
  }

  @Test
  void arcsOnAShortLegShareIt() {
    Trajectory trajectory =
        fitter.fit(EASTWARD, List.of(corner(1, 0), corner(1, 0.2), corner(2, 0.2)));
    List<Segment> segments = trajectory.segments();
    // straight, arc, arc, straight; the leg of 0.2 m is 0.1 m for each arc
    assertEquals(4, segments.size());
    assertEquals(0.9, segments.get(0).length(), 1e-9);
    assertEquals(0.1 * Math.PI / 2, segments.get(1).length(), 1e-9);
    assertEquals(0.9, segments.get(3).length(), 1e-9);
    assertEquals(0, trajectory.end().relative(new Pose(2, 0.2, 0)).position().norm(), 1e-9);
  }

  @Test
  void markedCornerIsTurnedOnTheSpot() {
    List<Segment> segments = fitter.fit(EASTWARD, List.of(spot(1, 0), corner(1, 1))).segments();
    assertEquals(3, segments.size());
    assertSegment(0.25, 0, 4, segments.get(0));
    assertSegment(0, 1, Math.PI / 2, segments.get(1));
    assertSegment(0.25, 0, 4, segments.get(2));
  }

  @Test
  void wayBackIsTurnedOnTheSpot() {
    List<Segment> segments = fitter.fit(EASTWARD, List.of(corner(1, 0), corner(0, 0))).segments();
    assertEquals(3, segments.size());
    assertEquals(0, segments.get(1).v());
    assertEquals(Math.PI, Math.abs(segments.get(1).angle()), 1e-9);
  }

  @Test
  void finalHeadingIsTurnedToAtTheEnd() {
    Trajectory trajectory = fitter.fit(EASTWARD, List.of(corner(1, 0)), Math.PI);
    assertEquals(Math.PI, trajectory.end().theta(), 1e-9);
    assertEquals(2, trajectory.segments().size());
  }

  @Test
  void robotThatStandsAtItsGoalDrivesNothing() {
    assertTrue(fitter.fit(EASTWARD, List.of()).segments().isEmpty());
    assertTrue(fitter.fit(EASTWARD, List.of(corner(0, 0))).segments().isEmpty());
  }

  @Test
  void numbersThatAreNoneAreRefused() {
    assertThrows(
        IllegalArgumentException.class, () -> fitter.fit(EASTWARD, List.of(corner(Double.NaN, 0))));
    assertThrows(
        IllegalArgumentException.class,
        () -> fitter.fit(new Pose(Double.POSITIVE_INFINITY, 0, 0), List.of(corner(1, 0))));
    assertThrows(
        IllegalArgumentException.class,
        () -> fitter.fit(EASTWARD, List.of(corner(1, 0)), Double.NaN));
    assertThrows(IllegalArgumentException.class, () -> new DriveSpeeds(0, 1, 1));
    assertThrows(
        IllegalArgumentException.class, () -> new SegmentFitter(DriveSpeeds.DEFAULT, -0.3));
  }
}
