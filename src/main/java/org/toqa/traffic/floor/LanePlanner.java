package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
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
import org.toqa.traffic.Deadline;
import org.toqa.traffic.JointPlanner;
import org.toqa.traffic.RoadGraph;

/**
 * Plans robots together on lane cells and gives them their paths.
 *
 * <p>Tried in this order, until everybody who wants to go somewhere can: with wide lane cells, on
 * which robots of every size can be planned, then with narrower ones; first without those who drive
 * paths of their own or are beside the lanes, then with them. Who is left out is driven round.
 */
final class LanePlanner {
  /** Of the time left, what each search may take. */
  private static final double SHARE = 0.5;

  private final FreeSpace freeSpace;
  private final SingleRobotPlanner singleRobotPlanner;
  private final SectionFitter fitter;
  private final JointPlanner planner;
  private final Supplier<Deadline> planningDeadline;

  LanePlanner(
      FreeSpace freeSpace,
      SingleRobotPlanner singleRobotPlanner,
      SectionFitter fitter,
      JointPlanner planner,
      Supplier<Deadline> planningDeadline) {
    this.freeSpace = freeSpace;
    this.singleRobotPlanner = singleRobotPlanner;
    this.fitter = fitter;
    this.planner = planner;
    this.planningDeadline = planningDeadline;
  }

  enum Outcome {
    /** All have paths by the new plan. */
    PLANNED,
    /** Those without a path can only stay, and nobody could make room: no plan would help now. */
    NOT_NEEDED,
    NOT_FOUND
  }

  /**
   * @param mustPlan whether paths were given up that others wait for
   */
  Outcome plan(Collection<TrafficRobot> robots, CellAllocations allocations, boolean mustPlan) {
    Deadline deadline = planningDeadline.get();
    List<Attempt> incomplete = new ArrayList<>();
    for (boolean everybody : List.of(false, true)) {
      for (double diameter : diameters(robots, everybody)) {
        Attempt attempt = new Attempt(robots, allocations, diameter, everybody);
        if (attempt.leftOutCount() > 0) {
          incomplete.add(attempt);
        } else {
          Outcome outcome = tryPlan(attempt, mustPlan, deadline);
          if (outcome != Outcome.NOT_FOUND) {
            return outcome;
          }
        }
      }
    }
    incomplete.sort(Comparator.comparingInt(Attempt::leftOutCount));
    for (Attempt attempt : incomplete) {
      Outcome outcome = tryPlan(attempt, mustPlan, deadline);
      if (outcome != Outcome.NOT_FOUND) {
        return outcome;
      }
    }
    return Outcome.NOT_FOUND;
  }

  /** Plans for all goals at once; where there is no such plan, for whoever waits longest. */
  private Outcome tryPlan(Attempt attempt, boolean mustPlan, Deadline deadline) {
    if (!mustPlan && attempt.wantedCells.isEmpty() && attempt.isStandingStill()) {
      return Outcome.NOT_NEEDED;
    }
    Optional<List<int[]>> steps =
        planner
            .plan(
                attempt.roads, attempt.starts, attempt.goals.assigned(), deadline.afterShare(SHARE))
            .or(
                () ->
                    planner.plan(
                        attempt.roads,
                        attempt.starts,
                        attempt.goals.forLongestWaiting().assigned(),
                        deadline.afterShare(SHARE)));
    steps.ifPresent(attempt::adopt);
    return steps.isPresent() ? Outcome.PLANNED : Outcome.NOT_FOUND;
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
    final BitSet wantedCells;
    final int[] starts;
    final GoalAssignment goals;
    BitSet blocked = new BitSet();
    RoadGraph roads;
    private final Collection<TrafficRobot> robots;
    private final CellAllocations allocations;
    private Map<TrafficRobot, Cell> places = Map.of();
    private Map<TrafficRobot, List<Section>> sectionsToPlaces = Map.of();

    Attempt(
        Collection<TrafficRobot> robots,
        CellAllocations allocations,
        double diameter,
        boolean everybody) {
      this.robots = robots;
      this.allocations = allocations;
      this.diameter = diameter;
      this.lanes = freeSpace.laneGrid(diameter);
      this.wantedCells = findWantedCells();
      robots.stream().filter(robot -> isCandidate(robot, everybody)).forEach(planned::add);
      this.roads = buildRoads();
      while (!assignPlaces()) {
        roads = buildRoads();
      }
      starts = planned.stream().mapToInt(robot -> roads.vertex(place(robot))).toArray();
      goals = new GoalAssignment(freeSpace, blocked, lanes, roads, planned, starts, wantedCells);
    }

    private Cell place(TrafficRobot robot) {
      Cell place = places.get(robot);
      if (place == null) {
        throw new IllegalStateException(robot.name + " has no place on the lanes.");
      }
      return place;
    }

    private boolean isCandidate(TrafficRobot robot, boolean everybody) {
      if (!robot.isMovable()
          || robot.isStalled()
          || robot.formation() != null
          || robot.radius() > diameter / 2) {
        return false;
      }
      return everybody
          || robot.needsPath()
          || robot.drive.isOnSharedPath()
          || (robot.drive.path() == null && isOnLane(robot, freeSpace.blocked()))
          || robot.standingCells().intersects(wantedCells);
    }

    /** Whether its disc keeps to one lane cell, and can go straight to the middle of that. */
    private boolean isOnLane(TrafficRobot robot, BitSet blockedCells) {
      Pose pose = robot.releasedEnd();
      Cell cell = lanes.lattice().cellAt(pose.position());
      Vec2 aside = pose.position().minus(lanes.lattice().centre(cell));
      double slack = lanes.lattice().resolution() / 2 - robot.radius() + 1e-9;
      return lanes.lattice().contains(cell)
          && Math.max(Math.abs(aside.x()), Math.abs(aside.y())) <= slack
          && !SweptCells.alongLine(
                  freeSpace.grid(), pose.position(), lanes.lattice().centre(cell), robot.radius())
              .intersects(blockedCells);
    }

    /** Closes what others have or will need. */
    private RoadGraph buildRoads() {
      blocked = (BitSet) freeSpace.blocked().clone();
      for (TrafficRobot robot : robots) {
        if (!planned.contains(robot)) {
          robot.addClaimedTo(blocked);
        }
      }
      planned.forEach(
          robot ->
              SweptCells.at(freeSpace.grid(), robot.releasedEnd().position(), robot.radius())
                  .forEach(blocked::clear));
      return lanes.roads(blocked);
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
      List<TrafficRobot> aside = new ArrayList<>();
      for (TrafficRobot robot : planned) {
        Cell cell = lanes.lattice().cellAt(robot.releasedEnd().position());
        if (!isOnLane(robot, blocked)
            || roads.vertex(cell) == RoadGraph.NONE
            || places.containsValue(cell)) {
          aside.add(robot);
        } else {
          places.put(robot, cell);
        }
      }
      BitSet swept = new BitSet();
      boolean all = true;
      for (TrafficRobot robot : aside) {
        if (!assignPlace(robot, swept)) {
          planned.remove(robot);
          all = false;
        }
      }
      return all;
    }

    private boolean assignPlace(TrafficRobot robot, BitSet swept) {
      Pose from = robot.releasedEnd();
      for (Cell cell : lanes.cellsAround(from.position())) {
        if (roads.vertex(cell) == RoadGraph.NONE || places.containsValue(cell)) {
          continue;
        }
        List<Waypoint> middle = List.of(new Waypoint(lanes.lattice().centre(cell), false));
        double length = lanes.lattice().resolution();
        List<Section> sections =
            fitter.fit(robot, from, middle, length, new PassingPlaces.OnlyAtEnd());
        if (sections.size() == 1 && canDrive(robot, from, sections.getFirst(), swept)) {
          sections.getFirst().cells().addTo(swept);
          places.put(robot, cell);
          sectionsToPlaces.put(robot, sections);
          return true;
        }
      }
      return false;
    }

    private boolean canDrive(TrafficRobot robot, Pose from, Section section, BitSet swept) {
      BitSet blockedCells = (BitSet) blocked.clone();
      robot.standingCells().forEach(blockedCells::clear);
      return !section.cells().intersects(blockedCells)
          && !section.cells().intersects(swept)
          && allocations.otherHolders(robot, section.cells()).stream()
              .allMatch(o -> !robot.drive.isDriving() && Clearance.isKept(robot, from, section, o));
    }

    /** How many that want to go somewhere would get nowhere by this. */
    int leftOutCount() {
      long notPlanned =
          robots.stream().filter(robot -> robot.needsPath() && !planned.contains(robot)).count();
      return goals.unreachableCount() + (int) notPlanned;
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

    /** The paths of robots that are too large for these lanes, as if the others were not there. */
    private BitSet findWantedCells() {
      BitSet wanted = new BitSet();
      for (TrafficRobot robot : robots) {
        boolean isTooLarge = robot.formation() != null || robot.radius() > diameter / 2;
        if (robot.needsPath() && robot.drive.path() == null && isTooLarge) {
          robot.waiting.setWanted(singleRobotPlanner.pathAlone(robot).orElse(List.of()));
          wanted.or(robot.waiting.wantedCells());
        }
      }
      return wanted;
    }

    void adopt(List<int[]> steps) {
      for (TrafficRobot robot : robots) {
        if (!planned.contains(robot) && robot.drive.isOnSharedPath()) {
          robot.freeUnreleased();
        }
      }
      for (TrafficRobot robot : planned) {
        List<Section> sections = sectionsToPlaces.get(robot);
        if (sections != null) {
          robot.continueOn(ReservedPath.independent(robot.releasedEnd(), sections));
          robot.drive.releaseAll();
          sections.forEach(s -> allocations.allocate(robot, s.cells()));
        }
      }
      new JointPlan(lanes, blocked, roads, planned, steps).adopt(fitter);
    }
  }
}
