package org.toqa.fleet.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.toqa.fleet.FloorView.FaultyCharger;
import org.toqa.grid.Place;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Which charging points do not charge: a robot was there, and its battery did not rise. Confined to
 * one agent.
 */
final class ChargerWatch {
  /** After that a point is tried again: somebody may have mended it. */
  static final Duration RETRY_AFTER = Duration.ofHours(1);

  /** Of 0 to 1; more than a gauge that shows whole percents goes to and fro. */
  static final double MIN_RISE = 0.015;

  private final Duration patience;
  private final Map<String, Stay> stays = new HashMap<>();
  private final Map<String, FaultyCharger> faultyChargers = new TreeMap<>();

  /**
   * A robot's stay at a charging point.
   *
   * @param battery the least since it rose last
   * @param lastRise when it rose last, or the robot came
   */
  private record Stay(String point, double battery, Instant lastRise) {}

  enum Finding {
    UNCHANGED,
    FAILED,
    RECOVERED
  }

  /**
   * @param patience a battery that has not risen for so long does not charge
   */
  ChargerWatch(Duration patience) {
    this.patience = patience;
  }

  /** A robot is at the point, with so much in its battery, of 0 to 1. */
  Finding observe(String robot, Place point, double battery, Instant now) {
    Stay stay = stays.get(robot);
    if (stay == null || !stay.point().equals(point.name())) {
      stays.put(robot, new Stay(point.name(), battery, now));
      return Finding.UNCHANGED;
    }
    if (battery >= stay.battery() + MIN_RISE) {
      stays.put(robot, new Stay(point.name(), battery, now));
      return faultyChargers.remove(point.name()) == null ? Finding.UNCHANGED : Finding.RECOVERED;
    }
    stays.put(robot, new Stay(point.name(), Math.min(battery, stay.battery()), stay.lastRise()));
    if (stay.lastRise().plus(patience).isAfter(now) || isFaulty(point)) {
      return Finding.UNCHANGED;
    }
    Sentence text = Phrase.CHARGER_IS_FAULTY.with(point.name(), robot, text(patience));
    faultyChargers.put(point.name(), new FaultyCharger(point.name(), point.position(), now, text));
    return Finding.FAILED;
  }

  /** The robot is not at a charging point. */
  void robotLeft(String robot) {
    stays.remove(robot);
  }

  boolean isFaulty(Place point) {
    return faultyChargers.containsKey(point.name());
  }

  /** To be called once a tick. */
  void forgetExpired(Instant now) {
    faultyChargers.values().removeIf(charger -> !charger.since().plus(RETRY_AFTER).isAfter(now));
  }

  List<FaultyCharger> faultyChargers() {
    return List.copyOf(faultyChargers.values());
  }

  private static Sentence text(Duration duration) {
    return duration.toMinutes() == 0
        ? Phrase.SECONDS.with(duration.toSeconds())
        : Phrase.MINUTES.with(duration.toMinutes());
  }
}
