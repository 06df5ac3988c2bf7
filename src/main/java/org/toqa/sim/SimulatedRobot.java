package org.toqa.sim;

import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.motion.DriveKind;

/**
 * A robot to be made.
 *
 * @param start where its body is put if it is new, map frame
 * @param maxLoad kilograms
 * @param battery what a new one has, 0 to 1
 * @param kind how its body can move
 * @param firmware the folder of the built firmware that is to drive it, in a simulated
 *     microcontroller; null: its body is simulated as a whole
 */
public record SimulatedRobot(
    String name,
    Pose start,
    double maxLoad,
    double battery,
    DriveKind kind,
    @Nullable Path firmware) {

  /** On three omni wheels. */
  public SimulatedRobot(
      String name, Pose start, double maxLoad, double battery, @Nullable Path firmware) {
    this(name, start, maxLoad, battery, DriveKind.OMNI, firmware);
  }

  public SimulatedRobot(String name, Pose start, double maxLoad, double battery) {
    this(name, start, maxLoad, battery, null);
  }
}
