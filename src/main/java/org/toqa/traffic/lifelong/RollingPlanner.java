package org.toqa.traffic.lifelong;

import static org.toqa.traffic.RoadGraph.NONE;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.toqa.traffic.Deadline;
import org.toqa.traffic.Itinerary;
import org.toqa.traffic.MotionModel;
import org.toqa.traffic.Prospect;
import org.toqa.traffic.RoadGraph;
import org.toqa.traffic.Stance;
import org.toqa.traffic.TrafficPlan;
import org.toqa.traffic.TrafficPlanner;
import org.toqa.traffic.TrafficRobot;
import org.toqa.traffic.TrafficScene;
import org.toqa.traffic.route.StateGraph;

/**
 * The planner of a fleet: {@link Guidance} shows each robot its way around the traffic, {@link
 * OperationSearch} settles step by step who goes and who makes way, {@link Traveller} keeps the
 * priorities.
 */
public final class RollingPlanner implements TrafficPlanner {
  private static final int DEPTH_CLASSIC = 3;
  private static final int DEPTH_TURNS = 4;

  /** Of the time there is, what the search for new ways may take. */
  private static final double SHARE_OF_GUIDANCE = 0.6;

  /** Ways that are looked for at the same time, without knowing of each other. */
  private static final int AT_ONCE = 4;

  private final MotionModel model;
  private final boolean mayRotate;
  private final SplittableRandom random;
  private final Map<String, Traveller> travellers = new HashMap<>();
  private @Nullable Floor lastFloor;

  /**
   * @param mayRotate whether robots may drive round in a full ring, all at once; not where a robot
   *     enters a cell only after another has left it
   */
  public RollingPlanner(MotionModel model, boolean mayRotate, long seed) {
    this.model = model;
    this.mayRotate = mayRotate;
    this.random = new SplittableRandom(seed);
  }

  /**
   * What is made for one set of roads, and thrown away with it.
   *
   * @param anywhere the costs of a robot that has no goal to go to: none
   */
  private record Floor(
      StateGraph graph,
      Guidance guidance,
      Operations operations,
      OperationSearch search,
      char[] anywhere) {}

  @Override
  public TrafficPlan plan(TrafficScene scene, Deadline deadline) {
    Floor floor = floorOf(scene.roads());
    Attendance attendance = Attendance.of(scene, floor.graph());
    forgetAbsent(scene, floor);
    List<Traveller> present = meet(scene, attendance, floor);
    findWays(present, floor.guidance(), deadline.after(SHARE_OF_GUIDANCE));
    startFromHere(present, floor.operations());
    floor
        .search()
        .improve(
            byPriority(scene, attendance, present),
            distances(present, floor),
            present.stream().mapToInt(Traveller::goal).toArray(),
            deadline);
    return report(scene, attendance, present, floor);
  }

  private Floor floorOf(RoadGraph roads) {
    Floor last = lastFloor;
    if (last != null && last.graph().roads() == roads) {
      return last;
    }
    travellers.values().forEach(Traveller::forgetRoads);
    StateGraph graph = new StateGraph(roads, model);
    int depth = model == MotionModel.CLASSIC ? DEPTH_CLASSIC : DEPTH_TURNS;
    Operations operations = new Operations(graph, depth);
    Floor floor =
        new Floor(
            graph,
            new Guidance(graph),
            operations,
            new OperationSearch(graph, operations, mayRotate, random.split()),
            new char[graph.states()]);
    lastFloor = floor;
    return floor;
  }

  private void forgetAbsent(TrafficScene scene, Floor floor) {
    Set<String> names = scene.robots().stream().map(TrafficRobot::name).collect(Collectors.toSet());
    travellers
        .entrySet()
        .removeIf(
            entry -> {
              boolean isAbsent = !names.contains(entry.getKey());
              if (isAbsent) {
                floor.guidance().withdraw(entry.getValue().takeWay());
              }
              return isAbsent;
            });
  }

  private List<Traveller> meet(TrafficScene scene, Attendance attendance, Floor floor) {
    List<Traveller> present = new ArrayList<>();
    for (int k = 0; k < attendance.size(); k++) {
      TrafficRobot robot = scene.robots().get(attendance.robot(k));
      Traveller traveller = travellers.computeIfAbsent(robot.name(), name -> new Traveller());
      int goal = attendance.goal(k);
      if (goal != traveller.goal()) {
        floor.guidance().withdraw(traveller.takeWay());
        traveller.headFor(goal);
      }
      traveller.isAt(attendance.state(k), floor.graph().vertex(attendance.state(k)), random);
      present.add(traveller);
    }
    return present;
  }

  /**
   * Looks for ways, a few at a time: these share the processor's cores, and the next few know of
   * the ways that they announce. Nobody who looks for a way is kept from one by what others said
   * who look for theirs: else a jam would go on for fear of itself.
   */
  private static void findWays(List<Traveller> present, Guidance guidance, Deadline deadline) {
    List<Traveller> seekers =
        present.stream()
            .filter(Traveller::seeksWay)
            .sorted(Comparator.comparing(Traveller::knowsWay))
            .toList();
    seekers.forEach(seeker -> guidance.withdraw(seeker.takeWay()));
    for (int k = 0; k < seekers.size() && !deadline.isPassed(); k += AT_ONCE) {
      List<Traveller> few = seekers.subList(k, Math.min(seekers.size(), k + AT_ONCE));
      List<char[]> found =
          few.parallelStream().map(t -> guidance.distances(t.state(), t.goal())).toList();
      for (int f = 0; f < few.size(); f++) {
        Traveller traveller = few.get(f);
        traveller.learn(found.get(f), guidance.announce(traveller.state(), found.get(f)));
      }
    }
  }

  private static void startFromHere(List<Traveller> present, Operations operations) {
    operations.restart(
        present.stream().mapToInt(Traveller::state).toArray(),
        present.stream().map(Traveller::operation).toArray(int[][]::new));
    for (int k = 0; k < present.size(); k++) {
      present.get(k).means(operations.of(k));
    }
  }

  private static int[] byPriority(
      TrafficScene scene, Attendance attendance, List<Traveller> present) {
    long[] keys = new long[present.size()];
    for (int k = 0; k < keys.length; k++) {
      int urgency = scene.robots().get(attendance.robot(k)).urgency();
      keys[k] = ((long) -present.get(k).priority(urgency) << Integer.SIZE) | k;
    }
    Arrays.sort(keys);
    return Arrays.stream(keys).mapToInt(key -> (int) key).toArray();
  }

  private static char[][] distances(List<Traveller> present, Floor floor) {
    char[][] distances = new char[present.size()][];
    for (int k = 0; k < distances.length; k++) {
      char[] known = present.get(k).distances();
      distances[k] = known == null ? floor.anywhere() : known;
    }
    return distances;
  }

  private static TrafficPlan report(
      TrafficScene scene, Attendance attendance, List<Traveller> present, Floor floor) {
    Itinerary[] itineraries = new Itinerary[scene.robots().size()];
    for (int robot = 0; robot < itineraries.length; robot++) {
      itineraries[robot] =
          new Itinerary(List.of(scene.robots().get(robot).stance()), attendance.prospect(robot));
    }
    for (int k = 0; k < attendance.size(); k++) {
      int robot = attendance.robot(k);
      Prospect prospect =
          present.get(k).goal() == NONE || present.get(k).knowsWay()
              ? attendance.prospect(robot)
              : Prospect.NOT_YET_PLANNED;
      List<Stance> stances = new ArrayList<>();
      stances.add(scene.robots().get(robot).stance());
      for (int t = 1; t <= floor.operations().depth(); t++) {
        stances.add(attendance.stance(robot, floor.operations().state(k, t)));
      }
      itineraries[robot] = new Itinerary(stances, prospect);
    }
    return new TrafficPlan(List.of(itineraries));
  }
}
