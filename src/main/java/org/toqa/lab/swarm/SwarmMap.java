package org.toqa.lab.swarm;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.lab.drawing.Colour;
import org.toqa.lab.drawing.Scene;
import org.toqa.planning.exact.ShortestDiscPath;

/**
 * A map for a swarm: squares of 20 m, a start at the left and a target at the right, obstacles
 * between them with several ways, of which the shortest is narrow. The paper's maps are pictures
 * that are lost, without a scale.
 */
record SwarmMap(String name, OccupancyGrid grid) {
  static final double CELL = 20;
  static final Vec2 START = new Vec2(180, 600);
  static final Vec2 TARGET = new Vec2(1840, 600);

  /** Lines before the rows. */
  private static final int HEADER = 4;

  /** A map of this package, in MovingAI's format. */
  static SwarmMap named(String name) {
    try (InputStream in = SwarmMap.class.getResourceAsStream(name + ".map")) {
      if (in == null) {
        throw new IllegalArgumentException("There is no map " + name + ".");
      }
      List<String> rows =
          new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8))
              .lines()
              .skip(HEADER)
              .toList();
      BitSet occupied = new BitSet();
      int width = rows.getFirst().length();
      for (int row = 0; row < rows.size(); row++) {
        for (int column = 0; column < width; column++) {
          occupied.set(row * width + column, rows.get(row).charAt(column) != '.');
        }
      }
      return new SwarmMap(name, new OccupancyGrid(width, rows.size(), CELL, Vec2.ZERO, occupied));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The same with one more obstacle, as when a map changes. */
  SwarmMap with(Vec2 least, Vec2 most) {
    BitSet occupied = new BitSet();
    for (int row = 0; row < grid.height(); row++) {
      for (int column = 0; column < grid.width(); column++) {
        Vec2 middle = grid.centre(new Cell(column, row));
        boolean isNew =
            middle.x() > least.x()
                && middle.x() < most.x()
                && middle.y() > least.y()
                && middle.y() < most.y();
        occupied.set(row * grid.width() + column, isNew || !grid.isFree(column, row));
      }
    }
    return new SwarmMap(
        name, new OccupancyGrid(grid.width(), grid.height(), CELL, Vec2.ZERO, occupied));
  }

  /**
   * The shortest path of a rigid swarm that does not turn, exactly: that of one robot on a map that
   * is occupied where any robot's is. Metres.
   *
   * @param places of the robots from the leader, whole squares
   * @param radius of a robot, metres
   */
  double shortest(List<Vec2> places, double radius) {
    BitSet occupied = new BitSet();
    for (int row = 0; row < grid.height(); row++) {
      for (int column = 0; column < grid.width(); column++) {
        occupied.set(row * grid.width() + column, !isFree(column, row, places));
      }
    }
    OccupancyGrid all = new OccupancyGrid(grid.width(), grid.height(), CELL, Vec2.ZERO, occupied);
    return new ShortestDiscPath(all, radius).length(START, TARGET).orElse(Double.NaN);
  }

  private boolean isFree(int column, int row, List<Vec2> places) {
    return places.stream()
        .allMatch(
            p ->
                grid.isFree(
                    column + (int) Math.rint(p.x() / CELL), row - (int) Math.rint(p.y() / CELL)));
  }

  /** Whether a robot touches an obstacle or the border. */
  boolean touches(Vec2 robot, double radius) {
    int reach = (int) Math.ceil(radius / CELL);
    int column = (int) Math.floor(robot.x() / CELL);
    int up = (int) Math.floor(robot.y() / CELL);
    for (int x = column - reach; x <= column + reach; x++) {
      for (int y = up - reach; y <= up + reach; y++) {
        if (!grid.isFree(x, grid.height() - 1 - y)) {
          double east = robot.x() - Math.clamp(robot.x(), x * CELL, (x + 1) * CELL);
          double north = robot.y() - Math.clamp(robot.y(), y * CELL, (y + 1) * CELL);
          if (east * east + north * north < radius * radius) {
            return true;
          }
        }
      }
    }
    return false;
  }

  /** The obstacles as marks, a run of squares each. */
  List<Scene.Mark> marks() {
    List<Scene.Mark> marks = new ArrayList<>();
    for (int row = 0; row < grid.height(); row++) {
      int begin = -1;
      for (int column = 0; column <= grid.width(); column++) {
        boolean isWall = column < grid.width() && !grid.isFree(column, row);
        if (isWall && begin < 0) {
          begin = column;
        } else if (!isWall && begin >= 0) {
          double low = (grid.height() - 1 - row) * CELL;
          marks.add(
              new Scene.Area(
                  List.of(
                      new Vec2(begin * CELL, low),
                      new Vec2(column * CELL, low),
                      new Vec2(column * CELL, low + CELL),
                      new Vec2(begin * CELL, low + CELL)),
                  Colour.WALL));
          begin = -1;
        }
      }
    }
    return marks;
  }

  Vec2 size() {
    return new Vec2(grid.width() * CELL, grid.height() * CELL);
  }
}
