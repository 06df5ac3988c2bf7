package org.toqa.traffic.floor;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.grid.Cell;
import org.toqa.grid.MoveRules;
import org.toqa.grid.OccupancyGrid;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.JointPlanner;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.Spacing;

/** Some of the robots on lanes of one width. */
final class LaneAttempt {
  /** So near to the middle of a narrow lane cell, metres, a robot is in it: it stopped there. */
  private static final double ON_LANE = 0.03;

  /** Of the time left, what each search may take. */
  private static final double SHARE = 0.5;

  /** So many lane cells round a robot others give up their own paths and are planned with it. */
  private static final double REACH = 6;

  private final LaneGrid lanes;
  private final double diameter;
  private final List<TrafficRobot> planned = new ArrayList<>();
  private final List<SweptArea> wanted;
  private final int[] starts;
  private final GoalAssignment goals;
  private final LanePoints points;
  private final Spacing spacing;
  private OccupiedSpace occupied;
  private RoadGraph roads;
  private final FreeSpace freeSpace;
  private final SectionFitter fitter;
  private final RightOfWay rightOfWay;
  private final Collection<TrafficRobot> robots;
  private final Claims claims;
  private final ClaimedAreas claimed;
  private Map<TrafficRobot, Cell> places = Map.of();
  private Map<TrafficRobot, List<Section>> sectionsToPlaces = Map.of();

  /**
   * @param claimed what the robots have or will need
   * @param diameter of the largest for which the lanes are, metres
   * @param everybody those too that drive paths of their own or are beside the lanes
   */
  LaneAttempt(
      FreeSpace freeSpace,
      SectionFitter fitter,
      RightOfWay rightOfWay,
      Collection<TrafficRobot> robots,
      Claims claims,
      ClaimedAreas claimed,
      double diameter,
      boolean everybody) {
    this.freeSpace = freeSpace;
    this.fitter = fitter;
    this.rightOfWay = rightOfWay;
    this.robots = robots;
    this.claims = claims;
    this.claimed = claimed;
    this.diameter = diameter;
    this.lanes = freeSpace.laneGrid(diameter);
    this.points = lanes.points(freeSpace.blocked());
    this.wanted = rightOfWay.wanted(robots, diameter);
    robots.stream().filter(robot -> isCandidate(robot, everybody)).forEach(planned::add);
    if (planned.size() > LanePlanner.MOST_WHOLE) {
      addNearby();
    }
    this.occupied = findOccupied();
    this.roads = buildRoads();
    while (!assignPlaces()) {
      occupied = findOccupied();
      roads = buildRoads();
    }
    spacing = lanes.spacing(roads);
    starts = planned.stream().mapToInt(robot -> roads.vertex(place(robot))).toArray();
    goals = new GoalAssignment(freeSpace, occupied, lanes, roads, spacing, planned, starts, wanted);
  }

  private Cell place(TrafficRobot robot) {
    Cell place = places.get(robot);
    if (place == null) {
      throw new IllegalStateException(robot.name + " has no place on the lanes.");
    }
    return place;
  }

  private boolean isCandidate(TrafficRobot robot, boolean everybody) {
    return canJoin(robot)
        && (everybody
            || robot.needsPath()
            || robot.drive.isOnSharedPath()
            || (robot.drive.path() == null && isOnLane(robot))
            || wanted.stream().anyMatch(area -> !Clearance.isKept(robot.standingArea(), area)));
  }

  private boolean canJoin(TrafficRobot robot) {
    return robot.isMovable()
        && !robot.isStalled()
        && robot.formation() == null
        && robot.radius() <= diameter / 2;
  }

  /** Those too that would meet them on paths of their own. */
  private void addNearby() {
    PointIndex ends = new PointIndex(REACH * lanes.lattice().resolution());
    Set<TrafficRobot> members = new HashSet<>(planned);
    planned.forEach(robot -> ends.add(robot.committedEnd().position()));
    for (TrafficRobot robot : robots) {
      if (canJoin(robot)
          && robot.drive.hasUncommitted()
          && !members.contains(robot)
          && robot.drive.uncommittedEnds().stream().anyMatch(ends::hasNear)) {
        planned.add(robot);
        ends.add(robot.committedEnd().position());
      }
    }
  }

  /**
   * Plans their next steps.
   *
   * @return whether anybody gets on by it
   */
  boolean planAhead(NextStepsPlanner nextSteps, Instant now, Deadline deadline) {
    RoadGraph all = freeSpace.laneRoads(diameter);
    List<Cell> goalCells = Arrays.stream(goals.shared()).mapToObj(roads::cell).toList();
    List<Cell> startCells = planned.stream().map(this::place).toList();
    List<int[]> steps =
        nextSteps.plan(
            lanes,
            all,
            roads,
            planned,
            startCells,
            goalCells,
            lanes.cellsNear(rightOfWay.way()),
            now,
            deadline);
    if (!rightOfWay.isClosed()
        && steps.stream().allMatch(places -> Arrays.equals(places, steps.getFirst()))) {
      return false;
    }
    goals.recordThere();
    rightOfWay.setPlanned(goals.reaching());
    adopt(all, lanes.spacing(all), steps);
    return true;
  }

  /** Whether it is near to the middle of a lane cell, and can go straight there. */
  private boolean isOnLane(TrafficRobot robot) {
    Pose pose = robot.committedEnd();
    OccupancyGrid lattice = lanes.lattice();
    Cell cell = lattice.cellAt(pose.position());
    if (!lattice.contains(cell)) {
      return false;
    }
    Vec2 middle = points.of(cell);
    double slack = lattice.resolution() - 2 * robot.radius() - Clearance.BETWEEN_ROBOTS;
    return pose.position().distanceTo(middle) <= Math.max(slack / 2, ON_LANE)
        && lattice.rules().metresAgainst(pose.position(), middle) <= MoveRules.SLACK
        && freeSpace.keepsMargin(pose.position(), middle, robot.radius());
  }

  /** What others have or will need. */
  private OccupiedSpace findOccupied() {
    Set<TrafficRobot> members = new HashSet<>(planned);
    List<SweptArea> others =
        robots.stream()
            .filter(robot -> !members.contains(robot))
            .flatMap(robot -> claimed.of(robot).stream())
            .toList();
    return new OccupiedSpace(freeSpace.grid(), freeSpace.blocked(), others);
  }

  private RoadGraph buildRoads() {
    return lanes.roads(occupied, planned.stream().map(TrafficRobot::committedEnd).toList());
  }

  /**
   * Gives each a lane cell to begin in; who is not in the middle of one drives there. Whoever can
   * have none is taken out.
   *
   * @return whether all have one
   */
  private boolean assignPlaces() {
    places = new HashMap<>();
    sectionsToPlaces = new HashMap<>();
    Set<Cell> taken = new HashSet<>();
    List<TrafficRobot> aside = new ArrayList<>();
    for (TrafficRobot robot : planned) {
      Cell cell = lanes.lattice().cellAt(robot.committedEnd().position());
      if (!isOnLane(robot) || roads.vertex(cell) == RoadGraph.NONE || !taken.add(cell)) {
        aside.add(robot);
      } else {
        places.put(robot, cell);
      }
    }
    List<SweptArea> swept = new ArrayList<>();
    aside.removeIf(robot -> assignPlace(robot, taken, swept));
    return !planned.removeAll(Set.copyOf(aside));
  }

  private boolean assignPlace(TrafficRobot robot, Set<Cell> taken, List<SweptArea> swept) {
    Pose from = robot.committedEnd();
    for (Cell cell : lanes.cellsAround(from.position())) {
      if (roads.vertex(cell) == RoadGraph.NONE || taken.contains(cell)) {
        continue;
      }
      List<Waypoint> middle = List.of(new Waypoint(points.of(cell), false));
      double length = lanes.lattice().resolution();
      List<Section> sections =
          fitter.fit(robot, from, middle, length, new PassingPlaces.OnlyAtEnd());
      boolean isStopped = robot.drive.released() == robot.drive.committed();
      if (isStopped
          && sections.size() == 1
          && freeSpace.keepsMargin(from.position(), points.of(cell), robot.radius())
          && DirectionCheck.isKept(lanes.lattice().rules(), from, sections)
          && canDrive(robot, from, sections.getFirst(), swept)) {
        swept.add(sections.getFirst().area());
        taken.add(cell);
        places.put(robot, cell);
        sectionsToPlaces.put(robot, sections);
        return true;
      }
    }
    return false;
  }

  private boolean canDrive(TrafficRobot robot, Pose from, Section section, List<SweptArea> swept) {
    SweptArea standing = robot.areaAt(from);
    return occupied.isFree(standing, section)
        && swept.stream().allMatch(area -> Clearance.isKept(standing, section.area(), area))
        && claims.tooNear(robot, standing, section.area()).isEmpty();
  }

  /** How many that want to go somewhere would get nowhere by this. */
  int leftOutCount() {
    long notPlanned =
        robots.stream().filter(robot -> robot.needsPath() && !places.containsKey(robot)).count();
    return goals.leftOutCount() + (int) notPlanned;
  }

  /** Of the largest for which the lanes are, metres. */
  double diameter() {
    return diameter;
  }

  int robotCount() {
    return planned.size();
  }

  /** Tells each robot who has its goal by this. */
  void recordHolders() {
    goals.recordHolders();
  }

  /** Whether one that waits would go on, or one that wants nothing make room. */
  boolean isOfUse() {
    return !wanted.isEmpty() || !isStandingStill();
  }

  /**
   * Plans for all goals at once; where there is no such plan, for that of whose turn it is.
   *
   * @return whether there is a plan
   */
  boolean planWhole(JointPlanner planner, LaneTurns turns, Instant now, Deadline deadline) {
    Optional<List<int[]>> steps = plan(planner, goals, deadline);
    if (steps.isPresent()) {
      if (leftOutCount() == 0) {
        turns.end();
      }
    } else {
      steps =
          turns
              .next(goals.byWaiting(), goals::canArrive, goals::isPassable)
              .flatMap(one -> planOnly(one, planner, turns, now, deadline));
    }
    steps.ifPresent(
        found -> {
          adopt(roads, spacing, found);
          rightOfWay.setPlanned(goals.reaching());
        });
    return steps.isPresent();
  }

  private Optional<List<int[]>> planOnly(
      TrafficRobot robot, JointPlanner planner, LaneTurns turns, Instant now, Deadline deadline) {
    Optional<List<int[]>> steps = plan(planner, goals.only(robot), deadline);
    if (steps.isPresent() && goals.canArrive(robot)) {
      turns.begin(robot, goals.makingRoom(robot), now);
    }
    return steps;
  }

  private Optional<List<int[]>> plan(JointPlanner planner, GoalAssignment to, Deadline deadline) {
    return planner.plan(roads, spacing, starts, to.assigned(), deadline.afterShare(SHARE));
  }

  /** Whether no one that waits goes on, and none that wants nothing makes room. */
  private boolean isStandingStill() {
    for (int i = 0; i < planned.size(); i++) {
      TrafficRobot robot = planned.get(i);
      if ((robot.needsPath() || robot.goal() == null) && starts[i] != goals.assigned()[i]) {
        return false;
      }
    }
    return true;
  }

  private void adopt(RoadGraph plannedOn, Spacing kept, List<int[]> steps) {
    for (TrafficRobot robot : robots) {
      if (!places.containsKey(robot) && robot.drive.isOnSharedPath()) {
        robot.drive.freeUncommitted();
      }
    }
    for (TrafficRobot robot : planned) {
      List<Section> sections = sectionsToPlaces.get(robot);
      if (sections != null) {
        robot.continueOn(ReservedPath.independent(robot.committedEnd(), sections));
        robot.drive.releaseAll();
        sections.forEach(s -> claims.add(robot, s.area()));
      }
    }
    new JointPlan(freeSpace, points, occupied, plannedOn, kept, planned, steps).adopt(fitter);
  }
}
