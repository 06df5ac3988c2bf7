package org.toqa.avoidance.fouragents;

/**
 * Who may drive the robot, the most careful first: between equal utilities the earlier one drives.
 */
public enum DrivingAgent {
  DYNAMIC_AVOIDANCE,
  STATIC_AVOIDANCE,
  NAVIGATION
}
