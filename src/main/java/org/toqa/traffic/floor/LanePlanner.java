package org.toqa.traffic.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.JointPlanner;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.Spacing;

/**
 * Plans robots together on lane cells and gives them their paths.
 *
 * <p>Tried in this order, until everybody who wants to go somewhere can: with wide lane cells, on
 * which robots of every size can be planned, then with narrower ones, those first that leave the
 * fewest out, for a while at least; first without those who drive paths of their own or are beside
 * the lanes, then with them. Who is left out is driven round. Of more than {@value #MOST_WHOLE}
 * robots only the next steps are planned ({@link NextStepsPlanner}), those included whose own paths
 * come near.
 */
final class LanePlanner {
  /** Of the time left, what each search may take. */
  private static final double SHARE = 0.5;

  /** So near to the middle of a narrow lane cell, metres, a robot is in it: it stopped there. */
  private static final double ON_LANE = 0.03;

  /** Of more robots only the next steps are planned. */
  private static final int MOST_WHOLE = 8;

  /** So many lane cells round a robot others give up their own paths and are planned with it. */
  private static final double REACH = 6;

  /**
   * For so long robots whose next steps are planned stay on lanes of one width: else they could be
   * led from the middles of wide lane cells to those of narrow ones and back, and get nowhere.
   */
  private static final Duration SAME_WIDTH = Duration.ofSeconds(20);

  private final FreeSpace freeSpace;
  private final SectionFitter fitter;
  private final JointPlanner planner;
  private final NextStepsPlanner nextSteps;
  private final RightOfWay rightOfWay;
  private final Supplier<Deadline> planningDeadline;

  /** Of the robots for which the lanes were on which next steps were planned last, metres. */
  private double keptWidth;

  private Instant widthKeptSince = Instant.MIN;

  LanePlanner(
      FreeSpace freeSpace,
      SectionFitter fitter,
      JointPlanner planner,
      NextStepsPlanner nextSteps,
      RightOfWay rightOfWay,
      Supplier<Deadline> planningDeadline) {
    this.freeSpace = freeSpace;
    this.fitter = fitter;
    this.planner = planner;
    this.nextSteps = nextSteps;
    this.rightOfWay = rightOfWay;
    this.planningDeadline = planningDeadline;
  }

  /**
   * @param claimed what the robots have or will need
   * @param mustPlan whether paths were given up that others wait for
   */
  LaneOutcome plan(
      Collection<TrafficRobot> robots,
      Claims claims,
      ClaimedAreas claimed,
      boolean mustPlan,
      boolean isStill,
      Instant now) {
    Deadline deadline = planningDeadline.get();
    rightOfWay.setPlanned(Set.of());
    List<Attempt> incomplete = new ArrayList<>();
    int fewestLeftOut = Integer.MAX_VALUE;
    for (boolean everybody : List.of(false, true)) {
      for (Attempt attempt : attempts(robots, claims, claimed, everybody, now)) {
        int leftOut = attempt.leftOutCount();
        if (everybody && !isStill && leftOut >= fewestLeftOut && fewestLeftOut > 0) {
          continue; // who is at its goal would be moved for nobody's sake
        }
        fewestLeftOut = Math.min(fewestLeftOut, leftOut);
        if (!isStill
            && (attempt.planned.size() > MOST_WHOLE || rightOfWay.isClosedTo(attempt.planned))
            && attempt.planAhead(now, deadline)) {
          keepWidth(attempt.diameter, now);
          return LaneOutcome.PLANNED_AHEAD;
        }
        if (leftOut > 0) {
          incomplete.add(attempt);
        } else {
          LaneOutcome outcome = tryPlan(attempt, mustPlan, deadline);
          if (outcome != LaneOutcome.NOT_FOUND) {
            return outcome;
          }
        }
      }
    }
    incomplete.sort(Comparator.comparingInt(Attempt::leftOutCount));
    for (Attempt attempt : incomplete) {
      LaneOutcome outcome = tryPlan(attempt, mustPlan, deadline);
      if (outcome != LaneOutcome.NOT_FOUND) {
        return outcome;
      }
    }
    return LaneOutcome.NOT_FOUND;
  }

  /**
   * On lanes of each width, up to those that leave nobody out: those that are kept first, then
   * those that leave the fewest out.
   */
  private List<Attempt> attempts(
      Collection<TrafficRobot> robots,
      Claims claims,
      ClaimedAreas claimed,
      boolean everybody,
      Instant now) {
    boolean isWidthKept = now.isBefore(widthKeptSince.plus(SAME_WIDTH));
    Comparator<Double> keptFirst = Comparator.comparing(d -> !(isWidthKept && d == keptWidth));
    List<Attempt> attempts = new ArrayList<>();
    for (double diameter : diameters(robots, everybody).stream().sorted(keptFirst).toList()) {
      Attempt attempt = new Attempt(robots, claims, claimed, diameter, everybody);
      attempts.add(attempt);
      if (attempt.leftOutCount() == 0) {
        break;
      }
    }
    attempts.sort(
        Comparator.<Attempt, Double>comparing(attempt -> attempt.diameter, keptFirst)
            .thenComparingInt(Attempt::leftOutCount));
    return attempts;
  }

  private void keepWidth(double diameter, Instant now) {
    if (diameter != keptWidth) {
      keptWidth = diameter;
      widthKeptSince = now;
    }
  }

  /** Plans for all goals at once; where there is no such plan, for whoever waits longest. */
  private LaneOutcome tryPlan(Attempt attempt, boolean mustPlan, Deadline deadline) {
    attempt.goals.recordHolders();
    if (!mustPlan && attempt.wanted.isEmpty() && attempt.isStandingStill()) {
      return LaneOutcome.NOT_NEEDED;
    }
    Optional<List<int[]>> steps =
        planner
            .plan(
                attempt.roads,
                attempt.spacing,
                attempt.starts,
                attempt.goals.assigned(),
                deadline.afterShare(SHARE))
            .or(
                () ->
                    planner.plan(
                        attempt.roads,
                        attempt.spacing,
                        attempt.starts,
                        attempt.goals.forLongestWaiting().assigned(),
                        deadline.afterShare(SHARE)));
    steps.ifPresent(
        found -> {
          attempt.adopt(attempt.roads, attempt.spacing, found);
          rightOfWay.setPlanned(attempt.goals.reaching());
        });
    return steps.isPresent() ? LaneOutcome.PLANNED : LaneOutcome.NOT_FOUND;
  }

  /** Of the robots that need a plan, or of everybody; the largest first. */
  private Set<Double> diameters(Collection<TrafficRobot> robots, boolean everybody) {
    Set<Double> diameters = new TreeSet<>(Comparator.reverseOrder());
    for (TrafficRobot robot : robots) {
      boolean needsPlan = everybody || robot.needsPath() || robot.drive.isOnSharedPath();
      if (robot.isMovable()
          && robot.formation() == null
          && needsPlan
          && LaneGrid.hasRoom(freeSpace.grid(), 2 * robot.radius())) {
        diameters.add(2 * robot.radius());
      }
    }
    return diameters;
  }

  /** Some of the robots on lanes of one width. */
  private final class Attempt {
    final LaneGrid lanes;
    final double diameter;
    final List<TrafficRobot> planned = new ArrayList<>();
    final List<SweptArea> wanted;
    final int[] starts;
    final GoalAssignment goals;
    final LanePoints points;
    final Spacing spacing;
    OccupiedSpace occupied;
    RoadGraph roads;
    private final Collection<TrafficRobot> robots;
    private final Claims claims;
    private final ClaimedAreas claimed;
    private Map<TrafficRobot, Cell> places = Map.of();
    private Map<TrafficRobot, List<Section>> sectionsToPlaces = Map.of();

    Attempt(
        Collection<TrafficRobot> robots,
        Claims claims,
        ClaimedAreas claimed,
        double diameter,
        boolean everybody) {
      this.robots = robots;
      this.claims = claims;
      this.claimed = claimed;
      this.diameter = diameter;
      this.lanes = freeSpace.laneGrid(diameter);
      this.points = lanes.points(freeSpace.blocked());
      this.wanted = rightOfWay.wanted(robots, diameter);
      robots.stream().filter(robot -> isCandidate(robot, everybody)).forEach(planned::add);
      if (planned.size() > MOST_WHOLE) {
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
      goals =
          new GoalAssignment(freeSpace, occupied, lanes, roads, spacing, planned, starts, wanted);
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
    boolean planAhead(Instant now, Deadline deadline) {
      goals.recordHolders();
      RoadGraph all = freeSpace.laneRoads(diameter);
      List<Cell> goalCells = Arrays.stream(goals.assigned()).mapToObj(roads::cell).toList();
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

    private boolean canDrive(
        TrafficRobot robot, Pose from, Section section, List<SweptArea> swept) {
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

    /** Whether no one that waits goes on, and none that wants nothing makes room. */
    boolean isStandingStill() {
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
}
