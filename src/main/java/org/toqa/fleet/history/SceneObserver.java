package org.toqa.fleet.history;

import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.FloorView;
import org.toqa.fleet.LoadView;
import org.toqa.fleet.RobotView;
import org.toqa.geometry.Polyline;
import org.toqa.geometry.Vec2;

/**
 * Finds in one snapshot after the other where a load comes to be elsewhere and a robot gets another
 * path. A floor that has not reported yet, as after a start, is left as it was.
 */
final class SceneObserver {
  private final Map<Long, LoadPlace> loads = new HashMap<>(); // by load, those that have not ended
  private final Map<String, PlannedPath> paths = new HashMap<>(); // by robot, likewise
  private final Map<Object, LoadPlace> changedLoads = new LinkedHashMap<>();
  private final Map<Object, PlannedPath> changedPaths = new LinkedHashMap<>();

  private record Key(Object of, Instant from) {}

  /** Loads and paths that have changed. */
  record Changes(List<LoadPlace> loads, List<PlannedPath> paths) {
    boolean isEmpty() {
      return loads.isEmpty() && paths.isEmpty();
    }
  }

  /**
   * @param openLoads what had not ended when the server did
   * @param openPaths likewise
   */
  SceneObserver(List<LoadPlace> openLoads, List<PlannedPath> openPaths) {
    openLoads.forEach(load -> loads.put(load.load(), load));
    openPaths.forEach(path -> paths.put(path.robot(), path));
  }

  void observe(FleetSnapshot snapshot) {
    Set<String> floors =
        snapshot.floors().stream().map(FloorView::name).collect(Collectors.toSet());
    observeLoads(snapshot, floors);
    observePaths(snapshot, floors);
  }

  private void observeLoads(FleetSnapshot snapshot, Set<String> floors) {
    Map<Long, LoadPlace> now = new HashMap<>();
    for (LoadView view : LoadView.of(snapshot)) {
      now.put(view.id(), LoadPlace.of(view, snapshot.at()));
    }
    for (LoadPlace before : List.copyOf(loads.values())) {
      LoadPlace next = now.get(before.load());
      boolean isGone = next == null ? floors.contains(before.floor()) : !next.isLike(before);
      if (isGone) {
        loads.remove(before.load());
        change(before.endedAt(snapshot.at()));
      }
    }
    for (LoadPlace load : now.values()) {
      if (floors.contains(load.floor()) && loads.putIfAbsent(load.load(), load) == null) {
        change(load);
      }
    }
  }

  private void observePaths(FleetSnapshot snapshot, Set<String> floors) {
    Map<String, RobotView> robots = new HashMap<>();
    snapshot.robots().forEach(robot -> robots.put(robot.name(), robot));
    for (PlannedPath before : List.copyOf(paths.values())) {
      if (floors.contains(before.floor()) && !isOn(before, robots.get(before.robot()))) {
        paths.remove(before.robot());
        change(before.endedAt(snapshot.at()));
      }
    }
    for (RobotView robot : snapshot.robots()) {
      if (floors.contains(robot.floor()) && hasPath(robot) && !paths.containsKey(robot.name())) {
        PlannedPath path =
            new PlannedPath(robot.name(), robot.floor(), snapshot.at(), null, points(robot));
        paths.put(robot.name(), path);
        change(path);
      }
    }
  }

  /** Whether the robot has the rest of that path ahead. */
  private static boolean isOn(PlannedPath path, @Nullable RobotView robot) {
    return robot != null
        && robot.floor().equals(path.floor())
        && hasPath(robot)
        && path.endsWith(points(robot));
  }

  private static boolean hasPath(RobotView robot) {
    return robot.pathPoints().size() > 1;
  }

  private static List<Vec2> points(RobotView robot) {
    return robot.pathPoints().stream().map(Polyline::toMillimetres).toList();
  }

  private void change(LoadPlace load) {
    changedLoads.put(new Key(load.load(), load.from()), load);
  }

  private void change(PlannedPath path) {
    changedPaths.put(new Key(path.robot(), path.from()), path);
  }

  /** What has changed and was not yet said to be stored; the oldest first. */
  Changes changes() {
    return new Changes(
        new ArrayList<>(changedLoads.values()), new ArrayList<>(changedPaths.values()));
  }

  /** They need not be told again. */
  void forgetChanges() {
    changedLoads.clear();
    changedPaths.clear();
  }
}
