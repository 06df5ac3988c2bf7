package org.toqa.allocation;

import static java.util.stream.Collectors.toSet;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.toqa.allocation.AllocationProblem.GivenTask;
import org.toqa.allocation.OpenTasks.TeamTask;
import org.toqa.allocation.TeamChoices.Exclusion;

/**
 * The tasks of a round against the robots that can have one of them, with what each pair costs. A
 * task for k robots is k rows of an {@link Assignment}, which may be filled in part.
 */
final class RoundTable {
  /** A second that a task has waited longer is worth this detour, metres. */
  private static final double METRES_PER_SECOND_WAITED = 0.1;

  /** A robot is not turned round for less, metres. */
  private static final double TURN_ROUND_METRES = 2;

  /** Above any sum of real costs: a robot at work. */
  private static final double WORKS = 1e9;

  /** Above any number of robots at work: tasks that robots have, and teams that are chosen. */
  private static final double MUST = 1e12;

  private final AllocationProblem problem;
  private final List<GivenTask> given;
  private final List<AllocationTask> singles;
  private final List<TeamTask> teams;
  private final List<Candidate> robots;

  /** By task, the given ones, the single ones, the teams: by robot. */
  private final List<List<Quote>> quotes = new ArrayList<>();

  RoundTable(AllocationProblem problem, OpenTasks open) {
    this.problem = problem;
    given = problem.givenTasks();
    singles = open.singles();
    teams = open.teams();
    Set<String> holders = given.stream().map(GivenTask::robot).collect(toSet());
    robots =
        problem.robots().stream()
            .filter(r -> r.isFree() || holders.contains(r.robot()))
            .filter(r -> !open.kept().contains(r.robot()))
            .toList();
    Quotes model = problem.quotes();
    given.forEach(task -> quotes.add(model.of(task.task(), robots)));
    singles.forEach(task -> quotes.add(model.of(task, robots)));
    teams.forEach(team -> quotes.add(quotes(team)));
  }

  /** By robot; nothing of those that are not able. */
  private List<Quote> quotes(TeamTask team) {
    Map<String, Quote> parts = new HashMap<>();
    for (int i = 0; i < team.able().size(); i++) {
      parts.put(team.able().get(i).robot(), team.quotes().get(i));
    }
    return robots.stream().map(r -> parts.getOrDefault(r.robot(), Quote.SILENT)).toList();
  }

  /**
   * Who gets what.
   *
   * @param robots by the numbers of the tasks, given ones first, then single ones, then teams: the
   *     numbers of those that have it
   * @param working how many robots have a task
   * @param joules over all, less what the tasks are worth that have waited
   */
  record Filling(List<List<Integer>> robots, int working, double joules) {}

  int firstTeam() {
    return given.size() + singles.size();
  }

  AllocationTask task(int number) {
    if (number < given.size()) {
      return given.get(number).task();
    }
    return number < firstTeam()
        ? singles.get(number - given.size())
        : teams.get(number - firstTeam()).task();
  }

  int taskCount() {
    return firstTeam() + teams.size();
  }

  int robotCount() {
    return robots.size();
  }

  Candidate robot(int number) {
    return robots.get(number);
  }

  Quote quote(int task, int robot) {
    return quotes.get(task).get(robot);
  }

  /** The robot that has the task now. */
  Optional<String> holder(int task) {
    return task < given.size() ? Optional.of(given.get(task).robot()) : Optional.empty();
  }

  /** The least cost where so much is settled; empty where a chosen team lacks robots. */
  Optional<Filling> fill(TeamChoices choices) {
    int[] rowTasks = rows(choices);
    int rows = rowTasks.length;
    List<List<Integer>> filled =
        IntStream.range(0, taskCount()).<List<Integer>>mapToObj(_ -> new ArrayList<>()).toList();
    int working = 0;
    double joules = 0;
    int[] robotOf = rows == 0 || robots.isEmpty() ? new int[0] : assign(rowTasks, choices);
    for (int row = 0; row < robotOf.length; row++) {
      int task = rowTasks[row];
      int robot = robotOf[row];
      if (robot >= 0 && isPossible(task, robot, choices)) {
        filled.get(task).add(robot);
        working++;
        joules += joules(task, robot);
      } else if (robot >= 0 && isHolder(task, robot)) {
        filled.get(task).add(robot); // who has it keeps it
      }
    }
    boolean isComplete =
        choices.chosen().stream()
            .allMatch(team -> filled.get(firstTeam() + team).size() == teams.get(team).size());
    return isComplete ? Optional.of(new Filling(filled, working, joules)) : Optional.empty();
  }

  /** The task of each row. */
  private int[] rows(TeamChoices choices) {
    return IntStream.range(0, taskCount())
        .filter(task -> !choices.dropped().contains(task - firstTeam()))
        .filter(task -> task < given.size() || !isShutOut(task, choices))
        .flatMap(
            task -> {
              int size = task < firstTeam() ? 1 : size(task - firstTeam());
              return IntStream.generate(() -> task).limit(size);
            })
        .toArray();
  }

  /** Whether a chosen team needs its places. */
  private boolean isShutOut(int task, TeamChoices choices) {
    return choices.chosen().stream()
        .map(team -> firstTeam() + team)
        .anyMatch(team -> team != task && isConflict(team, task));
  }

  /** Whether they need the same place, one of them being for several robots. */
  boolean isConflict(int team, int other) {
    return PlaceUse.of(task(team), true).stream()
        .anyMatch(
            use ->
                PlaceUse.of(task(other), true).stream()
                    .anyMatch(of -> of.place().distanceTo(use.place()) < PlaceUse.REACH));
  }

  /** By row its robot; -1 where there are fewer robots than rows. */
  private int[] assign(int[] rowTasks, TeamChoices choices) {
    boolean robotsAreColumns = rowTasks.length <= robots.size();
    int rows = robotsAreColumns ? rowTasks.length : robots.size();
    int columns = robotsAreColumns ? robots.size() : rowTasks.length;
    double[] flat = new double[rows * columns];
    for (int row = 0; row < rows; row++) {
      for (int column = 0; column < columns; column++) {
        flat[row * columns + column] =
            robotsAreColumns
                ? weight(rowTasks[row], column, choices)
                : weight(rowTasks[column], row, choices);
      }
    }
    int[] columnOf = Assignment.leastCost(flat, rows);
    if (robotsAreColumns) {
      return columnOf;
    }
    int[] robotOf = new int[rowTasks.length];
    Arrays.fill(robotOf, -1);
    for (int robot = 0; robot < rows; robot++) {
      robotOf[columnOf[robot]] = robot;
    }
    return robotOf;
  }

  /** 0 for what cannot be. */
  private double weight(int task, int robot, TeamChoices choices) {
    boolean isMust = task < given.size() || choices.chosen().contains(task - firstTeam());
    if (isPossible(task, robot, choices)) {
      return joules(task, robot) - (isMust ? MUST : WORKS);
    }
    return isHolder(task, robot) ? -MUST / 2 : 0;
  }

  private boolean isPossible(int task, int robot, TeamChoices choices) {
    return quote(task, robot).isPossible()
        && !choices.exclusions().contains(new Exclusion(task - firstTeam(), robot));
  }

  private double joules(int task, int robot) {
    double joules = quote(task, robot).joules();
    if (task < given.size()) {
      return joules + (isHolder(task, robot) ? 0 : Energy.joules(TURN_ROUND_METRES, 0));
    }
    double waited = task(task).waitedSeconds(problem.now()) * METRES_PER_SECOND_WAITED;
    return joules - Energy.joules(waited, 0);
  }

  private boolean isHolder(int task, int robot) {
    return holder(task).equals(Optional.of(robots.get(robot).robot()));
  }

  /** Whether all that a team needs are in it, and they are strong enough together. */
  boolean isStrongEnough(int team, List<Integer> members) {
    return TeamSize.isStrongEnough(
        teams.get(team).task().load(), members.stream().map(robots::get).toList());
  }

  int size(int team) {
    return teams.get(team).size();
  }
}
