package org.toqa.fleet;

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
 * Which charging points do not charge: a robot stood there, and its battery did not rise. Confined
 * to one agent.
 */
final class ChargerWatch {
  /** After that a point is tried again: somebody may have mended it. */
  static final Duration LEFT_OUT = Duration.ofHours(1);

  /** Of 0 to 1; more than a gauge that shows whole percents goes to and fro. */
  static final double RISE = 0.015;

  private final Duration patience;
  private final Map<String, Stay> stays = new HashMap<>();
  private final Map<String, FaultyCharger> faulty = new TreeMap<>();

  /**
   * A robot's stay at a charging point.
   *
   * @param battery the least since it rose last
   * @param risen when it rose last, or the robot came
   */
  private record Stay(String point, double battery, Instant risen) {}

  enum Finding {
    NOTHING_NEW,
    FAILS,
    WORKS_AGAIN
  }

  /**
   * @param patience a battery that has not risen for so long does not charge
   */
  ChargerWatch(Duration patience) {
    this.patience = patience;
  }

  /** A robot stands at the point, with so much in its battery, of 0 to 1. */
  Finding look(String robot, Place point, double battery, Instant now) {
    Stay stay = stays.get(robot);
    if (stay == null || !stay.point().equals(point.name())) {
      stays.put(robot, new Stay(point.name(), battery, now));
      return Finding.NOTHING_NEW;
    }
    if (battery >= stay.battery() + RISE) {
      stays.put(robot, new Stay(point.name(), battery, now));
      return faulty.remove(point.name()) == null ? Finding.NOTHING_NEW : Finding.WORKS_AGAIN;
    }
    stays.put(robot, new Stay(point.name(), Math.min(battery, stay.battery()), stay.risen()));
    if (stay.risen().plus(patience).isAfter(now) || fails(point)) {
      return Finding.NOTHING_NEW;
    }
    Sentence text = Phrase.CHARGER_IS_FAULTY.with(point.name(), robot, text(patience));
    faulty.put(point.name(), new FaultyCharger(point.name(), point.position(), now, text));
    return Finding.FAILS;
  }

  /** The robot does not stand at a charging point. */
  void left(String robot) {
    stays.remove(robot);
  }

  boolean fails(Place point) {
    return faulty.containsKey(point.name());
  }

  /** To be called once a tick. */
  void forget(Instant now) {
    faulty.values().removeIf(charger -> !charger.since().plus(LEFT_OUT).isAfter(now));
  }

  List<FaultyCharger> faulty() {
    return List.copyOf(faulty.values());
  }

  private static Sentence text(Duration duration) {
    return duration.toMinutes() == 0
        ? Phrase.SECONDS.with(duration.toSeconds())
        : Phrase.MINUTES.with(duration.toMinutes());
  }
}
