package org.toqa.fleet;

import org.toqa.geometry.Pose;

/**
 * A robot has been carried to another floor.
 *
 * @param floor where it is now
 * @param pose where it stands there, map frame
 */
public record RobotMove(String floor, Pose pose) {}
