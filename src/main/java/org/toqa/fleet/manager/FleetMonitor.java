package org.toqa.fleet.manager;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Supplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.PeriodicWork;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Looks every second whether the fleet goes on, and puts what it finds on the newest snapshot. It
 * needs none of the agents for that.
 */
final class FleetMonitor implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(FleetMonitor.class);
  private static final Duration PERIOD = Duration.ofSeconds(1);

  private final Supplier<List<Sentence>> agentFailures;
  private final Supplier<List<Sentence>> agentWarnings;
  private final List<Supplier<Optional<Sentence>>> checks = new CopyOnWriteArrayList<>();
  private final List<Supplier<Optional<Sentence>>> warnings = new CopyOnWriteArrayList<>();
  private final LatestSnapshot latest;
  private final PeriodicWork work;
  private List<Sentence> logged = List.of();

  FleetMonitor(
      Supplier<List<Sentence>> agentFailures,
      Supplier<List<Sentence>> agentWarnings,
      LatestSnapshot latest) {
    this.agentFailures = agentFailures;
    this.agentWarnings = agentWarnings;
    this.latest = latest;
    this.work = new PeriodicWork("fleet-monitor", PERIOD, this::look);
  }

  void addCheck(Supplier<Optional<Sentence>> check) {
    checks.add(check);
  }

  void addWarning(Supplier<Optional<Sentence>> check) {
    warnings.add(check);
  }

  /** Why the fleet cannot go on; empty while it can. */
  List<Sentence> failures() {
    List<Sentence> found = new ArrayList<>(agentFailures.get());
    checks.forEach(check -> check.get().ifPresent(found::add));
    return found;
  }

  private void look() {
    List<Sentence> found = failures();
    if (found.isEmpty() != logged.isEmpty()) {
      log.warn(
          found.isEmpty()
              ? "The fleet goes on."
              : Sentence.joined(Phrase.LISTED_APART, found).english());
    }
    logged = found;
    List<Sentence> alerts = new ArrayList<>(found);
    alerts.addAll(agentWarnings.get());
    warnings.forEach(check -> check.get().ifPresent(alerts::add));
    latest.setAlerts(alerts);
  }

  @Override
  public void close() {
    work.close();
  }
}
