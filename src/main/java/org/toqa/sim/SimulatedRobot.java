package org.toqa.sim;

import org.toqa.geometry.Pose;

/**
 * A robot to be made.
 *
 * @param start where its body is put if it is new, map frame
 * @param maxLoad kilograms
 * @param battery what a new one has, 0 to 1
 */
public record SimulatedRobot(String name, Pose start, double maxLoad, double battery) {}
