package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Disc;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.Segment;

/**
 * What a robot or a formation covers where it is, or while it drives: discs that are moved along
 * straights. Arcs are taken as chords, and never for less than they cover. Immutable.
 */
final class SweptArea {
  /** An arc is taken as chords; so far, in metres, it may rise over its chord. */
  private static final double MAX_CHORD_HEIGHT = 0.0005;

  private final List<Piece> pieces;
  private final double west;
  private final double east;
  private final double south;
  private final double north;

  /** What was found last; any thread may find it again. */
  private volatile @Nullable Middles middles;

  private record Middles(OccupancyGrid grid, double near, CellSet cells) {}

  /** A disc that is moved from one point to another, which may be the same; metres, map frame. */
  private record Piece(Vec2 from, Vec2 to, double radius) {

    IntStream middlesWithin(OccupancyGrid grid, double near) {
      double reach = radius + near;
      return reach <= 0 // deep in each other, as where one was put on another
          ? IntStream.empty()
          : new Disc(reach)
              .cellsAlong(grid, from, to).stream()
                  .filter(cell -> grid.centre(cell).distanceToLine(from, to) < reach)
                  .mapToInt(grid::index);
    }

    double gapTo(Piece other) {
      return Vec2.distanceBetweenLines(from, to, other.from, other.to) - radius - other.radius;
    }
  }

  private SweptArea(List<Piece> pieces) {
    this.pieces = List.copyOf(pieces);
    double left = Double.POSITIVE_INFINITY;
    double right = Double.NEGATIVE_INFINITY;
    double bottom = Double.POSITIVE_INFINITY;
    double top = Double.NEGATIVE_INFINITY;
    for (Piece piece : pieces) {
      left = Math.min(left, Math.min(piece.from.x(), piece.to.x()) - piece.radius);
      right = Math.max(right, Math.max(piece.from.x(), piece.to.x()) + piece.radius);
      bottom = Math.min(bottom, Math.min(piece.from.y(), piece.to.y()) - piece.radius);
      top = Math.max(top, Math.max(piece.from.y(), piece.to.y()) + piece.radius);
    }
    this.west = left;
    this.east = right;
    this.south = bottom;
    this.north = top;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof SweptArea area && pieces.equals(area.pieces);
  }

  @Override
  public int hashCode() {
    return pieces.hashCode();
  }

  /** Of a disc at rest, metres. */
  static SweptArea at(Vec2 centre, double radius) {
    return along(centre, centre, radius);
  }

  /** Of discs at rest. */
  static SweptArea at(List<PlacedDisc> discs) {
    return new SweptArea(
        discs.stream().map(d -> new Piece(d.centre(), d.centre(), d.radius())).toList());
  }

  /** Of a disc on a straight. */
  static SweptArea along(Vec2 from, Vec2 to, double radius) {
    return new SweptArea(List.of(new Piece(from, to, radius)));
  }

  /** Of a disc that drives a segment. */
  static SweptArea along(Pose from, Segment segment, double radius) {
    if (segment.speed() == 0) {
      return at(from.position(), radius);
    }
    double angle = Math.abs(segment.angle());
    double arcRadius = angle == 0 ? 0 : Math.abs(segment.length()) / angle;
    int chords = angle == 0 ? 1 : chords(arcRadius, angle);
    // height of an arc over its chord: R (1 - cos(angle/2))
    double height = arcRadius * (1 - Math.cos(angle / chords / 2));
    List<Piece> pieces = new ArrayList<>();
    Pose pose = from;
    for (int i = 0; i < chords; i++) {
      Pose next = pose.advanced(segment.twist(), segment.t() / chords);
      pieces.add(new Piece(pose.position(), next.position(), radius + height));
      pose = next;
    }
    return new SweptArea(pieces);
  }

  private static int chords(double radius, double angle) {
    double chordAngle = 2 * Math.acos(Math.max(0, 1 - MAX_CHORD_HEIGHT / radius));
    return Math.max(1, (int) Math.ceil(angle / chordAngle));
  }

  static SweptArea union(List<SweptArea> areas) {
    return new SweptArea(areas.stream().flatMap(area -> area.pieces.stream()).toList());
  }

  /** Metres between the edges of the two; below 0 where they overlap. */
  double gapTo(SweptArea other) {
    return gapTo(other, Double.POSITIVE_INFINITY);
  }

  /**
   * @param enough metres; more than that is not told apart
   */
  double gapTo(SweptArea other, double enough) {
    double least = enough;
    if (boxGapTo(other) >= enough) {
      return enough;
    }
    for (Piece piece : pieces) {
      for (Piece its : other.pieces) {
        least = Math.min(least, piece.gapTo(its));
      }
    }
    return least;
  }

  /** Whether another area is in the box round this one, or so near to that, metres. */
  boolean isInBox(SweptArea other, double near) {
    return boxGapTo(other) < near;
  }

  /** Metres between the boxes round the two, along one of the axes. */
  private double boxGapTo(SweptArea other) {
    double across = Math.max(other.west - east, west - other.east);
    double along = Math.max(other.south - north, south - other.north);
    return Math.max(across, along);
  }

  /** The cells of a grid that it touches, and those so near to it, metres. */
  CellSet cells(OccupancyGrid grid, double near) {
    return CellSet.of(
        pieces.stream()
            .flatMap(p -> new Disc(p.radius + near).cellsAlong(grid, p.from, p.to).stream())
            .mapToInt(grid::index)
            .toArray());
  }

  /** Metres from a point to its edge; below 0 inside. */
  double gapTo(Vec2 point) {
    double least = Double.POSITIVE_INFINITY;
    for (Piece piece : pieces) {
      least = Math.min(least, point.distanceToLine(piece.from, piece.to) - piece.radius);
    }
    return least;
  }

  /**
   * The cells of a grid whose middles are nearer to it than that, metres. They are looked for once
   * for all that ask with the same distance, as robots of one size do.
   */
  CellSet middlesWithin(OccupancyGrid grid, double near) {
    Middles known = middles;
    if (known == null || !known.grid.equals(grid) || known.near != near) {
      int[] cells = pieces.stream().flatMapToInt(p -> p.middlesWithin(grid, near)).toArray();
      known = new Middles(grid, near, CellSet.of(cells));
      middles = known;
    }
    return known.cells;
  }

  double west() {
    return west;
  }

  double east() {
    return east;
  }

  double south() {
    return south;
  }

  double north() {
    return north;
  }
}
