package org.toqa.allocation;

import static java.util.stream.Collectors.counting;
import static java.util.stream.Collectors.groupingBy;
import static java.util.stream.Collectors.joining;

import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.toqa.allocation.Costs.Obstacle;
import org.toqa.geometry.Vec2;

/** Why a task waits, as a sentence for people. */
public final class WaitingReason {
  /** Of so many robots each is named; of more, they are counted. */
  private static final int NAMED = 3;

  private final List<Candidate> robots;
  private final Costs costs;

  /**
   * @param travel {@link Travel#STRAIGHT} where nobody has looked for ways yet
   * @param chargers the floor's charging points, metres, map frame
   */
  public WaitingReason(List<Candidate> robots, Travel travel, List<Vec2> chargers) {
    this.robots = List.copyOf(robots);
    this.costs = new Costs(travel, chargers);
  }

  WaitingReason(Situation situation) {
    this(situation.robots(), situation.travel(), situation.chargers());
  }

  Decision.Waits waits(Job job) {
    List<Candidate> free = robots.stream().filter(Candidate::isFree).toList();
    List<Costs.Cost> prices = free.isEmpty() ? List.of() : costs.of(job, free);
    List<String> drained =
        IntStream.range(0, free.size())
            .filter(i -> prices.get(i).obstacle() == Obstacle.BATTERY)
            .mapToObj(i -> free.get(i).robot())
            .toList();
    return new Decision.Waits(job.id(), of(job), drained);
  }

  /** The reason of a task that no robot was given. */
  public String of(Job job) {
    if (robots.isEmpty()) {
      return "No robot has been added yet.";
    }
    List<Candidate> strong = robots.stream().filter(r -> r.isStrongEnough(job)).toList();
    if (strong.isEmpty()) {
      return tooHeavyForOne(job);
    }
    if (strong.size() == 1) {
      Candidate only = strong.getFirst();
      return robots.size() == 1
          ? "The only robot, %s, %s.".formatted(only.robot(), keeps(job, only))
          : "The only robot that is strong enough, %s, %s."
              .formatted(only.robot(), keeps(job, only));
    }
    return "None of the %d robots that are strong enough can take it now: %s."
        .formatted(
            strong.size(),
            strong.size() <= NAMED
                ? strong.stream().map(r -> r.robot() + " " + keeps(job, r)).collect(joining(", "))
                : counted(strong));
  }

  /** Says the true number of robots that the load needs, and how many are there. */
  private String tooHeavyForOne(Job job) {
    Optional<Integer> needed = TeamSize.of(job.load(), robots);
    double together = robots.stream().mapToDouble(Candidate::maxLoad).sum();
    if (job.load() > together) {
      return "The load weighs %s kg, and all %d robots together carry %s kg."
          .formatted(kilograms(job.load()), robots.size(), kilograms(together));
    }
    if (needed.isEmpty()) {
      return "The load weighs %s kg, and no robots carry it in even shares."
          .formatted(kilograms(job.load()));
    }
    long free = robots.stream().filter(Candidate::isFree).count();
    return "It needs %d robots that carry it together, and %d of %d %s free."
        .formatted(needed.get(), free, robots.size(), free == 1 ? "is" : "are");
  }

  private String keeps(Job job, Candidate robot) {
    return switch (robot.standing()) {
      case FREE -> keepsFree(job, robot);
      case BUSY ->
          robot.task() == null ? robot.standing().ofOne() : "works on task " + robot.task();
      default -> robot.standing().ofOne();
    };
  }

  private String keepsFree(Job job, Candidate robot) {
    return switch (costs.of(job, robot).obstacle()) {
      case null -> "is needed for another task first";
      case TOO_WEAK -> "is too weak";
      case NO_WAY ->
          String.format(
              Locale.ROOT,
              "finds no way to the load and its goal that is wide enough for its %.2f m",
              robot.diameter());
      case BATTERY ->
          robot.battery() == null
              ? "would not get to a charger after it"
              : String.format(
                  Locale.ROOT,
                  "has %.0f %% and would not get to a charger after it",
                  100 * robot.battery());
    };
  }

  private static String counted(List<Candidate> strong) {
    Map<Standing, Long> numbers =
        strong.stream()
            .collect(
                groupingBy(Candidate::standing, () -> new EnumMap<>(Standing.class), counting()));
    return numbers.entrySet().stream()
        .map(
            e ->
                e.getKey() == Standing.FREE
                    ? e.getValue()
                        + " cannot reach it, must charge first or are needed for other tasks first"
                    : e.getValue()
                        + " "
                        + (e.getValue() == 1 ? e.getKey().ofOne() : e.getKey().ofSeveral()))
        .collect(joining(", "));
  }

  private static String kilograms(double load) {
    return load == Math.rint(load)
        ? String.format(Locale.ROOT, "%.0f", load)
        : Double.toString(load);
  }
}
