package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;

class TrackThinnerTest {
  private static final Instant START = Instant.parse("2026-11-21T08:00:00Z");

  private final TrackThinner thinner = new TrackThinner("r1");
  private final List<TrackPoint> kept = new ArrayList<>();
  private Instant now = START;

  @Test
  void aStraightWayIsItsTwoEnds() {
    drive(new Vec2(0, 0), new Vec2(5, 0));
    drive(new Vec2(5, 0), new Vec2(5, 5));

    assertEquals(2, kept.size(), kept::toString);
    near(new Vec2(0, 0), kept.get(0).position());
    near(new Vec2(5, 0), kept.get(1).position());
  }

  @Test
  void whereARobotTurnsRoundIsKept() {
    drive(new Vec2(0, 0), new Vec2(3, 0));
    drive(new Vec2(3, 0), new Vec2(1, 0));

    near(new Vec2(3, 0), kept.get(1).position());
  }

  @Test
  void aRobotThatStandsForADayLeavesWhenItCameAndWhenItWent() {
    for (int i = 0; i < 24 * 60; i++) {
      see(new Vec2(1, 1 + 0.01 * (i % 2)), Duration.ofMinutes(1));
    }
    assertEquals(1, kept.size());
    Instant left = now;

    drive(new Vec2(1, 1), new Vec2(2, 1));

    assertEquals(2, kept.size());
    assertTrue(!kept.get(1).at().isBefore(left.minusSeconds(60)), kept::toString);
  }

  @Test
  void noPositionIsFarFromTheTrack() {
    Random random = new Random(1);
    List<Vec2> seen = new ArrayList<>();
    double heading = 0;
    Vec2 position = new Vec2(0, 0);
    for (int i = 0; i < 20_000; i++) {
      heading += 0.2 * random.nextGaussian();
      position = position.plus(new Vec2(Math.cos(heading), Math.sin(heading)).times(0.05));
      seen.add(position);
      see(position, Duration.ofMillis(200));
    }

    for (Vec2 point : seen.subList(0, 19_000)) {
      assertTrue(distanceToTrack(point) < 2 * TrackThinner.TOLERANCE + 0.05, point::toString);
    }
    assertTrue(kept.size() < 20_000 / 5, () -> kept.size() + " points");
  }

  private void drive(Vec2 from, Vec2 to) {
    for (int i = 0; i <= 50; i++) {
      see(from.plus(to.minus(from).times(i / 50.0)), Duration.ofMillis(200));
    }
  }

  private void see(Vec2 position, Duration after) {
    now = now.plus(after);
    thinner.add(now, position).ifPresent(kept::add);
  }

  private double distanceToTrack(Vec2 point) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = 1; i < kept.size(); i++) {
      least = Math.min(least, distance(point, kept.get(i - 1).position(), kept.get(i).position()));
    }
    return least;
  }

  private static double distance(Vec2 point, Vec2 from, Vec2 to) {
    Vec2 line = to.minus(from);
    Vec2 way = point.minus(from);
    double length = line.x() * line.x() + line.y() * line.y();
    double share =
        length == 0 ? 0 : Math.clamp((way.x() * line.x() + way.y() * line.y()) / length, 0, 1);
    return point.distanceTo(from.plus(line.times(share)));
  }

  private static void near(Vec2 expected, Vec2 actual) {
    assertTrue(
        expected.distanceTo(actual) <= TrackThinner.TOLERANCE + 0.1, expected + " " + actual);
  }
}
