package org.toqa.fleet.floor;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.mission.AssignedRobot;
import org.toqa.mission.Mission;

/**
 * A phase that a robot shall drive.
 *
 * @param task null when it drives home or to a charger, in phase 0
 * @param goal metres, map frame
 * @param heading how it shall face there, radians, counter-clockwise, map frame; null: in any way
 * @param load kilograms that it has on board
 */
record DriveGoal(@Nullable Long task, int phase, Vec2 goal, @Nullable Double heading, double load) {
  static DriveGoal toParking(Vec2 parking) {
    return new DriveGoal(null, 0, parking, null, 0);
  }

  static DriveGoal toCharger(Vec2 point) {
    return new DriveGoal(null, 0, point, null, 0);
  }

  /**
   * What the robot's phase of the mission asks.
   *
   * @param home its parking point
   */
  static DriveGoal of(Mission mission, String robot, Optional<Vec2> home) {
    int phase = mission.assignedRobot(robot).map(AssignedRobot::phase).orElse(3);
    Vec2 goal =
        switch (phase) {
          case 1 -> mission.object().position();
          case 2 -> mission.destination().position();
          default -> home.orElse(mission.task().goal().position());
        };
    double load = phase == 2 ? mission.task().load() / mission.assignedRobots().size() : 0;
    return new DriveGoal(mission.id(), phase, goal, null, load);
  }
}
