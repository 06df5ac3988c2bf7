package org.toqa.lab.drawing;

import static org.toqa.svg.SvgWriter.number;

import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.toqa.svg.SvgWriter;

/**
 * Lines over an axis.
 *
 * @param across what the horizontal axis is, with its unit
 * @param up what the vertical axis is, with its unit
 */
public record Chart(String name, String title, String across, String up, List<Series> series)
    implements Drawing {
  private static final double WIDTH = 800;
  private static final double HEIGHT = 420;
  private static final double LEFT = 84;
  private static final double RIGHT = 24;
  private static final double TOP = 44;
  private static final double AXIS = 52;
  private static final double LINE_OF_LEGEND = 20;

  /** At most so many lines of the grid on an axis. */
  private static final int TICKS = 6;

  /** Pixels of a point with a gap on both sides. */
  private static final double DOT = 5;

  /** A point of a chart, in the units of its axes; there is none where a value is not finite. */
  public record Point(double x, double y) {
    boolean isFinite() {
      return Double.isFinite(x) && Double.isFinite(y);
    }
  }

  /**
   * Points joined by a line, which has a gap where there is none.
   *
   * @param least the lower border of a band about the line, as many points; empty: there is none
   * @param most its upper border
   */
  public record Series(String name, List<Point> points, List<Point> least, List<Point> most) {
    public Series {
      points = List.copyOf(points);
      least = List.copyOf(least);
      most = List.copyOf(most);
    }

    /** Without a band. */
    public Series(String name, List<Point> points) {
      this(name, points, List.of(), List.of());
    }

    List<Point> all() {
      return Stream.of(points, least, most).flatMap(List::stream).toList();
    }

    /** The points between gaps. */
    static List<List<Point>> parts(List<Point> points) {
      List<List<Point>> parts = new ArrayList<>();
      boolean isGap = true;
      for (Point point : points) {
        if (point.isFinite()) {
          if (isGap) {
            parts.add(new ArrayList<>());
          }
          parts.getLast().add(point);
        }
        isGap = !point.isFinite();
      }
      return parts;
    }
  }

  public Chart {
    series = List.copyOf(series);
  }

  /** The values of an axis, and how far apart its lines are: 1, 2 or 5 of a power of ten. */
  private record Axis(double least, double most, double apart) {
    static Axis of(List<Series> series, ToDoubleFunction<Point> value) {
      double least = Double.POSITIVE_INFINITY;
      double most = Double.NEGATIVE_INFINITY;
      for (Series one : series) {
        for (Point point : one.all()) {
          double at = value.applyAsDouble(point);
          least = Double.isFinite(at) ? Math.min(least, at) : least;
          most = Double.isFinite(at) ? Math.max(most, at) : most;
        }
      }
      if (least > most) {
        return new Axis(0, 1, 0.5);
      }
      double span = most > least ? most - least : Math.max(1e-9, Math.abs(least));
      double power = Math.pow(10, Math.floor(Math.log10(span / TICKS)));
      double apart = power;
      for (double factor : new double[] {2, 5, 10}) {
        apart = span / apart > TICKS ? factor * power : apart;
      }
      return new Axis(
          apart * Math.floor(least / apart),
          Math.max(apart * Math.ceil(most / apart), apart * (Math.floor(least / apart) + 1)),
          apart);
    }

    List<Double> ticks() {
      List<Double> ticks = new ArrayList<>();
      int count = (int) Math.round((most - least) / apart);
      for (int i = 0; i <= count; i++) {
        ticks.add(least + i * apart);
      }
      return ticks;
    }

    /** From 0 to 1. */
    double share(double value) {
      return (value - least) / (most - least);
    }

    String text(double tick) {
      int decimals = (int) Math.max(0, Math.ceil(-Math.log10(apart) - 1e-9));
      return String.format(java.util.Locale.ROOT, "%." + decimals + "f", tick);
    }
  }

  @Override
  public String svg() {
    Axis x = Axis.of(series, Point::x);
    Axis y = Axis.of(series, Point::y);
    SvgWriter svg = new SvgWriter(WIDTH, TOP + HEIGHT + AXIS + LINE_OF_LEGEND * series.size() + 8);
    svg.text(title, "title");
    svg.element("rect", "width", "100%", "height", "100%", "fill", Colour.PAGE);
    svg.label(title, 24, 24, Colour.TEXT);
    drawAxes(svg, x, y);
    for (int i = 0; i < series.size(); i++) {
      String colour = Colour.ofLine(i).code();
      drawBand(svg, series.get(i), x, y, colour);
      for (List<Point> part : Series.parts(series.get(i).points())) {
        svg.stroke(path(part, x, y), colour, part.size() == 1 ? DOT : 2);
      }
      svg.label(series.get(i).name(), LEFT, TOP + HEIGHT + AXIS + LINE_OF_LEGEND * i + 12, colour);
    }
    return svg.end();
  }

  private static void drawBand(SvgWriter svg, Series series, Axis x, Axis y, String colour) {
    List<List<Point>> least = Series.parts(series.least());
    List<List<Point>> most = Series.parts(series.most());
    for (int i = 0; i < least.size(); i++) {
      List<Point> around = new ArrayList<>(least.get(i));
      around.addAll(most.get(i).reversed());
      svg.element("path", "d", path(around, x, y), "fill", colour, "fill-opacity", "0.15");
    }
  }

  private static String path(List<Point> points, Axis x, Axis y) {
    return points.stream()
        .map(p -> number(across(x, p.x())) + " " + number(up(y, p.y())))
        .collect(Collectors.joining("L", "M", points.size() == 1 ? "h0" : ""));
  }

  private void drawAxes(SvgWriter svg, Axis x, Axis y) {
    svg.element(
        "rect",
        "x",
        number(LEFT),
        "y",
        number(TOP),
        "width",
        number(WIDTH - LEFT - RIGHT),
        "height",
        number(HEIGHT),
        "fill",
        Colour.GROUND);
    for (double tick : x.ticks()) {
      double at = across(x, tick);
      svg.stroke(
          "M%s %sv%s".formatted(number(at), number(TOP), number(HEIGHT)), Colour.LIGHT.code(), 1);
      svg.label(x.text(tick), at - 10, TOP + HEIGHT + 18, Colour.TEXT);
    }
    for (double tick : y.ticks()) {
      double at = up(y, tick);
      svg.stroke(
          "M%s %sH%s".formatted(number(LEFT), number(at), number(WIDTH - RIGHT)),
          Colour.LIGHT.code(),
          1);
      svg.label(y.text(tick), 24, at + 5, Colour.TEXT);
    }
    svg.label(across, LEFT + (WIDTH - LEFT - RIGHT) / 2 - 60, TOP + HEIGHT + 36, Colour.TEXT);
    svg.label(up, 24, TOP - 6, Colour.TEXT);
  }

  private static double across(Axis axis, double value) {
    return LEFT + (WIDTH - LEFT - RIGHT) * axis.share(value);
  }

  private static double up(Axis axis, double value) {
    return TOP + HEIGHT * (1 - axis.share(value));
  }
}
