package org.toqa.allocation;

import java.time.Duration;
import java.time.Instant;
import java.util.Comparator;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.wording.Sentence;

/**
 * A transport task as an allocator sees it.
 *
 * @param load kilograms
 * @param start where the load is, metres, map frame
 * @param goal where it is to go, metres, map frame
 * @param waitsFrom the moment from which its waiting counts; see {@link #waitingSince(Instant, int,
 *     Instant)}
 * @param teams which robots a team may be of
 * @param onlyRobots names of those that may carry it; empty: whichever there are
 * @param via where it goes between start and goal, in order, metres, map frame
 * @param isForOne whether only one robot may carry it, since it charges on its way
 * @param choice what those that alone may carry it are called; null: by their names
 */
public record AllocationTask(
    long id,
    double load,
    Vec2 start,
    Vec2 goal,
    Instant waitsFrom,
    TeamLimit teams,
    List<String> onlyRobots,
    List<Vec2> via,
    boolean isForOne,
    @Nullable Sentence choice) {

  public AllocationTask {
    onlyRobots = List.copyOf(onlyRobots);
    via = List.copyOf(via);
  }

  public AllocationTask(long id, double load, Vec2 start, Vec2 goal, Instant waitsFrom) {
    this(id, load, start, goal, waitsFrom, TeamLimit.NONE, List.of(), List.of(), false, null);
  }

  /** The same, that only these robots may carry; empty: whichever there are. */
  public AllocationTask withOnlyRobots(List<String> robots) {
    return withOnlyRobots(robots, null);
  }

  /**
   * The same, that only these robots may carry.
   *
   * @param called what they are called; null: by their names
   */
  public AllocationTask withOnlyRobots(List<String> robots, @Nullable Sentence called) {
    return new AllocationTask(
        id, load, start, goal, waitsFrom, teams, robots, via, isForOne, called);
  }

  /** What those are called that alone may carry it. */
  Sentence chosen() {
    return choice == null ? Sentence.names(onlyRobots) : choice;
  }

  /**
   * The same on another way.
   *
   * @param between start and goal
   */
  public AllocationTask withStops(List<Vec2> between, boolean one) {
    return new AllocationTask(
        id, load, start, goal, waitsFrom, teams, onlyRobots, between, one, choice);
  }

  /** Whether a robot only goes there, with nothing to carry. */
  boolean isDrive() {
    return load == 0;
  }

  /** Whether the robot may carry it, alone or with others. */
  public boolean allows(String robot) {
    return onlyRobots.isEmpty() || onlyRobots.contains(robot);
  }

  /** What has waited longest, as it counts, comes first. */
  public static final Comparator<AllocationTask> BY_PRECEDENCE =
      Comparator.comparing(AllocationTask::waitsFrom).thenComparingLong(AllocationTask::id);

  /** How much earlier each level of priority lets a task come. */
  private static final Duration PRIORITY_LEVEL = Duration.ofMinutes(1);

  /** At its deadline a task comes before whatever has waited less than this. */
  private static final Duration DEADLINE_LEAD = Duration.ofHours(1);

  /**
   * The moment from which a task's waiting counts. Priority and deadline move it back, but by a
   * bounded time: whatever waits comes before all newcomers some day, so nothing waits for ever.
   *
   * @param priority each level counts as a minute of waiting
   */
  public static Instant waitingSince(Instant createdAt, int priority, @Nullable Instant deadline) {
    Instant usual = createdAt.minus(PRIORITY_LEVEL.multipliedBy(priority));
    if (deadline == null) {
      return usual;
    }
    Instant due = later(deadline, createdAt).minus(DEADLINE_LEAD);
    return due.isBefore(usual) ? due : usual;
  }

  private static Instant later(Instant a, Instant b) {
    return a.isAfter(b) ? a : b;
  }

  /** What one of several robots carries of it at most. */
  AllocationTask partFor(Candidate robot) {
    return new AllocationTask(
        id,
        Math.min(load, robot.maxLoad()),
        start,
        goal,
        waitsFrom,
        teams,
        onlyRobots,
        via,
        isForOne,
        choice);
  }

  /** The same, for such teams alone. */
  public AllocationTask withTeams(TeamLimit limit) {
    return new AllocationTask(
        id, load, start, goal, waitsFrom, limit, onlyRobots, via, isForOne, choice);
  }

  /** Whether the robot may be one of several. */
  public boolean allowsInTeam(Candidate robot) {
    return allows(robot.robot()) && robot.canBeInTeam() && teams.allows(robot);
  }

  /** Seconds, at least 0. */
  double waitedSeconds(Instant now) {
    return Math.max(0, Duration.between(waitsFrom, now).toMillis() / 1000.0);
  }
}
