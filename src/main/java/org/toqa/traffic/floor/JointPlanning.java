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
import org.toqa.traffic.RoadGraph;

/**
 * Plans robots together on lane cells and gives them their courses.
 *
 * <p>Tried in this order, until everybody who wants to go somewhere can: with wide lane cells, on
 * which robots of every size can be planned, then with narrower ones; first without those who drive
 * ways of their own or stand aside from the lanes, then with them. Who is left out is driven round.
 */
final class JointPlanning {
  /** Of the time left, what each search may take. */
  private static final double SHARE = 0.5;

  private final Ground ground;
  private final OwnWays ways;
  private final CourseFitter fitter;
  private final JointPlanner planner;
  private final Supplier<Deadline> patience;

  JointPlanning(
      Ground ground,
      OwnWays ways,
      CourseFitter fitter,
      JointPlanner planner,
      Supplier<Deadline> patience) {
    this.ground = ground;
    this.ways = ways;
    this.fitter = fitter;
    this.planner = planner;
    this.patience = patience;
  }

  enum Outcome {
    /** All have courses by the new plan. */
    PLANNED,
    /** Those without a way can only stay, and nobody could make room: no plan would help now. */
    NOT_NEEDED,
    NOT_FOUND
  }

  /**
   * @param mustPlan whether ways were given up that others wait for
   */
  Outcome plan(Collection<Mover> movers, Holdings holdings, boolean mustPlan) {
    Deadline deadline = patience.get();
    List<Attempt> incomplete = new ArrayList<>();
    for (boolean everybody : List.of(false, true)) {
      for (double diameter : diameters(movers, everybody)) {
        Attempt attempt = new Attempt(movers, holdings, diameter, everybody);
        if (attempt.leftOut() > 0) {
          incomplete.add(attempt);
        } else {
          Outcome outcome = tried(attempt, mustPlan, deadline);
          if (outcome != Outcome.NOT_FOUND) {
            return outcome;
          }
        }
      }
    }
    incomplete.sort(Comparator.comparingInt(Attempt::leftOut));
    for (Attempt attempt : incomplete) {
      Outcome outcome = tried(attempt, mustPlan, deadline);
      if (outcome != Outcome.NOT_FOUND) {
        return outcome;
      }
    }
    return Outcome.NOT_FOUND;
  }

  /** Plans for all goals at once; where there is no such plan, for whoever waits longest. */
  private Outcome tried(Attempt attempt, boolean mustPlan, Deadline deadline) {
    if (!mustPlan && attempt.wished.isEmpty() && attempt.allStay()) {
      return Outcome.NOT_NEEDED;
    }
    Optional<List<int[]>> steps =
        planner
            .plan(attempt.roads, attempt.starts, attempt.goals.assigned(), deadline.after(SHARE))
            .or(
                () ->
                    planner.plan(
                        attempt.roads,
                        attempt.starts,
                        attempt.goals.ofLongestWaiting().assigned(),
                        deadline.after(SHARE)));
    steps.ifPresent(attempt::adopt);
    return steps.isPresent() ? Outcome.PLANNED : Outcome.NOT_FOUND;
  }

  /** Of the robots that need a plan, or of everybody; the largest first. */
  private Set<Double> diameters(Collection<Mover> movers, boolean everybody) {
    Set<Double> diameters = new TreeSet<>(Comparator.reverseOrder());
    for (Mover m : movers) {
      boolean needsPlan = everybody || m.isUnserved() || m.isOnSharedWay();
      if (m.movable && m.group() == null && needsPlan && Lanes.fit(ground.grid(), 2 * m.radius)) {
        diameters.add(2 * m.radius);
      }
    }
    return diameters;
  }

  /** Some of the robots on lanes of one width. */
  private final class Attempt {
    final Lanes lanes;
    final double diameter;
    final List<Mover> planned = new ArrayList<>();
    final BitSet wished;
    final int[] starts;
    final Goals goals;
    BitSet closed = new BitSet();
    RoadGraph roads;
    private final Collection<Mover> movers;
    private final Holdings holdings;
    private Map<Mover, Cell> places = Map.of();
    private Map<Mover, List<Stretch>> toPlaces = Map.of();

    Attempt(Collection<Mover> movers, Holdings holdings, double diameter, boolean everybody) {
      this.movers = movers;
      this.holdings = holdings;
      this.diameter = diameter;
      this.lanes = ground.lanes(diameter);
      this.wished = wishes();
      movers.stream().filter(m -> isCandidate(m, everybody)).forEach(planned::add);
      this.roads = close();
      while (!findPlaces()) {
        roads = close();
      }
      starts = planned.stream().mapToInt(m -> roads.vertex(place(m))).toArray();
      goals = new Goals(ground, closed, lanes, roads, planned, starts, wished);
    }

    private Cell place(Mover m) {
      Cell place = places.get(m);
      if (place == null) {
        throw new IllegalStateException(m.name + " has no place on the lanes.");
      }
      return place;
    }

    private boolean isCandidate(Mover m, boolean everybody) {
      if (!m.movable || m.stalled || m.group() != null || m.radius > diameter / 2) {
        return false;
      }
      return everybody
          || m.isUnserved()
          || m.isOnSharedWay()
          || (m.course == null && isOnLane(m, ground.closed()))
          || m.standing().intersects(wished);
    }

    /** Whether its disc keeps to one lane cell, and can go straight to the middle of that. */
    private boolean isOnLane(Mover m, BitSet shut) {
      Pose pose = m.releasedEnd();
      Cell cell = lanes.lattice().cellAt(pose.position());
      Vec2 aside = pose.position().minus(lanes.lattice().centre(cell));
      double play = lanes.lattice().resolution() / 2 - m.radius + 1e-9;
      return lanes.lattice().contains(cell)
          && Math.max(Math.abs(aside.x()), Math.abs(aside.y())) <= play
          && !SweptCells.straight(
                  ground.grid(), pose.position(), lanes.lattice().centre(cell), m.radius)
              .intersects(shut);
    }

    /** Closes what others have or will need. */
    private RoadGraph close() {
      closed = (BitSet) ground.closed().clone();
      for (Mover m : movers) {
        if (!planned.contains(m)) {
          m.addClaimedTo(closed);
        }
      }
      planned.forEach(
          m ->
              SweptCells.standing(ground.grid(), m.releasedEnd().position(), m.radius)
                  .forEach(closed::clear));
      return lanes.roads(closed);
    }

    /**
     * Gives each a lane cell to begin in; who stands aside drives to the middle of one. Whoever can
     * have none is taken out.
     *
     * @return whether all have one
     */
    private boolean findPlaces() {
      places = new HashMap<>();
      toPlaces = new HashMap<>();
      List<Mover> aside = new ArrayList<>();
      for (Mover m : planned) {
        Cell cell = lanes.lattice().cellAt(m.releasedEnd().position());
        if (!isOnLane(m, closed)
            || roads.vertex(cell) == RoadGraph.NONE
            || places.containsValue(cell)) {
          aside.add(m);
        } else {
          places.put(m, cell);
        }
      }
      BitSet swept = new BitSet();
      boolean all = true;
      for (Mover m : aside) {
        if (!findPlace(m, swept)) {
          planned.remove(m);
          all = false;
        }
      }
      return all;
    }

    private boolean findPlace(Mover m, BitSet swept) {
      Pose from = m.releasedEnd();
      for (Cell cell : lanes.near(from.position())) {
        if (roads.vertex(cell) == RoadGraph.NONE || places.containsValue(cell)) {
          continue;
        }
        List<Waypoint> middle = List.of(new Waypoint(lanes.lattice().centre(cell), false));
        double length = lanes.lattice().resolution();
        List<Stretch> way = fitter.fit(m, from, middle, length, new Halts.AtTheEnd());
        if (way.size() == 1 && mayDrive(m, from, way.getFirst(), swept)) {
          way.getFirst().cells().addTo(swept);
          places.put(m, cell);
          toPlaces.put(m, way);
          return true;
        }
      }
      return false;
    }

    private boolean mayDrive(Mover m, Pose from, Stretch stretch, BitSet swept) {
      BitSet shut = (BitSet) closed.clone();
      m.standing().forEach(shut::clear);
      return !stretch.cells().intersects(shut)
          && !stretch.cells().intersects(swept)
          && holdings.others(m, stretch.cells()).stream()
              .allMatch(o -> !m.isDriving() && Clearance.isKept(m, from, stretch, o));
    }

    /** How many that want to go somewhere would get nowhere by this. */
    int leftOut() {
      long notPlanned = movers.stream().filter(m -> m.isUnserved() && !planned.contains(m)).count();
      return goals.unreachable() + (int) notPlanned;
    }

    /** Whether no one that waits goes on, and none that wants nothing makes room. */
    boolean allStay() {
      for (int i = 0; i < planned.size(); i++) {
        Mover m = planned.get(i);
        if ((m.isUnserved() || m.goal == null) && starts[i] != goals.assigned()[i]) {
          return false;
        }
      }
      return true;
    }

    /** The ways of robots that are too large for these lanes, as if the others were not there. */
    private BitSet wishes() {
      BitSet wished = new BitSet();
      for (Mover m : movers) {
        boolean isTooLarge = m.group() != null || m.radius > diameter / 2;
        if (m.isUnserved() && m.course == null && isTooLarge) {
          m.wish = new BitSet();
          ways.alone(m).ifPresent(way -> way.forEach(s -> s.cells().addTo(m.wish)));
          wished.or(m.wish);
        }
      }
      return wished;
    }

    void adopt(List<int[]> steps) {
      for (Mover m : movers) {
        if (!planned.contains(m) && m.isOnSharedWay()) {
          m.cut();
        }
      }
      for (Mover m : planned) {
        List<Stretch> way = toPlaces.get(m);
        if (way != null) {
          m.take(Course.meetingNobody(m.releasedEnd(), way));
          m.released += way.size();
          way.forEach(s -> holdings.add(m, s.cells()));
        }
      }
      new JointPlan(lanes, closed, roads, planned, steps).adopt(fitter);
    }
  }
}
