package org.toqa.lab.drawing;

import static org.toqa.svg.SvgWriter.number;

import java.util.List;
import java.util.stream.Collectors;
import org.toqa.geometry.Vec2;
import org.toqa.svg.SvgWriter;

/**
 * A place seen from above, with what is in it.
 *
 * @param least its lower left corner, metres
 * @param most its upper right corner, metres
 * @param marks are drawn one over the other
 */
public record Scene(String name, String title, Vec2 least, Vec2 most, List<Mark> marks)
    implements Drawing {
  private static final double LONGEST_SIDE = 800;
  private static final double FRAME = 24;
  private static final double HEAD = 36;
  private static final double LINE_OF_LEGEND = 20;
  private static final double MIN_WIDTH = 480;

  /** What is drawn; lengths are metres in the scene's frame, x to the right and y up. */
  public sealed interface Mark {}

  /** A filled disc. */
  public record Disc(Vec2 centre, double radius, Colour colour) implements Mark {}

  /** A filled polygon. */
  public record Area(List<Vec2> corners, Colour colour) implements Mark {}

  /** A line through points, and what the legend calls it; an empty name is left out. */
  public record Line(List<Vec2> points, Colour colour, boolean isDashed, String label)
      implements Mark {}

  /** A text that begins at a point. */
  public record Label(String text, Vec2 at) implements Mark {}

  public Scene {
    marks = List.copyOf(marks);
  }

  /**
   * Where in the picture the scene lies.
   *
   * @param width of the picture, pixels
   * @param height of the picture, pixels
   * @param left of the scene's least x, pixels
   * @param top of the scene's most y, pixels
   * @param scale pixels a metre
   */
  public record Frame(double width, double height, double left, double top, double scale) {}

  /** Of the picture that {@link #svg} draws. */
  public Frame frame() {
    double scale = LONGEST_SIDE / Math.max(most.x() - least.x(), most.y() - least.y());
    double width = Math.max(MIN_WIDTH, (most.x() - least.x()) * scale + 2 * FRAME);
    double bottom = (most.y() - least.y()) * scale + HEAD + FRAME;
    return new Frame(width, bottom + LINE_OF_LEGEND * named().size(), FRAME, HEAD, scale);
  }

  private List<Line> named() {
    return marks.stream()
        .filter(Line.class::isInstance)
        .map(Line.class::cast)
        .filter(line -> !line.label().isEmpty())
        .toList();
  }

  @Override
  public String svg() {
    Frame frame = frame();
    double scale = frame.scale();
    double bottom = (most.y() - least.y()) * scale + HEAD + FRAME;
    List<Line> named = named();
    SvgWriter svg = new SvgWriter(frame.width(), frame.height());
    svg.text(title, "title");
    svg.element("rect", "width", "100%", "height", "100%", "fill", Colour.PAGE);
    svg.label(title, FRAME, FRAME, Colour.TEXT);
    svg.element(
        "rect",
        "x",
        number(FRAME),
        "y",
        number(HEAD),
        "width",
        number((most.x() - least.x()) * scale),
        "height",
        number((most.y() - least.y()) * scale),
        "fill",
        Colour.GROUND);
    for (Mark mark : marks) {
      draw(svg, mark, scale);
    }
    for (int i = 0; i < named.size(); i++) {
      double y = bottom + LINE_OF_LEGEND * i;
      svg.label(named.get(i).label(), FRAME, y, named.get(i).colour().code());
    }
    return svg.end();
  }

  private void draw(SvgWriter svg, Mark mark, double scale) {
    switch (mark) {
      case Disc disc -> {
        Vec2 centre = inPicture(disc.centre(), scale);
        svg.element(
            "circle",
            "cx",
            number(centre.x()),
            "cy",
            number(centre.y()),
            "r",
            number(disc.radius() * scale),
            "fill",
            disc.colour().code());
      }
      case Area area ->
          svg.element(
              "path", "d", outline(area.corners(), scale) + "z", "fill", area.colour().code());
      case Line line -> {
        svg.open("g", "stroke-dasharray", line.isDashed() ? "6 6" : "none");
        svg.stroke(outline(line.points(), scale), line.colour().code(), 2.5);
        svg.close();
      }
      case Label label -> {
        Vec2 at = inPicture(label.at(), scale);
        svg.label(label.text(), at.x(), at.y(), Colour.TEXT);
      }
    }
  }

  private Vec2 inPicture(Vec2 point, double scale) {
    return new Vec2(FRAME + (point.x() - least.x()) * scale, HEAD + (most.y() - point.y()) * scale);
  }

  private String outline(List<Vec2> points, double scale) {
    return points.stream()
        .map(point -> inPicture(point, scale))
        .map(p -> number(p.x()) + " " + number(p.y()))
        .collect(Collectors.joining("L", "M", ""));
  }
}
