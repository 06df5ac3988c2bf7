package org.toqa.allocation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.toqa.allocation.Floors.busy;
import static org.toqa.allocation.Floors.free;
import static org.toqa.allocation.Floors.job;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class WaitExplainerTest {
  @ParameterizedTest
  @CsvSource({"r1, 5, true", "r1, 6, false", "r2, 1, false", "r9, 1, false"})
  void whoeverIsFreeAndMayKeepsNoTaskWaiting(String only, double load, boolean isFree) {
    WaitExplainer explainer =
        new WaitExplainer(
            List.of(free("r1", 5, 10), busy("r2", 5, 30, 7)), PathLengths.STRAIGHT, List.of());

    assertEquals(isFree, explainer.hasFreeRobot(job(1, load, 20).withOnlyRobots(List.of(only))));
  }
}
