package org.toqa.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.sim.SimulatedCamera.Standing;

/** What a camera sees of walls and of what stands before them. */
class SimulatedCameraTest {
  private static final int MIDDLE = SimulatedCamera.WIDTH / 2;
  private static final int RED = 0xFF0000;

  /** 10 x 5 m. */
  private static final OccupancyGrid HALL =
      OccupancyGrid.parse("##########", "#........#", "#........#", "#........#", "##########");

  private static final double SIDE = HALL.resolution();
  private static final Vec2 EYE = new Vec2(1.5 * SIDE, 2.5 * SIDE);

  private static BufferedImage view(double heading, Standing... standing) {
    return SimulatedCamera.draw(HALL, new Pose(EYE.x(), EYE.y(), heading), List.of(standing));
  }

  private static Standing ahead(double cells, double left) {
    return new Standing(EYE.plus(new Vec2(cells * SIDE, left * SIDE)), SIDE / 4, 0.3, RED);
  }

  /** How many pixels of a column have that hue. */
  private static long red(BufferedImage picture, int column) {
    long count = 0;
    for (int row = 0; row < SimulatedCamera.HEIGHT; row++) {
      int colour = picture.getRGB(column, row);
      count += (colour >> 16 & 255) > 40 && (colour & 0xFFFF) == 0 ? 1 : 0;
    }
    return count;
  }

  private static long redColumns(BufferedImage picture) {
    long count = 0;
    for (int column = 0; column < SimulatedCamera.WIDTH; column++) {
      count += red(picture, column) > 0 ? 1 : 0;
    }
    return count;
  }

  @Test
  void whatStandsAheadIsInTheMiddleAndSmallerTheFartherItIs() {
    BufferedImage near = view(0, ahead(2, 0));
    BufferedImage far = view(0, ahead(4, 0));

    assertTrue(red(near, MIDDLE) > 0);
    // twice as far: half as wide, by the pinhole model
    assertEquals(2.0, (double) redColumns(near) / redColumns(far), 0.3);
  }

  @Test
  void whatIsOnTheLeftIsOnTheLeftOfThePicture() {
    BufferedImage picture = view(0, ahead(3, 1));

    int first = 0;
    while (red(picture, first) == 0) {
      first++;
    }
    assertTrue(first < MIDDLE - 10, "it begins at column " + first);
    assertEquals(0, red(picture, MIDDLE + 10));
  }

  @Test
  void whatIsBehindAWallOrBehindTheCameraIsNotSeen() {
    assertEquals(0, redColumns(view(0, ahead(9.5, 0))));
    assertEquals(0, redColumns(view(Math.PI, ahead(2, 0))));
  }

  @Test
  void nearerWallIsHigher() {
    BufferedImage far = view(0); // the wall is 8 cells away
    BufferedImage near = view(Math.PI / 2); // it is one and a half away

    int row = SimulatedCamera.HEIGHT / 2 + 20;
    assertNotEquals(far.getRGB(MIDDLE, row), near.getRGB(MIDDLE, row));
  }
}
