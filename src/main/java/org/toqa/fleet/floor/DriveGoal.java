package org.toqa.fleet.floor;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.mission.AssignedRobot;
import org.toqa.mission.Mission;
import org.toqa.mission.Phase;

/**
 * A phase that a robot shall drive.
 *
 * @param task null when it drives home or to a charger
 * @param goal metres, map frame
 * @param heading how it shall face there, radians, counter-clockwise, map frame; null: any heading
 * @param load kilograms that it has on board
 * @param stop the number, from 0, of the mission's stop that it is; 0 too where it is none
 * @param isWithoutLoad whether it is for a task that carries nothing
 */
record DriveGoal(
    @Nullable Long task,
    Phase phase,
    Vec2 goal,
    @Nullable Double heading,
    double load,
    int stop,
    boolean isWithoutLoad) {

  private static DriveGoal withoutTask(Vec2 place) {
    return new DriveGoal(null, Phase.NONE, place, null, 0, 0, false);
  }

  /** The same, with that heading. */
  DriveGoal facing(double radians) {
    return new DriveGoal(task, phase, goal, radians, load, stop, isWithoutLoad);
  }

  /** The same, to another place. */
  DriveGoal leadingTo(Vec2 place) {
    return new DriveGoal(task, phase, place, heading, load, stop, isWithoutLoad);
  }

  static DriveGoal toParking(Vec2 parking) {
    return withoutTask(parking);
  }

  static DriveGoal toPlace(Vec2 place) {
    return withoutTask(place);
  }

  static DriveGoal toCharger(Vec2 point) {
    return withoutTask(point);
  }

  /**
   * What the robot's phase of the mission asks.
   *
   * @param home its parking point
   * @param share kilograms that it has of the load
   */
  static DriveGoal of(Mission mission, String robot, Optional<Vec2> home, double share) {
    Phase phase = mission.assignedRobot(robot).map(AssignedRobot::phase).orElse(Phase.HOME);
    Vec2 goal =
        switch (phase) {
          case TO_OBJECT -> mission.object().position();
          case TO_GOAL -> mission.destination().position();
          case HOME, NONE -> home.orElse(mission.task().goal().position());
        };
    return new DriveGoal(
        mission.id(),
        phase,
        goal,
        null,
        phase == Phase.TO_GOAL ? share : 0,
        mission.stopNumber(phase),
        mission.task().isDrive());
  }
}
