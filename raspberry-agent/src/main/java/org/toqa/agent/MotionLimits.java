package org.toqa.agent;

/**
 * What a robot's body may be asked for.
 *
 * @param speed metres a second
 * @param turnRate radians a second
 * @param acceleration metres a second squared
 * @param turnAcceleration radians a second squared
 */
public record MotionLimits(
    double speed, double turnRate, double acceleration, double turnAcceleration) {}
