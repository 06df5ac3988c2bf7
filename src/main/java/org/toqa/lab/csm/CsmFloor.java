package org.toqa.lab.csm;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Objects;
import org.toqa.avoidance.MovingDisc;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.lab.drawing.Colour;
import org.toqa.lab.drawing.Scene;

/**
 * A floor of the paper: 250 x 250 cm, a border of wall, and obstacles of ours, as the files beside
 * this class tell.
 *
 * @param number from 1, as the robots are counted
 * @param moving the obstacles that move in the dynamic environment
 */
record CsmFloor(int number, Vec2 start, Vec2 goal, List<Box> obstacles, List<MovingDisc> moving) {
  static final double SIDE = 2.5;
  private static final int CELLS = 250;
  private static final double CENTIMETRE = 0.01;

  /** An obstacle: its lower left corner and its sides, metres. */
  record Box(double left, double lower, double width, double height) {}

  static List<CsmFloor> all() {
    return List.of(read(1), read(2), read(3));
  }

  static CsmFloor read(int number) {
    String file = "floor-" + number + ".txt";
    try (InputStream in = CsmFloor.class.getResourceAsStream(file)) {
      String text =
          new String(Objects.requireNonNull(in, file).readAllBytes(), StandardCharsets.UTF_8);
      return parse(number, text);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static CsmFloor parse(int number, String text) {
    Vec2 start = Vec2.ZERO;
    Vec2 goal = Vec2.ZERO;
    List<Box> obstacles = new ArrayList<>();
    List<MovingDisc> moving = new ArrayList<>();
    for (String line : text.lines().filter(line -> !line.startsWith("#")).toList()) {
      String[] words = line.strip().split(" ", -1);
      double[] n = new double[words.length - 1];
      for (int i = 0; i < n.length; i++) {
        n[i] = CENTIMETRE * Double.parseDouble(words[i + 1]);
      }
      switch (words[0]) {
        case "start" -> start = new Vec2(n[0], n[1]);
        case "goal" -> goal = new Vec2(n[0], n[1]);
        case "obstacle" -> obstacles.add(new Box(n[0], n[1], n[2], n[3]));
        case "moving" ->
            moving.add(new MovingDisc(new Vec2(n[0], n[1]), new Vec2(n[3], n[4]), n[2], 0));
        default -> throw new IllegalArgumentException("A floor has no \"" + words[0] + "\".");
      }
    }
    return new CsmFloor(number, start, goal, List.copyOf(obstacles), List.copyOf(moving));
  }

  /** In cells of 1 cm. */
  OccupancyGrid grid() {
    BitSet occupied = new BitSet();
    for (Box box : obstacles) {
      int left = cells(box.left());
      int lower = cells(box.lower());
      for (int y = lower; y < lower + cells(box.height()); y++) {
        int row = CELLS - 1 - y;
        occupied.set(row * CELLS + left, row * CELLS + left + cells(box.width()));
      }
    }
    return new OccupancyGrid(CELLS, CELLS, CENTIMETRE, Vec2.ZERO, occupied);
  }

  private static int cells(double metres) {
    return (int) Math.round(metres / CENTIMETRE);
  }

  /** What a picture of it begins with. */
  List<Scene.Mark> marks() {
    List<Scene.Mark> marks = new ArrayList<>();
    for (Box box : obstacles) {
      double right = box.left() + box.width();
      double upper = box.lower() + box.height();
      marks.add(
          new Scene.Area(
              List.of(
                  new Vec2(box.left(), box.lower()),
                  new Vec2(right, box.lower()),
                  new Vec2(right, upper),
                  new Vec2(box.left(), upper)),
              Colour.WALL));
    }
    return marks;
  }
}
