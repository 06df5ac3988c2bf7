package org.toqa.app.plan;

import static org.toqa.svg.SvgWriter.number;

import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DifferentialLimits;
import org.toqa.motion.WheelCommand;
import org.toqa.svg.SvgWriter;

/** A smooth curve as a picture: the map with the curve, and below it the speeds over time. */
final class SmoothSvg {
  private static final double MAX_SIDE_PIXELS = 900;
  private static final double MAX_CELL_PIXELS = 64;
  private static final double FRAME = 24;
  private static final double CHART = 200;
  private static final double CAPTION = 56;
  private static final double MIN_WIDTH = 620;

  private static final String PAGE = "#f4f6fa";
  private static final String FREE = "#ffffff";
  private static final String WALL = "#44506a";
  private static final String TEXT = "#1f2a3d";
  private static final String LINE = "#c9d1de";
  private static final String CURVE = "#1c66d6";
  private static final String LEFT = "#17704a";
  private static final String RIGHT = "#b3261e";

  private final SmoothDrive drive;
  private final OccupancyGrid grid;
  private final SvgShapes shapes;
  private final SvgWriter svg;
  private final double scale;
  private final double width;

  private SmoothSvg(SmoothDrive drive) {
    this.drive = drive;
    grid = drive.floor().grid();
    shapes = new SvgShapes(grid);
    scale = Math.min(MAX_CELL_PIXELS, MAX_SIDE_PIXELS / Math.max(grid.width(), grid.height()));
    width = Math.max(MIN_WIDTH, grid.width() * scale + 2 * FRAME);
    svg = new SvgWriter(width, grid.height() * scale + 2 * FRAME + CHART + CAPTION);
  }

  static String of(SmoothDrive drive) {
    return new SmoothSvg(drive).render();
  }

  private String render() {
    svg.text("A smooth path on the map " + drive.floor().name(), "title");
    svg.element("rect", "width", "100%", "height", "100%", "fill", PAGE);
    svg.open(
        "g",
        "transform",
        "translate(%s %s) scale(%s)".formatted(number(FRAME), number(FRAME), scale));
    svg.element(
        "rect", "width", number(grid.width()), "height", number(grid.height()), "fill", FREE);
    svg.element("path", "d", shapes.cellArea(grid.occupied()), "fill", WALL);
    double disc = 2 * drive.space().radius() / grid.resolution();
    svg.stroke(curve(), LINE, disc);
    svg.stroke(curve(), CURVE, 2.5 / scale);
    svg.close();
    drawChart(grid.height() * scale + 2 * FRAME);
    return svg.end();
  }

  private String curve() {
    List<Vec2> points = drive.points();
    return points.stream()
        .map(shapes::toPicture)
        .map(p -> number(p.x()) + " " + number(p.y()))
        .collect(Collectors.joining("L", "M", ""));
  }

  private void drawChart(double top) {
    double fastest = DifferentialLimits.DEFAULT.wheelSpeed();
    double middle = top + CHART / 2;
    svg.stroke(
        "M%s %sH%s".formatted(number(FRAME), number(middle), number(width - FRAME)), LINE, 1);
    drawSpeeds(middle, fastest, c -> c.left().speed(), LEFT);
    drawSpeeds(middle, fastest, c -> c.right().speed(), RIGHT);
    drawSpeeds(middle, fastest, WheelCommand::v, CURVE);
    svg.label(
        String.format(
            Locale.ROOT,
            "%s: %.2f m in %.1f s, at most %.2f radians per metre, %d turns on the spot",
            drive.floor().name(),
            drive.curve().length(),
            drive.schedule().duration(),
            drive.curve().maxCurvature(),
            drive.turnsOnSpot()),
        FRAME,
        top + CHART + 20,
        TEXT);
    svg.label("speed", FRAME, top + CHART + 42, CURVE);
    svg.label("left wheel", FRAME + 70, top + CHART + 42, LEFT);
    svg.label("right wheel", FRAME + 170, top + CHART + 42, RIGHT);
    svg.label("from -0.52 to 0.52 m/s", FRAME + 280, top + CHART + 42, TEXT);
  }

  private void drawSpeeds(
      double middle, double fastest, ToDoubleFunction<WheelCommand> speed, String colour) {
    double seconds = drive.schedule().duration();
    String line =
        drive.schedule().commands().stream()
            .map(
                c ->
                    number(FRAME + (width - 2 * FRAME) * c.time() / seconds)
                        + " "
                        + number(middle - CHART / 2 * speed.applyAsDouble(c) / fastest))
            .collect(Collectors.joining("L", "M", ""));
    svg.stroke(line, colour, 1.5);
  }
}
