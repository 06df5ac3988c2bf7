package org.toqa.fleet.dispatch;

import java.time.Duration;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.PathLengths;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;

/**
 * When a task can be delivered at the earliest: by the robot that has it, or else by the one that
 * could be there first, after what it carries now. A bound, not a plan: nobody blocks its path, and
 * no other task comes before it.
 */
final class DeliveryForecast {
  private final PathLengths travel;
  private final List<RobotView> robots;
  private final Map<Long, TaskView> assigned;

  /**
   * @param left until it is delivered, of the fleet's time
   */
  record Delivery(String robot, Duration left) {}

  /**
   * For the tasks of one floor.
   *
   * @param assigned tasks that robots have
   */
  DeliveryForecast(PathLengths travel, List<RobotView> robots, List<TaskView> assigned) {
    this.travel = travel;
    this.robots = robots;
    this.assigned = assigned.stream().collect(Collectors.toMap(TaskView::id, task -> task));
  }

  /**
   * @return empty where no robot can carry it alone now
   */
  Optional<Delivery> earliestDelivery(TaskView task) {
    Stream<RobotView> able =
        task.robots().isEmpty()
            ? robots.stream().filter(r -> r.maxLoad() >= task.task().load())
            : robots.stream().filter(r -> task.robots().contains(r.name()));
    return able.flatMap(robot -> metres(task, robot).stream().map(m -> deliveryAfter(robot, m)))
        .min(Comparator.comparing(Delivery::left));
  }

  private static Delivery deliveryAfter(RobotView robot, double metres) {
    double seconds = metres / robot.speed();
    return new Delivery(robot.name(), Duration.ofMillis(Math.round(1000 * seconds)));
  }

  private Optional<Double> metres(TaskView task, RobotView robot) {
    Pose pose = robot.telemetry().pose();
    if (pose == null || !robot.state().isFit()) {
      return Optional.empty();
    }
    Long currentId = robot.work().task();
    TaskView current = currentId == null ? null : assigned.get(currentId);
    double metres = remainingMetres(robot, pose.position(), task, current);
    return Double.isFinite(metres) ? Optional.of(metres) : Optional.empty();
  }

  private double remainingMetres(
      RobotView robot, Vec2 position, TaskView task, @Nullable TaskView current) {
    if (current != null && current.id() == task.id()) {
      return metresToDelivery(robot, position, task);
    }
    if (current == null || current.state() == TaskState.RETURNING) {
      return metresToDelivery(robot, position, task);
    }
    return metresToDelivery(robot, position, current)
        + metresToDelivery(robot, current.task().goal().position(), task);
  }

  /** With the load on board, or through where it is. */
  private double metresToDelivery(RobotView robot, Vec2 from, TaskView task) {
    double metres = 0;
    Vec2 at = from;
    for (TaskPlace place : task.placesAhead()) {
      metres += metres(robot, at, place.position());
      at = place.position();
    }
    return metres;
  }

  private double metres(RobotView robot, Vec2 from, Vec2 to) {
    return travel.lengthsTo(to, robot.capabilities().footprint()).applyAsDouble(from);
  }
}
