package org.toqa.avoidance.fouragents;

import org.toqa.geometry.Pose;

/**
 * What static avoidance keeps while it leads round something.
 *
 * @param isClockwise which way round
 * @param reference what the robot tracks, map frame
 */
record Encounter(boolean isClockwise, Pose reference) {}
