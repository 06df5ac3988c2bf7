package org.toqa.lab.drawing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.toqa.lab.drawing.Chart.Point;
import org.toqa.lab.drawing.Chart.Series;

class ChartTest {

  /** The paths of a chart's first line. */
  private static List<String> lines(Point... points) {
    Chart chart = new Chart("steps", "Steps", "v", "n", List.of(new Series("a", List.of(points))));
    return Pattern.compile("d=\"([^\"]*)\"[^>]*stroke=\"" + Colour.ofLine(0).code())
        .matcher(chart.svg())
        .results()
        .map(found -> found.group(1))
        .toList();
  }

  /** Axes from 0 to 4 and from 0 to 1 over 692 and 420 pixels, from (84, 464). */
  @Test
  void aLineHasAGapWhereThereIsNoValue() {
    List<String> lines =
        lines(
            new Point(0, 0),
            new Point(1, 1),
            new Point(2, Double.NaN),
            new Point(3, 1),
            new Point(4, Math.log10(0)));

    assertEquals(List.of("M84 464L257 44", "M603 44h0"), lines);
  }

  @Test
  void aChartOfGapsOnlyHasAxesAndNoLine() {
    assertTrue(lines(new Point(0, Double.NaN), new Point(1, Double.NaN)).isEmpty());
  }

  /** The axes have room for the band, up to 2. */
  @Test
  void aBandGoesRoundWhatIsBetweenItsBordersAndHasTheSameGaps() {
    double none = Double.NaN;
    Series series =
        new Series(
            "a",
            List.of(new Point(0, 1), new Point(1, 1), new Point(2, none)),
            List.of(new Point(0, 0), new Point(1, 1), new Point(2, none)),
            List.of(new Point(0, 2), new Point(1, 2), new Point(2, none)));
    String svg = new Chart("a", "A", "x", "y", List.of(series)).svg();

    assertTrue(
        svg.contains("d=\"M84 464L430 254L430 44L84 44\" fill=\"" + Colour.BLUE.code()), svg);
    assertTrue(svg.contains("d=\"M84 254L430 254\""), svg);
  }
}
