package org.toqa.traffic.floor;

import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.toqa.traffic.floor.ReservedPath.Dependency;

/**
 * Gives robots the paths of a plan that was made elsewhere, while they drove on.
 *
 * <p>A path still fits if its robot wants the same, can move, and what it may drive ends where the
 * path begins, or farther along it; whoever has gone farther must not have passed another that the
 * plan lets go first. A path that no longer fits is left out: its robot stops where its released
 * part ends, and nobody waits for it in the plan's order. Whatever is adopted, nobody is released
 * what is another's ({@link SectionReleaser}), so a plan that is too old costs time, never a
 * contact.
 */
final class PlanAdopter {
  private final Map<String, TrafficRobot> robots;
  private final Claims claims;
  private final ReplanTrigger trigger;

  /**
   * @param robots all on the floor by name, as they are at any time
   */
  PlanAdopter(Map<String, TrafficRobot> robots, Claims claims, ReplanTrigger trigger) {
    this.robots = robots;
    this.claims = claims;
    this.trigger = trigger;
  }

  /** A plan and what still fits of it. */
  private final class Adoption {
    final FloorPlan plan;

    /** None of them may be on a path. */
    final BitSet newObstacles;

    final Map<String, TrafficRobot> pictured;
    final Map<String, ProposedPath> proposed;

    /** By robot whose path fits: so many of its sections it has been released meanwhile. */
    final Map<String, Integer> along = new HashMap<>();

    Adoption(FloorPlan plan, BitSet newObstacles) {
      this.plan = plan;
      this.newObstacles = newObstacles;
      pictured = HashMap.newHashMap(plan.request().robots().size());
      proposed = HashMap.newHashMap(plan.paths().size());
      plan.request().robots().forEach(robot -> pictured.put(robot.name, robot));
      plan.paths().forEach(path -> proposed.put(path.robot(), path));
    }

    TrafficRobot pictured(ProposedPath path) {
      return Objects.requireNonNull(pictured.get(path.robot()));
    }

    ProposedPath path(String robot) {
      return Objects.requireNonNull(proposed.get(robot));
    }

    /** How far the robot is along the path; below 0: it does not fit. */
    private int along(ProposedPath path) {
      TrafficRobot robot = robots.get(path.robot());
      if (robot == null || !robot.isUnchangedSince(pictured(path))) {
        return -1;
      }
      int count = robot.drive.releasedAlong(path.path(), pictured(path).drive);
      boolean isThere =
          count >= 0
              && FormationPlanner.isAtPlace(path.path().poseAfter(count), robot.releasedEnd());
      return isThere && isClear(path) ? count : -1;
    }

    private boolean isClear(ProposedPath path) {
      return newObstacles.isEmpty()
          || path.path().sections().stream().noneMatch(s -> s.cells().intersects(newObstacles));
    }
  }

  /**
   * @param obstacles those that are there now
   * @return whether all of the plan was adopted
   */
  boolean adopt(FloorPlan plan, BitSet obstacles) {
    BitSet newObstacles = new BitSet();
    if (!obstacles.equals(plan.request().obstacles().cells())) {
      newObstacles.or(obstacles);
      newObstacles.andNot(plan.request().obstacles().cells());
    }
    Adoption adoption = new Adoption(plan, newObstacles);
    adoptFindings(adoption);
    boolean isWhole = adoptShared(adoption);
    return adoptIndependent(adoption) && isWhole;
  }

  private void adoptFindings(Adoption adoption) {
    for (TrafficRobot pictured : adoption.plan.request().robots()) {
      TrafficRobot robot = robots.get(pictured.name);
      if (robot != null && Objects.equals(robot.goal(), pictured.goal())) {
        robot.waiting.adopt(Objects.requireNonNull(adoption.plan.findings().get(pictured.name)));
      }
    }
  }

  // --- paths in an order ------------------------------------------------------------------------

  private boolean adoptShared(Adoption adoption) {
    List<ProposedPath> paths =
        adoption.plan.paths().stream().filter(path -> !path.isIndependent()).toList();
    for (ProposedPath path : paths) {
      int along = adoption.along(path);
      if (along >= 0) {
        adoption.along.put(path.robot(), along);
      }
    }
    List<ProposedPath> outOfOrder =
        paths.stream().filter(path -> !isInOrder(adoption, path)).toList();
    outOfOrder.forEach(path -> adoption.along.remove(path.robot()));
    paths.stream()
        .filter(path -> path.releasedAtOnce() > 0 && !canDriveAtOnce(adoption, path))
        .forEach(path -> adoption.along.remove(path.robot()));
    paths.forEach(path -> adoptShared(adoption, path));
    return paths.stream()
        .allMatch(
            path -> adoption.along.containsKey(path.robot()) || !robots.containsKey(path.robot()));
  }

  /** Whether nobody whom the plan lets go first is left behind by one that has gone on. */
  private boolean isInOrder(Adoption adoption, ProposedPath path) {
    Integer along = adoption.along.get(path.robot());
    if (along == null || along == 0 || !path.path().isShared()) {
      return true;
    }
    int last = path.path().visitAfterSections(path.path().committed(along));
    return path.path().dependencies().subList(0, last + 1).stream()
        .flatMap(List::stream)
        .allMatch(dependency -> isOver(adoption, dependency));
  }

  private static boolean isOver(Adoption adoption, Dependency dependency) {
    Integer along = adoption.along.get(dependency.robot());
    if (along == null) {
      return true;
    }
    ReservedPath path = adoption.path(dependency.robot()).path();
    return path.visitAfterSections(path.committed(along)) > dependency.visit();
  }

  /** Whether what it is to drive to where it was planned from is still free; it is its own then. */
  private boolean canDriveAtOnce(Adoption adoption, ProposedPath path) {
    Integer along = adoption.along.get(path.robot());
    TrafficRobot robot = robots.get(path.robot());
    if (along == null || robot == null) {
      return false;
    }
    SweptArea standing = robot.areaAt(robot.releasedEnd());
    List<Section> sections =
        path.path().sections().stream().limit(path.releasedAtOnce()).skip(along).toList();
    boolean isFree =
        sections.stream().allMatch(s -> claims.tooNear(robot, standing, s.area()).isEmpty());
    if (isFree) {
      sections.forEach(s -> claims.add(robot, s.area()));
    }
    return isFree;
  }

  private void adoptShared(Adoption adoption, ProposedPath path) {
    TrafficRobot robot = robots.get(path.robot());
    if (robot == null) {
      return;
    }
    Integer along = adoption.along.get(path.robot());
    if (along == null || path.isStop()) {
      trigger.markFreed(robot);
      robot.drive.freeUncommitted();
    } else {
      robot.adopt(withDependenciesOn(adoption, path), along);
    }
  }

  /** Who stays out of the plan holds nobody up by its order. */
  private static ProposedPath withDependenciesOn(Adoption adoption, ProposedPath path) {
    return path.withPath(
        path.path()
            .withDependencies(
                path.path().dependencies().stream()
                    .map(
                        before ->
                            before.stream()
                                .filter(d -> adoption.along.containsKey(d.robot()))
                                .toList())
                    .toList()));
  }

  // --- paths of their own -----------------------------------------------------------------------

  private boolean adoptIndependent(Adoption adoption) {
    List<ProposedPath> paths =
        adoption.plan.paths().stream().filter(ProposedPath::isIndependent).toList();
    if (paths.isEmpty()) {
      return true;
    }
    List<TrafficRobot> strangers =
        robots.values().stream().filter(robot -> isStranger(adoption, robot)).toList();
    boolean all = true;
    for (ProposedPath path : paths) {
      TrafficRobot robot = robots.get(path.robot());
      if (robot == null) {
        continue;
      }
      int along = adoption.along(path);
      boolean isBefore = along >= 0 && along <= path.path().inherited();
      if (isBefore && meetsNobody(robot, path, strangers)) {
        trigger.markFreed(robot);
        robot.adopt(path, along);
        robot.waiting.setSince(path.waitsSince());
      } else {
        robot.waiting.forgetPath();
        all = false;
      }
    }
    return all;
  }

  /** Whether a robot may be, or come to be, where the plan knew nothing of. */
  private static boolean isStranger(Adoption adoption, TrafficRobot robot) {
    TrafficRobot pictured = adoption.pictured.get(robot.name);
    ProposedPath path = adoption.proposed.get(robot.name);
    if (pictured == null
        || robot.radius() != pictured.radius()
        || robot.formation() != pictured.formation()) {
      return true;
    }
    if (path != null && !path.isIndependent()) {
      return !adoption.along.containsKey(robot.name);
    }
    return robot.drive.pathNumber() != pictured.drive.pathNumber()
        || (robot.drive.path() == null
            && !FormationPlanner.isAtPlace(pictured.releasedEnd(), robot.releasedEnd()));
  }

  private static boolean meetsNobody(
      TrafficRobot robot, ProposedPath path, List<TrafficRobot> strangers) {
    SweptArea standing = robot.areaAt(robot.releasedEnd());
    return strangers.stream()
        .filter(other -> other != robot)
        .flatMap(other -> other.claimed().stream())
        .allMatch(
            area ->
                path.path().sections().stream()
                    .allMatch(s -> Clearance.isKept(standing, s.area(), area)));
  }
}
