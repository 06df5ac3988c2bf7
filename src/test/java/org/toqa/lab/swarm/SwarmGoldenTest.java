package org.toqa.lab.swarm;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.formation.swarm.SwarmLaw;
import org.toqa.lab.experiment.Run;

/** Drives of the sweep with seed 2, as docs/laboratory.md has them. */
class SwarmGoldenTest {

  @ParameterizedTest
  @CsvSource({
    "simple, 1, 0.5, 2001020, 3648, 0",
    "simple, 1, 2.5, 2001040, 758, 3",
    "simple, 1, 3.0, 2001045, 602, 6",
    "simple, 20, 5.0, 2020236, 513, 3",
    "complex, 1, 1.5, 2001030, 5081, 0",
    "complex, 5, 2.5, 2005076, 1276, 0"
  })
  void aSeedDrivesAsItDid(String map, int turn, double speed, long seed, int steps, int lost) {
    SwarmDrive.Result result =
        new SwarmDrive(
                SwarmMap.named(map),
                SwarmSetup.of(Run.of(2, 1)),
                SwarmLaw.published(Math.toRadians(turn)),
                speed,
                new SplittableRandom(seed))
            .run();

    assertEquals(steps, result.steps());
    assertEquals(lost, result.lost());
  }
}
