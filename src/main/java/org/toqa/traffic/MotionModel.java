package org.toqa.traffic;

/** What a robot can do in one step. */
public enum MotionModel {
  /** Go to one of the four neighbours, or wait. */
  CLASSIC,
  /** Go forward, turn left or right by 90 degrees on the spot, or wait. */
  TURNS
}
