package org.toqa.traffic.floor;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Pose;
import org.toqa.motion.Segment;

class PathDeviationTest {
  private static final double CLOSE = 1e-9;

  /** A metre east, a quarter turn on the spot, a metre north. */
  private static final Drive.OpenSection SECTION =
      new Drive.OpenSection(
          new Pose(0, 0, 0),
          List.of(new Segment(0.25, 0, 4), new Segment(0, 0.5, Math.PI), new Segment(0.25, 0, 4)));

  @Test
  void aRobotBesideAStraightIsSoFarToItsLeft() {
    PathDeviation off = PathDeviation.of(SECTION, new Pose(0.4, 0.02, 0.1));
    assertEquals(0.02, off.crossTrack(), CLOSE);
    assertEquals(0.1, off.heading(), CLOSE);
  }

  @Test
  void aRobotRightOfAPathToTheNorthIsEastOfIt() {
    PathDeviation off = PathDeviation.of(SECTION, new Pose(1.03, 0.5, Math.PI / 2 - 0.05));
    assertEquals(-0.03, off.crossTrack(), CLOSE);
    assertEquals(-0.05, off.heading(), CLOSE);
  }

  @Test
  void aRobotThatTurnsOnTheSpotIsComparedWithTheTurnNotWithItsEnd() {
    PathDeviation off = PathDeviation.of(SECTION, new Pose(1, 0, 0.7));
    assertEquals(0, off.crossTrack(), CLOSE);
    assertEquals(0, off.heading(), CLOSE);
  }
}
