package org.toqa.traffic.floor;

import static java.util.Comparator.nullsLast;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DriveSpeeds;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;
import org.toqa.traffic.Deadline;
import org.toqa.wording.Sentence;

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
  private static final Duration NO_PROGRESS_AFTER = Duration.ofSeconds(10);
  private static final Duration PLAN_AGAIN_AFTER = Duration.ofSeconds(5);
  private static final Duration BACK_OFF_AFTER = Duration.ofSeconds(2);
  private static final Duration LOOK_AGAIN_AFTER = Duration.ofSeconds(1);

  private final Ground ground;
  private final OwnWays ways;
  private final JointPlanning together;
  private final Releases releases;
  private final Hindrances hindrances;
  private final Holdings holdings;
  private final StandstillWatch watch = new StandstillWatch();
  private final Map<String, Mover> movers = new TreeMap<>();
  private int joined;

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
  public FloorTraffic(OccupancyGrid grid, JointPlanner joint, Supplier<Deadline> patience) {
    CourseFitter fitter = new CourseFitter();
    this.ground = new Ground(grid);
    this.ways = new OwnWays(ground, fitter);
    this.together = new JointPlanning(ground, ways, fitter, joint, patience);
    this.holdings = new Holdings(grid, movers.values());
    this.releases = new Releases(fitter, movers, holdings);
    this.hindrances = new Hindrances(ground, ways);
  }

  // --- what is so -------------------------------------------------------------------------------

  /** The robot stands at a pose and has no way; it may be new here. */
  public void stands(String robot, Pose pose, double footprint, Instant now) {
    OccupancyGrid grid = ground.grid();
    Mover m =
        movers.computeIfAbsent(
            robot, name -> new Mover(name, ++joined, grid, pose, footprint / 2, now));
    broken |= m.hasUnreleased();
    changed |= m.course != null || !m.cell().equals(grid.cellAt(pose.position()));
    m.isAt(pose, footprint / 2);
    m.stop();
  }

  /**
   * The robot, which stands, leads others from now on: what it wants is where the load shall go,
   * and all of the group's cells are its own. The others must have left.
   *
   * @param group null: it drives alone again
   */
  public void leads(String robot, @Nullable Group group) {
    Mover m = mover(robot);
    if (m.group() != group) {
      giveUpTheRest(m);
      m.leads(group);
      changed = true;
    }
  }

  /**
   * How fast the robot shall drive from now on.
   *
   * @param robot one that stands or drives here
   */
  public void drivesAt(String robot, DriveSpeeds speeds) {
    mover(robot).speeds = speeds;
  }

  /**
   * The robot is on the way that it was told.
   *
   * @param segments so many are completed
   */
  public void moved(String robot, Pose pose, int segments, Instant now) {
    Mover m = mover(robot);
    m.isAt(pose, m.radius);
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
      Trajectory way,
      int segments,
      int released,
      Instant now) {
    stands(robot, pose, footprint, now);
    Mover m = mover(robot);
    List<Stretch> stretches = new ArrayList<>();
    Pose at = way.start();
    for (Segment segment : way.segments().subList(0, Math.min(released, way.segments().size()))) {
      CellSet cells = m.swept(at, segment);
      at = at.advanced(segment.twist(), segment.t());
      stretches.add(new Stretch(List.of(segment), at, cells, m.standingAt(at)));
    }
    m.take(Course.meetingNobody(way.start(), stretches));
    m.released = stretches.size();
    m.done = Math.min(segments, stretches.size());
    m.begun = true;
    m.toldReleased = m.released;
    m.lastProgress = now;
  }

  /**
   * @param goal null: it wants nothing, and may be asked to step aside
   */
  public void wants(String robot, @Nullable Vec2 goal, Instant now) {
    wants(robot, goal, null, now);
  }

  /**
   * @param goal null: it wants nothing, and may be asked to step aside
   * @param heading how it shall face there, radians, map frame; null: in any way
   */
  public void wants(String robot, @Nullable Vec2 goal, @Nullable Double heading, Instant now) {
    Mover m = mover(robot);
    if (!Objects.equals(m.goal, goal) || !Objects.equals(m.heading, heading)) {
      m.goal = goal;
      m.heading = heading;
      m.wish = new BitSet();
      m.waitingSince = goal == null ? null : now;
      m.hindrance = null;
      m.takenBy = null;
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
    if (ground.takeObstacles(cells)) {
      changed = true;
      movers.values().stream().filter(m -> m.needsAny(cells)).forEach(this::giveUpTheRest);
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
  public @Nullable Sentence reason(String robot) {
    Hindrance why = mover(robot).why();
    return why == null ? null : why.sentence();
  }

  /** The cells that are its own now, as bits by {@link OccupancyGrid#index}. */
  public BitSet held(String robot) {
    return mover(robot).held();
  }

  /** Whether an obstacle stands on what it has been released and not driven yet. */
  public boolean isHeadingForObstacle(String robot) {
    Mover m = mover(robot);
    Course course = m.course;
    return course != null
        && course.stretches().subList(Math.min(m.done, m.released), m.released).stream()
            .anyMatch(stretch -> stretch.cells().intersects(ground.obstacles()));
  }

  /** Robots that do not get on as they should, each in one of these at most. */
  public List<Standstill> standstills() {
    return watch.standstills();
  }

  /** The rest of its way. */
  public Route route(String robot) {
    Mover m = mover(robot);
    return m.course == null ? Route.NONE : Route.of(m.course, m.done, m.released, m.pose);
  }

  // --- decisions --------------------------------------------------------------------------------

  /** Plans for whoever needs a way, and releases what can be. */
  public List<Decision> decide(Instant now) {
    holdings.take();
    watchForStalls(now);
    planEachAlone(now);
    planTogether(now);
    explain(now);
    movers.values().stream().filter(m -> m.isUnserved()).forEach(m -> makeRoomFor(m, now));
    movers.values().forEach(m -> releases.release(m, now));
    watch.look(movers.values(), now);
    return movers.values().stream().flatMap(m -> m.untold().stream()).toList();
  }

  private void giveUpTheRest(Mover m) {
    broken |= m.hasUnreleased();
    m.cut();
  }

  private void watchForStalls(Instant now) {
    for (Mover m : movers.values()) {
      if (!m.isDriving()) {
        m.lastProgress = now;
      }
      boolean stalled = StandstillWatch.isNotMoving(m, now);
      if (stalled != m.stalled) {
        m.stalled = stalled;
        changed = true;
        if (stalled) {
          giveUpTheRest(m);
        }
      }
    }
  }

  /** Gives their own ways to those that wait: groups first, then the longest waiting. */
  private void planEachAlone(Instant now) {
    List<Mover> unserved =
        movers.values().stream()
            .filter(Mover::isUnserved)
            .sorted(
                Comparator.<Mover, Boolean>comparing(m -> !m.isGroup())
                    .thenComparing(
                        m -> m.waitingSince, nullsLast(Comparator.<Instant>naturalOrder())))
            .toList();
    for (Mover m : unserved) {
      if (m.waitingSince == null) {
        m.waitingSince = now;
      }
      if (changed || m.triedAlone.plus(LOOK_AGAIN_AFTER).isBefore(now)) {
        m.triedAlone = now;
        BitSet taken = claimedByOthers(m);
        movers.values().stream().filter(o -> o.goesBefore(m)).forEach(o -> taken.or(o.wish));
        ways.among(m, movers.values(), taken).ifPresent(way -> takeOwn(m, way));
      }
    }
  }

  private static void takeOwn(Mover m, List<Stretch> way) {
    m.take(Course.meetingNobody(m.releasedEnd(), way));
    m.hindrance = null;
    m.takenBy = null;
    m.waitingSince = null;
    m.wish = new BitSet();
  }

  private BitSet claimedByOthers(Mover m) {
    BitSet claimed = new BitSet();
    for (Mover other : movers.values()) {
      if (other != m) {
        other.addClaimedTo(claimed);
      }
    }
    return claimed;
  }

  private void planTogether(Instant now) {
    broken |= isStandstill(now);
    boolean isNeeded = broken || movers.values().stream().anyMatch(Mover::isUnserved);
    if (!isNeeded || !(changed || plannedTogether.plus(PLAN_AGAIN_AFTER).isBefore(now))) {
      return;
    }
    plannedTogether = now;
    changed = false;
    if (together.plan(movers.values(), holdings, broken) == JointPlanning.Outcome.PLANNED) {
      broken = false;
      for (Mover m : movers.values()) {
        if (m.isServed()) {
          m.hindrance = null;
          m.waitingSince = null;
        }
      }
    }
  }

  /** Whether robots wait in a circle, or have ways and none has got on for long. */
  private boolean isStandstill(Instant now) {
    boolean isCycle =
        watch.standstills().stream().anyMatch(s -> s.kind() == Standstill.Kind.CYCLE_OF_WAITS);
    return isCycle
        || (lastProgress.plus(NO_PROGRESS_AFTER).isBefore(now)
            && movers.values().stream().anyMatch(Mover::hasUnreleased)
            && movers.values().stream().noneMatch(m -> m.isDriving() && !m.stalled));
  }

  private void explain(Instant now) {
    for (Mover m : movers.values()) {
      if (!m.isUnserved()) {
        m.hindrance = null;
      } else if (m.hindrance == null || m.hindranceSince.plus(LOOK_AGAIN_AFTER).isBefore(now)) {
        m.hindrance = hindrances.of(m, movers.values());
        m.hindranceSince = now;
      }
    }
  }

  /**
   * Where a robot stands in another's only way and no plan for all could move it, as one that is
   * too large for the lanes, it is sent to the nearest place where it stands in nobody's way.
   */
  private void makeRoomFor(Mover m, Instant now) {
    if (m.waitingSince == null || m.waitingSince.plus(BACK_OFF_AFTER).isAfter(now)) {
      return;
    }
    Mover other = standingInTheWayOf(m);
    if (other == null || !other.movable || other.goesBefore(m)) {
      return;
    }
    m.wish = new BitSet();
    ways.roundFixed(m, movers.values()).ifPresent(way -> way.forEach(s -> s.cells().addTo(m.wish)));
    if (m.wish.isEmpty()) {
      return;
    }
    ways.outOf(other, movers.values(), claimedByOthers(other), m.wish)
        .ifPresent(
            way -> {
              giveUpTheRest(other);
              other.take(Course.meetingNobody(other.releasedEnd(), way));
              other.waitingSince = other.goal == null ? null : now;
            });
  }

  /** One that cannot go on its way, as to where a group stands, stands in that group's way too. */
  private @Nullable Mover standingInTheWayOf(Mover m) {
    Hindrance hindrance = m.hindrance;
    if (hindrance == null || hindrance.robot() == null) {
      return null;
    }
    Mover other = movers.get(hindrance.robot());
    boolean isStanding =
        switch (hindrance) {
          case Hindrance.Standing _ -> other != null && other.course == null;
          case Hindrance.Passing _ -> other != null && m.isGroup() && !other.isDriving();
          default -> false;
        };
    return isStanding ? other : null;
  }
}
