package org.toqa.app.bench.meter;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Instant;
import org.junit.jupiter.api.Test;

class LatencyHistogramTest {
  private final LatencyHistogram histogram = new LatencyHistogram();

  @Test
  void percentilesAreTheUpperEndsOfTheirTenths() {
    for (int millis = 1; millis <= 200; millis++) {
      histogram.add(Instant.EPOCH, Instant.EPOCH.plusMillis(millis));
    }

    // 100 of 200 are at most 100 ms, 198 at most 198 ms; each lies at the lower end of its tenth
    assertEquals(new LatencySummary(200, 100.1, 198.1, 200), histogram.summary());
  }

  @Test
  void whatTookAnHourIsCountedToo() {
    histogram.add(Instant.EPOCH, Instant.EPOCH.plusSeconds(3_600));

    assertEquals(new LatencySummary(1, 3_600_000, 3_600_000, 3_600_000), histogram.summary());
  }

  @Test
  void nothingIsLeftAfterAReset() {
    histogram.add(Instant.EPOCH, Instant.EPOCH.plusMillis(7));

    histogram.reset();

    assertEquals(new LatencySummary(0, 0, 0, 0), histogram.summary());
  }
}
