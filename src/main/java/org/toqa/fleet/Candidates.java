package org.toqa.fleet;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.toqa.allocation.Candidate;
import org.toqa.allocation.Standing;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Place;

/** A floor's robots, as its reports tell of them, in the eyes of an allocator. */
final class Candidates {
  private Candidates() {}

  /**
   * @param promised robots that are being given a task which no report tells of yet
   */
  static List<Candidate> of(FloorMap floor, List<RobotView> robots, Set<String> promised) {
    return robots.stream().map(r -> of(floor, r, standing(r, promised))).toList();
  }

  private static Candidate of(FloorMap floor, RobotView robot, Standing standing) {
    Vec2 position = robot.pose() == null ? floor.grid().origin() : robot.pose().position();
    Vec2 parking =
        Optional.ofNullable(robot.parking())
            .flatMap(floor::place)
            .map(Place::position)
            .orElse(position);
    return new Candidate(
        robot.name(),
        robot.maxLoad(),
        robot.footprint(),
        robot.speed(),
        position,
        parking,
        robot.battery(),
        standing,
        standing == Standing.BUSY ? robot.task() : null);
  }

  private static Standing standing(RobotView robot, Set<String> promised) {
    return switch (robot.state()) {
      case CONNECTING -> Standing.CONNECTING;
      case LOST -> Standing.LOST;
      case NOT_LOCALISED -> Standing.NOT_LOCALISED;
      case ERROR -> Standing.ERROR;
      case OUT_OF_SERVICE -> Standing.OUT_OF_SERVICE;
      case HOLDING -> robot.task() == null ? Standing.HELD : Standing.BUSY;
      case CHARGING -> Standing.CHARGING;
      case IDLE, DRIVING -> robot.charger() != null ? Standing.CHARGING : working(robot, promised);
    };
  }

  private static Standing working(RobotView robot, Set<String> promised) {
    boolean isBusy = promised.contains(robot.name()) || (robot.task() != null && robot.phase() < 3);
    return isBusy ? Standing.BUSY : Standing.FREE;
  }
}
