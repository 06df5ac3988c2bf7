package org.toqa.traffic.floor;

import static java.util.Comparator.comparing;
import static java.util.Comparator.nullsLast;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.grid.Cell;
import org.toqa.grid.Inflation;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DriveSpeeds;
import org.toqa.planning.HeadingAStar;
import org.toqa.planning.PathPlanner;
import org.toqa.planning.PlanResult;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.floor.Course.Wait;

/**
 * Who may drive where on one floor, and in which order.
 *
 * <p>A robot that wants to go somewhere is first offered its own smooth way: the shortest one in
 * eight headings round whoever stands. It gets it if the cells that it sweeps meet nobody else's,
 * now or later; such ways need no order. Otherwise all robots are planned together from where their
 * released ways end ({@link JointPlanner}), those that want nothing too, so that they step aside;
 * the plan's order of visits to each cell is then kept ({@link JointPlan}).
 *
 * <p>Ways are released stretch by stretch. A stretch is released when no other robot holds a cell
 * of it and whoever comes before has left; what is released is driven to its end whatever others
 * do, and a robot can stand there. So a robot never enters what another has not left, however late
 * anyone is, and since the order has no cycle somebody can always go on.
 *
 * <p>Confined to one thread. It knows no clock: time is handed in.
 *
 * <ol>
 *   <li>Tell it what is so: {@link #stands}, {@link #moved}, {@link #wants}, {@link #isFixed}.
 *   <li>Ask {@link #decide} what robots are to be told, in that order.
 * </ol>
 */
public final class FloorTraffic {
  private static final Duration STALLED_AFTER = Duration.ofSeconds(10);
  private static final Duration BREAK_AFTER = Duration.ofMillis(500);
  private static final Duration PLAN_AGAIN_AFTER = Duration.ofSeconds(5);

  /** A robot that waits for its place this many cells from it is near enough. */
  private static final int NEAR = 4;

  /** Released ahead of a robot: at least so many stretches, and so many seconds of driving. */
  private static final int STRETCHES_AHEAD = 2;

  private static final double SECONDS_AHEAD = 3;

  private final OccupancyGrid grid;
  private final CourseFitter fitter;
  private final PathPlanner planner = new HeadingAStar();
  private final JointPlanner joint;
  private final Supplier<Deadline> patience;
  final Map<String, Mover> movers = new TreeMap<>();
  private final Map<Double, OccupancyGrid> inflated = new HashMap<>();

  /** Cells where something stands that the map does not show. */
  private BitSet obstructed = new BitSet();

  /** Whether something changed since the robots were last planned together. */
  private boolean changed = true;

  /** Whether a robot gave up a part of its way that others wait for it to drive. */
  private boolean broken;

  /** When any robot last completed a stretch. */
  private Instant lastProgress = Instant.MIN;

  private Instant plannedTogether = Instant.MIN;

  /**
   * @param patience how long a plan for all robots may take
   */
  public FloorTraffic(
      OccupancyGrid grid, DriveSpeeds speeds, JointPlanner joint, Supplier<Deadline> patience) {
    this.grid = grid;
    this.fitter = new CourseFitter(grid, speeds);
    this.joint = joint;
    this.patience = patience;
  }

  // --- what is so -------------------------------------------------------------------------------

  /** The robot stands at a pose and has no way; it may be new here. */
  public void stands(String robot, Pose pose, double footprint, Instant now) {
    Mover m =
        movers.computeIfAbsent(robot, name -> new Mover(name, grid, pose, footprint / 2, now));
    broken |= m.hasUnreleased();
    if (m.course != null || !grid.cellAt(m.pose.position()).equals(grid.cellAt(pose.position()))) {
      changed = true;
    }
    m.pose = pose;
    m.radius = footprint / 2;
    m.course = null;
    m.isCutUntold = false;
    m.done = 0;
    m.released = 0;
  }

  /**
   * The robot is on the way that it was told.
   *
   * @param segments so many are completed
   */
  public void moved(String robot, Pose pose, int segments, Instant now) {
    Mover m = mover(robot);
    m.pose = pose;
    Course course = m.course;
    if (course != null) {
      int done = Math.min(course.stretchesOf(segments), m.released);
      if (done > m.done) {
        m.done = done;
        m.lastProgress = now;
        lastProgress = now;
        changed |= done == course.size();
      }
    }
  }

  /**
   * The robot is known to drive a way that this traffic did not give it, as after a restart.
   *
   * @param way all of which up to {@code released} segments it may drive; the rest is forgotten
   */
  public void drives(
      String robot,
      Pose pose,
      double footprint,
      org.toqa.motion.Trajectory way,
      int segments,
      int released,
      Instant now) {
    stands(robot, pose, footprint, now);
    Mover m = mover(robot);
    List<Stretch> stretches = new ArrayList<>();
    Pose at = way.start();
    for (var segment : way.segments().subList(0, Math.min(released, way.segments().size()))) {
      BitSet cells = SweptCells.of(grid, at, segment, m.radius);
      at = at.advanced(segment.twist(), segment.t());
      stretches.add(
          new Stretch(
              List.of(segment), at, cells, SweptCells.standing(grid, at.position(), m.radius)));
    }
    m.take(Course.meetingNobody(way.start(), stretches));
    m.released = stretches.size();
    m.done = Math.min(segments, stretches.size());
    m.isCutUntold = true;
    m.lastProgress = now;
  }

  /**
   * @param goal null: it wants nothing, and may be asked to step aside
   */
  public void wants(String robot, @Nullable Vec2 goal, Instant now) {
    Mover m = mover(robot);
    if (!Objects.equals(m.goal, goal)) {
      m.goal = goal;
      m.wish = new BitSet();
      m.waitingSince = goal == null ? null : now;
      m.reason = null;
      changed = true;
    }
  }

  /** Whether it cannot be told to move: lost, held, or not sure where it is. */
  public void isFixed(String robot, boolean fixed) {
    Mover m = mover(robot);
    if (m.movable == fixed) {
      m.movable = !fixed;
      changed = true;
      if (fixed) {
        giveUpTheRest(m);
      }
    }
  }

  /**
   * Something stands where the map shows nothing: robots go round, and ways that are not released
   * are given up where they meet it.
   *
   * @param cells all that are obstructed now, as bits by {@link OccupancyGrid#index}; instead of
   *     those told before
   */
  public void isObstructed(BitSet cells) {
    if (!cells.equals(obstructed)) {
      obstructed = (BitSet) cells.clone();
      changed = true;
    }
  }

  public void leaves(String robot) {
    broken |= mover(robot).hasUnreleased();
    movers.remove(robot);
    changed = true;
  }

  public boolean knows(String robot) {
    return movers.containsKey(robot);
  }

  private Mover mover(String robot) {
    Mover m = movers.get(robot);
    if (m == null) {
      throw new IllegalArgumentException("There is no robot " + robot + " on this floor.");
    }
    return m;
  }

  // --- what can be read -------------------------------------------------------------------------

  /** Whether the robot stands in the cell it wants. */
  public boolean isAtGoal(String robot) {
    return mover(robot).isAtGoal();
  }

  /** Why it does not go on, for people; null while it does. */
  public @Nullable String reason(String robot) {
    Mover m = mover(robot);
    return m.isDriving() || m.reason != null ? m.reason : m.obstruction;
  }

  /** The cells that are its own now, as bits by {@link OccupancyGrid#index}. */
  public BitSet held(String robot) {
    return mover(robot).held();
  }

  /** Robots that do not get on as they should, each in one of these at most. */
  public List<Standstill> standstills() {
    return List.of();
  }

  /** The rest of its way. */
  public Route route(String robot) {
    Mover m = mover(robot);
    return m.course == null ? Route.NONE : Route.of(m.course, m.done, m.released, m.pose);
  }

  // --- decisions --------------------------------------------------------------------------------

  /** Plans for whoever needs a way, and releases what can be. */
  public List<Decision> decide(Instant now) {
    Told told = new Told();
    watchForStalls(now);
    planEachAlone(now, told);
    if (isStandstill(now)) {
      broken = true;
    }
    if ((broken || movers.values().stream().anyMatch(Mover::isUnserved))
        && (changed || plannedTogether.plus(PLAN_AGAIN_AFTER).isBefore(now))) {
      plannedTogether = now;
      changed = false;
      planTogether(told);
    }
    for (Mover m : movers.values()) {
      release(m, now, told);
    }
    return told.decisions();
  }

  /** Gathers what changed for each robot, and says it in as few words as possible. */
  private final class Told {
    private final Map<String, Integer> releasedBefore = new HashMap<>();
    private final Map<String, Integer> redrivenFrom = new TreeMap<>();
    private final Set<String> begun = new HashSet<>();

    Told() {
      movers.values().forEach(m -> releasedBefore.put(m.name, m.released));
    }

    /** From its released part on, the robot has another way than before. */
    void redriven(Mover m, boolean stood) {
      if (stood) {
        begun.add(m.name);
      } else {
        redrivenFrom.putIfAbsent(m.name, m.released);
      }
    }

    List<Decision> decisions() {
      List<Decision> decisions = new ArrayList<>();
      for (Mover m : movers.values()) {
        Course course = m.course;
        if (course == null || !m.movable) {
          continue;
        }
        int released = course.segmentsOf(m.released);
        Integer from = redrivenFrom.get(m.name);
        if (from == null && m.isCutUntold) {
          from = m.released;
        }
        m.isCutUntold = false;
        if (begun.contains(m.name)) {
          decisions.add(new Decision.Begin(m.name, course.trajectory(), released, endsAtGoal(m)));
        } else if (from != null) {
          decisions.add(
              new Decision.Extend(
                  m.name,
                  course.segmentsOf(from),
                  course.segmentsFrom(from),
                  released,
                  endsAtGoal(m)));
        } else if (m.released > releasedBefore.getOrDefault(m.name, 0)) {
          decisions.add(new Decision.Release(m.name, released));
        }
      }
      return decisions;
    }
  }

  private void giveUpTheRest(Mover m) {
    broken |= m.hasUnreleased();
    m.cut();
  }

  /** Whether robots have ways and none has got on for long: that must not be, so plan anew. */
  private boolean isStandstill(Instant now) {
    return lastProgress.plus(STALLED_AFTER).isBefore(now)
        && movers.values().stream().anyMatch(Mover::hasUnreleased)
        && movers.values().stream().noneMatch(m -> m.isDriving() && !m.stalled);
  }

  private boolean endsAtGoal(Mover m) {
    Course course = m.course;
    return course != null
        && (m.goal == null || grid.cellAt(course.end().position()).equals(m.goalCell()));
  }

  private void watchForStalls(Instant now) {
    for (Mover m : movers.values()) {
      Course course = m.course;
      if (course == null || !m.isDriving()) {
        m.lastProgress = now;
        if (m.stalled) {
          m.stalled = false;
          changed = true;
        }
        continue;
      }
      double planned = course.stretches().get(m.done).duration();
      Duration patient = STALLED_AFTER.plusMillis((long) (3000 * planned));
      boolean stalled = m.lastProgress.plus(patient).isBefore(now);
      if (stalled != m.stalled) {
        m.stalled = stalled;
        changed = true;
        if (stalled) {
          giveUpTheRest(m);
        }
      }
    }
  }

  // --- alone ------------------------------------------------------------------------------------

  private void planEachAlone(Instant now, Told told) {
    List<Mover> unserved =
        movers.values().stream()
            .filter(Mover::isUnserved)
            .filter(m -> m.course == null || m.done == m.released)
            .sorted(comparing(m -> m.waitingSince, nullsLast(Comparator.<Instant>naturalOrder())))
            .toList();
    for (Mover m : unserved) {
      if (m.waitingSince == null) {
        m.waitingSince = now;
      }
      if (!changed && m.triedAlone) {
        continue;
      }
      m.triedAlone = true;
      smooth(m)
          .ifPresent(
              stretches -> {
                boolean stood = m.course == null;
                m.take(Course.meetingNobody(m.releasedEnd(), stretches));
                m.reason = null;
                m.waitingSince = null;
                m.wish = new BitSet();
                told.redriven(m, stood);
              });
    }
  }

  /** Its own shortest way round whoever stands, if that meets nobody's cells. */
  private Optional<List<Stretch>> smooth(Mover m) {
    Cell goal = m.goalCell();
    if (goal == null) {
      return Optional.empty();
    }
    BitSet claimed = claimedByOthers(m);
    OccupancyGrid free = blocked(clear(m.radius), claimed, m.radius, m.releasedCell());
    if (!(planner.plan(free, m.releasedCell(), goal) instanceof PlanResult.Found(var path))) {
      return Optional.empty();
    }
    List<Waypoint> way = path.waypoints(grid);
    List<Stretch> stretches = fitter.fit(m.releasedEnd(), way, m.radius);
    boolean isAlone = stretches.stream().noneMatch(s -> s.cells().intersects(claimed));
    boolean isClear = stretches.stream().allMatch(s -> isOffTheWalls(s.cells()));
    return isAlone && isClear ? Optional.of(stretches) : Optional.empty();
  }

  private boolean isOffTheWalls(BitSet cells) {
    return !cells.intersects(walls());
  }

  private @Nullable BitSet walls;

  private BitSet walls() {
    BitSet known = walls;
    if (known == null) {
      known = grid.occupied();
      walls = known;
    }
    return known;
  }

  private BitSet claimedByOthers(Mover m) {
    BitSet claimed = new BitSet();
    for (Mover other : movers.values()) {
      if (other != m) {
        claimed.or(other.claimed());
        if (waitsLonger(other, m)) {
          claimed.or(other.wish);
        }
      }
    }
    return claimed;
  }

  private static boolean waitsLonger(Mover other, Mover m) {
    return other.waitingSince != null
        && (m.waitingSince == null || other.waitingSince.isBefore(m.waitingSince));
  }

  private OccupancyGrid clear(double radius) {
    return inflated.computeIfAbsent(radius, r -> Inflation.of(grid, r));
  }

  /** Blocks the cells too, with the robot's margin round them; not the one where it stands. */
  private OccupancyGrid blocked(OccupancyGrid clear, BitSet cells, double radius, Cell standing) {
    if (cells.isEmpty()) {
      return clear;
    }
    BitSet all = grid.occupied();
    all.or(cells);
    BitSet grown = Inflation.of(grid.withOccupied(all), radius).occupied();
    grown.or(clear.occupied());
    grown.clear(grid.index(standing));
    return grid.withOccupied(grown);
  }

  // --- together ---------------------------------------------------------------------------------

  private void planTogether(Told told) {
    List<Mover> planned = movers.values().stream().filter(this::canBePlanned).toList();
    BitSet closed = grid.occupied();
    for (Mover m : movers.values()) {
      if (!planned.contains(m)) {
        closed.or(m.claimed());
      }
    }
    planned.forEach(m -> closed.clear(grid.index(m.releasedCell())));
    planned.forEach(m -> centre(m, told));
    RoadGraph roads = new RoadGraph(grid.withOccupied(closed));
    int[] starts = planned.stream().mapToInt(m -> roads.vertex(m.releasedCell())).toArray();
    BitSet wished = wishes(planned);
    int[] goals = new Goals(roads, planned, starts, wished).assigned();
    if (!broken && wished.isEmpty() && allWaitersStay(planned, starts, goals)) {
      return;
    }
    Optional<List<int[]>> steps = joint.plan(roads, starts, goals, patience.get());
    if (steps.isEmpty()) {
      planned.stream()
          .filter(Mover::isUnserved)
          .forEach(m -> m.reason = "Waits: no way was found yet that clears all robots' ways.");
      return;
    }
    broken = false;
    Map<Mover, Boolean> stood = new HashMap<>();
    planned.forEach(m -> stood.put(m, m.course == null));
    new JointPlan(grid, roads, planned, steps.get()).adopt(fitter);
    for (Mover m : planned) {
      if (m.course != null) {
        told.redriven(m, Boolean.TRUE.equals(stood.get(m)));
      }
      if (endsAtGoal(m)) {
        m.reason = null;
        m.waitingSince = null;
      }
    }
  }

  /**
   * A plan knows cells only, so a robot that was stopped between two of them first goes to the
   * middle of its own. It needs no leave for that: it sweeps no cell but those that it is in.
   */
  private void centre(Mover m, Told told) {
    Pose from = m.releasedEnd();
    if (SweptCells.standing(grid, from.position(), m.radius).cardinality() <= 1) {
      return;
    }
    List<Waypoint> middle = List.of(new Waypoint(grid.centre(m.releasedCell()), false));
    told.redriven(m, m.course == null);
    m.take(Course.meetingNobody(from, fitter.fit(from, middle, m.radius)));
    m.released = Objects.requireNonNull(m.course).size();
  }

  /** Whether those without a way can only wait, and the others drive: no plan would help now. */
  private static boolean allWaitersStay(List<Mover> planned, int[] starts, int[] goals) {
    for (int i = 0; i < planned.size(); i++) {
      Mover m = planned.get(i);
      if (m.isUnserved() && starts[i] != goals[i]) {
        return false;
      }
    }
    return true;
  }

  /** The ways of robots that are too large to be planned with the others, as if these were not. */
  private BitSet wishes(List<Mover> planned) {
    BitSet wished = new BitSet();
    for (Mover m : movers.values()) {
      Cell goal = m.goalCell();
      if (planned.contains(m) || !m.isUnserved() || m.course != null || goal == null) {
        continue;
      }
      m.wish = new BitSet();
      if (planner.plan(clear(m.radius), m.releasedCell(), goal)
          instanceof PlanResult.Found(var path)) {
        fitter.fit(m.pose, path.waypoints(grid), m.radius).forEach(s -> m.wish.or(s.cells()));
        m.reason = "Waits for room on its way.";
        wished.or(m.wish);
      } else {
        m.reason = "Waits: there is no way to its goal that is wide enough.";
      }
    }
    return wished;
  }

  /** A robot that fits a cell, can be told to move, and does not share its cell. */
  private boolean canBePlanned(Mover m) {
    return m.movable && !m.stalled && m.radius <= grid.resolution() / 2 && isOnFreeCell(m);
  }

  private boolean isOnFreeCell(Mover m) {
    return grid.isFree(m.releasedCell())
        && movers.values().stream()
            .noneMatch(o -> o != m && o.releasedCell().equals(m.releasedCell()));
  }

  /**
   * A goal for each robot, all different: its own if it can have it, else a place near to it; and
   * for a robot that wants nothing the place where it stands, unless another wants that. Whoever
   * has a place or a way to it keeps it, then whoever waits longest chooses.
   */
  private final class Goals {
    private final RoadGraph roads;
    private final List<Mover> planned;
    private final int[] starts;
    private final int[] assigned;
    private final Map<Integer, String> taken = new HashMap<>();
    private final BitSet wished;

    /**
     * @param wished cells where nobody shall stay
     */
    Goals(RoadGraph roads, List<Mover> planned, int[] starts, BitSet wished) {
      this.roads = roads;
      this.planned = planned;
      this.starts = starts;
      this.assigned = new int[planned.size()];
      this.wished = wished;
    }

    int[] assigned() {
      List<Integer> order = new ArrayList<>();
      for (int i = 0; i < planned.size(); i++) {
        order.add(i);
      }
      order.sort(
          Comparator.<Integer, Boolean>comparing(i -> planned.get(i).goal == null)
              .thenComparing(i -> planned.get(i).isUnserved())
              .thenComparing(
                  i -> planned.get(i).waitingSince, nullsLast(Comparator.<Instant>naturalOrder())));
      for (int i : order) {
        assigned[i] = goal(i);
        taken.put(assigned[i], planned.get(i).name);
      }
      return assigned;
    }

    private int goal(int i) {
      Mover m = planned.get(i);
      Cell wanted = m.goalCell();
      if (wanted == null) {
        return nearest(starts[i], starts[i]);
      }
      int vertex = roads.vertex(wanted);
      if (vertex == RoadGraph.NONE || !roads.isConnected(starts[i], vertex)) {
        m.reason = blocker(wanted);
        return nearest(starts[i], starts[i]);
      }
      String other = taken.get(vertex);
      if (other != null) {
        m.reason = "Waits for " + other + " to leave the place.";
        return nearest(vertex, starts[i]);
      }
      if (isWished(vertex)) {
        m.reason = "Waits for a larger robot to pass.";
        return nearest(vertex, starts[i]);
      }
      return vertex;
    }

    private boolean isWished(int vertex) {
      return wished.get(grid.index(roads.cell(vertex)));
    }

    private String blocker(Cell wanted) {
      for (Mover other : movers.values()) {
        if (!planned.contains(other) && other.claimed().get(grid.index(wanted))) {
          return "Waits for " + other.name + ", which stands where it has to go.";
        }
      }
      return "Waits: robots that cannot be moved block every way to its goal.";
    }

    /**
     * A vertex near to the wanted one that nobody else goes to. A robot that is near already stays
     * where it is; otherwise waiting robots would change places for ever.
     */
    private int nearest(int to, int start) {
      Deque<Integer> queue = new ArrayDeque<>(List.of(to));
      Map<Integer, Integer> steps = new HashMap<>(Map.of(to, 0));
      int found = RoadGraph.NONE;
      while (!queue.isEmpty()) {
        int vertex = queue.poll();
        int here = steps.getOrDefault(vertex, 0);
        if (found != RoadGraph.NONE && here > NEAR) {
          return found;
        }
        if (isOpen(vertex)) {
          if (vertex == start) {
            return start;
          }
          found = found == RoadGraph.NONE ? vertex : found;
        }
        for (int d = 0; d < RoadGraph.DIRECTIONS; d++) {
          int next = roads.neighbour(vertex, d);
          if (next != RoadGraph.NONE && steps.putIfAbsent(next, here + 1) == null) {
            queue.add(next);
          }
        }
      }
      return found == RoadGraph.NONE ? start : found;
    }

    private boolean isOpen(int vertex) {
      return !taken.containsKey(vertex) && !isWished(vertex);
    }
  }

  // --- release ----------------------------------------------------------------------------------

  private void release(Mover m, Instant now, Told told) {
    Course course = m.course;
    if (course == null || !m.movable || m.stalled) {
      return;
    }
    while (m.released < course.size() && !isEnoughAhead(m, course)) {
      if (!mayEnter(m, course, m.released)) {
        if (!standsBefore(m, now) || !breakCorner(m, course, told)) {
          return;
        }
        course = Objects.requireNonNull(m.course);
        continue;
      }
      if (m.done == m.released) {
        m.lastProgress = now;
      }
      m.released++;
      m.blockedSince = null;
      m.obstruction = null;
    }
  }

  private static boolean isEnoughAhead(Mover m, Course course) {
    double seconds = 0;
    for (int i = m.done; i < m.released; i++) {
      seconds += course.stretches().get(i).duration();
    }
    return m.released - m.done >= STRETCHES_AHEAD && seconds >= SECONDS_AHEAD;
  }

  private boolean mayEnter(Mover m, Course course, int index) {
    Stretch stretch = course.stretches().get(index);
    for (Mover other : movers.values()) {
      if (other != m && stretch.cells().intersects(other.held())) {
        m.obstruction = "Waits for " + other.name + " to pass.";
        return false;
      }
    }
    if (index < course.base() || course.visits().isEmpty()) {
      return true;
    }
    int last = course.visitAfterStretches(index + 1);
    for (int v = course.visitAfterStretches(index) + 1; v <= last; v++) {
      Wait wait = course.waits().get(v);
      if (wait != null && !isOver(wait)) {
        m.obstruction = "Waits for " + wait.robot() + " to pass.";
        return false;
      }
    }
    return true;
  }

  private boolean isOver(Wait wait) {
    Mover other = movers.get(wait.robot());
    return other == null
        || other.courseNumber != wait.course()
        || other.course == null
        || other.course.visitAfterStretches(other.done) > wait.visit();
  }

  private static boolean standsBefore(Mover m, Instant now) {
    if (m.done < m.released) {
      return false;
    }
    if (m.blockedSince == null) {
      m.blockedSince = now;
    }
    return m.blockedSince.plus(BREAK_AFTER).isBefore(now);
  }

  /**
   * A corner that is rounded needs the cells before and behind it at once; a robot that has waited
   * for both drives up to the corner, turns there on the spot, and so needs one at a time.
   */
  private boolean breakCorner(Mover m, Course course, Told told) {
    int index = m.released;
    if (!course.stretches().get(index).rounds()
        || course.visits().isEmpty()
        || index < course.base()) {
      return false;
    }
    int from = course.visitAfterStretches(index);
    int until = course.visitAfterStretches(index + 1);
    List<Waypoint> way =
        JointPlan.waypoints(grid, course.visits(), from, v -> v > from && v < until);
    List<Stretch> stretches = fitter.fit(course.poseAfter(index), way, m.radius);
    told.redriven(m, m.course != null && m.released == 0 && told.begun.contains(m.name));
    m.course =
        course.redriven(
            index, stretches, JointPlan.visitsAfter(grid, stretches, course.visits(), from));
    m.blockedSince = null;
    return true;
  }
}
