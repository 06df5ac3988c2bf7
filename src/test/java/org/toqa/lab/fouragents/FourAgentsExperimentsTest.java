package org.toqa.lab.fouragents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.toqa.lab.experiment.Experiment;
import org.toqa.lab.experiment.Report;
import org.toqa.lab.experiment.Run;

/** What the commands in docs/laboratory.md print of four agents, by seed. */
@Tag("full")
class FourAgentsExperimentsTest {
  private final List<Double> shares = new ArrayList<>();

  private Report report(Experiment experiment, long seed) {
    return experiment.run(new Run(seed, 1, Map.of(), (share, _) -> shares.add(share), () -> false));
  }

  /** Some columns of a table, a line each. */
  private static String lines(Report report, int table, int... columns) {
    return report.tables().get(table).rows().stream()
        .map(
            row ->
                Arrays.stream(columns)
                    .mapToObj(row::get)
                    .collect(Collectors.joining(", ", "", "\n")))
        .collect(Collectors.joining());
  }

  @Test
  void theScenesAreDrivenAsTheyWere() {
    Report report = report(new PublishedScenes(), 2);

    assertEquals(
        """
        static-clockwise, 20 of 20, 16.4, 1.090, 1.017
        static-counter-clockwise, 20 of 20, 16.5, 1.102, 1.022
        static-and-moving, 20 of 20, 20.2, 1.483, 1.417
        cluttered-horizontal, 20 of 20, 30.2, 2.113, 1.737
        cluttered-vertical, 20 of 20, 29.0, 2.090, 1.737
        cluttered-both, 20 of 20, 29.2, 2.101, 1.737
        """,
        lines(report, 0, 0, 1, 4, 6, 7));
    assertEquals("2", report.figures().getLast().measured().text());
  }

  @Test
  void generatedScenesAreDrivenAsTheyWere() {
    Report report = report(new GeneratedScenes(), 3);

    assertEquals(
        """
        0, 25, 25, 0, 19.1, 1.006
        1, 28, 27, 1, 19.5, 1.012
        2, 24, 23, 1, 21.1, 1.035
        3, 23, 22, 1, 20.7, 1.027
        all, 100, 97, 3, 19.9, 1.024
        """,
        lines(report, 0, 0, 1, 2, 3, 6, 8));
    assertEquals(
        """
        as chosen, 97 of 100
        margin 0.01, 93 of 100
        margin 0.04, 97 of 100
        danger 0.03, 92 of 100
        danger 0.08, 83 of 100
        approach 0.00, 86 of 100
        approach 0.04, 96 of 100
        hysteresis 0.00, 97 of 100
        hysteresis 0.20, 96 of 100
        noise 0.00, 97 of 100
        noise 0.05, 97 of 100
        """,
        lines(report, 1, 0, 1));
    assertSteady();
  }

  /** The page's bar never stands still for long, nor goes back. */
  private void assertSteady() {
    shares.add(1.0);
    double before = 0;
    for (double share : shares) {
      assertTrue(share >= before && share - before < 0.1, "from " + before + " to " + share);
      before = share;
    }
  }
}
