package org.toqa.fleet.supervision;

import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.arm.Arm;
import org.toqa.fleet.Answer;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.MapProblem;
import org.toqa.fleet.RobotView;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** What speaks against a supervision before it begins, and against maps while it runs. */
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
    OccupancyGrid drivable = new DrivableArea(floor, clearance(floor, supervisor)).among(List.of());
    for (Map.Entry<Integer, Vec2> box : order.targets().entrySet()) {
      if (HandlingPlaces.round(box.getValue(), arm, drivable).isEmpty()) {
        return rejected(
            "boxes",
            Phrase.SUPERVISION_TARGET_UNREACHABLE.with(box.getKey(), Sentence.of(box.getValue())));
      }
    }
    return Optional.empty();
  }

  /** The targets of a running supervision that its robots get to now, and not on another map. */
  static List<MapProblem> mapProblems(
      Supervision running, FloorMap now, FloorDrawing drawing, FleetSnapshot snapshot) {
    Optional<RobotView> supervisor = SupervisionRules.robot(snapshot, running.supervisor());
    Optional<Arm> arm =
        Supervisor.workers(running, snapshot).stream()
            .flatMap(worker -> Stream.ofNullable(worker.capabilities().arm()))
            .findFirst();
    if (supervisor.isEmpty() || arm.isEmpty()) {
      return List.of(); // nothing is carried until they are there
    }
    List<Vec2> robots = Supervisor.robots(running, snapshot);
    FloorMap next = new FloorMap(now.name(), drawing, now.margins());
    Predicate<Vec2> isServedNow = isServed(now, supervisor.get(), arm.get(), robots);
    Predicate<Vec2> isServedThen = isServed(next, supervisor.get(), arm.get(), robots);
    return running.boxes().values().stream()
        .filter(box -> !box.delivered())
        .filter(box -> isServedNow.test(box.target()) && !isServedThen.test(box.target()))
        .map(
            box ->
                new MapProblem(
                    true,
                    Phrase.SUPERVISION_TARGET_CUT_OFF.with(
                        now.name(), box.number(), Sentence.of(box.target())),
                    box.target()))
        .toList();
  }

  /** Whether an arm lays something there, from where one of the robots gets to. */
  private static Predicate<Vec2> isServed(
      FloorMap floor, RobotView supervisor, Arm arm, List<Vec2> robots) {
    OccupancyGrid drivable = new DrivableArea(floor, clearance(floor, supervisor)).among(List.of());
    BitSet reachable = DrivableArea.reachable(drivable, robots);
    return target ->
        HandlingPlaces.round(target, arm, drivable).stream()
            .anyMatch(stand -> reachable.get(drivable.index(drivable.cellAt(stand))));
  }

  private static double clearance(FloorMap floor, RobotView supervisor) {
    return supervisor.capabilities().footprint() / 2 + floor.margins().robot();
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
