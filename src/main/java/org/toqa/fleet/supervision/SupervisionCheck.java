package org.toqa.fleet.supervision;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.arm.Arm;
import org.toqa.fleet.Answer;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.RobotView;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** What speaks against a supervision before it begins. */
final class SupervisionCheck {
  private SupervisionCheck() {}

  static Optional<Answer<Supervision>> objection(
      SupervisionOrder order, List<FloorMap> floors, FleetSnapshot snapshot) {
    Optional<FloorMap> floor =
        floors.stream().filter(f -> f.name().equals(order.floor())).findFirst();
    if (floor.isEmpty()) {
      return Optional.of(new Answer.Unknown<>(Phrase.NO_SUCH_FLOOR.with(order.floor())));
    }
    Optional<RobotView> supervisor = robot(order.supervisor(), order, snapshot);
    if (supervisor.isEmpty()) {
      return rejected("supervisor", notHere(order.supervisor(), order));
    }
    if (supervisor.get().telemetry().readings().camera() == null) {
      return rejected("supervisor", Phrase.SUPERVISION_NEEDS_CAMERA.with(order.supervisor()));
    }
    Arm arm = null;
    for (String name : order.workers()) {
      Optional<RobotView> worker = robot(name, order, snapshot);
      if (worker.isEmpty()) {
        return rejected("workers", notHere(name, order));
      }
      if (name.equals(order.supervisor())) {
        return rejected("workers", Phrase.SUPERVISION_WORKS_NOT.with(name));
      }
      Arm mounted = worker.get().capabilities().arm();
      if (mounted == null) {
        return rejected("workers", Phrase.SUPERVISION_NEEDS_ARM.with(name));
      }
      arm = mounted;
    }
    return arm == null
        ? rejected("workers", Phrase.SUPERVISION_NEEDS_ARM.with(""))
        : objectionToTargets(order, floor.get(), supervisor.get(), arm);
  }

  private static Optional<Answer<Supervision>> objectionToTargets(
      SupervisionOrder order, FloorMap floor, RobotView supervisor, Arm arm) {
    double clearance = supervisor.capabilities().footprint() / 2 + floor.margins().robot();
    OccupancyGrid drivable = new DrivableArea(floor, clearance).among(List.of());
    for (Map.Entry<Integer, Vec2> box : order.targets().entrySet()) {
      if (HandlingPlaces.round(box.getValue(), arm, drivable).isEmpty()) {
        return rejected(
            "boxes",
            Phrase.SUPERVISION_TARGET_UNREACHABLE.with(box.getKey(), Sentence.of(box.getValue())));
      }
    }
    return Optional.empty();
  }

  private static Optional<RobotView> robot(
      String name, SupervisionOrder order, FleetSnapshot snapshot) {
    return SupervisionRules.robot(snapshot, name)
        .filter(robot -> robot.floor().equals(order.floor()));
  }

  private static Sentence notHere(String name, SupervisionOrder order) {
    return Phrase.SUPERVISION_NO_ROBOT.with(name, order.floor());
  }

  private static Optional<Answer<Supervision>> rejected(@Nullable String field, Sentence why) {
    return Optional.of(new Answer.Rejected<>(field, why));
  }
}
