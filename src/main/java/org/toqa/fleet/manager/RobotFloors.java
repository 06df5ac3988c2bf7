package org.toqa.fleet.manager;

import java.util.Collection;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import org.toqa.fleet.RobotRecord;

/** On which floor each robot is; no two have the same name. Any thread may call it. */
final class RobotFloors {
  /** By name, without regard to case. */
  private final Map<String, Entry> entries = new ConcurrentHashMap<>();

  /** Where robots are being moved, by their names without regard to case. */
  private final Map<String, String> coming = new ConcurrentHashMap<>();

  private record Entry(String robot, String floor) {}

  RobotFloors(Collection<RobotRecord> robots) {
    robots.forEach(robot -> set(robot.name(), robot.floor()));
  }

  private static String key(String robot) {
    return robot.toLowerCase(Locale.ROOT);
  }

  /**
   * Takes the name for a robot of that floor.
   *
   * @return false: another has it
   */
  boolean reserve(String robot, String floor) {
    return entries.putIfAbsent(key(robot), new Entry(robot, floor)) == null;
  }

  /** The floor is not empty until {@link #set} or {@link #stay}. */
  void come(String robot, String floor) {
    coming.put(key(robot), floor);
  }

  /** It has not come, and is where it was. */
  void stay(String robot) {
    coming.remove(key(robot));
  }

  void set(String robot, String floor) {
    entries.put(key(robot), new Entry(robot, floor));
    coming.remove(key(robot));
  }

  void remove(String robot) {
    entries.remove(key(robot));
  }

  Optional<String> floorOf(String robot) {
    return Optional.ofNullable(entries.get(key(robot)))
        .filter(entry -> entry.robot().equals(robot))
        .map(Entry::floor);
  }

  /** How many are on the floor, or on their way there. */
  int count(String floor) {
    return (int)
        Stream.concat(entries.values().stream().map(Entry::floor), coming.values().stream())
            .filter(floor::equals)
            .count();
  }
}
