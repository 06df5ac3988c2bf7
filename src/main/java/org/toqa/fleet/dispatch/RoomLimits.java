package org.toqa.fleet.dispatch;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.toqa.allocation.AllocationTask;
import org.toqa.allocation.Availability;
import org.toqa.allocation.Candidate;
import org.toqa.allocation.TeamLimit;
import org.toqa.allocation.TeamSize;

/**
 * What teams a task has room for, as far as it was found: a team that had none says so of all that
 * are as wide, and where it could go sideways of those too that cannot.
 *
 * @param any metres: teams have no room where one of them is as wide
 * @param omnidirectional the same of teams that can go sideways; at least as much
 */
record RoomLimits(double any, double omnidirectional) {
  static final RoomLimits NONE = new RoomLimits(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);

  /** After such a team had no room. */
  RoomLimits without(PathQuery.TeamQuestion question) {
    return new RoomLimits(
        Math.min(any, question.diameter()),
        question.hasDifferential()
            ? omnidirectional
            : Math.min(omnidirectional, question.diameter()));
  }

  /**
   * The task for teams of which nothing was found yet: of those that are free now, else of those
   * that may be some day; empty where these robots are no such team.
   *
   * @param job for the robots that were chosen
   */
  Optional<AllocationTask> restrict(AllocationTask job, List<Candidate> robots) {
    List<AllocationTask> ways =
        Stream.of(new TeamLimit(any, false), new TeamLimit(omnidirectional, true))
            .map(job::withTeams)
            .filter(way -> hasTeam(way, robots, _ -> true))
            .toList();
    return ways.stream()
        .filter(way -> hasTeam(way, robots, r -> r.availability() == Availability.FREE))
        .findFirst()
        .or(() -> ways.stream().findFirst());
  }

  /** One that is strong enough alone does not fit on the path, or it would be no task for teams. */
  private static boolean hasTeam(
      AllocationTask job, List<Candidate> robots, Predicate<Candidate> which) {
    List<Candidate> able =
        robots.stream()
            .filter(which)
            .filter(job::allowsInTeam)
            .filter(robot -> robot.maxLoad() < job.load())
            .toList();
    return TeamSize.smallest(job.load(), able).isPresent();
  }
}
