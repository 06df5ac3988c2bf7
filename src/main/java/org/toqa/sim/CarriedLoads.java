package org.toqa.sim;

import java.util.HashMap;
import java.util.Map;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.SharedLoad;
import org.toqa.geometry.Pose;

/** The loads of a simulated world that several robots carry. May be used by any thread. */
final class CarriedLoads {
  private final Map<Long, CarriedLoad> loads = new HashMap<>();

  /** By robot, the task of the load that lies on it. */
  private final Map<String, Long> tasks = new HashMap<>();

  /** Those that may be among them; null: there are none. */
  private @Nullable SimulatedBoxes boxes;

  synchronized void setBoxes(SimulatedBoxes there) {
    boxes = there;
  }

  /**
   * A robot tells what lies on it; at each of its ticks.
   *
   * @param load null: nothing that others carry too
   * @param truth where the robot really is, map frame
   */
  synchronized void put(String robot, @Nullable SharedLoad load, Pose truth) {
    Long before = tasks.get(robot);
    if (before != null && (load == null || load.task() != before)) {
      takeAway(robot, before);
    }
    if (load != null) {
      tasks.put(robot, load.task());
      loads.computeIfAbsent(load.task(), _ -> lift(load)).put(robot, load, truth);
    }
  }

  private CarriedLoad lift(SharedLoad load) {
    if (boxes != null) {
      boxes.lift(load.task(), load.middle());
    }
    return new CarriedLoad(load);
  }

  private void takeAway(String robot, long task) {
    tasks.remove(robot);
    CarriedLoad load = loads.get(task);
    if (load != null && load.takeAway(robot)) {
      loads.remove(task);
      if (boxes != null) {
        boxes.setDown(task, load.middle());
      }
    }
  }

  /** Kilograms that the robot bears; empty where the load does not lie on all its robots. */
  synchronized OptionalDouble shareOf(String robot) {
    Long task = tasks.get(robot);
    CarriedLoad load = task == null ? null : loads.get(task);
    return load == null ? OptionalDouble.empty() : load.shareOf(robot);
  }
}
