package org.toqa.fleet.dispatch;

import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/** On which floor each task is that has not ended, or whose load lies there. Any thread may ask. */
public final class TaskFloors {
  private final Map<Long, String> open = new ConcurrentHashMap<>();

  /** By floor: the ended tasks whose loads lie there. */
  private final Map<String, Set<Long>> leftLoads = new ConcurrentHashMap<>();

  void addOpen(long task, String floor) {
    open.put(task, floor);
  }

  void removeOpen(long task) {
    open.remove(task);
  }

  void setLeftLoads(String floor, Set<Long> tasks) {
    leftLoads.put(floor, tasks);
  }

  boolean hasLeftLoad(String floor, long task) {
    return leftLoads.getOrDefault(floor, Set.of()).contains(task);
  }

  public Optional<String> floorOf(long task) {
    return Optional.ofNullable(open.get(task))
        .or(
            () ->
                leftLoads.entrySet().stream()
                    .filter(entry -> entry.getValue().contains(task))
                    .map(Map.Entry::getKey)
                    .findFirst());
  }

  /** How many are on the floor that have not ended. */
  public int openCount(String floor) {
    return (int) open.values().stream().filter(floor::equals).count();
  }

  /** How many loads of ended tasks lie on the floor. */
  public int leftLoadCount(String floor) {
    return leftLoads.getOrDefault(floor, Set.of()).size();
  }
}
