package org.toqa.allocation;

import static java.util.stream.Collectors.counting;
import static java.util.stream.Collectors.groupingBy;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.toqa.allocation.Costs.Obstacle;
import org.toqa.geometry.Vec2;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Why a task waits. */
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
  public Sentence of(Job job) {
    if (robots.isEmpty()) {
      return Phrase.NO_ROBOT_ADDED.with();
    }
    List<Candidate> strong = robots.stream().filter(r -> r.isStrongEnough(job)).toList();
    if (strong.isEmpty()) {
      return tooHeavyForOne(job);
    }
    if (strong.size() == 1) {
      Candidate only = strong.getFirst();
      Phrase phrase = robots.size() == 1 ? Phrase.ONLY_ROBOT : Phrase.ONLY_STRONG_ROBOT;
      return phrase.with(only.robot(), keeps(job, only));
    }
    return Phrase.NONE_OF_STRONG_ROBOTS.with(
        strong.size(),
        Sentence.joined(
            Phrase.LISTED, strong.size() <= NAMED ? named(job, strong) : counted(strong)));
  }

  /** Says the true number of robots that the load needs, and how many are there. */
  private Sentence tooHeavyForOne(Job job) {
    Optional<Integer> needed = TeamSize.of(job.load(), robots);
    double together = robots.stream().mapToDouble(Candidate::maxLoad).sum();
    if (job.load() > together) {
      return Phrase.TOO_HEAVY_FOR_ALL.with(job.load(), robots.size(), together);
    }
    if (needed.isEmpty()) {
      return Phrase.NO_EVEN_SHARES.with(job.load());
    }
    long free = robots.stream().filter(Candidate::isFree).count();
    return Phrase.NEEDS_TEAM.with(needed.get(), free, robots.size());
  }

  private List<Sentence> named(Job job, List<Candidate> strong) {
    return strong.stream()
        .map(robot -> Phrase.ROBOT_AND_CLAUSE.with(robot.robot(), keeps(job, robot)))
        .toList();
  }

  private Sentence keeps(Job job, Candidate robot) {
    Long task = robot.task();
    return switch (robot.standing()) {
      case FREE -> keepsFree(job, robot);
      case BUSY -> task == null ? robot.standing().ofOne() : Phrase.WORKS_ON_TASK.with(task);
      default -> robot.standing().ofOne();
    };
  }

  private Sentence keepsFree(Job job, Candidate robot) {
    Double battery = robot.battery();
    return switch (costs.of(job, robot).obstacle()) {
      case null -> robot.standing().ofOne();
      case TOO_WEAK -> Phrase.IS_TOO_WEAK.with();
      case NO_WAY -> Phrase.FINDS_NO_WAY.with(robot.diameter());
      case BATTERY ->
          battery == null
              ? Phrase.WOULD_NOT_REACH_CHARGER.with()
              : Phrase.WOULD_NOT_REACH_CHARGER_WITH.with(Math.round(100 * battery));
    };
  }

  private static List<Sentence> counted(List<Candidate> strong) {
    Map<Standing, Long> numbers =
        strong.stream()
            .collect(
                groupingBy(Candidate::standing, () -> new EnumMap<>(Standing.class), counting()));
    return numbers.entrySet().stream().map(e -> e.getKey().ofSeveral(e.getValue())).toList();
  }
}
