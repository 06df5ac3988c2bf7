package org.toqa.app.robot;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.ChassisCommand.MoveAt;
import org.toqa.agent.chassis.ChassisReading;
import org.toqa.agent.chassis.SimulatedBattery;
import org.toqa.agent.chassis.SimulatedChassis;
import org.toqa.agent.chassis.SimulatedWheels;
import org.toqa.agent.chassis.Surroundings;
import org.toqa.avoidance.RangeSensors;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.link.http.RobotDescription;
import org.toqa.link.http.WheelOrder;
import org.toqa.link.http.WheelReport;
import org.toqa.link.trust.PrivateFolder;
import org.toqa.motion.DifferentialKinematics;
import org.toqa.motion.Odometry;
import org.toqa.motion.WheelSpeeds;

/**
 * A simulated body on two wheels: what its wheels are told holds for 200 ms. Any thread may call
 * it.
 */
final class SimulatedHttpBody implements AutoCloseable {
  private static final long NANOS_PER_MILLI = 1_000_000;
  private static final double TRACK = 0.20;
  private static final double WHEEL_RADIUS = 0.04;

  /** Metres a second, of either wheel (CSM-MAMRS). */
  private static final double MAX_SPEED = 0.52;

  private static final double FOOTPRINT = 0.255;
  private static final DifferentialKinematics WHEELS =
      new DifferentialKinematics(WHEEL_RADIUS, TRACK);

  private final SimulatedChassis chassis;
  private final double maxLoad;
  private final List<Double> rangeAngles;
  private final RobotDescription.@Nullable Sonar sonar;
  private final LongSupplier nanos;
  private final long boot;
  private ChassisReading reading;
  private long seq;

  /**
   * A new body, or the one that the folder keeps.
   *
   * @param folder null: nothing outlives the process, and its counts begin anew with the next one
   * @param start where a new body is, map frame
   * @param slip standard deviation of a wheel's slip, as a share of what it turns
   * @param sizeError standard deviation of a wheel's constant error in size, as a share of it
   * @param maxLoad kilograms
   * @param rangeAngles where range sensors on its rim look, radians, from right to left; empty: it
   *     has none
   * @param sonar that it tells of; null: none
   * @param surroundings is told where the body really is
   * @param nanos its clock, which does not jump back
   */
  SimulatedHttpBody(
      @Nullable Path folder,
      Pose start,
      double slip,
      double sizeError,
      long seed,
      double maxLoad,
      List<Double> rangeAngles,
      RobotDescription.@Nullable Sonar sonar,
      Surroundings surroundings,
      LongSupplier nanos)
      throws IOException {
    this.nanos = nanos;
    this.maxLoad = maxLoad;
    this.rangeAngles = List.copyOf(rangeAngles);
    this.sonar = sonar;
    RangeSensors sensors = RangeSensors.onRim(FOOTPRINT / 2, rangeAngles);
    SimulatedWheels wheels = new SimulatedWheels(WHEELS, slip, sizeError);
    if (folder == null) {
      chassis = new SimulatedChassis(start, wheels, seed, sensors, surroundings);
      boot = System.currentTimeMillis();
    } else {
      PrivateFolder.create(folder);
      boot = boot(folder.resolve("boot"));
      chassis =
          new SimulatedChassis(
              folder.resolve("body"),
              start,
              SimulatedBattery.FULL,
              wheels,
              seed,
              sensors,
              surroundings);
    }
    reading = chassis.exchange(MoveAt.STANDSTILL, nanos.getAsLong());
  }

  /** That of the body that is kept, or a new one. */
  private static long boot(Path file) throws IOException {
    try {
      return Long.parseLong(Files.readString(file).strip());
    } catch (NoSuchFileException e) {
      long made = System.currentTimeMillis();
      Files.writeString(file, made + "\n");
      return made;
    } catch (NumberFormatException e) {
      throw new IOException(file + " is no number; remove the folder for a new body.", e);
    }
  }

  synchronized RobotDescription description() {
    return new RobotDescription(
        TRACK,
        WHEEL_RADIUS,
        Odometry.COUNTS_PER_WHEEL_TURN,
        MAX_SPEED,
        maxLoad,
        FOOTPRINT,
        !rangeAngles.isEmpty(),
        rangeAngles,
        sonar,
        boot,
        seq);
  }

  /** Obeys the order if it is a newer one, and was not held up on its way. */
  synchronized WheelReport obey(WheelOrder order) {
    long now = nanos.getAsLong();
    if (order.seq() > seq && !order.isStale(now / NANOS_PER_MILLI)) {
      seq = order.seq();
      reading = chassis.exchange(new MoveAt(twist(order)), now);
    } else {
      chassis.advance(now);
    }
    int[] counts = chassis.wheelCounts();
    return new WheelReport(
        seq,
        boot,
        now / NANOS_PER_MILLI,
        counts[0],
        counts[1],
        reading.battery(),
        rangeAngles.isEmpty() ? null : reading.ranges(),
        List.of());
  }

  private static Twist twist(WheelOrder order) {
    return WHEELS.twist(
        new WheelSpeeds(
            within(order.left().speed()) / WHEEL_RADIUS,
            within(order.right().speed()) / WHEEL_RADIUS,
            0));
  }

  private static double within(double speed) {
    return Math.clamp(speed, -MAX_SPEED, MAX_SPEED);
  }

  /** Where the body really is, map frame. */
  synchronized Pose truePose() {
    chassis.advance(nanos.getAsLong());
    return chassis.truePose();
  }

  @Override
  public synchronized void close() {
    chassis.close();
  }
}
