package org.toqa.app.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.toqa.app.bench.meter.LatencySummary;
import org.toqa.geometry.Pose;
import tools.jackson.databind.json.JsonMapper;

@Timeout(60)
class PoseLatenciesTest {
  private static final Instant START = Instant.parse("2026-01-01T00:00:00Z");
  private static final Duration DELAY = Duration.ofMillis(200);

  private Instant now = START;
  private final PoseReports reports = new PoseReports(() -> now);
  private final PoseLatencies latencies = new PoseLatencies(reports);
  private final PoseLatencies.Watcher watcher = latencies.new Watcher();

  @Test
  void eachLegIsCountedFromWhereItBegins() {
    see(0, Duration.ZERO, Duration.ZERO);
    latencies.reset();

    see(1, Duration.ofMillis(30), Duration.ofMillis(100));

    assertEquals(new LatencySummary(1, 30, 30, 30), latencies.summary().heard());
    assertEquals(new LatencySummary(1, 70, 70, 70), latencies.summary().streamed()); // 100 - 30
    assertEquals(new LatencySummary(1, 100, 100, 100), latencies.summary().seen());
    assertEquals(0, latencies.summary().unmatched());
  }

  @Test
  void aRobotThatStandsIsCountedFromItsFirstReportOfThePlace() {
    see(0, Duration.ZERO, Duration.ZERO);
    latencies.reset();
    reports.add("r1", new Pose(1, 0, 0));
    now = now.plusMillis(400);

    see(1, Duration.ofMillis(30), Duration.ofMillis(100));

    assertEquals(500, latencies.summary().seen().maxMs()); // 400 + 100
  }

  @Test
  void aPoseThatNobodyReportedIsCountedApart() {
    see(0, Duration.ZERO, Duration.ZERO);
    receive(7, now, now);

    assertEquals(0, latencies.summary().seen().count());
    assertEquals(1, latencies.summary().unmatched());
  }

  @Test
  void lateLinkAndLateStreamShowInTheirNumbers() throws Exception {
    LatencySummary[] prompt = measure(Duration.ZERO, Duration.ZERO);
    LatencySummary[] lateLink = measure(DELAY, Duration.ZERO);
    LatencySummary[] lateStream = measure(Duration.ZERO, DELAY);

    assertTrue(prompt[0].p50Ms() < 200 && prompt[1].p50Ms() < 200, prompt[2]::toString);
    assertTrue(lateLink[0].p50Ms() >= 200 && lateLink[1].p50Ms() < 200, lateLink[2]::toString);
    assertTrue(
        lateStream[0].p50Ms() < 200 && lateStream[1].p50Ms() >= 200, lateStream[2]::toString);
    assertTrue(lateLink[2].p50Ms() >= 200 && lateStream[2].p50Ms() >= 200);
  }

  /** Heard, streamed, seen; of three readers. */
  private static LatencySummary[] measure(Duration link, Duration stream) throws Exception {
    PoseReports reported = new PoseReports(InstantSource.system());
    PoseLatencies measured = new PoseLatencies(reported);
    try (StreamFixture server = new StreamFixture(reported, link, stream, "");
        LiveStreamClients clients =
            LiveStreamClients.open(server.root(), "t", 3, measured, InstantSource.system())) {
      while (measured.summary().seen().count() < 15) {
        TimeUnit.MILLISECONDS.sleep(10);
      }
      assertTrue(clients.events() >= 15, "all of them are counted");
      assertEquals(0, measured.summary().unmatched());
    }
    return new LatencySummary[] {
      measured.summary().heard(), measured.summary().streamed(), measured.summary().seen()
    };
  }

  private void see(double x, Duration untilHeard, Duration untilSeen) {
    reports.add("r1", new Pose(x, 0, 0));
    receive(x, now.plus(untilHeard), now.plus(untilSeen));
    now = now.plusSeconds(1);
  }

  private void receive(double x, Instant heard, Instant seen) {
    String event =
        """
        {"robots":[{"name":"r1","pose":{"x":%s,"y":0.0,"theta":0.0},"lastSeen":"%s"}]}
        """
            .formatted(x, heard);
    watcher.receive(JsonMapper.shared().readTree(event), seen);
  }
}
