package org.toqa.fleet.dispatch;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.PlaceUse;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Pose;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;

/** Where the robots of a floor fetch loads and set them down, now or soon. */
final class PlacesInUse {
  private PlacesInUse() {}

  /**
   * @param missions tasks that have robots
   * @param robots of the floor
   */
  static List<PlaceUse> of(Stream<TaskView> missions, List<RobotView> robots) {
    List<PlaceUse> uses = new ArrayList<>();
    Map<Long, List<Pose>> posesByTask = posesByTask(robots);
    missions.forEach(
        task -> {
          List<Pose> stand = posesByTask.getOrDefault(task.id(), List.of());
          @Nullable TaskPlace here = placeOfWait(task);
          add(uses, task, task.object(), isComingForLoad(task), here, stand);
          task.task()
              .placesFrom(task.task().stopAfterFirst(task.progress()))
              .forEach(place -> add(uses, task, place, isComing(task), here, stand));
        });
    return List.copyOf(uses);
  }

  /**
   * @param here where its robots wait, round the load; null: they do not
   */
  private static void add(
      List<PlaceUse> uses,
      TaskView task,
      TaskPlace place,
      boolean isComing,
      @Nullable TaskPlace here,
      List<Pose> stand) {
    boolean isThere =
        place.equals(here)
            || stand.stream()
                .anyMatch(pose -> pose.position().distanceTo(place.position()) < PlaceUse.REACH);
    if (isComing || isThere) {
      uses.add(new PlaceUse(task.id(), place.position(), task.robots().size() > 1));
    }
  }

  private static boolean isComingForLoad(TaskView task) {
    return isComing(task) && task.state() != TaskState.CARRYING;
  }

  /** What a person must see to first may take hours, and keeps nobody else away. */
  private static boolean isComing(TaskView task) {
    return !task.held()
        && task.needs() == null
        && !isAwaitingPerson(task)
        && switch (task.state()) {
          case ASSIGNED, TO_OBJECT, CARRYING -> true;
          case QUEUED, RETURNING, DONE, FAILED, CANCELLED -> false;
        };
  }

  private static boolean isAwaitingPerson(TaskView task) {
    return placeOfWait(task) != null
        && task.task().route().get(task.progress().stop()).awaitsPersonAlone();
  }

  /** The stop at which its robots wait; null: they do not. */
  private static @Nullable TaskPlace placeOfWait(TaskView task) {
    return task.progress().waitingSince() == null
        ? null
        : task.task().route().get(task.progress().stop()).place();
  }

  /** Where those are who still work for a task. */
  private static Map<Long, List<Pose>> posesByTask(List<RobotView> robots) {
    Map<Long, List<Pose>> poses = new HashMap<>();
    for (RobotView robot : robots) {
      Long task = robot.work().task();
      Pose pose = robot.telemetry().pose();
      if (task != null && pose != null) {
        poses.computeIfAbsent(task, _ -> new ArrayList<>()).add(pose);
      }
    }
    return poses;
  }
}
