package org.toqa.fleet;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FloorView.LeftLoad;
import org.toqa.geometry.Vec2;
import org.toqa.mission.LoadRecord;
import org.toqa.mission.OrderPart;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask.LoadSize;

/**
 * A load and where it is: where it waits to be fetched, on its robots, or where it was set down.
 * What was delivered is on its goal until its robots have parked, and then none of the fleet's.
 *
 * @param load which one, and since when it is there
 * @param name of the task that brought it there, or brings it
 * @param weight kilograms
 * @param place metres, map frame; null: on its robots
 * @param robots that carry it, the leader first
 * @param task that it was ordered for, or that left it there
 * @param fetchedBy the task that will fetch it where another one left it; null: none yet
 * @param isLeft whether its task has ended and left it on the floor
 */
public record LoadView(
    LoadRecord load,
    String name,
    String floor,
    double weight,
    @Nullable LoadSize size,
    @Nullable TaskPlace place,
    List<String> robots,
    long task,
    @Nullable Long fetchedBy,
    boolean isLeft) {

  /** Metres; whoever fetches a load of its weight and size so near to where it lies fetches it. */
  public static final double SAME_PLACE = 0.05;

  public LoadView {
    robots = List.copyOf(robots);
  }

  public long id() {
    return load.id();
  }

  public LoadView withPlace(@Nullable TaskPlace named) {
    return new LoadView(load, name, floor, weight, size, named, robots, task, fetchedBy, isLeft);
  }

  /** All that a snapshot knows of, the newest first. */
  public static List<LoadView> of(FleetSnapshot snapshot) {
    Map<String, FloorView> floors =
        snapshot.floors().stream().collect(Collectors.toMap(FloorView::name, Function.identity()));
    List<LoadView> loads = new ArrayList<>();
    for (TaskView task : snapshot.tasks()) {
      FloorView floor = floors.get(task.task().floor());
      if (isKnown(task) && (floor == null || leftLoadFor(task, floor) == null)) {
        loads.add(of(task));
      }
    }
    for (FloorView floor : snapshot.floors()) {
      floor.leftLoads().forEach(left -> loads.add(of(left, floor, snapshot.tasks())));
    }
    loads.sort(Comparator.comparingLong(LoadView::id).reversed());
    return loads;
  }

  /** A leg that waits for the one before has its load there. */
  private static boolean isKnown(TaskView task) {
    OrderPart part = task.task().part();
    boolean isWithOther = task.state() == TaskState.QUEUED && part != null && part.awaitsPrevious();
    return !task.state().isEnded() && !isWithOther && !task.task().isDrive();
  }

  /** What it will fetch where another task left it. */
  private static @Nullable LeftLoad leftLoadFor(TaskView task, FloorView floor) {
    boolean isStillToFetch =
        !task.state().isEnded()
            && task.state() != TaskState.CARRYING
            && task.state() != TaskState.RETURNING;
    return isStillToFetch
        ? floor.leftLoads().stream()
            .filter(left -> left.where().distanceTo(task.object().position()) < SAME_PLACE)
            .filter(left -> task.task().hasLoadOf(left.weight(), left.size()))
            .findFirst()
            .orElse(null)
        : null;
  }

  private static LoadView of(TaskView task) {
    boolean isOnBoard = task.state() == TaskState.CARRYING;
    boolean isDelivered = task.state() == TaskState.RETURNING;
    return new LoadView(
        task.load(),
        task.task().name(),
        task.task().floor(),
        task.task().load(),
        task.task().size(),
        isOnBoard ? null : isDelivered ? task.task().goal() : task.object(),
        isOnBoard ? task.robots() : List.of(),
        task.id(),
        null,
        false);
  }

  private static LoadView of(LeftLoad left, FloorView floor, List<TaskView> tasks) {
    Vec2 where = left.where();
    return new LoadView(
        left.load(),
        left.name(),
        floor.name(),
        left.weight(),
        left.size(),
        new TaskPlace(where, null),
        List.of(),
        left.task(),
        tasks.stream()
            .filter(task -> task.task().floor().equals(floor.name()))
            .filter(task -> left.equals(leftLoadFor(task, floor)))
            .map(TaskView::id)
            .findFirst()
            .orElse(null),
        true);
  }
}
