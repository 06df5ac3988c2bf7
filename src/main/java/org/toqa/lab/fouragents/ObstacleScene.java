package org.toqa.lab.fouragents;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.OptionalDouble;
import org.toqa.avoidance.fouragents.StaticObstacle;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.planning.exact.ShortestDiscPath;

/**
 * A robot's start and target among obstacles.
 *
 * @param size metres, from the origin; only what is drawn, there is no wall
 * @param start map frame
 * @param target metres, map frame
 * @param standing convex obstacles by their corners, counter-clockwise, metres; known to the robot
 * @param moving unknown to the robot
 */
record ObstacleScene(
    String name,
    Vec2 size,
    Pose start,
    Vec2 target,
    List<List<Vec2>> standing,
    List<MovingDisc> moving) {

  /** Metres: the grid on which the shortest path is looked for. */
  private static final double CELL = 0.01;

  /** Metres round the scene where a path may go too. */
  private static final double AROUND = 0.3;

  ObstacleScene {
    standing = standing.stream().map(List::copyOf).toList();
    moving = List.copyOf(moving);
  }

  /** One of the scenes of the paper, by the name of its file. */
  static ObstacleScene named(String name) {
    try (InputStream in = ObstacleScene.class.getResourceAsStream(name + ".scene")) {
      if (in == null) {
        throw new IllegalArgumentException("There is no scene " + name + ".");
      }
      BufferedReader lines = new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8));
      return parse(name, lines.lines().toList());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * Reads lines such as {@code size 1.2 0.8}, {@code start X Y HEADING}, {@code target X Y}, {@code
   * static X,Y X,Y X,Y ...} and {@code moving RADIUS X,Y X,Y SPEED}; a line that begins with # is a
   * comment.
   */
  static ObstacleScene parse(String name, List<String> lines) {
    Vec2 size = Vec2.ZERO;
    Pose start = new Pose(0, 0, 0);
    Vec2 target = Vec2.ZERO;
    List<List<Vec2>> standing = new ArrayList<>();
    List<MovingDisc> moving = new ArrayList<>();
    for (String line : lines) {
      List<String> words = Arrays.asList(line.strip().split("\\s+", -1));
      switch (words.getFirst()) {
        case "size" -> size = new Vec2(number(words, 1), number(words, 2));
        case "start" -> start = new Pose(number(words, 1), number(words, 2), number(words, 3));
        case "target" -> target = new Vec2(number(words, 1), number(words, 2));
        case "static" -> standing.add(words.stream().skip(1).map(ObstacleScene::point).toList());
        case "moving" ->
            moving.add(
                new MovingDisc(
                    number(words, 1), point(words.get(2)), point(words.get(3)), number(words, 4)));
        default -> {
          if (!line.isBlank() && !line.startsWith("#")) {
            throw new IllegalArgumentException(name + ": what is '" + line + "'?");
          }
        }
      }
    }
    return new ObstacleScene(name, size, start, target, standing, moving);
  }

  private static double number(List<String> words, int index) {
    return Double.parseDouble(words.get(index));
  }

  private static Vec2 point(String word) {
    int comma = word.indexOf(',');
    return new Vec2(
        Double.parseDouble(word.substring(0, comma)),
        Double.parseDouble(word.substring(comma + 1)));
  }

  /** The circles that the robot knows. */
  List<StaticObstacle> known() {
    return standing.stream().map(StaticObstacle::around).toList();
  }

  /**
   * Metres that a disc has to go at least, with nothing moving; nothing where there is no path. The
   * obstacles are the squares of 0.01 m that lie wholly inside them, so this is a lower bound, less
   * than one square's worth too small at each obstacle.
   *
   * @param radius of the disc, metres
   */
  OptionalDouble shortest(double radius) {
    int width = (int) Math.ceil((size.x() + 2 * AROUND) / CELL);
    int height = (int) Math.ceil((size.y() + 2 * AROUND) / CELL);
    Vec2 origin = new Vec2(-AROUND, -AROUND);
    BitSet occupied = new BitSet();
    for (int row = 0; row < height; row++) {
      for (int column = 0; column < width; column++) {
        double x = origin.x() + column * CELL;
        double y = origin.y() + (height - 1 - row) * CELL;
        occupied.set(row * width + column, isSquareInside(x, y));
      }
    }
    OccupancyGrid grid = new OccupancyGrid(width, height, CELL, origin, occupied);
    return new ShortestDiscPath(grid, radius).length(start.position(), target);
  }

  private boolean isSquareInside(double x, double y) {
    return standing.stream()
        .anyMatch(
            corners ->
                Outlines.contains(corners, new Vec2(x, y))
                    && Outlines.contains(corners, new Vec2(x + CELL, y))
                    && Outlines.contains(corners, new Vec2(x, y + CELL))
                    && Outlines.contains(corners, new Vec2(x + CELL, y + CELL)));
  }
}
