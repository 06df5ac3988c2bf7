package org.toqa.agent.chassis;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import org.toqa.avoidance.RangeSensors;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.motion.Odometry;
import org.toqa.motion.WheelKinematics;

/**
 * The body of a robot on two or three wheels, simulated: motors that follow a command with a lag
 * and a limited acceleration, wheels that slip a little (seeded noise between what turns and what
 * moves), odometry from encoder counts alone but for marks on the floor, a battery (see {@link
 * SimulatedPower}), range sensors (see {@link SimulatedRanges}). Its state is kept in a file, see
 * {@link SimulatedBodyFile}.
 */
public final class SimulatedChassis implements Chassis {

  private static final double RADIANS_A_COUNT = 2 * Math.PI / Odometry.COUNTS_PER_WHEEL_TURN;

  /** 220 turns a minute, as rated. */
  private static final double FASTEST_RATE = 220 / 60.0 * 2 * Math.PI;

  /** Radians a second squared: 1.5 m/s2 at the rim of a wheel of 0.04 m. */
  private static final double WHEEL_ACCELERATION = 1.5 / 0.04;

  private static final ThreeWheels NO_SLIP = new ThreeWheels(1, 1, 1);

  private static final double MOTOR_LAG_SECONDS = 0.04;

  /** Radians a second; wheels that turn no faster stand. */
  private static final double STANDS = 1e-3;

  private static final double LONGEST_STEP_SECONDS = 0.02;

  /** The sensors of a robot that nobody asks what it sees. */
  private static final RangeSensors UNSEEING = new RangeSensors(0.1275);

  private final SimulatedBodyFile file;
  private final SimulatedPower power;
  private final Surroundings surroundings;
  private final SimulatedRanges ranges;
  private final WheelKinematics kinematics;
  private final double noise;
  private final ThreeWheels sizes;
  private final SplittableRandom random;
  private ThreeWheels grip = NO_SLIP;
  private boolean frozen;
  private SimulatedBody body;
  private Odometry odometry;
  private boolean started;
  private long lastNanos;
  private long commandNanos;
  private int framesToLose;
  private @Nullable ChassisReading reading;

  /** Kilograms on board. */
  private double load;

  /**
   * Finds the body that the file keeps, or puts a new one.
   *
   * @param file keeps the body
   * @param start where a new body is put, map frame
   * @param noise standard deviation of a wheel's slip, as a share of what it turns
   */
  public SimulatedChassis(Path file, Pose start, SimulatedPower power, double noise, long seed)
      throws IOException {
    this(file, start, power, noise, seed, UNSEEING, Surroundings.EMPTY);
  }

  /** The same, among other things. */
  public SimulatedChassis(
      Path file,
      Pose start,
      SimulatedPower power,
      double noise,
      long seed,
      RangeSensors sensors,
      Surroundings surroundings)
      throws IOException {
    this(
        new SimulatedBodyFile(file),
        start,
        power,
        SimulatedWheels.omni(noise, 0),
        seed,
        sensors,
        surroundings);
  }

  /** A new body that nothing is kept of, with a full battery. */
  public SimulatedChassis(Pose start, SimulatedWheels wheels, long seed) {
    this(
        new SimulatedBodyFile(),
        start,
        SimulatedPower.FULL,
        wheels,
        seed,
        UNSEEING,
        Surroundings.EMPTY);
  }

  private SimulatedChassis(
      SimulatedBodyFile file,
      Pose start,
      SimulatedPower power,
      SimulatedWheels wheels,
      long seed,
      RangeSensors sensors,
      Surroundings surroundings) {
    this.file = file;
    this.power = power;
    this.surroundings = surroundings;
    this.ranges = new SimulatedRanges(sensors, surroundings, seed);
    this.kinematics = wheels.kinematics();
    this.noise = wheels.slip();
    this.sizes = sizes(wheels.sizeError(), seed);
    body = this.file.read().orElseGet(() -> SimulatedBody.placed(start, power.first()));
    random = new SplittableRandom(seed + body.steps());
    odometry = odometryOf(body);
    rollOut();
    this.file.write(body);
  }

  @Override
  public void carries(double kilograms) {
    load = kilograms;
  }

  @Override
  public ChassisReading exchange(Twist command, long nanos) {
    if (started) {
      live(nanos - lastNanos);
    }
    started = true;
    lastNanos = nanos;
    boolean isLost = framesToLose > 0;
    framesToLose -= isLost ? 1 : 0;
    body = isLost ? body : body.commanded(command);
    commandNanos = isLost ? commandNanos : nanos;
    file.write(body);
    surroundings.isAt(body.truth());
    if (!isLost || reading == null) {
      reading = reading(nanos);
    }
    return reading;
  }

  private ChassisReading reading(long nanos) {
    return new ChassisReading(
        body.powerCycle(),
        body.powerCycle() == 1 ? body.start() : null,
        body.odometry(),
        kinematics.twist(body.rates().values(kinematics.wheels())),
        body.battery(),
        ranges.read(body.truth(), nanos),
        List.of());
  }

  /** Where the body really is, map frame: what no robot knows of itself. */
  public Pose truth() {
    return body.truth();
  }

  /** Takes the power away and gives it back: the robot no longer knows where it is. */
  public void cyclePower() {
    body = body.powerCycled();
    odometry = odometryOf(body);
    file.write(body);
  }

  /** Fault switch: so many exchanges to come do not reach the body, and it is not heard in them. */
  public void loseFrames(int count) {
    framesToLose = count;
  }

  /** Fault switch: the wheels stand and obey nothing, and the body does not know why. */
  public void freeze(boolean freezes) {
    frozen = freezes;
  }

  /**
   * Fault switch: a wheel turns and does not move the body as far.
   *
   * @param wheel from 0
   * @param share of its turning that is lost, 0 to 1
   */
  public void slipWheel(int wheel, double share) {
    double[] grips = NO_SLIP.values(kinematics.wheels());
    grips[wheel] = 1 - share;
    grip = ThreeWheels.of(grips);
  }

  /**
   * Fault switch: a range sensor sees nothing.
   *
   * @param sensor from 0, from right to left
   */
  public void blind(int sensor, boolean isBlind) {
    ranges.blind(sensor, isBlind);
  }

  @Override
  public void close() {
    file.close();
  }

  private void live(long nanos) {
    long left = Math.max(0, commandNanos + COMMAND_LIFE_NANOS - lastNanos);
    double commanded = Math.min(nanos, left) / 1e9;
    move(body.command(), commanded);
    move(Twist.ZERO, nanos / 1e9 - commanded);
  }

  /** The body of a daemon that died: its last command ran out, then it came to a stand. */
  private void rollOut() {
    move(body.command(), COMMAND_LIFE_NANOS / 1e9);
    while (body.rates().largest() > STANDS) {
      move(Twist.ZERO, LONGEST_STEP_SECONDS);
    }
  }

  private void move(Twist command, double seconds) {
    double left = seconds;
    while (left > 1e-9) {
      double step = Math.min(left, LONGEST_STEP_SECONDS);
      move(ThreeWheels.of(kinematics.rates(command)).limited(FASTEST_RATE), step);
      left -= step;
    }
  }

  private void move(ThreeWheels wanted, double dt) {
    // first-order lag; the acceleration limited alike for all wheels, so that its direction stays
    ThreeWheels change =
        wanted
            .minus(body.rates())
            .times(1 - Math.exp(-dt / MOTOR_LAG_SECONDS))
            .limited(WHEEL_ACCELERATION * dt);
    ThreeWheels rates = frozen ? ThreeWheels.ZERO : body.rates().plus(change);
    ThreeWheels turns = frozen ? ThreeWheels.ZERO : body.rates().plus(rates).times(dt / 2);
    ThreeWheels turned = body.turned().plus(turns);
    ThreeWheels rolled =
        new ThreeWheels(slip(turns.one()), slip(turns.two()), slip(turns.three()))
            .times(sizes)
            .times(grip);
    Twist moves = kinematics.twist(rolled.values(kinematics.wheels()));
    double metres = Math.hypot(moves.vx(), moves.vy());
    boolean isCharged = rates.largest() < STANDS && power.isDocked(body.truth());
    body =
        new SimulatedBody(
            body.powerCycle(),
            body.start(),
            body.truth().advanced(moves, 1),
            turned,
            rates,
            odometry.update(counts(turned)),
            body.command(),
            isCharged
                ? power.charged(body.battery(), dt)
                : power.drained(body.battery(), dt, metres, load),
            body.steps() + 1);
    if (body.powerCycle() == 1 && surroundings.isMarked(body.truth().position())) {
      body = body.corrected(body.start().relative(body.truth()));
      odometry = odometryOf(body);
    }
  }

  private double slip(double turns) {
    return turns * (1 + noise * random.nextGaussian());
  }

  private static ThreeWheels sizes(double error, long seed) {
    SplittableRandom random = new SplittableRandom(~seed);
    return new ThreeWheels(
        1 + error * random.nextGaussian(),
        1 + error * random.nextGaussian(),
        1 + error * random.nextGaussian());
  }

  private Odometry odometryOf(SimulatedBody body) {
    return new Odometry(
        kinematics, Odometry.COUNTS_PER_WHEEL_TURN, body.odometry(), counts(body.turned()));
  }

  /** Whole counts; the counters wrap around like the 32-bit registers that they stand for. */
  private int[] counts(ThreeWheels turned) {
    return Arrays.stream(turned.values(kinematics.wheels()))
        .mapToInt(SimulatedChassis::count)
        .toArray();
  }

  private static int count(double turned) {
    return (int) (long) Math.floor(turned / RADIANS_A_COUNT);
  }
}
