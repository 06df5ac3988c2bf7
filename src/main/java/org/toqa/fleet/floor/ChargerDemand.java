package org.toqa.fleet.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import org.toqa.fleet.FloorView.ChargerShortage;
import org.toqa.wording.Phrase;

/**
 * Whether a floor has enough charging points, by the last hour. Robots that charge for C
 * robot-hours while others work or are free for W robot-hours balance what they use; so N robots
 * none of which waits keep N C / (C + W) charging points busy. Confined to one agent.
 */
final class ChargerDemand {
  static final Duration WINDOW = Duration.ofHours(1);

  /** Before that there is nothing to judge by. */
  static final Duration LEAST_OBSERVED = Duration.ofMinutes(30);

  /** Robots that wait, on average over the window; fewer are no shortage. */
  static final double LEAST_WAITING = 0.5;

  private static final Duration INTERVAL = Duration.ofMinutes(1);

  private final Deque<Interval> intervals = new ArrayDeque<>();

  /** What robots did, in robot-seconds. */
  private static final class Interval {
    private final Instant begin;
    private double seconds;
    private double charging;
    private double waiting;
    private double other;

    private Interval(Instant begin) {
      this.begin = begin;
    }
  }

  /**
   * What the robots of the floor do since the last call.
   *
   * @param charging how many are at a charging point or on their way to a free one
   * @param waiting how many wait for one
   * @param other how many do something else, or nothing
   */
  void observe(int charging, int waiting, int other, Duration passed, Instant now) {
    while (!intervals.isEmpty() && intervals.getFirst().begin.plus(WINDOW).isBefore(now)) {
      intervals.removeFirst();
    }
    if (intervals.isEmpty() || !intervals.getLast().begin.plus(INTERVAL).isAfter(now)) {
      intervals.addLast(new Interval(now));
    }
    double seconds = passed.toNanos() / 1e9;
    Interval last = intervals.getLast();
    last.seconds += seconds;
    last.charging += charging * seconds;
    last.waiting += waiting * seconds;
    last.other += other * seconds;
  }

  /**
   * @param chargers how many charging points the floor has
   * @param robots how many robots charge there
   * @return empty: they are enough, or it is too early to say
   */
  Optional<ChargerShortage> shortage(int chargers, int robots) {
    double seconds = intervals.stream().mapToDouble(i -> i.seconds).sum();
    double charging = intervals.stream().mapToDouble(i -> i.charging).sum();
    double waiting = intervals.stream().mapToDouble(i -> i.waiting).sum() / seconds;
    double other = intervals.stream().mapToDouble(i -> i.other).sum();
    if (seconds < LEAST_OBSERVED.toSeconds() || waiting < LEAST_WAITING || charging == 0) {
      return Optional.empty();
    }
    int needed = (int) Math.ceil(robots * charging / (charging + other));
    return needed <= chargers
        ? Optional.empty()
        : Optional.of(
            new ChargerShortage(
                chargers, needed, Phrase.TOO_FEW_CHARGERS.with(waiting, chargers, needed)));
  }
}
