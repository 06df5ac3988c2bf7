package org.toqa.traffic;

import org.toqa.grid.Cell;

/**
 * A robot as traffic sees it.
 *
 * @param name by which the planner knows it again
 * @param goal where it wants to be; a robot that wants nothing has the cell it stands on, and makes
 *     way for others
 * @param urgency a head start over others, in steps of waiting
 */
public record TrafficRobot(String name, Stance stance, Cell goal, int urgency) {}
