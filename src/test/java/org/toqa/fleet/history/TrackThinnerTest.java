package org.toqa.fleet.history;

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
  void aStraightPathIsItsTwoEnds() {
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
  void whereARobotWaitedForSecondsItStands() {
    drive(new Vec2(0, 0), new Vec2(3, 0));
    drive(new Vec2(3, 0), new Vec2(3, 0));
    Instant waited = now.minusSeconds(5);
    drive(new Vec2(3, 0), new Vec2(6, 0));
    drive(new Vec2(6, 0), new Vec2(6, 3));

    near(new Vec2(3, 0), at(waited));
    assertEquals(4, kept.size(), kept::toString);
  }

  @Test
  void whatIsSeenAgainWithoutANewWordCountsOnce() {
    for (int i = 0; i < 5; i++) {
      see(new Vec2(i, 0), Duration.ofSeconds(1));
      see(new Vec2(i, 0), Duration.ZERO);
    }

    assertEquals(1, kept.size(), kept::toString);
  }

  @Test
  void whoComesBackElsewhereAfterALongSilenceLeavesNoPointTwice() {
    see(new Vec2(0, 0), Duration.ZERO);
    see(new Vec2(9, 9), Duration.ofHours(1));
    see(new Vec2(9, 9), Duration.ofSeconds(1));

    assertEquals(
        List.of(START, START.plus(Duration.ofHours(1))),
        kept.stream().map(TrackPoint::at).toList());
  }

  @Test
  void theTrackIsNearWhereTheRobotWasAtEveryMoment() {
    Random random = new Random(1);
    List<TrackPoint> seen = new ArrayList<>();
    double heading = 0;
    double speed = 0.25;
    Vec2 position = new Vec2(0, 0);
    for (int i = 0; i < 20_000; i++) {
      heading += 0.2 * random.nextGaussian();
      speed = Math.clamp(speed + 0.1 * random.nextGaussian(), 0, 0.5);
      position = position.plus(new Vec2(Math.cos(heading), Math.sin(heading)).times(0.2 * speed));
      see(position, Duration.ofMillis(200));
      seen.add(new TrackPoint("r1", now, position));
    }

    for (TrackPoint point : seen.subList(0, 19_000)) {
      near(point.position(), at(point.at()));
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

  /** Where the track says that the robot was. */
  private Vec2 at(Instant moment) {
    int next = 1;
    while (kept.get(next).at().isBefore(moment)) {
      next++;
    }
    TrackPoint from = kept.get(next - 1);
    TrackPoint to = kept.get(next);
    double share =
        (double) Duration.between(from.at(), moment).toNanos()
            / Duration.between(from.at(), to.at()).toNanos();
    return from.position().plus(to.position().minus(from.position()).times(share));
  }

  private static void near(Vec2 expected, Vec2 actual) {
    assertTrue(
        expected.distanceTo(actual) <= Math.sqrt(2) * TrackThinner.TOLERANCE + 1e-9,
        expected + " " + actual);
  }
}
