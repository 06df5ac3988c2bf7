package org.toqa.sim;

import org.toqa.geometry.Pose;

/**
 * A robot to be made.
 *
 * @param start where its body is put if it is new, map frame
 * @param maxLoad kilograms
 */
public record SimulatedRobot(String name, Pose start, double maxLoad) {}
