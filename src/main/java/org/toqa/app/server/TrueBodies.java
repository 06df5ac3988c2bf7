package org.toqa.app.server;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Supplier;
import org.toqa.fleet.FleetSnapshot;
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
    fleet.get().tasks().stream()
        .filter(task -> task.task().floor().equals(floor))
        .filter(task -> task.state() == TaskState.CARRYING)
        .filter(task -> task.robots().size() > 1 || task.task().size() != null)
        .flatMap(task -> load(task).stream())
        .forEach(bodies::add);
    return bodies;
  }

  /**
   * On its carrier; or several are all round its middle, the leader in front, see {@link
   * org.toqa.formation.Shape}.
   */
  private Optional<Body> load(TaskView task) {
    List<Vec2> places =
        task.robots().stream()
            .flatMap(robot -> robots.truePose(robot).stream())
            .map(Pose::position)
            .toList();
    if (places.size() < task.robots().size()) {
      return Optional.empty();
    }
    Vec2 middle = places.stream().reduce(Vec2.ZERO, Vec2::plus).times(1.0 / places.size());
    double heading =
        places.size() == 1
            ? robots.truePose(task.robots().getFirst()).orElseThrow().theta()
            : places.getFirst().minus(middle).angle();
    LoadSize size = Objects.requireNonNullElse(task.task().size(), LoadSize.DEFAULT);
    return Optional.of(
        Body.load(
            "load of task " + task.task().id(),
            new Pose(middle.x(), middle.y(), heading),
            size.length(),
            size.width(),
            new HashSet<>(task.robots())));
  }
}
