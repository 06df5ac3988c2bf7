package org.toqa.cooperation;

import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;

/**
 * What is known of a robot; the supervisor is one itself.
 *
 * @param box what it is about, of those activities that have one
 * @param position metres, map frame
 * @param battery 0 to 1
 * @param workSeconds since it last charged
 */
public record KnownRobot(
    Activity activity, @Nullable Integer box, Vec2 position, double battery, double workSeconds) {

  /** What it does now. */
  public enum Activity {
    IDLE,
    /** Drives to where it has not seen the store. */
    SEARCHING,
    TO_BOX,
    /** Beside a heavy box, until a second worker is there. */
    WAITING,
    TO_HELP,
    CARRYING,
    /** Drives to a station, or is there. */
    CHARGING,
    /** Drives to its parking place. */
    PARKING,
    LOST
  }

  /** Whether it takes a new box. */
  boolean isFree() {
    return activity == Activity.IDLE
        || activity == Activity.PARKING
        || activity == Activity.SEARCHING;
  }

  KnownRobot doing(Activity next) {
    return new KnownRobot(next, null, position, battery, workSeconds);
  }

  KnownRobot doing(Activity next, int about) {
    return new KnownRobot(next, about, position, battery, workSeconds);
  }

  boolean isAbout(int number) {
    return box != null && box == number;
  }
}
