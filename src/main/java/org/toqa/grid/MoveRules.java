package org.toqa.grid;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.toqa.geometry.Vec2;

/**
 * How robots may move over the free cells of a floor, by its areas and places: in which directions,
 * and how fast. It is about the way of a robot's middle, or of the middle of what several carry.
 * Immutable.
 */
public final class MoveRules {
  /** Anywhere in any direction. */
  public static final MoveRules NONE = new MoveRules(List.of(), List.of(), List.of());

  /**
   * Metres that a path may lead against areas in all, where a robot drives from a little beside the
   * middle of its cell: no robot stops exactly.
   */
  public static final double SLACK = 0.03;

  /**
   * Metres round an area with a speed limit where that counts already: a robot that comes in has
   * slowed down, though it is a little beside its path or before its place on it.
   */
  public static final double SLOWING = 0.1;

  /** Metres; below this nothing has moved, or is inside. */
  private static final double ROUNDING = 1e-4;

  /** A cell is driven into in its direction by who is less than 44 degrees beside that. */
  private static final double IN_DIRECTION = Math.cos(Math.toRadians(44));

  private final List<OneWay> oneWay;
  private final List<OneWay> approaches;
  private final List<SpeedLimit> speedLimits;
  private final List<Area> freeZones;

  /**
   * @param oneWay areas in which nobody moves against a direction
   * @param approaches areas that are entered in a direction, and left in any
   */
  public MoveRules(List<OneWay> oneWay, List<OneWay> approaches, List<SpeedLimit> speedLimits) {
    this(oneWay, approaches, speedLimits, List.of());
  }

  /**
   * The same with areas that are given to one robot as a whole, which finds its own way there if it
   * can.
   */
  public MoveRules(
      List<OneWay> oneWay,
      List<OneWay> approaches,
      List<SpeedLimit> speedLimits,
      List<Area> freeZones) {
    this.oneWay = List.copyOf(oneWay);
    this.approaches = List.copyOf(approaches);
    this.speedLimits = List.copyOf(speedLimits);
    this.freeZones = List.copyOf(freeZones);
  }

  /** Those of a floor: its areas, and the cells of its places that have an approach. */
  static MoveRules of(FloorDrawing drawing) {
    List<OneWay> approaches = new ArrayList<>();
    OccupancyGrid grid = drawing.walls();
    drawing
        .places()
        .filter(place -> place.approach() != null)
        .forEach(
            place -> {
              double side = grid.resolution();
              Vec2 middle = grid.centre(grid.cellAt(place.position()));
              Area cell = new Area(middle.minus(new Vec2(side / 2, side / 2)), side, side);
              approaches.add(new OneWay(cell, place.approach()));
            });
    return new MoveRules(drawing.oneWay(), approaches, drawing.speedLimits(), drawing.freeZones());
  }

  public boolean isNone() {
    return !isDirected() && speedLimits.isEmpty();
  }

  /** Whether there is a move that is allowed in one direction only. */
  public boolean isDirected() {
    return !oneWay.isEmpty() || !approaches.isEmpty();
  }

  /** The areas that have a direction, each once. */
  List<Area> directedAreas() {
    List<Area> areas = new ArrayList<>();
    oneWay.forEach(one -> areas.add(one.area()));
    approaches.forEach(one -> areas.add(one.area()));
    return areas;
  }

  /** Whether a middle may move straight from one point to another, metres, map frame. */
  public boolean allows(Vec2 from, Vec2 to) {
    return metresAgainst(from, to) < 10 * ROUNDING;
  }

  /**
   * So many metres a straight leads against the direction of areas; without end where it leads into
   * the cell of a place otherwise than in that one's direction.
   *
   * @param from metres, map frame
   * @param to metres, map frame
   */
  public double metresAgainst(Vec2 from, Vec2 to) {
    Vec2 way = to.minus(from);
    double metres = 0;
    for (OneWay one : oneWay) {
      double along = dot(way, one.direction().vector());
      if (along < 0) {
        metres -= along * one.area().shareInside(from, to, ROUNDING);
      }
    }
    for (OneWay one : approaches) {
      boolean isEntered =
          !one.area().contains(from, ROUNDING) && one.area().shareInside(from, to, ROUNDING) > 0;
      if (isEntered && dot(way, one.direction().vector()) < IN_DIRECTION * way.norm()) {
        return Double.POSITIVE_INFINITY;
      }
    }
    return metres;
  }

  /** The lowest limit that counts anywhere on a straight, metres a second; without end: none. */
  public double speedLimit(Vec2 from, Vec2 to) {
    double limit = Double.POSITIVE_INFINITY;
    for (SpeedLimit slow : speedLimits) {
      if (slow.speed() < limit && slow.area().shareInside(from, to, ROUNDING - SLOWING) > 0) {
        limit = slow.speed();
      }
    }
    return limit;
  }

  /** Where limits begin or end on a straight, as shares of it between 0 and 1. */
  public List<Double> speedChanges(Vec2 from, Vec2 to) {
    List<Double> shares = new ArrayList<>();
    for (SpeedLimit slow : speedLimits) {
      double enter = slow.area().enter(from, to, -SLOWING);
      double leave = slow.area().leave(from, to, -SLOWING);
      if (leave > enter) {
        shares.add(enter);
        shares.add(leave);
      }
    }
    return shares;
  }

  /** Areas in which nobody moves against a direction. */
  public List<OneWay> oneWay() {
    return oneWay;
  }

  /** Areas that are entered in a direction, and left in any. */
  public List<OneWay> approaches() {
    return approaches;
  }

  public List<SpeedLimit> speedLimits() {
    return speedLimits;
  }

  /** Areas that are given to one robot as a whole, which finds its own way there if it can. */
  public List<Area> freeZones() {
    return freeZones;
  }

  private static double dot(Vec2 a, Vec2 b) {
    return a.x() * b.x() + a.y() * b.y();
  }

  @Override
  public boolean equals(Object other) {
    return this == other
        || (other instanceof MoveRules that
            && oneWay.equals(that.oneWay)
            && approaches.equals(that.approaches)
            && speedLimits.equals(that.speedLimits)
            && freeZones.equals(that.freeZones));
  }

  @Override
  public int hashCode() {
    return Objects.hash(oneWay, approaches, speedLimits, freeZones);
  }
}
