package org.toqa.traffic.lifelong;

import static org.toqa.traffic.RoadGraph.DIRECTIONS;
import static org.toqa.traffic.RoadGraph.NONE;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.MotionModel;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.Spacing;
import org.toqa.traffic.mapf.StateGraph;

/**
 * The planner of a fleet: {@link Guidance} shows each robot its path around the traffic, {@link
 * OperationSearch} settles step by step who goes and who makes room, {@link RobotProgress} keeps
 * the priorities. Plans reach a few steps ahead and are made anew as robots move (rolling horizon:
 * Li et al., "Lifelong multi-agent path finding in large-scale warehouses", AAAI 2021).
 */
public final class RollingHorizonPlanner implements LifelongPlanner {
  private static final int DEPTH_CLASSIC = 3;
  private static final int DEPTH_TURNS = 5;

  /**
   * Where hardly a vertex is free, long operations meet more than one robot: shorter ones are
   * exchanged more often in the same time.
   */
  private static final int DEPTH_PACKED = 3;

  /** Robots for each vertex from which on the roads are packed. */
  private static final double PACKED = 0.85;

  /** Of the time there is, what the search for paths that are missing may take. */
  private static final double SHARE_OF_SEEKERS = 0.6;

  /** Of the time there is, after what share no more look for better paths. */
  private static final double SHARE_OF_RENEWALS = 0.3;

  /**
   * Of the time left then, what the search for operations may take; the rest is to tell the plan.
   */
  private static final double SHARE_OF_OPERATIONS = 0.9;

  /** Paths that are looked for at the same time, without knowing of each other. */
  private static final int AT_ONCE = 4;

  /** Robots that look in each plan whether the traffic has opened a better path, oldest first. */
  private static final int RENEWALS = 20;

  private static final int LONGEST_RANDOM_WALK = 24;

  private final MotionModel model;
  private final boolean mayRotate;
  private final double apart;
  private final SplittableRandom random;
  private final Map<String, RobotProgress> robots = new HashMap<>();
  private @Nullable GraphContext lastContext;
  private int planCount;

  /**
   * Robots may be on any two cells at once.
   *
   * @param mayRotate whether robots may drive round in a full ring, all at once; not where a robot
   *     enters a cell only after another has left it
   * @param seed of all chance
   */
  public RollingHorizonPlanner(MotionModel model, boolean mayRotate, long seed) {
    this(model, mayRotate, 1, seed);
  }

  /**
   * @param apart what is kept between the middles of robots, in cells
   */
  public RollingHorizonPlanner(MotionModel model, boolean mayRotate, double apart, long seed) {
    this.model = model;
    this.mayRotate = mayRotate;
    this.apart = apart;
    this.random = new SplittableRandom(seed);
  }

  /**
   * What is made for one set of roads, and thrown away with it.
   *
   * @param zeroCosts the costs of a robot that has no goal to go to: none
   */
  private record GraphContext(
      StateGraph graph,
      Guidance guidance,
      Operations operations,
      OperationSearch search,
      char[] zeroCosts) {}

  @Override
  public LifelongPlan plan(TrafficSnapshot snapshot, Deadline deadline) {
    planCount++;
    GraphContext context = contextOf(snapshot);
    ActiveRobots active = ActiveRobots.of(snapshot, context.graph());
    forgetAbsent(snapshot, context);
    List<RobotProgress> present = updateRobots(snapshot, active, context);
    BitSet fixed = fixed(active);
    context.guidance().setFixed(vertices(fixed, present, context.graph()));
    sendStuckOnDetours(present, context.graph());
    findPaths(present, context.guidance(), deadline);
    fixed.stream().forEach(k -> present.get(k).forgetOperation());
    restartOperations(snapshot, active, present, context.operations());
    context
        .search()
        .improve(
            task(snapshot, active, present, fixed, context),
            deadline.afterShare(SHARE_OF_OPERATIONS));
    return active.toPlan(
        context.operations().depth(),
        context.operations()::state,
        k -> present.get(k).target() == NONE || present.get(k).hasPath());
  }

  private static BitSet fixed(ActiveRobots active) {
    BitSet fixed = new BitSet();
    IntStream.range(0, active.size()).filter(active::isFixed).forEach(fixed::set);
    return fixed;
  }

  private static BitSet vertices(BitSet fixed, List<RobotProgress> present, StateGraph graph) {
    BitSet vertices = new BitSet();
    fixed.stream().forEach(k -> vertices.set(graph.vertex(present.get(k).state())));
    return vertices;
  }

  private GraphContext contextOf(TrafficSnapshot snapshot) {
    RoadGraph roads = snapshot.roads();
    int depth = depth(roads, snapshot.robots().size());
    GraphContext last = lastContext;
    if (last != null && last.graph().roads() == roads && last.operations().depth() == depth) {
      return last;
    }
    robots.values().forEach(RobotProgress::forgetGraph);
    StateGraph graph = new StateGraph(roads, model);
    Spacing spacing = new Spacing(roads, apart);
    Operations operations = new Operations(graph, spacing, depth);
    GraphContext context =
        new GraphContext(
            graph,
            new Guidance(graph, spacing),
            operations,
            new OperationSearch(graph, operations, mayRotate, random.split()),
            new char[graph.stateCount()]);
    lastContext = context;
    return context;
  }

  private int depth(RoadGraph roads, int robotCount) {
    int usual = model == MotionModel.CLASSIC ? DEPTH_CLASSIC : DEPTH_TURNS;
    return robotCount > PACKED * roads.vertexCount() ? DEPTH_PACKED : usual;
  }

  private void forgetAbsent(TrafficSnapshot snapshot, GraphContext context) {
    Set<String> names =
        snapshot.robots().stream().map(PlannedRobot::name).collect(Collectors.toSet());
    robots
        .entrySet()
        .removeIf(
            entry -> {
              boolean isAbsent = !names.contains(entry.getKey());
              if (isAbsent) {
                context.guidance().withdraw(entry.getValue().takeEdges());
              }
              return isAbsent;
            });
  }

  private List<RobotProgress> updateRobots(
      TrafficSnapshot snapshot, ActiveRobots active, GraphContext context) {
    List<RobotProgress> present = new ArrayList<>();
    for (int k = 0; k < active.size(); k++) {
      PlannedRobot robot = snapshot.robots().get(active.robot(k));
      RobotProgress progress = robots.computeIfAbsent(robot.name(), name -> new RobotProgress());
      int goal = active.goal(k);
      if (goal != progress.goal()) {
        context.guidance().withdraw(progress.takeEdges());
        progress.setGoal(goal);
      }
      int state = active.state(k);
      progress.advance(state, context.graph().vertex(state), snapshot.steps(), random);
      present.add(progress);
    }
    return present;
  }

  /** Whoever is stuck, and who is beside it. */
  private void sendStuckOnDetours(List<RobotProgress> present, StateGraph graph) {
    Set<Integer> stuck =
        present.stream()
            .filter(RobotProgress::isStuck)
            .map(progress -> graph.vertex(progress.state()))
            .collect(Collectors.toSet());
    if (stuck.isEmpty()) {
      return;
    }
    for (RobotProgress progress : present) {
      int vertex = graph.vertex(progress.state());
      boolean isInvolved =
          stuck.contains(vertex)
              || IntStream.range(0, DIRECTIONS)
                  .anyMatch(d -> stuck.contains(graph.roads().neighbour(vertex, d)));
      if (isInvolved) {
        progress.startDetour(randomWalkEnd(vertex, graph.roads()));
      }
    }
  }

  /** Some vertex near another one: where a walk without turning back leads. */
  private int randomWalkEnd(int start, RoadGraph roads) {
    int at = start;
    int last = NONE;
    for (int left = 1 + random.nextInt(LONGEST_RANDOM_WALK); left > 0; left--) {
      int next = roads.neighbour(at, random.nextInt(DIRECTIONS));
      if (next != NONE && next != last) {
        last = at;
        at = next;
      }
    }
    return at;
  }

  /**
   * Looks for paths, a few at a time: these share the processor's cores, and the next few know of
   * the paths that they announce. Nobody who looks for a path is kept from one by what others
   * announced who look for theirs: else each would avoid the jam that the others have left.
   */
  private void findPaths(List<RobotProgress> present, Guidance guidance, Deadline deadline) {
    Deadline renewals = deadline.afterShare(SHARE_OF_RENEWALS);
    List<RobotProgress> seekers =
        present.stream()
            .filter(RobotProgress::needsPath)
            .sorted(Comparator.comparing(RobotProgress::hasPath))
            .toList();
    seekers.forEach(seeker -> guidance.withdraw(seeker.takeEdges()));
    findPaths(seekers, guidance, deadline.afterShare(SHARE_OF_SEEKERS), RobotProgress::setPath);
    List<RobotProgress> oldest =
        present.stream()
            .filter(robot -> robot.target() != NONE && !robot.needsPath())
            .sorted(Comparator.comparingInt(RobotProgress::pathPlan))
            .limit(RENEWALS)
            .toList();
    findPaths(oldest, guidance, renewals, RobotProgress::renewPath);
  }

  /** Takes the path that was found for a robot. */
  @FunctionalInterface
  private interface PathTaker {
    void take(RobotProgress robot, char[] distances, int[] edges, int plan);
  }

  private void findPaths(
      List<RobotProgress> seekers, Guidance guidance, Deadline deadline, PathTaker taker) {
    for (int k = 0; k < seekers.size() && !deadline.isPassed(); k += AT_ONCE) {
      List<RobotProgress> few = seekers.subList(k, Math.min(seekers.size(), k + AT_ONCE));
      few.forEach(robot -> guidance.withdraw(robot.takeEdges()));
      List<char[]> found =
          few.parallelStream().map(t -> guidance.distances(t.state(), t.target())).toList();
      for (int f = 0; f < few.size(); f++) {
        RobotProgress robot = few.get(f);
        char[] distances = found.get(f);
        char[] former = robot.distances();
        taker.take(robot, distances, guidance.announce(robot.state(), distances), planCount);
        if (former != null) {
          guidance.recycle(former);
        }
      }
    }
  }

  private static void restartOperations(
      TrafficSnapshot snapshot,
      ActiveRobots active,
      List<RobotProgress> present,
      Operations operations) {
    operations.restart(
        present.stream().mapToInt(RobotProgress::state).toArray(),
        present.stream().map(RobotProgress::operation).toArray(int[][]::new),
        snapshot.steps(),
        delays(active),
        snapshot.closed());
    for (int k = 0; k < present.size(); k++) {
      present.get(k).setOperation(operations.of(k));
    }
  }

  private static int[] delays(ActiveRobots active) {
    return IntStream.range(0, active.size()).map(active::delay).toArray();
  }

  private static SearchTask task(
      TrafficSnapshot snapshot,
      ActiveRobots active,
      List<RobotProgress> present,
      BitSet fixed,
      GraphContext context) {
    return SearchTask.of(
        byPriority(snapshot, active, present),
        distances(present, context),
        present.stream().mapToInt(RobotProgress::target).toArray(),
        fixed,
        delays(active),
        present.stream().mapToInt(RobotProgress::weight).toArray());
  }

  private static int[] byPriority(
      TrafficSnapshot snapshot, ActiveRobots active, List<RobotProgress> present) {
    long[] keys = new long[present.size()];
    for (int k = 0; k < keys.length; k++) {
      int urgency = snapshot.robots().get(active.robot(k)).urgency();
      keys[k] = ((long) -present.get(k).priority(urgency) << Integer.SIZE) | k;
    }
    Arrays.sort(keys);
    return Arrays.stream(keys).mapToInt(key -> (int) key).toArray();
  }

  private static char[][] distances(List<RobotProgress> present, GraphContext context) {
    char[][] distances = new char[present.size()][];
    for (int k = 0; k < distances.length; k++) {
      char[] known = present.get(k).distances();
      distances[k] = known == null ? context.zeroCosts() : known;
    }
    return distances;
  }
}
