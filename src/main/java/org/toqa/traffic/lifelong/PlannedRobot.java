package org.toqa.traffic.lifelong;

import org.toqa.grid.Cell;
import org.toqa.traffic.GridPose;

/**
 * A robot as traffic sees it.
 *
 * @param name by which the planner knows it again
 * @param goal where it wants to be; a robot that wants nothing has the cell it is on, and makes
 *     room for others
 * @param urgency a head start over others, in steps of waiting
 * @param isFixed whether it stays where it is, whatever its goal; others go round it. Unlike a cell
 *     that is no road, it changes from plan to plan at no cost
 * @param delay in so many steps from now it is where its pose says: it goes on no earlier, and
 *     until then the place is its own
 */
public record PlannedRobot(
    String name, GridPose pose, Cell goal, int urgency, boolean isFixed, int delay) {
  /** A robot that moves, from now on. */
  public PlannedRobot(String name, GridPose pose, Cell goal, int urgency) {
    this(name, pose, goal, urgency, false);
  }

  /** A robot that is where its pose says. */
  public PlannedRobot(String name, GridPose pose, Cell goal, int urgency, boolean isFixed) {
    this(name, pose, goal, urgency, isFixed, 0);
  }
}
