package org.toqa.exploration;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorReader;
import org.toqa.grid.MapArchive;
import org.toqa.grid.OccupancyGrid;

/** Grounds that are shipped, for robots to explore in simulation; they are told nothing of them. */
public enum HiddenGround {
  /** Rooms at both sides of a corridor, with doors of 1.2 m and one of 2 m. */
  OFFICE(2, 2, 22, 14),
  /** A store with racks, and aisles of 3 m and more. */
  STORE(2, 2, 28, 18);

  /** Metres along a cell's side; the files have none. */
  private static final double CELL = 0.2;

  private final double startX;
  private final double startY;
  private final double targetX;
  private final double targetY;

  HiddenGround(double startX, double startY, double targetX, double targetY) {
    this.startX = startX;
    this.startY = startY;
    this.targetX = targetX;
    this.targetY = targetY;
  }

  /** As it is called in orders. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  public static Optional<HiddenGround> named(String word) {
    return Arrays.stream(values()).filter(ground -> ground.word().equals(word)).findFirst();
  }

  /** Where one may start, metres. */
  public Vec2 start() {
    return new Vec2(startX, startY);
  }

  /** Where one may drive to from there, metres. */
  public Vec2 target() {
    return new Vec2(targetX, targetY);
  }

  /** As it is in truth. */
  public OccupancyGrid grid() {
    String file = word() + ".map";
    try (InputStream in = HiddenGround.class.getResourceAsStream(file)) {
      if (in == null) {
        throw new IllegalStateException("There is no " + file + ".");
      }
      OccupancyGrid metres =
          FloorReader.read(MapArchive.of(Map.of(file, in.readAllBytes()))).drawing().walls();
      return new OccupancyGrid(
          metres.width(), metres.height(), CELL, metres.origin(), metres.occupied());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
