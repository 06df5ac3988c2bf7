package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.agent.chassis.SimulatedBattery;
import org.toqa.agent.chassis.SimulatedChassis;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;

/** The judge of a site sees what it is to see. */
@Timeout(60)
class SiteTruthTest {
  private static final long TICK = 20_000_000;

  @TempDir private Path folder;
  private long nanos;

  @Test
  void bodiesThatTouchAreSeenAlsoWhenTheyPartAgain() throws Exception {
    try (SimulatedChassis one = body("one", 1);
        SimulatedChassis other = body("other", 1.4);
        SiteTruth truth = truth()) {
      drive(other, truth, 0);
      drive(one, truth, 0.1);
      truth.endRun();

      drive(one, truth, 0.1); // to 1.2 m: 0.2 m from 1.4 m, of 0.255 m
      drive(one, truth, -0.1);

      String said = assertThrows(AssertionError.class, truth::endRun).getMessage();
      assertTrue(said.startsWith("they touched") && said.contains("other"), said);
    }
  }

  @Test
  void aTouchCountsInItsOwnRunOnly() throws Exception {
    try (SimulatedChassis one = body("one", 1);
        SimulatedChassis other = body("other", 1.4);
        SiteTruth truth = truth()) {
      drive(other, truth, 0);
      drive(one, truth, 0.2); // to 1.2 m: 0.2 m from 1.4 m, of 0.255 m
      drive(one, truth, -0.2);
      assertThrows(AssertionError.class, truth::endRun);

      drive(one, truth, 0.1);
      truth.endRun();
    }
  }

  private SiteTruth truth() throws IOException {
    return new SiteTruth(Map.of("one", folder.resolve("one"), "other", folder.resolve("other")));
  }

  private SimulatedChassis body(String name, double x) throws IOException {
    Path home = Files.createDirectory(folder.resolve(name));
    SimulatedChassis body =
        new SimulatedChassis(home.resolve("body"), new Pose(x, 1, 0), SimulatedBattery.FULL, 0, 1);
    body.exchange(Twist.ZERO, nanos);
    return body;
  }

  /** For a second of the body's, then until it has been seen to stand there. */
  private void drive(SimulatedChassis body, SiteTruth truth, double speed) throws Exception {
    for (int i = 0; i < 100; i++) {
      body.exchange(i < 50 ? new Twist(speed, 0, 0) : Twist.ZERO, nanos += TICK);
    }
    long seen = truth.moments();
    while (truth.moments() < seen + 110) {
      TimeUnit.MILLISECONDS.sleep(5);
    }
  }
}
