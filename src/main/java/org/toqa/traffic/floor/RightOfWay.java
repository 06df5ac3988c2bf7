package org.toqa.traffic.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/**
 * Closes the way of a robot that has waited for long to newcomers: who is on it goes on and leaves
 * it, nobody else enters it until that robot has its path. It is for those that need their whole
 * way free at once, as groups and robots too large for the lanes do; others would cross it for
 * ever. Those that are planned together go first by their priority instead.
 *
 * <p>One way at a time, so that nobody who leaves one is kept out by another: that of whoever has
 * stood longest.
 */
final class RightOfWay {
  /** Who has stood so long short of its goal goes first. */
  static final Duration AFTER = Duration.ofSeconds(20);

  /** For so long a way is closed at most, and open again at least, before it is the next turn. */
  static final Duration TURN = Duration.ofSeconds(60);

  private final SingleRobotPlanner singleRobotPlanner;
  private @Nullable String holder;
  private Instant since = Instant.MIN;
  private Instant looked = Instant.MIN;
  private List<SweptArea> way = List.of();

  /** When the turns of robots ended that had to be given up. */
  private final Map<String, Instant> givenUp = new HashMap<>();

  /** The names of those that were planned together last, to their own goals. */
  private Set<String> planned = Set.of();

  RightOfWay(SingleRobotPlanner singleRobotPlanner) {
    this.singleRobotPlanner = singleRobotPlanner;
  }

  /** These are planned together: they need no way for themselves. */
  void setPlanned(Set<String> names) {
    planned = names;
  }

  /** Looks whose turn it is, once a second. */
  void update(Collection<TrafficRobot> robots, Instant now) {
    boolean isKept =
        robots.stream().anyMatch(robot -> robot.name.equals(holder) && needsWay(robot, now));
    boolean isRecent = now.isBefore(looked.plus(FloorPlanner.RETRY_AFTER));
    if (isRecent && (isKept || holder == null)) {
      return;
    }
    looked = now;
    if (isKept && !since.plus(TURN).isAfter(now)) {
      givenUp.put(Objects.requireNonNull(holder), now);
    }
    givenUp.values().removeIf(ended -> ended.plus(TURN).isBefore(now));
    String last = holder;
    holder = null;
    way = List.of();
    robots.stream()
        .filter(robot -> needsWay(robot, now) && !givenUp.containsKey(robot.name))
        .sorted(
            Comparator.<TrafficRobot, Boolean>comparing(robot -> !robot.name.equals(last))
                .thenComparing(robot -> robot.waiting.standingSince()))
        .filter(robot -> !setWay(robot, robots).isEmpty())
        .findFirst()
        .ifPresent(
            robot -> {
              holder = robot.name;
              since = robot.name.equals(last) ? since : now;
            });
  }

  private boolean needsWay(TrafficRobot robot, Instant now) {
    return robot.needsPath() && !planned.contains(robot.name) && isWaitingLong(robot, now);
  }

  /** Whether others, but none that is at its goal, have kept a robot from its own for long. */
  static boolean isWaitingLong(TrafficRobot robot, Instant now) {
    return robot.goal() != null
        && robot.waiting.goalTakenBy() == null
        && !robot.isGoal(robot.committedEnd())
        && robot.waiting.isStandingFor(AFTER, now);
  }

  /**
   * What it would cover on its way: round those that are at their goals, where there is such a way;
   * else these step aside. Nothing where one stays on it that does not, as a group at its goal.
   */
  private List<SweptArea> setWay(TrafficRobot robot, Collection<TrafficRobot> robots) {
    way = areas(singleRobotPlanner.pathAroundStaying(robot, robots));
    if (robots.stream().anyMatch(other -> isAtGoalOnWay(robot, other))) {
      List<SweptArea> round =
          areas(
              singleRobotPlanner.pathAround(
                  robot,
                  robots,
                  other ->
                      !other.isMovable() || other.isAtGoal() || SingleRobotPlanner.stays(other)));
      boolean isBarred =
          robots.stream().anyMatch(other -> other.isFormation() && isAtGoalOnWay(robot, other));
      way = isBarred || !round.isEmpty() ? round : way;
    }
    return way;
  }

  private boolean isAtGoalOnWay(TrafficRobot robot, TrafficRobot other) {
    return other != robot && other.isAtGoal() && !isOff(other.standingArea());
  }

  /** Whether who covers an area keeps off the closed way. */
  boolean isOff(SweptArea area) {
    return way.stream().allMatch(closed -> Clearance.isKept(area, closed));
  }

  /** Whose way is closed to others; null: nobody's. */
  @Nullable String holder() {
    return holder;
  }

  /** What is closed, in parts. */
  List<SweptArea> way() {
    return way;
  }

  boolean isClosed() {
    return holder != null;
  }

  /** What is closed to a robot, in parts. */
  List<SweptArea> closedTo(TrafficRobot robot) {
    return robot.name.equals(holder) ? List.of() : way;
  }

  /** What has to be left: the closed way, and the paths alone of those too large for lanes. */
  List<SweptArea> wanted(Collection<TrafficRobot> robots, double diameter) {
    List<SweptArea> all = new ArrayList<>(way);
    for (TrafficRobot robot : robots) {
      boolean isTooLarge = robot.formation() != null || robot.radius() > diameter / 2;
      if (robot.needsPath()
          && robot.drive.path() == null
          && isTooLarge
          && !robot.name.equals(holder)) {
        robot.waiting.setWanted(areas(singleRobotPlanner.pathAroundStaying(robot, robots)));
        all.addAll(robot.waiting.wanted());
      }
    }
    return all;
  }

  private static List<SweptArea> areas(Optional<List<Section>> sections) {
    return sections.orElse(List.of()).stream().map(Section::area).toList();
  }

  /** Who has not come to the way yet gives up paths of its own over it. */
  void freePathsOver(Collection<TrafficRobot> robots) {
    for (TrafficRobot robot : robots) {
      if (!closedTo(robot).isEmpty()
          && robot.drive.hasUncommitted()
          && !robot.drive.isOnSharedPath()
          && isOff(robot.areaAt(robot.committedEnd()))
          && robot.drive.unreleasedAreas().stream().anyMatch(area -> !isOff(area))) {
        robot.drive.freeUncommitted();
      }
    }
  }
}
