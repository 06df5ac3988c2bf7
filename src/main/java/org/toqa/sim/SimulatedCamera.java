package org.toqa.sim;

import java.awt.image.BufferedImage;
import java.util.Comparator;
import java.util.List;
import org.toqa.geometry.Angles;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.RayCast;

/**
 * What a camera on a robot would see: the walls of its floor, and what stands before them. A ray a
 * column finds the wall, whose height on the picture follows from its distance along the optical
 * axis (pinhole model); whatever stands is a box facing the camera, drawn from far to near, and is
 * hidden where a wall is nearer. One picture costs a ray a column and some milliseconds at most.
 */
public final class SimulatedCamera {
  public static final int WIDTH = 320;
  public static final int HEIGHT = 240;

  /** Radians, from the left edge of the picture to the right one. */
  private static final double FIELD_OF_VIEW = Math.toRadians(70);

  /** Pixels for one metre at a distance of one metre. */
  private static final double FOCAL_LENGTH = WIDTH / 2.0 / Math.tan(FIELD_OF_VIEW / 2);

  /** Metres above the floor. */
  private static final double EYE = 0.25;

  private static final double WALL_HEIGHT = 0.8;

  /** Metres; no nearer than a lens is to what it touches. */
  private static final double NEAREST = 0.05;

  private static final double FARTHEST = 30;

  private static final int FLOOR = 0x6E7176;
  private static final int CEILING = 0xD5DBE3;
  private static final int WALL = 0xA9B4C2;

  private SimulatedCamera() {}

  /**
   * Something that stands on the floor.
   *
   * @param middle metres, map frame
   * @param radius metres
   * @param height metres
   * @param colour red, green and blue of eight bits each
   */
  public record Standing(Vec2 middle, double radius, double height, int colour) {}

  /**
   * The picture.
   *
   * @param camera map frame; its heading is where the camera looks
   * @param standing others than the robot that it is on
   */
  public static BufferedImage draw(OccupancyGrid walls, Pose camera, List<Standing> standing) {
    BufferedImage picture = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
    double[] depth = new double[WIDTH];
    for (int column = 0; column < WIDTH; column++) {
      double angle = Math.atan((WIDTH / 2.0 - column - 0.5) / FOCAL_LENGTH);
      double ray = RayCast.distance(walls, camera.position(), camera.theta() + angle, FARTHEST);
      depth[column] = Math.max(NEAREST, ray * Math.cos(angle));
      background(picture, column);
      if (ray < FARTHEST) {
        stripe(picture, column, depth[column], WALL_HEIGHT, WALL);
      }
    }
    standing.stream()
        .sorted(Comparator.comparingDouble((Standing s) -> -along(camera, s.middle())))
        .forEach(body -> draw(picture, depth, camera, body));
    return picture;
  }

  private static void background(BufferedImage picture, int column) {
    for (int row = 0; row < HEIGHT; row++) {
      picture.setRGB(column, row, row < HEIGHT / 2 ? CEILING : FLOOR);
    }
  }

  /** Metres along the optical axis. */
  private static double along(Pose camera, Vec2 point) {
    Vec2 from = point.minus(camera.position());
    return from.norm() * Math.cos(Angles.normalise(from.angle() - camera.theta()));
  }

  private static void draw(BufferedImage picture, double[] depth, Pose camera, Standing body) {
    double away = along(camera, body.middle());
    if (away < NEAREST) {
      return; // behind the camera, or round it
    }
    Vec2 from = body.middle().minus(camera.position());
    double left = from.norm() * Math.sin(Angles.normalise(from.angle() - camera.theta()));
    int first = column(left + body.radius(), away);
    int last = column(left - body.radius(), away);
    for (int column = Math.max(0, first); column < Math.min(WIDTH, last); column++) {
      if (away < depth[column]) {
        stripe(picture, column, away, body.height(), body.colour());
      }
    }
  }

  private static int column(double left, double away) {
    return (int) Math.round(WIDTH / 2.0 - FOCAL_LENGTH * left / away);
  }

  /** From the floor up, darker the farther it is away. */
  private static void stripe(
      BufferedImage picture, int column, double away, double height, int colour) {
    int bottom = (int) Math.round(HEIGHT / 2.0 + FOCAL_LENGTH * EYE / away);
    int top = (int) Math.round(HEIGHT / 2.0 - FOCAL_LENGTH * (height - EYE) / away);
    int shade = shaded(colour, 1 / (1 + away / 6));
    for (int row = Math.max(0, top); row < Math.min(HEIGHT, bottom); row++) {
      picture.setRGB(column, row, shade);
    }
  }

  private static int shaded(int colour, double share) {
    int red = (int) ((colour >> 16 & 255) * share);
    int green = (int) ((colour >> 8 & 255) * share);
    int blue = (int) ((colour & 255) * share);
    return red << 16 | green << 8 | blue;
  }
}
