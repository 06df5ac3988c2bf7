package org.toqa.fleet.manager;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.PeriodicWork;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Looks every second whether the fleet goes on, and puts what it finds on the newest snapshots. It
 * needs none of the agents for that.
 */
final class FleetMonitor implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(FleetMonitor.class);
  private static final Duration PERIOD = Duration.ofSeconds(1);

  private final Supplier<List<FloorEntry>> floors;
  private final Supplier<List<Sentence>> managerFailures;
  private final SiteSnapshots site;
  private final List<Supplier<Optional<Sentence>>> checks = new CopyOnWriteArrayList<>();
  private final List<Supplier<Optional<Sentence>>> warnings = new CopyOnWriteArrayList<>();
  private final List<Supplier<Optional<Sentence>>> advisers = new CopyOnWriteArrayList<>();
  private final List<Supplier<Map<String, Sentence>>> robotChecks = new CopyOnWriteArrayList<>();
  private final PeriodicWork work;
  private List<Sentence> logged = List.of();
  private List<Sentence> lastAdvice = List.of();

  /** Also what was said a period ago: who asks may have read the snapshot before. */
  private volatile List<Sentence> advice = List.of();

  FleetMonitor(
      Supplier<List<FloorEntry>> floors,
      Supplier<List<Sentence>> managerFailures,
      SiteSnapshots site) {
    this.floors = floors;
    this.managerFailures = managerFailures;
    this.site = site;
    this.work = new PeriodicWork("fleet-monitor", PERIOD, this::look);
  }

  void addCheck(Supplier<Optional<Sentence>> check) {
    checks.add(check);
  }

  void addWarning(Supplier<Optional<Sentence>> check) {
    warnings.add(check);
  }

  void addAdviser(Supplier<Optional<Sentence>> adviser) {
    advisers.add(adviser);
  }

  void addRobotCheck(Supplier<Map<String, Sentence>> check) {
    robotChecks.add(check);
  }

  /** Why the fleet cannot go on; empty while it can. */
  List<Sentence> failures() {
    List<Sentence> found = new ArrayList<>(ofAllFloors());
    floors.get().forEach(floor -> found.addAll(floor.failures()));
    return found;
  }

  /** What of the alerts is no fault of the fleet's. */
  List<Sentence> advice() {
    return advice;
  }

  private List<Sentence> ofAllFloors() {
    List<Sentence> found = new ArrayList<>(managerFailures.get());
    checks.forEach(check -> check.get().ifPresent(found::add));
    return found;
  }

  private void look() {
    List<Sentence> failures = failures();
    if (failures.isEmpty() != logged.isEmpty()) {
      log.warn(
          failures.isEmpty()
              ? "The fleet goes on."
              : Sentence.joined(Phrase.LISTED_APART, failures).english());
    }
    logged = failures;
    List<Sentence> everywhere = ofAllFloors();
    warnings.forEach(check -> check.get().ifPresent(everywhere::add));
    List<Sentence> now = advisers.stream().flatMap(adviser -> adviser.get().stream()).toList();
    everywhere.addAll(now);
    advice = Stream.concat(lastAdvice.stream(), now.stream()).distinct().toList();
    lastAdvice = now;
    Map<String, Sentence> ofRobots = new HashMap<>();
    robotChecks.forEach(check -> check.get().forEach(ofRobots::putIfAbsent));
    for (FloorEntry floor : floors.get()) {
      List<Sentence> here = new ArrayList<>(everywhere);
      here.addAll(floor.failures());
      floor.ifRunning(agents -> here.addAll(agents.warnings()));
      floor.snapshots().setAlerts(here, ofRobots);
    }
    site.setAlerts(everywhere);
  }

  @Override
  public void close() {
    work.close();
  }
}
