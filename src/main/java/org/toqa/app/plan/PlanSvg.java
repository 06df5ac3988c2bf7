package org.toqa.app.plan;

import static org.toqa.svg.SvgWriter.number;

import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;
import org.toqa.svg.SvgWriter;

/** A plan as a picture: the map, the cells of the path, the path, and its trajectory. */
final class PlanSvg {
  private static final double MAX_SIDE_PIXELS = 1200;
  private static final double MAX_CELL_PIXELS = 64;

  /** Below this a cell's border would hide the cell. */
  private static final double SMALLEST_CELL_WITH_LINES = 6;

  private static final double FRAME = 24;
  private static final double CAPTION = 64;
  private static final double MIN_WIDTH = 560;

  private static final String PAGE = "#f4f6fa";
  private static final String FREE = "#ffffff";
  private static final String WALL = "#44506a";
  private static final String MARGIN = "#c9d1de";
  private static final String LINE = "#eef1f6";
  private static final String TEXT = "#1f2a3d";
  private static final String PLACE = "#0f766e";
  private static final String CELLS = "#cfe1fb";
  private static final String PATH = "#f0b04a";
  private static final String DRIVE = "#1c66d6";
  private static final String START = "#17704a";
  private static final String GOAL = "#b3261e";

  private final PlannedDrive drive;
  private final OccupancyGrid walls;
  private final SvgShapes shapes;
  private final SvgWriter svg;

  /** Pixels a cell. */
  private final double scale;

  private PlanSvg(PlannedDrive drive) {
    this.drive = drive;
    walls = drive.floor().grid();
    shapes = new SvgShapes(walls);
    scale = Math.min(MAX_CELL_PIXELS, MAX_SIDE_PIXELS / Math.max(walls.width(), walls.height()));
    svg =
        new SvgWriter(
            Math.max(MIN_WIDTH, walls.width() * scale + 2 * FRAME),
            walls.height() * scale + FRAME + CAPTION);
  }

  static String of(PlannedDrive drive) {
    return new PlanSvg(drive).render();
  }

  private String render() {
    svg.text("A path on the map " + drive.floor().name(), "title");
    svg.element("rect", "width", "100%", "height", "100%", "fill", PAGE);
    svg.open(
        "g",
        "transform",
        "translate(%s %s) scale(%s)".formatted(number(FRAME), number(FRAME), scale));
    drawMap();
    drawPath();
    drawPlaces(drive.floor());
    drawArrow(drive.trajectory().start(), START);
    drawArrow(drive.trajectory().end(), GOAL);
    svg.close();
    drawCaption();
    return svg.end();
  }

  private void drawMap() {
    svg.element(
        "rect", "width", number(walls.width()), "height", number(walls.height()), "fill", FREE);
    BitSet margin = drive.inflated().occupied();
    margin.andNot(walls.occupied());
    fillCells(margin, MARGIN);
    BitSet cells = new BitSet();
    drive.path().cells().forEach(cell -> cells.set(walls.index(cell)));
    fillCells(cells, CELLS);
    if (scale >= SMALLEST_CELL_WITH_LINES) {
      drawStroke(shapes.gridLines(), LINE, 1);
    }
    fillCells(walls.occupied(), WALL);
  }

  private void drawPlaces(FloorMap floor) {
    List<Place> places =
        Stream.of(floor.stations(), floor.parking(), floor.charging())
            .flatMap(List::stream)
            .toList();
    for (Place place : places) {
      Vec2 at = shapes.toPicture(place.position());
      drawDot(at, 3, PLACE);
      svg.text(
          place.name(),
          "text",
          "x",
          number(at.x()),
          "y",
          number(at.y() - pixels(13)),
          "font-size",
          number(pixels(11)),
          "font-family",
          "sans-serif",
          "text-anchor",
          "middle",
          "fill",
          PLACE,
          "stroke",
          FREE,
          "stroke-width",
          number(pixels(3)),
          "paint-order",
          "stroke");
    }
  }

  private void drawPath() {
    Trajectory trajectory = drive.trajectory();
    drawStroke(shapes.polyline(drive.path().cells()), PATH, 5);
    drawStroke(shapes.trajectoryPath(trajectory), DRIVE, 2.5);
    Pose pose = trajectory.start();
    for (Segment segment : trajectory.segments()) {
      if (segment.v() == 0) {
        drawDot(shapes.toPicture(pose.position()), 6, PATH);
      }
      pose = pose.advanced(segment.twist(), segment.t());
    }
  }

  /** A disc with an arrowhead in the direction of the heading. */
  private void drawArrow(Pose pose, String colour) {
    Vec2 at = shapes.toPicture(pose.position());
    svg.open(
        "g",
        "transform",
        "translate(%s %s) rotate(%s) scale(%s)"
            .formatted(
                number(at.x()), number(at.y()), number(-Math.toDegrees(pose.theta())), pixels(1)));
    svg.element("circle", "r", "9", "fill", colour, "stroke", FREE, "stroke-width", "2");
    svg.element("path", "d", "M-3 -4.5L6 0L-3 4.5z", "fill", FREE);
    svg.close();
  }

  private void drawCaption() {
    Trajectory trajectory = drive.trajectory();
    double top = walls.height() * scale + FRAME;
    svg.label(
        String.format(
            Locale.ROOT,
            "%s: cost %.2f cells, %.2f m driven in %.1f s, %d turns on the spot",
            drive.floor().name(),
            drive.path().cost(),
            trajectory.length(),
            trajectory.duration(),
            drive.path().turnsOnSpot()),
        FRAME,
        top + 26,
        TEXT);
    drawLegend("●", START, "start", 0, top);
    drawLegend("●", GOAL, "goal", 80, top);
    drawLegend("■", CELLS, "cells", 160, top);
    drawLegend("━", PATH, "planned", 240, top);
    drawLegend("━", DRIVE, "driven", 340, top);
    drawLegend("■", MARGIN, "margin", 430, top);
  }

  private void drawLegend(String sign, String colour, String text, double left, double top) {
    svg.label(sign, FRAME + left, top + 48, colour);
    svg.label(text, FRAME + left + 20, top + 48, TEXT);
  }

  private void fillCells(BitSet cells, String colour) {
    svg.element(
        "path", "d", shapes.cellArea(cells), "fill", colour, "shape-rendering", "crispEdges");
  }

  private void drawStroke(String path, String colour, double width) {
    svg.stroke(path, colour, pixels(width));
  }

  private void drawDot(Vec2 at, double radius, String colour) {
    svg.element(
        "circle",
        "cx",
        number(at.x()),
        "cy",
        number(at.y()),
        "r",
        number(pixels(radius)),
        "fill",
        colour);
  }

  /** So many pixels in units of the map's group, which are cells. */
  private double pixels(double count) {
    return count / scale;
  }
}
