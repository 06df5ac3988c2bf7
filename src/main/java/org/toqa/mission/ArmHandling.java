package org.toqa.mission;

import org.toqa.geometry.Vec2;

/**
 * That the robot's arm picks the load up and puts it down, beside where the robot stands then.
 *
 * @param pick where the load lies, metres, map frame
 * @param place where it shall lie, metres, map frame
 */
public record ArmHandling(Vec2 pick, Vec2 place) {}
