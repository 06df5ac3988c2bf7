package org.toqa.fleet.dispatch;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;

/** On which floor each task is that has not ended. Any thread may ask. */
public final class OpenTasks {
  private final Map<Long, String> floors = new ConcurrentHashMap<>();

  void add(long task, String floor) {
    floors.put(task, floor);
  }

  void remove(long task) {
    floors.remove(task);
  }

  public Optional<String> floorOf(long task) {
    return Optional.ofNullable(floors.get(task));
  }

  /** How many are on the floor. */
  public int count(String floor) {
    return (int) floors.values().stream().filter(floor::equals).count();
  }
}
