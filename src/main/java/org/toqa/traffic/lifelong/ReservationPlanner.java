package org.toqa.traffic.lifelong;

import static org.toqa.traffic.RoadGraph.NONE;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
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
import org.toqa.traffic.route.SafeIntervalSearch;
import org.toqa.traffic.route.StateDistances;
import org.toqa.traffic.route.StateGraph;
import org.toqa.traffic.route.Timetable;

/**
 * The baseline: first come, first served. A robot reserves its whole route in space and time when
 * it gets a goal, around what others have reserved; where there is none it stays and asks again
 * every step. Nobody makes way, so idle robots bar aisles and two can bar each other for ever.
 *
 * <p>D. Silver, "Cooperative pathfinding", AIIDE 2005.
 */
public final class ReservationPlanner implements TrafficPlanner {
  private static final int HORIZON = 4;

  private final MotionModel model;
  private final Map<String, Booking> bookings = new HashMap<>();
  private @Nullable StateGraph lastGraph;

  public ReservationPlanner(MotionModel model) {
    this.model = model;
  }

  /** A robot's route from the present step on; its last state is kept for ever. */
  private static final class Booking {
    int goal = NONE;
    char @Nullable [] distances;
    int[] route;

    Booking(int state) {
      route = new int[] {state};
    }

    int expected() {
      return route[Math.min(1, route.length - 1)];
    }
  }

  @Override
  public TrafficPlan plan(TrafficScene scene, Deadline deadline) {
    StateGraph graph = graphOf(scene.roads());
    Attendance attendance = Attendance.of(scene, graph);
    List<Booking> present = advance(scene, attendance);
    Timetable timetable = new Timetable(scene.roads(), span(present));
    present.forEach(booking -> timetable.add(vertices(graph, booking.route)));
    SafeIntervalSearch search = new SafeIntervalSearch(graph, timetable);
    for (int k = 0; k < present.size() && !deadline.isPassed(); k++) {
      book(present.get(k), attendance.goal(k), graph, timetable, search);
    }
    return report(scene, attendance, present);
  }

  private StateGraph graphOf(RoadGraph roads) {
    StateGraph last = lastGraph;
    if (last != null && last.roads() == roads) {
      return last;
    }
    bookings.clear();
    StateGraph graph = new StateGraph(roads, model);
    lastGraph = graph;
    return graph;
  }

  /** One step on; if a robot is not where it booked to be, all bookings are void. */
  private List<Booking> advance(TrafficScene scene, Attendance attendance) {
    Map<String, Booking> former = new HashMap<>(bookings);
    bookings.clear();
    List<Booking> present = new ArrayList<>();
    boolean isObeyed = true;
    for (int k = 0; k < attendance.size(); k++) {
      String name = scene.robots().get(attendance.robot(k)).name();
      int state = attendance.state(k);
      Booking booking = former.getOrDefault(name, new Booking(state));
      isObeyed &= booking.expected() == state && (former.isEmpty() || former.containsKey(name));
      present.add(booking);
      bookings.put(name, booking);
    }
    for (int k = 0; k < present.size(); k++) {
      Booking booking = present.get(k);
      if (isObeyed) {
        booking.route =
            Arrays.copyOfRange(
                booking.route, Math.min(1, booking.route.length - 1), booking.route.length);
      } else {
        booking.route = new int[] {attendance.state(k)};
        booking.goal = NONE;
      }
    }
    return present;
  }

  private static int span(List<Booking> present) {
    int longest = present.stream().mapToInt(booking -> booking.route.length).max().orElse(0);
    return 2 * longest + 512;
  }

  private static void book(
      Booking booking, int goal, StateGraph graph, Timetable timetable, SafeIntervalSearch search) {
    int state = booking.route[0];
    boolean ends = graph.vertex(booking.route[booking.route.length - 1]) == goal;
    if (goal == NONE || (booking.goal == goal && ends)) {
      return;
    }
    char[] distances = booking.distances;
    if (booking.goal != goal || distances == null) {
      distances = StateDistances.to(graph, goal);
      booking.goal = goal;
      booking.distances = distances;
    }
    timetable.remove(vertices(graph, booking.route));
    int[] route = search.route(state, goal, distances, timetable.end());
    booking.route = route == null ? booking.route : route;
    timetable.add(vertices(graph, booking.route));
  }

  private static int[] vertices(StateGraph graph, int[] route) {
    return Arrays.stream(route).map(graph::vertex).toArray();
  }

  private static TrafficPlan report(
      TrafficScene scene, Attendance attendance, List<Booking> present) {
    Itinerary[] itineraries = new Itinerary[scene.robots().size()];
    for (int robot = 0; robot < itineraries.length; robot++) {
      TrafficRobot asked = scene.robots().get(robot);
      itineraries[robot] = new Itinerary(List.of(asked.stance()), attendance.prospect(robot));
    }
    for (int k = 0; k < attendance.size(); k++) {
      int robot = attendance.robot(k);
      int[] route = present.get(k).route;
      List<Stance> stances = new ArrayList<>();
      stances.add(scene.robots().get(robot).stance());
      for (int t = 1; t <= HORIZON; t++) {
        stances.add(attendance.stance(robot, route[Math.min(t, route.length - 1)]));
      }
      Prospect prospect = attendance.prospect(robot);
      itineraries[robot] = new Itinerary(stances, prospect);
    }
    return new TrafficPlan(List.of(itineraries));
  }
}
