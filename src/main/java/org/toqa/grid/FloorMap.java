package org.toqa.grid;

import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/** A floor as robots drive on it: what is drawn of it, and what follows from that. Immutable. */
public final class FloorMap {
  /** Metres. */
  private static final double SAME_POINT = 0.001;

  private final String name;
  private final FloorDrawing drawing;
  private final OccupancyGrid grid;
  private final Margins margins;
  private final String version;

  /** The places that have a heading. */
  private final List<Place> facing;

  /**
   * @param margins that are kept on it
   */
  public FloorMap(String name, FloorDrawing drawing, Margins margins) {
    this(name, drawing, drawing.drivable(), margins);
  }

  private FloorMap(String name, FloorDrawing drawing, OccupancyGrid grid, Margins margins) {
    this.name = name;
    this.drawing = drawing;
    this.grid = grid;
    this.margins = margins;
    this.version = Integer.toHexString(drawing.hashCode());
    this.facing = drawing.places().filter(place -> place.heading() != null).toList();
  }

  /** With the usual margins, and no areas. */
  public FloorMap(
      String name,
      OccupancyGrid grid,
      List<Place> stations,
      List<Place> parking,
      List<Place> charging) {
    this(
        name,
        new FloorDrawing(grid, stations, parking, charging, List.of(), List.of(), List.of()),
        Margins.USUAL);
  }

  public FloorMap withMargins(Margins kept) {
    return new FloorMap(name, drawing, grid, kept);
  }

  public FloorMap withName(String other) {
    return new FloorMap(other, drawing, grid, margins);
  }

  public String name() {
    return name;
  }

  /** Names what is drawn, within one process: another map has another name. */
  public String version() {
    return version;
  }

  public FloorDrawing drawing() {
    return drawing;
  }

  /** Where robots may drive: keep-out areas are occupied cells too. */
  public OccupancyGrid grid() {
    return grid;
  }

  public List<Place> stations() {
    return drawing.stations();
  }

  public List<Place> parking() {
    return drawing.parking();
  }

  public List<Place> charging() {
    return drawing.charging();
  }

  /** By which robots drive alone. */
  public Moves moves() {
    return drawing.moves();
  }

  public Margins margins() {
    return margins;
  }

  /**
   * How a robot stands at a point, radians counter-clockwise from map east; null: as it comes.
   *
   * @param point metres, map frame
   */
  public @Nullable Double headingAt(Vec2 point) {
    for (Place place : facing) {
      if (place.position().distanceTo(point) < SAME_POINT) {
        return place.heading();
      }
    }
    return null;
  }

  /** The station, parking or charging point of that name. */
  public Optional<Place> place(String placeName) {
    return drawing.places().filter(p -> p.name().equals(placeName)).findFirst();
  }
}
