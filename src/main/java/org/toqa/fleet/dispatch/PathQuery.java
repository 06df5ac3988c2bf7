package org.toqa.fleet.dispatch;

import com.github.benmanes.caffeine.cache.AsyncCache;
import com.github.benmanes.caffeine.cache.Cache;
import com.github.benmanes.caffeine.cache.Caffeine;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.Executor;
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.Candidate;
import org.toqa.fleet.RobotCapabilities;
import org.toqa.fleet.floor.TeamRoomCheck;
import org.toqa.formation.GroupMobility;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Inflation;
import org.toqa.grid.Margins;
import org.toqa.grid.OccupancyGrid;
import org.toqa.mission.Mission;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.planning.HeadingAStar;
import org.toqa.planning.PathPlanner;
import org.toqa.planning.PlanResult;
import org.toqa.planning.SearchLimit;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.floor.FloorTraffic;
import org.toqa.traffic.mapf.LacamJointPlanner;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * What planning says of a floor without other robots: whether one robot has a path, and whether
 * several have room round a load. Any thread may ask; nothing is planned on the asking one, but in
 * the turn of the check that it is for.
 *
 * <p>An answer depends on the immutable grid that is asked about, and on nothing else: the last
 * answers are kept by grid and question, and a floor that gets another grid is asked about anew. A
 * plan that fails, or does not end in time, is not kept.
 */
final class PathQuery {
  private static final int MAX_ANSWERS = 2_000;
  private static final int MAX_FLOORS = 32;
  private static final String ROBOT = "robot";

  /** On the clock of {@link #checkDeadline}, which stands at 0 before it. */
  private static final long OVER = Long.MAX_VALUE / 2;

  private final PathPlanner planner = new HeadingAStar();
  private final Cache<PathKey, FloorPath> paths;
  private final AsyncCache<TeamKey, Optional<Sentence>> teams;
  private final Cache<FloorKey, EmptyFloor> emptyFloors;

  /**
   * @param planning what plans for the fleet; it may plan several things beside each other
   */
  PathQuery(Executor planning) {
    paths = Caffeine.newBuilder().maximumSize(MAX_ANSWERS).executor(Runnable::run).build();
    teams = Caffeine.newBuilder().maximumSize(MAX_ANSWERS).executor(planning).buildAsync();
    emptyFloors = Caffeine.newBuilder().maximumSize(MAX_FLOORS).executor(Runnable::run).build();
  }

  /**
   * @param diameter of the robot, metres
   */
  private record FloorKey(OccupancyGrid grid, double diameter) {}

  /**
   * @param start metres, map frame
   * @param goal metres, map frame
   */
  private record PathKey(FloorKey floor, Vec2 start, Vec2 goal) {}

  private record TeamKey(OccupancyGrid grid, Margins margins, TeamQuestion question) {
    TeamKey(FloorMap floor, TeamQuestion question) {
      this(floor.grid(), floor.margins(), question);
    }
  }

  /**
   * All on which it depends whether so many robots have room for a task.
   *
   * @param object where the load is
   * @param stops where it is carried, in order
   * @param diameter of the largest robot, metres
   * @param mobility how they can be led
   * @param size of the load; null: not told
   */
  record TeamQuestion(
      TaskPlace object,
      List<TaskPlace> stops,
      int robots,
      double diameter,
      GroupMobility mobility,
      @Nullable LoadSize size) {

    /** About these, who are to carry it together. */
    static TeamQuestion of(Mission mission, List<Candidate> team) {
      return new TeamQuestion(
          mission.object(),
          mission.placesFromObject(),
          team.size(),
          team.stream()
              .mapToDouble(Candidate::diameter)
              .max()
              .orElse(RobotCapabilities.UNKNOWN.footprint()),
          GroupMobility.of(
              team.stream().allMatch(Candidate::isOmnidirectional),
              team.stream().allMatch(Candidate::knowsShifts)),
          mission.task().size());
    }

    /** Whether they may lack room because one of them cannot go sideways. */
    boolean hasDifferential() {
      return mobility == GroupMobility.NON_HOLONOMIC;
    }
  }

  /**
   * The path of one robot on a floor where nobody else is.
   *
   * @param start metres, map frame
   * @param goal metres, map frame; in another cell
   * @param diameter of the robot, metres
   * @param check what it is asked for
   */
  CompletableFuture<FloorPath> findPath(
      OccupancyGrid grid, Vec2 start, Vec2 goal, double diameter, OrderChecks.Check check) {
    PathKey key = new PathKey(new FloorKey(grid, diameter), start, goal);
    FloorPath known = paths.getIfPresent(key);
    return known == null ? check.run(() -> plan(key)) : CompletableFuture.completedFuture(known);
  }

  private FloorPath plan(PathKey key) {
    FloorPath planned = emptyFloors.get(key.floor(), EmptyFloor::new).plan(key, planner);
    paths.put(key, planned);
    return planned;
  }

  /**
   * Why robots have no room for a task; empty if they have, or one does it. The fleet asks.
   *
   * @param question about this mission
   */
  CompletableFuture<Optional<Sentence>> objectionToTeam(
      FloorMap floor, Mission mission, TeamQuestion question) {
    return question.robots() < 2
        ? CompletableFuture.completedFuture(Optional.empty())
        : teams.get(new TeamKey(floor, question), _ -> objection(floor, mission, question));
  }

  /** The same for an order or preview. */
  CompletableFuture<Optional<Sentence>> objectionToTeam(
      FloorMap floor, Mission mission, TeamQuestion question, OrderChecks.Check check) {
    if (question.robots() < 2) {
      return CompletableFuture.completedFuture(Optional.empty());
    }
    TeamKey key = new TeamKey(floor, question);
    Optional<Sentence> known = teams.synchronous().getIfPresent(key);
    return known == null
        ? check.run(() -> remember(key, objection(floor, mission, question)))
        : CompletableFuture.completedFuture(known);
  }

  /** Why none of these teams has room for it; empty if one has, or there is none. */
  CompletableFuture<Optional<Sentence>> objectionToTeams(
      FloorMap floor, Mission mission, List<List<Candidate>> teams, OrderChecks.Check check) {
    CompletableFuture<Optional<Sentence>> first =
        teams.isEmpty()
            ? CompletableFuture.completedFuture(Optional.empty())
            : objectionToTeam(floor, mission, TeamQuestion.of(mission, teams.getFirst()), check);
    return first.thenCompose(
        objection ->
            objection.isEmpty() || teams.size() == 1
                ? CompletableFuture.completedFuture(objection)
                : objectionToTeams(floor, mission, teams.subList(1, teams.size()), check)
                    .thenApply(ofOthers -> ofOthers.isEmpty() ? ofOthers : objection));
  }

  private Optional<Sentence> remember(TeamKey key, Optional<Sentence> objection) {
    teams.synchronous().put(key, objection);
    return objection;
  }

  private static Optional<Sentence> objection(
      FloorMap floor, Mission mission, TeamQuestion question) {
    return new TeamRoomCheck(floor.grid(), floor.margins())
        .objection(mission, question.robots(), question.diameter(), question.mobility())
        .map(why -> question.hasDifferential() ? Phrase.WITH_DIFFERENTIAL.with(why) : why);
  }

  /** Passed when the check that is worked for on this thread is out of time. */
  private static Deadline checkDeadline() {
    return new Deadline(() -> SearchLimit.isOver() ? OVER : 0, OVER);
  }

  /** A floor on which one robot is alone. Any thread may plan on it. */
  private static final class EmptyFloor {
    private final OccupancyGrid grid;
    private final double diameter;
    private final OccupancyGrid standable;

    /** Each confined to the thread that has taken it out. */
    private final Queue<FloorTraffic> idleTraffics = new ConcurrentLinkedQueue<>();

    EmptyFloor(FloorKey key) {
      this.grid = key.grid();
      this.diameter = key.diameter();
      this.standable = Inflation.inflate(grid, diameter / 2);
    }

    FloorPath plan(PathKey key, PathPlanner planner) {
      PlanResult planned =
          planner.plan(standable, standable.cellAt(key.start()), standable.cellAt(key.goal()));
      if (planned instanceof PlanResult.Found(var path)) {
        return new FloorPath.Found(points(key.start(), path.waypoints(standable), key.goal()));
      }
      return hasPathInTraffic(key.start(), key.goal())
          ? new FloorPath.FoundBetweenCells()
          : new FloorPath.NotFound();
    }

    private static List<Vec2> points(Vec2 start, List<Waypoint> bends, Vec2 goal) {
      List<Vec2> points = new ArrayList<>(List.of(start));
      bends.subList(0, bends.size() - 1).forEach(bend -> points.add(bend.position()));
      points.add(goal);
      return points;
    }

    /** Whether the traffic would find a path for the robot: between the middles of cells too. */
    private boolean hasPathInTraffic(Vec2 start, Vec2 goal) {
      FloorTraffic idle = idleTraffics.poll();
      FloorTraffic traffic =
          idle == null
              ? new FloorTraffic(grid, new LacamJointPlanner(), PathQuery::checkDeadline)
              : idle;
      traffic.reportStanding(ROBOT, new Pose(start.x(), start.y(), 0), diameter, Instant.EPOCH);
      traffic.setMovable(ROBOT, true);
      traffic.setGoal(ROBOT, goal, Instant.EPOCH);
      traffic.decide(Instant.EPOCH);
      SearchLimit.check(); // else no path may mean no time
      boolean hasPath = traffic.waitReason(ROBOT) == null;
      traffic.removeRobot(ROBOT);
      idleTraffics.add(traffic);
      return hasPath;
    }
  }
}
