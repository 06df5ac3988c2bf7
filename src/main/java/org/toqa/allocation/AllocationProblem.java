package org.toqa.allocation;

import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/**
 * What an allocator knows of a floor.
 *
 * @param low the floor's lower left corner, metres, map frame
 * @param high the floor's upper right corner, metres, map frame
 * @param terrain what the map tells
 * @param waiting tasks that no robot has, the most urgent ones at least
 * @param givenTasks tasks that robots have but whose loads are not picked up, as far as they may
 *     still go to other robots; no two of one robot
 * @param robots all of the floor
 * @param placesInUse places where tasks that have robots are being fetched or set down
 * @param received what the robots' agents said of the tasks; null: it is computed here
 */
public record AllocationProblem(
    Instant now,
    Vec2 low,
    Vec2 high,
    Terrain terrain,
    List<AllocationTask> waiting,
    List<GivenTask> givenTasks,
    List<Candidate> robots,
    List<PlaceUse> placesInUse,
    @Nullable ReceivedQuotes received) {

  /** A task that a robot has and that another one may still take over. */
  public record GivenTask(AllocationTask task, String robot) {}

  public AllocationProblem(
      Instant now,
      Vec2 low,
      Vec2 high,
      Terrain terrain,
      List<AllocationTask> waiting,
      List<GivenTask> givenTasks,
      List<Candidate> robots,
      List<PlaceUse> placesInUse) {
    this(now, low, high, terrain, waiting, givenTasks, robots, placesInUse, null);
  }

  public AllocationProblem {
    waiting = waiting.stream().sorted(AllocationTask.BY_PRECEDENCE).toList();
    givenTasks = List.copyOf(givenTasks);
    robots = List.copyOf(robots);
    placesInUse = List.copyOf(placesInUse);
  }

  /** What robots would carry the tasks for. */
  Quotes quotes() {
    return received == null ? new Costs(terrain) : received;
  }

  AllocationProblem withWaiting(List<AllocationTask> nextWaiting, List<Candidate> nextRobots) {
    return new AllocationProblem(
        now, low, high, terrain, nextWaiting, givenTasks, nextRobots, placesInUse, received);
  }

  /** The same with this task alone. */
  public AllocationProblem withTask(AllocationTask task) {
    return withWaiting(List.of(task), robots);
  }

  /** All robots, those busy that these decisions give something to. */
  List<Candidate> robotsAfter(List<Decision> decisions) {
    Map<String, Long> taken = new HashMap<>();
    for (Decision decision : decisions) {
      if (decision instanceof Decision.Assigned assigned) {
        assigned.robots().forEach(robot -> taken.put(robot, assigned.task()));
      }
    }
    return robots.stream()
        .map(r -> taken.containsKey(r.robot()) ? r.withTask(taken.get(r.robot())) : r)
        .toList();
  }

  List<Candidate> freeRobots() {
    return robots.stream().filter(Candidate::isFree).toList();
  }
}
