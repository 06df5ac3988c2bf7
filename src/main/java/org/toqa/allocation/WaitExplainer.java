package org.toqa.allocation;

import static java.util.stream.Collectors.counting;
import static java.util.stream.Collectors.groupingBy;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.toqa.geometry.Vec2;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Why a task waits. */
public final class WaitExplainer {
  /** Of so many robots each is named; of more, they are counted. */
  private static final int NAMED = 3;

  private final List<Candidate> robots;
  private final Quotes quotes;

  /**
   * @param pathLengths {@link PathLengths#STRAIGHT} where nobody has looked for paths yet
   * @param chargers the floor's charging points, metres, map frame
   */
  public WaitExplainer(List<Candidate> robots, PathLengths pathLengths, List<Vec2> chargers) {
    this(robots, new Costs(new Terrain(pathLengths, chargers)));
  }

  WaitExplainer(AllocationProblem problem) {
    this(problem.robots(), problem.quotes());
  }

  WaitExplainer(List<Candidate> robots, Quotes quotes) {
    this.robots = List.copyOf(robots);
    this.quotes = quotes;
  }

  Decision.Unassigned unassigned(AllocationTask task) {
    List<Candidate> free = allowed(task).stream().filter(Candidate::isFree).toList();
    List<Quote> prices = free.isEmpty() ? List.of() : quotes.of(task, free);
    List<String> drained =
        IntStream.range(0, free.size())
            .filter(i -> prices.get(i).impediment() == Impediment.BATTERY)
            .mapToObj(i -> free.get(i).robot())
            .toList();
    return new Decision.Unassigned(task.id(), reason(task), drained);
  }

  /** The reason of a task that no robot was given. */
  public Sentence reason(AllocationTask task) {
    if (robots.isEmpty()) {
      return Phrase.NO_ROBOT_ADDED.with();
    }
    return task.onlyRobots().isEmpty() ? reason(task, robots) : reasonOfChosen(task);
  }

  /** Where only some robots may have it: who they are, and what keeps them. */
  private Sentence reasonOfChosen(AllocationTask task) {
    List<Candidate> chosen = allowed(task);
    Sentence names = task.chosen();
    if (chosen.isEmpty()) {
      return Phrase.CHOSEN_ARE_NOT_HERE.with(names);
    }
    if (chosen.size() == 1 && chosen.getFirst().isStrongEnough(task)) {
      return Phrase.ONLY_CHOSEN_MAY.with(names, whatKeeps(task, chosen.getFirst()));
    }
    return Phrase.LISTED_APART.with(Phrase.ONLY_CHOSEN_MAY_ALL.with(names), reason(task, chosen));
  }

  private List<Candidate> allowed(AllocationTask task) {
    return robots.stream().filter(robot -> task.allows(robot.robot())).toList();
  }

  /**
   * @param robots at least one
   */
  private Sentence reason(AllocationTask task, List<Candidate> robots) {
    List<Candidate> strong = robots.stream().filter(r -> r.isStrongEnough(task)).toList();
    if (strong.isEmpty()) {
      return tooHeavyForOne(task, robots);
    }
    if (strong.size() == 1) {
      Candidate only = strong.getFirst();
      Phrase phrase = robots.size() == 1 ? Phrase.ONLY_ROBOT : Phrase.ONLY_STRONG_ROBOT;
      return phrase.with(only.robot(), whatKeeps(task, only));
    }
    Phrase none = task.isDrive() ? Phrase.NONE_OF_ROBOTS_FOR_DRIVE : Phrase.NONE_OF_STRONG_ROBOTS;
    return none.with(
        strong.size(),
        Sentence.joined(
            Phrase.LISTED, strong.size() <= NAMED ? named(task, strong) : counted(strong)));
  }

  /**
   * Whether one of them is free to do it alone, so that nothing keeps it but that nobody decided.
   */
  public boolean hasFreeRobot(AllocationTask task) {
    return allowed(task).stream()
        .anyMatch(
            robot ->
                robot.isFree()
                    && robot.isStrongEnough(task)
                    && quotes.of(task, robot).reason() == null);
  }

  /** Whether none of these robots will ever carry it, alone or together, whatever becomes free. */
  public boolean isImpossible(AllocationTask task) {
    List<Candidate> allowed = allowed(task);
    return allowed.stream().noneMatch(r -> r.isStrongEnough(task))
        && (task.isForOne() || TeamSize.smallest(task.load(), allowed).isEmpty());
  }

  /** Says the true number of robots that the load needs, and how many are there. */
  private static Sentence tooHeavyForOne(AllocationTask task, List<Candidate> robots) {
    if (task.isForOne()) {
      return Phrase.TOO_HEAVY_TO_CHARGE.with(task.load());
    }
    Optional<Integer> needed = TeamSize.smallest(task.load(), robots);
    double together = robots.stream().mapToDouble(Candidate::maxLoad).sum();
    if (needed.isEmpty()) {
      return Phrase.TOO_HEAVY_FOR_ALL.with(task.load(), robots.size(), together);
    }
    long free = robots.stream().filter(Candidate::isFree).count();
    return Phrase.NEEDS_TEAM.with(needed.get(), free, robots.size());
  }

  private List<Sentence> named(AllocationTask task, List<Candidate> strong) {
    return strong.stream()
        .map(robot -> Phrase.ROBOT_AND_CLAUSE.with(robot.robot(), whatKeeps(task, robot)))
        .toList();
  }

  private Sentence whatKeeps(AllocationTask task, Candidate robot) {
    Long currentTask = robot.task();
    return switch (robot.availability()) {
      case FREE -> whatKeepsFree(task, robot);
      case BUSY ->
          currentTask == null
              ? robot.availability().ofOne()
              : Phrase.WORKS_ON_TASK.with(currentTask);
      default -> robot.availability().ofOne();
    };
  }

  private Sentence whatKeepsFree(AllocationTask task, Candidate robot) {
    Sentence reason = quotes.of(task, robot).reason();
    return reason == null ? robot.availability().ofOne() : reason;
  }

  private static List<Sentence> counted(List<Candidate> strong) {
    Map<Availability, Long> numbers =
        strong.stream()
            .collect(
                groupingBy(
                    Candidate::availability, () -> new EnumMap<>(Availability.class), counting()));
    return numbers.entrySet().stream().map(e -> e.getKey().ofSeveral(e.getValue())).toList();
  }
}
