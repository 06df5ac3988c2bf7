package org.toqa.lab.swarm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.toqa.lab.experiment.Experiment;
import org.toqa.lab.experiment.Figure;
import org.toqa.lab.experiment.Report;
import org.toqa.lab.experiment.Run;
import org.toqa.lab.experiment.Verdict;

/** What the commands in docs/laboratory.md print of a swarm, in one run. */
@Tag("full")
class SwarmExperimentsTest {
  private static final int SEED = 2;

  /** A verdict is not comparable only where an input is not published, which the reason names. */
  private static final Pattern NAMES_INPUT =
      Pattern.compile("not published|the paper names no number");

  private final List<Double> shares = new ArrayList<>();

  private Report report(Experiment experiment) {
    Run run = new Run(SEED, 1, Map.of(), (share, _) -> shares.add(share), () -> false);
    return experiment.run(run);
  }

  /** The page's bar never stands still for long, nor goes back. */
  private void assertSteady() {
    shares.add(1.0);
    double before = 0;
    for (double share : shares) {
      assertTrue(share >= before && share - before < 0.06, "from " + before + " to " + share);
      before = share;
    }
  }

  private static String of(Report report, String figure) {
    Figure found =
        report.figures().stream()
            .filter(one -> one.name().equals(figure))
            .findFirst()
            .orElseThrow();
    return found.measured().text() + ": " + found.verdict().word();
  }

  @Test
  void theSweepSaysWhatItSaid() {
    Report report = report(new SwarmSweep());

    assertEquals(
        "from 1.1 to 1.4 m/s: not comparable", of(report, "simple, w = 1: all robots arrive"));
    assertEquals("3.4 m/s: not comparable", of(report, "simple, w = 1: none arrives from"));
    assertEquals(
        "3 of 32: reproduced", of(report, "simple, w = 1: steps rise from one speed to the next"));
    assertEquals(
        "5.04, 1.47: reproduced", of(report, "simple: robots lost with w = 1, and with w = 20"));
    assertEquals(
        "0.87, 0.00: not comparable",
        of(report, "complex: change of the losses from speed to speed, w = 1 and w = 20"));
    assertEquals(
        "75 of 440: refuted", of(report, "guides the robots without collisions (abstract)"));
    assertEquals(
        "14 and 5 of 40: not comparable",
        of(report, "complex, v to 1: swarms that arrive with epsilon, and without"));
    assertEquals(
        "2.38, 0.85: reproduced",
        of(report, "complex, v to 1: robots that reach the target with epsilon, and without"));
    report.figures().stream()
        .filter(figure -> figure.verdict() == Verdict.NOT_COMPARABLE)
        .forEach(figure -> assertTrue(NAMES_INPUT.matcher(figure.reason()).find(), figure::name));
    assertSteady();
  }

  /** The paper has no numbers of its limits, so there are no verdicts. */
  @Test
  void theLimitsSayWhatTheySaid() {
    Report report = report(new SwarmLimits());

    assertEquals(List.of(), report.figures());
    assertEquals(
        """
        as published, published: 15 of 24, 1.00, 0.00
        as published, that keeps the shape: 15 of 24, 0.50, 0.00
        as published, extended: 18 of 24, 0.63, 0.00
        delay of 10 steps, published: 13 of 24, 0.38, 0.00
        delay of 10 steps, that keeps the shape: 13 of 24, 0.38, 0.00
        delay of 10 steps, extended: 13 of 24, 0.38, 0.00
        delay of 30 steps, published: 0 of 24, 9.00, -
        delay of 30 steps, that keeps the shape: 0 of 24, 2.96, -
        delay of 30 steps, extended: 0 of 24, 0.00, -
        ranges with 10 % noise, published: 17 of 24, 1.54, 0.00
        ranges with 10 % noise, that keeps the shape: 17 of 24, 1.21, 0.00
        ranges with 10 % noise, extended: 24 of 24, 1.33, 0.00
        wheels with 20 % noise, published: 19 of 24, 0.63, 15.40
        wheels with 20 % noise, that keeps the shape: 16 of 24, 0.58, 0.52
        wheels with 20 % noise, extended: 19 of 24, 0.79, 0.59
        wheels with 50 % noise, published: 24 of 24, 2.13, 35.08
        wheels with 50 % noise, that keeps the shape: 20 of 24, 1.00, 1.22
        wheels with 50 % noise, extended: 20 of 24, 1.04, 1.13
        an obstacle appears, published: 24 of 24, 2.08, 0.00
        an obstacle appears, that keeps the shape: 24 of 24, 1.46, 0.00
        an obstacle appears, extended: 24 of 24, 2.04, 0.00
        all of it, published: 21 of 24, 1.50, 14.67
        all of it, that keeps the shape: 23 of 24, 1.67, 0.56
        all of it, extended: 17 of 24, 1.00, 0.51
        """,
        String.join("", report.tables().getFirst().rows().stream().map(this::line).toList()));
    assertSteady();
  }

  private String line(List<String> row) {
    return "%s, %s: %s, %s, %s\n".formatted(row.toArray());
  }
}
