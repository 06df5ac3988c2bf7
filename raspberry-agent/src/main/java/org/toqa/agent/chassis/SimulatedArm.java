package org.toqa.agent.chassis;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.storage.NumberFile;
import org.toqa.arm.Arm;
import org.toqa.arm.ArmCommand;
import org.toqa.arm.ArmReading;
import org.toqa.arm.JointAngles;
import org.toqa.arm.JointLimits;

/**
 * An arm, simulated: joints that follow a command as fast as they can, and a load sensor. Its hand
 * grasps the box that lies there; where no boxes are simulated there is one wherever it closes. Its
 * state is kept in a file, since an arm does not let go when its daemon is killed.
 */
public final class SimulatedArm implements ArmDrive {

  private static final int NUMBERS = 4;

  private final Arm arm;
  private final NumberFile file;
  private final SimulatedChassis body;
  private ArmReading reading;
  private @Nullable Double boxWeight;
  private double expectedLoad;
  private long lastNanos;
  private boolean started;
  private boolean stuck;

  /**
   * @param body on which it is mounted
   * @param boxWeight kilograms of the boxes that its hand grasps, 0 for no box; null: as they are
   *     simulated, else as ordered
   * @throws IOException when the file cannot be read or written
   */
  public SimulatedArm(Path path, Arm arm, @Nullable Double boxWeight, SimulatedChassis body)
      throws IOException {
    this.arm = arm;
    this.body = body;
    this.boxWeight = boxWeight;
    this.file = new NumberFile(path, NUMBERS);
    Optional<double[]> kept = file.read();
    reading =
        kept.map(n -> new ArmReading(new JointAngles(n[0], n[1]), n[2] != 0, n[3]))
            .orElse(new ArmReading(arm.rest(), false, 0));
  }

  @Override
  public ArmReading reading() {
    return reading;
  }

  @Override
  public void expectLoad(double kilograms) {
    expectedLoad = kilograms;
  }

  @Override
  public ArmReading exchange(ArmCommand command, long nanos) {
    double seconds = started ? Math.min(nanos - lastNanos, Chassis.COMMAND_LIFE_NANOS) / 1e9 : 0;
    started = true;
    lastNanos = nanos;
    JointAngles at = reading.angles();
    JointAngles angles =
        stuck
            ? at
            : new JointAngles(
                turned(at.shoulder(), command.angles().shoulder(), arm.shoulder(), seconds),
                turned(at.elbow(), command.angles().elbow(), arm.elbow(), seconds));
    boolean closed = command.handClosed();
    double load = closed ? (reading.handClosed() ? reading.load() : graspedWeight(angles)) : 0;
    if (!closed && reading.isHolding()) {
      body.release(arm.handAt(angles));
    }
    reading = new ArmReading(angles, closed, load);
    file.write(angles.shoulder(), angles.elbow(), closed ? 1 : 0, load);
    return reading;
  }

  private double graspedWeight(JointAngles angles) {
    return boxWeight == null ? body.grasp(arm.handAt(angles)).orElse(expectedLoad) : boxWeight;
  }

  private static double turned(double at, double wanted, JointLimits joint, double seconds) {
    // a little faster than it is told at most, so that what is lost in one tick is made up for
    double most = 1.1 * joint.maxRate() * seconds;
    return at + Math.clamp(wanted - at, -most, most);
  }

  /**
   * Fault switch: what its hand will grasp weighs that.
   *
   * @param kilograms 0: there is no box
   */
  public void setBoxWeight(double kilograms) {
    boxWeight = kilograms;
  }

  /** Fault switch: its joints follow no command. */
  public void setStuck(boolean isStuck) {
    stuck = isStuck;
  }

  @Override
  public void close() {
    file.close();
  }
}
