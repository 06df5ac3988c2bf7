package org.toqa.lab.cmct;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.toqa.geometry.Vec2;
import org.toqa.lab.experiment.Figure;
import org.toqa.lab.experiment.Report;
import org.toqa.lab.experiment.Run;
import org.toqa.lab.experiment.RunStoppedException;
import org.toqa.lab.experiment.Value;
import org.toqa.lab.experiment.Verdict;

@Tag("full")
class CmctExperimentsTest {

  private static Run run(double scenes) {
    return new Run(1, 1, Map.of("scenes", scenes, "boxes", 3.0), (s, t) -> {}, () -> false);
  }

  @Test
  void inFreeSpaceThePlannerIsTheStraightLineAndNoBetterThanAStarWithItsMoves() {
    Report report = new CmctPlanning().run(run(5));

    String free = "figure 9, without obstacles: distance of CMCT-PP over A*, ";
    assertEquals(Value.of(1, ""), named(report, free + "same moves").measured());
    assertEquals(Verdict.REFUTED, named(report, free + "same moves").verdict());
    Value.Quantity octile = (Value.Quantity) named(report, free + "cell to cell").measured();
    assertTrue(octile.number() > 0.9238 && octile.number() < 1, octile::toString);
    Value.Quantity crowded =
        (Value.Quantity)
            named(report, "figure 11, with obstacles: distance of CMCT-PP over A*, same moves")
                .measured();
    assertTrue(crowded.number() >= 1, crowded::toString);
    assertEveryVerdictHasItsReason(report);
    assertEquals(6, report.drawings().size());
  }

  /** As it was with this seed. */
  @Test
  void aSeedPlansAsItDid() {
    List<String> row = new CmctPlanning().run(run(5)).tables().get(1).rows().getLast();

    assertEquals(
        List.of(
            "10", "1185 ± 89", "1145 ± 67", "1289 ± 79", "1217 ± 66", "1056 ± 68", "1.122 ± 0.040"),
        row);
  }

  @Test
  void aSeedCarriesAsItDid() {
    Report report = new CmctCarrying().run(run(1));

    assertEquals(
        List.of("499 ± 0", "740 ± 0", "561 ± 0", "492 ± 0", "577 ± 0"),
        report.tables().getFirst().rows().stream().map(r -> r.get(1)).toList());
    assertEquals(
        Verdict.REPRODUCED,
        named(report, "every box is at its target once, until no box is left").verdict());
    assertEveryVerdictHasItsReason(report);
  }

  /** 60 m and 50 m: it goes along y, where a step helps less, and past the target for ever. */
  @Test
  void thePrintedRuleDoesNotArrive() {
    assertFalse(PrintedRule.of(new Vec2(60, 50), false).arrives());
    PrintedRule smallest = PrintedRule.of(new Vec2(60, 50), true);
    assertTrue(smallest.arrives());
    assertTrue(smallest.total() > 3 * smallest.length());
  }

  @Test
  void aRunThatIsStoppedEndsWithoutAReport() {
    Run run = new Run(1, 1, Map.of(), (share, step) -> {}, () -> true);

    assertThrows(RunStoppedException.class, () -> new CmctPlanning().run(run));
    assertThrows(RunStoppedException.class, () -> new CmctCarrying().run(run));
  }

  private static void assertEveryVerdictHasItsReason(Report report) {
    for (Figure figure : report.figures()) {
      assertFalse(
          figure.verdict() == Verdict.NOT_COMPARABLE && figure.reason().isEmpty(),
          figure::toString);
    }
  }

  private static Figure named(Report report, String name) {
    return report.figures().stream().filter(f -> f.name().equals(name)).findFirst().orElseThrow();
  }
}
