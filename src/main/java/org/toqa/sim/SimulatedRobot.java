package org.toqa.sim;

import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.config.ArmConfig;
import org.toqa.agent.config.Avoidance;
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
 * @param arm null: it has none
 * @param cameraRange metres that its cameras see; 0: it has none
 * @param avoidance how it gets round what it sees
 */
public record SimulatedRobot(
    String name,
    Pose start,
    double maxLoad,
    double battery,
    DriveKind kind,
    @Nullable Path firmware,
    @Nullable ArmConfig arm,
    double cameraRange,
    Avoidance avoidance) {

  /** Without an arm and cameras. */
  public SimulatedRobot(
      String name,
      Pose start,
      double maxLoad,
      double battery,
      DriveKind kind,
      @Nullable Path firmware) {
    this(name, start, maxLoad, battery, kind, firmware, null, 0, Avoidance.WEIGHTED_DIRECTIONS);
  }

  /** The same with that arm. */
  public SimulatedRobot withArm(ArmConfig mounted) {
    return new SimulatedRobot(
        name, start, maxLoad, battery, kind, firmware, mounted, cameraRange, avoidance);
  }

  /** The same with cameras that see so far, metres. */
  public SimulatedRobot withCamera(double range) {
    return new SimulatedRobot(name, start, maxLoad, battery, kind, firmware, arm, range, avoidance);
  }

  /** The same on two wheels, with eight range sensors and four agents. */
  public SimulatedRobot withFourAgents() {
    return new SimulatedRobot(
        name,
        start,
        maxLoad,
        battery,
        DriveKind.DIFFERENTIAL,
        null,
        arm,
        cameraRange,
        Avoidance.FOUR_AGENTS);
  }

  /** On three omni wheels. */
  public SimulatedRobot(
      String name, Pose start, double maxLoad, double battery, @Nullable Path firmware) {
    this(name, start, maxLoad, battery, DriveKind.OMNI, firmware);
  }

  public SimulatedRobot(String name, Pose start, double maxLoad, double battery) {
    this(name, start, maxLoad, battery, null);
  }
}
