package org.toqa.grid;

import java.util.List;
import java.util.Optional;

/** A floor as robots drive on it: what is drawn of it, and what follows from that. Immutable. */
public final class FloorMap {
  private final String name;
  private final FloorDrawing drawing;
  private final OccupancyGrid grid;
  private final Margins margins;

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

  public Margins margins() {
    return margins;
  }

  /** The station, parking or charging point of that name. */
  public Optional<Place> place(String placeName) {
    return drawing.places().filter(p -> p.name().equals(placeName)).findFirst();
  }
}
