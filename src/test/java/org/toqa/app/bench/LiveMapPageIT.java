package org.toqa.app.bench;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Duration;
import java.time.InstantSource;
import java.util.Arrays;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.ExtendWith;
import org.toqa.app.bench.meter.LatencySummary;
import org.toqa.testbed.Needed;
import org.toqa.testbed.SteadyNetwork;

/** What is measured in Chromium, on a page that is as slow as a test wants. */
@Tag("full")
@Timeout(180)
@ExtendWith(SteadyNetwork.class)
class LiveMapPageIT {
  private static final int DELAY = 200;

  private Path chromium;

  @BeforeEach
  void find() {
    Needed.orLeftOut(HeadlessChromium.find().isPresent(), HeadlessChromium.MISSING);
    chromium = HeadlessChromium.find().orElseThrow();
  }

  @Test
  void slowPageShowsInItsFramesAndItsPictures() throws Exception {
    Measured measured = measure(Duration.ZERO, DELAY);

    assertTrue(measured.drawing().p50Ms() >= DELAY - 1, measured::toString);
    assertTrue(measured.drawn().p50Ms() >= DELAY - 1, measured::toString);
    assertTrue(measured.longestFrame() >= DELAY, measured::toString);
  }

  @Test
  void lateStreamShowsInTheWholeWayAndNotInTheDrawing() throws Exception {
    Measured measured = measure(Duration.ofMillis(DELAY), 0);

    assertTrue(measured.drawn().p50Ms() >= DELAY - 1, measured::toString);
    assertTrue(measured.drawing().p50Ms() < DELAY, measured::toString);
  }

  private record Measured(LatencySummary drawing, LatencySummary drawn, double longestFrame) {}

  /** It is busy for so many milliseconds with each event. */
  private static String page(int busyMillis) {
    return """
        <!doctype html>
        <script>
          new EventSource('/api/v1/events?changes=true').addEventListener('change', () => {
            const end = performance.now() + %d;
            while (performance.now() < end) {}
          });
        </script>
        """
        .formatted(busyMillis);
  }

  private Measured measure(Duration late, int busyMillis) throws Exception {
    PoseReports reports = new PoseReports(InstantSource.system());
    try (StreamFixture server = new StreamFixture(reports, Duration.ZERO, late, page(busyMillis));
        LiveMapPage map = LiveMapPage.open(chromium, server.root().resolve("map"), "t", reports)) {
      map.reset();
      while (map.drawn().count() < 10) {
        TimeUnit.MILLISECONDS.sleep(50);
        map.collect();
      }
      double longest = Arrays.stream(map.frameMillis()).max().orElseThrow();
      return new Measured(map.drawing(), map.drawn(), longest);
    }
  }
}
