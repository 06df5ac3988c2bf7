package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.accounts.Site;
import org.toqa.app.config.Configuration;
import org.toqa.app.config.Setting;
import org.toqa.app.config.SettingSource;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.SnapshotFeed;
import org.toqa.testbed.CheapPassword;
import org.toqa.web.Texts;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Everything behind the pages of one site, by a wall clock that is set while it runs or not. */
class ClockOfServerTest {
  private static final Path MAP = Path.of("maps/lab.yaml").toAbsolutePath();
  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final int MANY = 1000;
  private static final Sentence JUMPED = Phrase.CLOCK_JUMPED.with(1095L);

  @TempDir private Path folder;
  private volatile Instant wall = Instant.parse("2026-11-21T10:00:00Z");

  /** What a test does with a running server. */
  @FunctionalInterface
  private interface Use {
    void use(FleetServer toqa) throws Exception;
  }

  @Test
  void aClockThatWasSetWhileNoServerRanIsTold() throws Exception {
    run(toqa -> assertFalse(alerts(toqa).contains(JUMPED)));
    wall = wall.plus(Duration.ofDays(3 * 365).plusHours(1));

    run(toqa -> awaitAlert(toqa, JUMPED));
    run(toqa -> assertFalse(alerts(toqa).contains(JUMPED), "it was started again"));
  }

  @Test
  void aClockThatIsSetNeitherEndsNorProlongsTheWaitForALink() throws Exception {
    run(
        toqa -> {
          Duration wait = askForLinks(toqa);
          for (Duration jump : List.of(Duration.ofDays(1), Duration.ofDays(-2))) {
            wall = wall.plus(jump);
            Duration left = askForLink(toqa);
            assertTrue(left.isPositive() && left.compareTo(wait) <= 0, left::toString);
          }
        });
  }

  /** Until it is to wait. */
  private static Duration askForLinks(FleetServer toqa) {
    for (int i = 0; i < MANY; i++) {
      Duration wait = askForLink(toqa);
      if (wait.isPositive()) {
        return wait;
      }
    }
    return fail("it may ask without end");
  }

  private static Duration askForLink(FleetServer toqa) {
    return toqa.services().passwordLinks().sendLink("ann", "192.0.2.7", Texts.in(Locale.ENGLISH));
  }

  private static List<Sentence> alerts(FleetServer toqa) {
    return toqa.fleet().snapshots().latest().alerts();
  }

  private static void awaitAlert(FleetServer toqa, Sentence alert) throws InterruptedException {
    SnapshotFeed snapshots = toqa.fleet().snapshots();
    long end = System.nanoTime() + PATIENCE.toNanos();
    FleetSnapshot snapshot = snapshots.latest();
    while (!snapshot.alerts().contains(alert) && System.nanoTime() < end) {
      snapshot = snapshots.awaitNewer(snapshot.version(), PATIENCE);
    }
    assertTrue(snapshot.alerts().contains(alert), snapshot.alerts()::toString);
  }

  private void run(Use use) throws Exception {
    Map<Setting, @Nullable String> options = new EnumMap<>(Setting.class);
    options.put(Setting.DATA, folder.toString());
    options.put(Setting.MAP, MAP.toString());
    Configuration configuration =
        Configuration.of(MAP, List.of(SettingSource.fromCommandLine(options)));
    ServerParts shared = ServerParts.of(configuration, CheapPassword.hasher(), () -> wall);
    Site site = new Site(Site.FIRST_ID, "main");
    try (FleetServer toqa = FleetServer.start(site, configuration, shared)) {
      use.use(toqa);
    } finally {
      shared.telemetry().close();
    }
  }
}
