package org.toqa.grid;

import java.util.BitSet;
import java.util.List;
import java.util.stream.Stream;

/**
 * A floor as it is drawn: its walls, and what is drawn over them. Immutable.
 *
 * @param walls occupied where a wall or something else stands that never moves
 * @param keepOut where nobody drives
 * @param freeZones that are given to one robot as a whole, which finds its own way there if it can
 * @param moves by which robots drive alone
 */
public record FloorDrawing(
    OccupancyGrid walls,
    List<Place> stations,
    List<Place> parking,
    List<Place> charging,
    List<Area> keepOut,
    List<SpeedLimit> speedLimits,
    List<OneWay> oneWay,
    List<Area> freeZones,
    Moves moves) {

  public FloorDrawing {
    stations = List.copyOf(stations);
    parking = List.copyOf(parking);
    charging = List.copyOf(charging);
    keepOut = List.copyOf(keepOut);
    speedLimits = List.copyOf(speedLimits);
    oneWay = List.copyOf(oneWay);
    freeZones = List.copyOf(freeZones);
  }

  /** Without free zones. */
  public FloorDrawing(
      OccupancyGrid walls,
      List<Place> stations,
      List<Place> parking,
      List<Place> charging,
      List<Area> keepOut,
      List<SpeedLimit> speedLimits,
      List<OneWay> oneWay,
      Moves moves) {
    this(walls, stations, parking, charging, keepOut, speedLimits, oneWay, List.of(), moves);
  }

  /** With the usual moves. */
  public FloorDrawing(
      OccupancyGrid walls,
      List<Place> stations,
      List<Place> parking,
      List<Place> charging,
      List<Area> keepOut,
      List<SpeedLimit> speedLimits,
      List<OneWay> oneWay) {
    this(walls, stations, parking, charging, keepOut, speedLimits, oneWay, Moves.HEADING);
  }

  /** Walls alone. */
  public static FloorDrawing of(OccupancyGrid walls) {
    return new FloorDrawing(
        walls, List.of(), List.of(), List.of(), List.of(), List.of(), List.of());
  }

  public FloorDrawing withWalls(OccupancyGrid others) {
    return new FloorDrawing(
        others, stations, parking, charging, keepOut, speedLimits, oneWay, freeZones, moves);
  }

  public FloorDrawing withStations(List<Place> others) {
    return new FloorDrawing(
        walls, others, parking, charging, keepOut, speedLimits, oneWay, freeZones, moves);
  }

  public FloorDrawing withMoves(Moves others) {
    return new FloorDrawing(
        walls, stations, parking, charging, keepOut, speedLimits, oneWay, freeZones, others);
  }

  public FloorDrawing withFreeZones(List<Area> others) {
    return new FloorDrawing(
        walls, stations, parking, charging, keepOut, speedLimits, oneWay, others, moves);
  }

  /** The stations, then the parking points, then the charging points. */
  public Stream<Place> places() {
    return Stream.of(stations, parking, charging).flatMap(List::stream);
  }

  /**
   * The grid that robots drive on, with the rules of its areas and places: every cell that a
   * keep-out area overlaps is occupied too.
   */
  public OccupancyGrid drivable() {
    OccupancyGrid ruled = walls.withRules(MoveRules.of(this));
    if (keepOut.isEmpty()) {
      return ruled;
    }
    BitSet occupied = walls.occupied();
    keepOut.forEach(area -> occupied.or(area.cells(walls)));
    return ruled.withOccupied(occupied);
  }
}
