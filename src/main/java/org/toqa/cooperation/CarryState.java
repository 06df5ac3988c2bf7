package org.toqa.cooperation;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.toqa.cooperation.KnownBox.Stage;
import org.toqa.cooperation.KnownRobot.Activity;
import org.toqa.geometry.Vec2;

/**
 * All that is known: by the supervisor, or among workers without one.
 *
 * @param supervisor who alone has cameras and orders; without one each worker has cameras, goes for
 *     what it has seen itself, and they tell each other what they go for
 * @param boxes that were seen, by number
 * @param robots by name
 * @param occupied charging stations, by number, with the robot that was sent there and has not left
 * @param stations metres, map frame
 * @param haveSeenAll robots with cameras for which nothing of the store is unseen
 * @param asked boxes for which a person was asked to bring a worker
 */
public record CarryState(
    @Nullable String supervisor,
    Map<Integer, KnownBox> boxes,
    Map<String, KnownRobot> robots,
    Map<Integer, String> occupied,
    List<Vec2> stations,
    Set<String> haveSeenAll,
    List<Integer> asked) {

  public CarryState {
    boxes = new TreeMap<>(boxes);
    robots = new LinkedHashMap<>(robots);
    occupied = new TreeMap<>(occupied);
    stations = List.copyOf(stations);
    haveSeenAll = Set.copyOf(haveSeenAll);
    asked = List.copyOf(asked);
  }

  /** Of what has just started: robots are known by name, and no box. */
  public static CarryState begin(
      @Nullable String supervisor, List<String> workers, List<Vec2> stations) {
    Map<String, KnownRobot> robots = new LinkedHashMap<>();
    KnownRobot unknown = new KnownRobot(Activity.LOST, null, Vec2.ZERO, 1, 0);
    if (supervisor != null) {
      robots.put(supervisor, unknown.doing(Activity.IDLE));
    }
    workers.forEach(worker -> robots.put(worker, unknown));
    return new CarryState(supervisor, Map.of(), robots, Map.of(), stations, Set.of(), List.of());
  }

  /** Whether the store is seen and each box in it is at its target. */
  public boolean isDone() {
    return searchers().stream().anyMatch(haveSeenAll::contains)
        && boxes.values().stream().allMatch(box -> box.stage() == Stage.DELIVERED);
  }

  /** The robots with cameras that are heard. */
  List<String> searchers() {
    return supervisor != null
        ? List.of(supervisor)
        : workers().stream().filter(w -> robot(w).activity() != Activity.LOST).toList();
  }

  List<String> workers() {
    return robots.keySet().stream().filter(name -> !name.equals(supervisor)).toList();
  }

  KnownRobot robot(String name) {
    KnownRobot robot = robots.get(name);
    if (robot == null) {
      throw new IllegalArgumentException("There is no robot " + name + ".");
    }
    return robot;
  }

  KnownBox box(int number) {
    KnownBox box = boxes.get(number);
    if (box == null) {
      throw new IllegalArgumentException("There is no box " + number + ".");
    }
    return box;
  }

  CarryState with(String name, KnownRobot robot) {
    Map<String, KnownRobot> changed = new LinkedHashMap<>(robots);
    changed.put(name, robot);
    return new CarryState(supervisor, boxes, changed, occupied, stations, haveSeenAll, asked);
  }

  CarryState with(int number, KnownBox box) {
    Map<Integer, KnownBox> changed = new TreeMap<>(boxes);
    changed.put(number, box);
    return new CarryState(supervisor, changed, robots, occupied, stations, haveSeenAll, asked);
  }

  CarryState seenAll(String robot) {
    Set<String> more = new TreeSet<>(haveSeenAll);
    more.add(robot);
    return new CarryState(supervisor, boxes, robots, occupied, stations, more, asked);
  }

  /** What was seen counts no more. */
  CarryState seenNothing() {
    return new CarryState(supervisor, boxes, robots, occupied, stations, Set.of(), asked);
  }

  CarryState askedFor(int number) {
    List<Integer> more = new ArrayList<>(asked);
    more.add(number);
    return new CarryState(supervisor, boxes, robots, occupied, stations, haveSeenAll, more);
  }

  CarryState occupying(int station, String robot) {
    Map<Integer, String> changed = new TreeMap<>(occupied);
    changed.put(station, robot);
    return new CarryState(supervisor, boxes, robots, changed, stations, haveSeenAll, asked);
  }

  /** A robot has been sent away from its station. */
  CarryState leaving(String robot) {
    Map<Integer, String> changed = new TreeMap<>(occupied);
    changed.values().removeIf(robot::equals);
    return new CarryState(supervisor, boxes, robots, changed, stations, haveSeenAll, asked);
  }
}
