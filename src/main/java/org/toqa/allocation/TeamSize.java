package org.toqa.allocation;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/** How many robots it takes to carry a load, and how much of it each of them has. */
public final class TeamSize {
  /** Kilograms; sums of what robots carry are not exact. */
  static final double ROUNDING = 1e-9;

  private TeamSize() {}

  /** Whether the load is too heavy for every robot that fits on its path. */
  static boolean isForSeveral(AllocationProblem problem, AllocationTask task) {
    return isForSeveral(task, fitting(problem, task));
  }

  /**
   * @param fitting the robots that fit on its path
   */
  static boolean isForSeveral(AllocationTask task, List<Candidate> fitting) {
    return !task.isForOne()
        && !fitting.isEmpty()
        && fitting.stream().noneMatch(r -> r.isStrongEnough(task));
  }

  /** The robots that may have it, for which the path of the load is wide enough. */
  static List<Candidate> fitting(AllocationProblem problem, AllocationTask task) {
    Quotes quotes = problem.quotes();
    return problem.robots().stream()
        .filter(r -> task.allows(r.robot()) && quotes.hasPathFor(task, r))
        .toList();
  }

  /** How many robots carry the load, of those that are not broken; empty if all cannot. */
  static Optional<Integer> ofAll(AllocationTask task, List<Candidate> robots) {
    return smallest(task.load(), robots.stream().filter(TeamSize::canBeFree).toList());
  }

  private static boolean canBeFree(Candidate robot) {
    return switch (robot.availability()) {
      case FREE, BUSY, CHARGING, HELD, DRIVEN_BY_HAND -> true;
      case CONNECTING, LOST, NOT_LOCALISED, ERROR, OUT_OF_SERVICE -> false;
    };
  }

  /** The least number whose maximum loads add up to it; empty where those of all do not. */
  public static Optional<Integer> smallest(double load, List<Candidate> robots) {
    if (robots.stream().anyMatch(robot -> robot.maxLoad() >= load - ROUNDING)) {
      return Optional.of(1);
    }
    List<Double> strongestFirst =
        robots.stream()
            .filter(Candidate::canBeInTeam)
            .map(Candidate::maxLoad)
            .sorted(Comparator.reverseOrder())
            .toList();
    return IntStream.rangeClosed(2, strongestFirst.size())
        .filter(n -> sum(strongestFirst.subList(0, n)) >= load - ROUNDING)
        .boxed()
        .findFirst();
  }

  /**
   * The first ones that are together strong enough.
   *
   * @param robots the one that shall be in it first
   * @param size as many as there shall be
   * @return fewer, or too weak ones, where there is no such team
   */
  public static List<Candidate> first(double load, int size, List<Candidate> robots) {
    List<Candidate> team = new ArrayList<>();
    for (int i = 0; i < robots.size() && team.size() < size; i++) {
      List<Double> rest =
          robots.subList(i + 1, robots.size()).stream()
              .map(Candidate::maxLoad)
              .sorted(Comparator.reverseOrder())
              .limit(size - team.size() - 1L)
              .toList();
      double most = sum(maxLoads(team)) + robots.get(i).maxLoad() + sum(rest);
      if (rest.size() == size - team.size() - 1 && most >= load - ROUNDING) {
        team.add(robots.get(i));
      }
    }
    return team.size() == size ? team : robots.stream().limit(size).toList();
  }

  static boolean isStrongEnough(double load, List<Candidate> team) {
    return sum(maxLoads(team)) >= load - ROUNDING;
  }

  static List<Double> maxLoads(List<Candidate> team) {
    return team.stream().map(Candidate::maxLoad).toList();
  }

  /**
   * Kilograms that each has of the load, in the order of the robots: who carries twice as much has
   * twice the share, so that nobody has more than he may.
   *
   * @param maxLoads kilograms, each more than 0
   */
  public static List<Double> shares(double load, List<Double> maxLoads) {
    double sum = sum(maxLoads);
    return maxLoads.stream().map(most -> load * most / sum).toList();
  }

  private static double sum(List<Double> kilograms) {
    return kilograms.stream().mapToDouble(Double::doubleValue).sum();
  }
}
