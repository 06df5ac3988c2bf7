package org.toqa.fleet;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.toqa.wording.Sentence;

/**
 * The whole fleet at one moment, immutable.
 *
 * @param version rises with every change
 * @param robots by name
 * @param tasks those that robots have, the first ones of the queue, and those that ended last;
 *     newest first
 * @param queuedCount how many tasks wait in the queue, also those that are not among {@code tasks}
 * @param floors those that have reported, in their order
 * @param pause null while the fleet is not paused
 * @param negotiations by task, what was last said of it by robots' agents; the oldest first
 * @param allocators by floor, the word of the one that a manager has chosen
 * @param alerts what concerns the whole fleet, such as a store that does not answer
 */
public record FleetSnapshot(
    long version,
    Instant at,
    List<RobotView> robots,
    List<TaskView> tasks,
    int queuedCount,
    List<FloorView> floors,
    @Nullable Hold pause,
    Map<Long, List<NegotiationEntry>> negotiations,
    Map<String, String> allocators,
    List<Sentence> alerts) {

  public FleetSnapshot {
    robots = List.copyOf(robots);
    tasks = List.copyOf(tasks);
    floors = List.copyOf(floors);
    negotiations = Map.copyOf(negotiations);
    allocators = Map.copyOf(allocators);
    alerts = List.copyOf(alerts);
  }

  /** Of a fleet that nothing is known of yet but whether it is paused. */
  public static FleetSnapshot initial(Instant at, @Nullable Hold pause) {
    return new FleetSnapshot(
        0, at, List.of(), List.of(), 0, List.of(), pause, Map.of(), Map.of(), List.of());
  }

  /** The same with another version and other alerts. */
  public FleetSnapshot with(long otherVersion, List<Sentence> otherAlerts) {
    return new FleetSnapshot(
        otherVersion,
        at,
        robots,
        tasks,
        queuedCount,
        floors,
        pause,
        negotiations,
        allocators,
        otherAlerts);
  }

  /** The same with other views of its floors. */
  public FleetSnapshot withFloors(List<FloorView> others) {
    return new FleetSnapshot(
        version, at, robots, tasks, queuedCount, others, pause, negotiations, allocators, alerts);
  }

  /** The same with other views of its robots. */
  public FleetSnapshot withRobots(List<RobotView> others) {
    return new FleetSnapshot(
        version, at, others, tasks, queuedCount, floors, pause, negotiations, allocators, alerts);
  }
}
