package org.toqa.app.server;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Supplier;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.FloorView.HoldPoint;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.sim.Body;
import org.toqa.sim.SimulatedFleet;

/**
 * What is really where on a simulated floor: the robots, and the loads that several of them carry.
 * The fleet says only who carries what; where a load is follows from where its carriers really are.
 */
public final class TrueBodies {
  private final SimulatedFleet robots;
  private final Supplier<FleetSnapshot> fleet;

  /**
   * @param fleet what it does now
   */
  public TrueBodies(SimulatedFleet robots, Supplier<FleetSnapshot> fleet) {
    this.robots = robots;
    this.fleet = fleet;
  }

  /** All of them on that floor, now. */
  public List<Body> on(String floor) {
    List<Body> bodies = new ArrayList<>(robots.bodies(floor));
    FleetSnapshot now = fleet.get();
    now.tasks().stream()
        .filter(task -> task.task().floor().equals(floor))
        .filter(task -> task.state() == TaskState.CARRYING)
        .filter(task -> task.robots().size() > 1 || task.task().size() != null)
        .flatMap(task -> load(task, now).stream())
        .forEach(bodies::add);
    return bodies;
  }

  /**
   * On its carrier; or where several are round it as the fleet says, as near as a rigid body can
   * be.
   */
  private Optional<Body> load(TaskView task, FleetSnapshot now) {
    List<Pose> truths =
        task.robots().stream().flatMap(robot -> robots.truePose(robot).stream()).toList();
    if (truths.size() < task.robots().size()) {
      return Optional.empty();
    }
    LoadSize size = Objects.requireNonNullElse(task.task().size(), LoadSize.DEFAULT);
    return pose(task, truths, now)
        .map(
            pose ->
                Body.load(
                    "load of task " + task.task().id(),
                    pose,
                    size.length(),
                    size.width(),
                    new HashSet<>(task.robots())));
  }

  private static Optional<Pose> pose(TaskView task, List<Pose> truths, FleetSnapshot now) {
    if (truths.size() == 1) {
      return Optional.of(truths.getFirst());
    }
    return now.floors().stream()
        .flatMap(floor -> floor.heldLoads().stream())
        .filter(held -> held.task() == task.id() && held.points().size() == truths.size())
        .findFirst()
        .map(
            held ->
                fitted(
                    held.points().stream().map(HoldPoint::place).toList(),
                    truths.stream().map(Pose::position).toList()));
  }

  /**
   * The pose of a frame in which those points are as near as can be to where they are on the map,
   * by least squares (Arun, Huang, Blostein, "Least-squares fitting of two 3-D point sets", 1987).
   */
  private static Pose fitted(List<Vec2> inFrame, List<Vec2> onMap) {
    Vec2 middleInFrame = mean(inFrame);
    Vec2 middleOnMap = mean(onMap);
    double along = 0;
    double across = 0;
    for (int i = 0; i < inFrame.size(); i++) {
      Vec2 from = inFrame.get(i).minus(middleInFrame);
      Vec2 to = onMap.get(i).minus(middleOnMap);
      along += from.x() * to.x() + from.y() * to.y();
      across += from.x() * to.y() - from.y() * to.x();
    }
    double heading = Math.atan2(across, along);
    Vec2 origin = middleOnMap.minus(middleInFrame.rotated(heading));
    return new Pose(origin.x(), origin.y(), heading);
  }

  private static Vec2 mean(List<Vec2> points) {
    return points.stream().reduce(Vec2.ZERO, Vec2::plus).times(1.0 / points.size());
  }
}
