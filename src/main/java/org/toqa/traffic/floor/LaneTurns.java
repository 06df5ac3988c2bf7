package org.toqa.traffic.floor;

import java.time.Instant;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiPredicate;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/**
 * Whose turn it is where no plan brings all to their goals, as where they would have to pass each
 * other in an aisle: whoever has waited longest, until it is there. Else the next plan would be for
 * who made room meanwhile, and both were led to and fro for ever.
 *
 * <p>Who had its turn stays at its goal: who made room for it and has no way past waits until it
 * goes elsewhere. Others may still have their turn.
 */
final class LaneTurns {
  private @Nullable Turn turn;

  /** By robot that is at its goal since its turn. */
  private final Map<String, Turn> over = new HashMap<>();

  /** By robot that made room: who is at its goal since, and leaves it no way past. */
  private final Map<String, String> cutOff = new HashMap<>();

  /** When the turns of robots ended that did not get on. */
  private final Map<String, Instant> givenUp = new HashMap<>();

  /**
   * @param makeRoom who want to be, or to get past, where it has to go
   */
  private record Turn(String robot, Vec2 goal, Instant since, Set<String> makeRoom) {
    boolean isOf(TrafficRobot other) {
      return other.name.equals(robot) && goal.equals(other.goal());
    }

    boolean isOfUse(TrafficRobot holder, Instant now) {
      boolean isStanding =
          !since.plus(RightOfWay.TURN).isAfter(now)
              && holder.waiting.isStandingFor(RightOfWay.TURN, now);
      return holder.isMovable() && !holder.isStalled() && !isStanding;
    }
  }

  /** Looks who has arrived, and who gets on no more or has another goal. To be called first. */
  void update(Collection<TrafficRobot> robots, Instant now) {
    Turn last = turn;
    if (last != null) {
      Optional<TrafficRobot> holder = robots.stream().filter(last::isOf).findFirst();
      if (holder.filter(LaneTurns::isThere).isPresent()) {
        over.put(last.robot(), last);
        turn = null;
      } else if (holder.filter(robot -> last.isOfUse(robot, now)).isEmpty()) {
        givenUp.put(last.robot(), now);
        turn = null;
      }
    }
    givenUp.values().removeIf(ended -> ended.plus(RightOfWay.TURN).isBefore(now));
    over.values().removeIf(past -> robots.stream().noneMatch(r -> past.isOf(r) && isThere(r)));
    cutOff.values().retainAll(over.keySet());
  }

  private static boolean isThere(TrafficRobot robot) {
    return robot.drive.isOver() && robot.isGoal(robot.committedEnd());
  }

  /**
   * Whose turn it is; of those that need a path whoever has waited longest, but for those whose
   * turn was of no use of late.
   *
   * @param planned those that can be planned for, whoever has waited longest first
   * @param canArrive whether its goal is nobody else's
   * @param isPassable whether a robot could get to its goal past another one that stays
   */
  Optional<TrafficRobot> next(
      List<TrafficRobot> planned,
      Predicate<TrafficRobot> canArrive,
      BiPredicate<TrafficRobot, String> isPassable) {
    Turn now = turn;
    if (now != null) {
      return planned.stream().filter(now::isOf).findFirst();
    }
    List<TrafficRobot> waiting =
        planned.stream().filter(r -> r.needsPath() && !isCutOff(r, isPassable)).toList();
    return waiting.stream()
        .filter(robot -> canArrive.test(robot) && !givenUp.containsKey(robot.name))
        .findFirst()
        .or(() -> waiting.stream().filter(canArrive).findFirst())
        .or(() -> waiting.stream().findFirst())
        .or(() -> planned.stream().filter(TrafficRobot::hasPathToGoal).findFirst());
  }

  private boolean isCutOff(TrafficRobot robot, BiPredicate<TrafficRobot, String> isPassable) {
    cutOff.remove(robot.name);
    over.values().stream()
        .filter(past -> past.makeRoom().contains(robot.name))
        .map(Turn::robot)
        .filter(there -> !isPassable.test(robot, there))
        .min(Comparator.naturalOrder())
        .ifPresent(there -> cutOff.put(robot.name, there));
    return cutOff.containsKey(robot.name);
  }

  /**
   * There is a plan to its goal; nothing of one that was on its way there anyway.
   *
   * @param makeRoom those planned that want to be, or to get past, where it has to go
   */
  void begin(TrafficRobot robot, Set<String> makeRoom, Instant now) {
    Set<String> all = new HashSet<>(makeRoom);
    Instant since = now;
    if (turn != null && turn.isOf(robot)) {
      all.addAll(turn.makeRoom());
      since = turn.since();
    } else if (!robot.needsPath()) {
      return;
    }
    turn = new Turn(robot.name, Objects.requireNonNull(robot.goal()), since, all);
  }

  /** All get to their goals by the last plan, or go on in the order of their priorities. */
  void end() {
    turn = null;
  }

  /** Who is at its goal since its turn, and leaves a robot no way past that made room for it. */
  Optional<String> cameFirst(TrafficRobot robot) {
    return Optional.ofNullable(cutOff.get(robot.name));
  }
}
