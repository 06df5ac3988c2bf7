package org.toqa.grid;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import org.toqa.geometry.Vec2;

/** One of the directions along the axes of the map frame. */
public enum Direction {
  EAST(1, 0),
  NORTH(0, 1),
  WEST(-1, 0),
  SOUTH(0, -1);

  private final int east;
  private final int north;

  Direction(int east, int north) {
    this.east = east;
    this.north = north;
  }

  /** The direction of that word. */
  public static Optional<Direction> ofWord(String word) {
    return Arrays.stream(values()).filter(d -> d.word().equals(word)).findFirst();
  }

  /** In files and on the wire. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Of length 1, map frame. */
  public Vec2 vector() {
    return new Vec2(east, north);
  }

  /** Radians counter-clockwise from map east. */
  public double heading() {
    return ordinal() * Math.PI / 2;
  }
}
