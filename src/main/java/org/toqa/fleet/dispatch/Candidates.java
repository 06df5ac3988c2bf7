package org.toqa.fleet.dispatch;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.toqa.allocation.Availability;
import org.toqa.allocation.Candidate;
import org.toqa.fleet.RobotCondition;
import org.toqa.fleet.RobotView;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Place;
import org.toqa.motion.DriveKind;

/** A floor's robots, as reported by it, as an allocator's input. */
final class Candidates {
  private Candidates() {}

  /**
   * A robot that was never connected is none, once another was: what it can do is not known.
   *
   * @param promised robots that are being given a task which no report tells of yet
   */
  static List<Candidate> of(FloorMap floor, List<RobotView> robots, Set<String> promised) {
    boolean isAnyKnown = robots.stream().anyMatch(RobotView::isLoadKnown);
    return robots.stream()
        .filter(r -> r.isLoadKnown() || !isAnyKnown)
        .map(r -> of(floor, r, RobotCondition.availability(r, promised.contains(r.name()))))
        .toList();
  }

  private static Candidate of(FloorMap floor, RobotView robot, Availability availability) {
    Pose pose = robot.telemetry().pose();
    Vec2 position = pose == null ? floor.grid().origin() : pose.position();
    Vec2 parking =
        Optional.ofNullable(robot.record().parking())
            .flatMap(floor::place)
            .map(Place::position)
            .orElse(position);
    return new Candidate(
        robot.name(),
        robot.maxLoad(),
        robot.capabilities().footprint(),
        robot.speed(),
        robot.capabilities().kind() == DriveKind.OMNI,
        position,
        parking,
        robot.telemetry().battery(),
        availability,
        availability == Availability.BUSY ? robot.work().task() : null,
        !robot.record().isHttp(),
        robot.capabilities().knowsShifts());
  }
}
