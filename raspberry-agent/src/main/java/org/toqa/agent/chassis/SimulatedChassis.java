package org.toqa.agent.chassis;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.ChassisCommand.DrivePath;
import org.toqa.agent.chassis.ChassisCommand.MoveAt;
import org.toqa.avoidance.RangeSensors;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;
import org.toqa.motion.DriveKind;
import org.toqa.motion.Odometry;
import org.toqa.motion.WheelKinematics;
import org.toqa.motion.WheelLimits;
import org.toqa.motion.WheelSpeeds;

/**
 * The body of a robot on two or three wheels, simulated: a queue of segments that it drives by
 * itself as the firmware does, motors that follow a command with a lag and a limited acceleration,
 * wheels that slip a little (seeded noise between what turns and what moves), odometry from encoder
 * counts alone but for marks on the floor, a battery (see {@link SimulatedBattery}), range sensors
 * (see {@link SimulatedRangeSensors}). Its state is kept in a file, see {@link
 * SimulatedChassisFile}.
 */
public final class SimulatedChassis implements Chassis {

  private static final double RADIANS_A_COUNT = 2 * Math.PI / Odometry.COUNTS_PER_WHEEL_TURN;

  /** Radians a second: more than the firmware commands, which is slower than the motors may be. */
  private static final double MAX_WHEEL_SPEED = WheelLimits.DEFAULT.ratedRate();

  /** Radians a second squared: 1.5 m/s2 at the rim of a wheel of 0.04 m. */
  private static final double WHEEL_ACCELERATION = 1.5 / 0.04;

  private static final ThreeWheels NO_SLIP = new ThreeWheels(1, 1, 1);

  private static final double MOTOR_LAG_SECONDS = 0.04;

  /** Radians a second; wheels that turn no faster count as stopped. */
  private static final double STANDING_SPEED = 1e-3;

  private static final double LONGEST_STEP_SECONDS = 0.02;

  /** The sensors where nothing is around that they could see. */
  private static final RangeSensors DEFAULT_SENSORS = new RangeSensors(0.1275);

  private final SimulatedChassisFile file;
  private final SimulatedBattery battery;
  private final Surroundings surroundings;
  private final SimulatedRangeSensors ranges;
  private final SimulatedCamera camera;
  private final WheelKinematics kinematics;
  private final DriveKind kind;
  private final double noise;
  private final ThreeWheels wheelSizes;
  private final SplittableRandom random;
  private ThreeWheels grip = NO_SLIP;
  private boolean frozen;
  private SimulatedChassisState state;
  private Odometry odometry;
  private boolean started;
  private long lastNanos;
  private long commandNanos;
  private int framesToLose;
  private @Nullable SimulatedArm arm;

  /** Null while it drives by a velocity. */
  private @Nullable SegmentQueue queue;

  /** The number of the last path that it began. */
  private long lastPath;

  private @Nullable ChassisReading reading;

  /** Kilograms on board. */
  private double load;

  private @Nullable SharedLoad sharedLoad;

  /**
   * Finds the body that the file keeps, or puts a new one.
   *
   * @param file keeps the body
   * @param start where a new body is put, map frame
   * @param noise standard deviation of a wheel's slip, as a share of what it turns, 0 or more
   * @throws IOException when the file cannot be read or written
   */
  public SimulatedChassis(Path file, Pose start, SimulatedBattery battery, double noise, long seed)
      throws IOException {
    this(file, start, battery, noise, seed, DEFAULT_SENSORS, Surroundings.EMPTY);
  }

  /**
   * The same among obstacles, with sensors that see them.
   *
   * @throws IOException as above
   */
  public SimulatedChassis(
      Path file,
      Pose start,
      SimulatedBattery battery,
      double noise,
      long seed,
      RangeSensors sensors,
      Surroundings surroundings)
      throws IOException {
    this(
        new SimulatedChassisFile(file),
        start,
        battery,
        SimulatedWheels.omni(noise, 0),
        seed,
        sensors,
        surroundings);
  }

  /**
   * The same on other wheels.
   *
   * @throws IOException as above
   */
  public SimulatedChassis(
      Path file,
      Pose start,
      SimulatedBattery battery,
      SimulatedWheels wheels,
      long seed,
      RangeSensors sensors,
      Surroundings surroundings)
      throws IOException {
    this(new SimulatedChassisFile(file), start, battery, wheels, seed, sensors, surroundings);
  }

  /** A new body that nothing is kept of, with a full battery. */
  public SimulatedChassis(Pose start, SimulatedWheels wheels, long seed) {
    this(start, wheels, seed, DEFAULT_SENSORS, Surroundings.EMPTY);
  }

  /** The same among obstacles. */
  public SimulatedChassis(
      Pose start,
      SimulatedWheels wheels,
      long seed,
      RangeSensors sensors,
      Surroundings surroundings) {
    this(
        new SimulatedChassisFile(),
        start,
        SimulatedBattery.FULL,
        wheels,
        seed,
        sensors,
        surroundings);
  }

  private SimulatedChassis(
      SimulatedChassisFile file,
      Pose start,
      SimulatedBattery battery,
      SimulatedWheels wheels,
      long seed,
      RangeSensors sensors,
      Surroundings surroundings) {
    this.file = file;
    this.battery = battery;
    this.surroundings = surroundings;
    this.ranges = new SimulatedRangeSensors(sensors, surroundings, seed);
    this.camera = new SimulatedCamera(surroundings);
    this.kinematics = wheels.kinematics();
    this.kind = wheels.kind();
    this.noise = wheels.slip();
    this.wheelSizes = wheelSizes(wheels.sizeError(), seed);
    state =
        this.file
            .read()
            .orElseGet(() -> SimulatedChassisState.atStart(start, battery.initialLevel()));
    random = new SplittableRandom(seed + state.steps());
    odometry = odometryOf(state);
    stopWheels();
    this.file.write(state);
  }

  /** Mounts an arm on it. */
  public void mount(SimulatedArm mounted) {
    arm = mounted;
  }

  @Override
  public Optional<ArmDrive> arm() {
    return Optional.ofNullable(arm);
  }

  @Override
  public void setLoad(double kilograms) {
    load = kilograms;
  }

  @Override
  public void setSharedLoad(@Nullable SharedLoad shared) {
    sharedLoad = shared;
  }

  @Override
  public ChassisReading exchange(ChassisCommand command, long nanos) {
    if (started) {
      simulate(nanos - lastNanos);
    }
    started = true;
    lastNanos = nanos;
    surroundings.takePlace().ifPresent(place -> state = state.carriedTo(place));
    boolean isLost = framesToLose > 0;
    framesToLose -= isLost ? 1 : 0;
    if (!isLost) {
      take(command);
      commandNanos = nanos;
    }
    file.write(state);
    surroundings.setTruePose(state.truePose());
    surroundings.setSharedLoad(sharedLoad);
    if (!isLost || reading == null) {
      reading = reading(nanos);
    }
    return reading;
  }

  /** Time passes, and no command reaches the body. */
  public void advance(long nanos) {
    if (started) {
      simulate(nanos - lastNanos);
    }
    started = true;
    lastNanos = nanos;
    file.write(state);
    surroundings.setTruePose(state.truePose());
  }

  /** What the counters of its wheels say; they wrap around. */
  public int[] wheelCounts() {
    return counts(state.wheelTurns());
  }

  private void take(ChassisCommand command) {
    SegmentQueue driven = queue;
    switch (command) {
      case MoveAt(Twist velocity) -> {
        queue = null;
        state = state.withCommand(velocity);
      }
      case DrivePath path when driven != null && driven.path() == path.number() ->
          driven.take(path);
      case DrivePath path when path.number() > lastPath -> {
        queue = new SegmentQueue(path, kind);
        lastPath = path.number();
      }
      case DrivePath _ -> {} // it was dropped
    }
  }

  private ChassisReading reading(long nanos) {
    return new ChassisReading(
        state.powerCycle(),
        state.powerCycle() == 1 ? state.start() : null,
        state.odometry(),
        kinematics.twist(state.wheelSpeeds()),
        state.battery(),
        ranges.update(state.truePose(), nanos),
        List.of(),
        measuredLoad(),
        queue == null ? null : queue.progress(),
        camera.update(state.truePose().position(), nanos),
        false);
  }

  /** As a scale under the load would. */
  private @Nullable Double measuredLoad() {
    if (sharedLoad == null) {
      return load > 0 ? load : null;
    }
    OptionalDouble borne = surroundings.borneShare();
    return borne.isPresent() ? borne.getAsDouble() : null;
  }

  /** Where the body really is, map frame: what no robot knows of itself. */
  public Pose truePose() {
    return state.truePose();
  }

  /** Takes the power away and gives it back: the robot no longer knows where it is. */
  public void cyclePower() {
    state = state.withPowerCycle();
    odometry = odometryOf(state);
    queue = null;
    file.write(state);
  }

  /**
   * Fault switch: somebody pushes it aside, and its odometry tells it.
   *
   * @param by metres, in the frame in which it began
   */
  public void shove(Vec2 by) {
    state = state.shoved(by);
    odometry = odometryOf(state);
  }

  /** Fault switch: so many exchanges to come do not reach the body, and bring no new reading. */
  public void loseFrames(int count) {
    framesToLose = count;
  }

  /** Fault switch: the wheels are stopped and follow no command, and the body does not know why. */
  public void setFrozen(boolean isFrozen) {
    frozen = isFrozen;
  }

  /**
   * Fault switch: a wheel turns and does not move the body as far.
   *
   * @param wheel from 0
   * @param share of its turning that is lost, 0 to 1
   */
  public void setWheelSlip(int wheel, double share) {
    grip = grip.with(wheel, 1 - share);
  }

  /**
   * Fault switch: a range sensor sees nothing.
   *
   * @param sensor from 0, from right to left
   */
  public void setBlind(int sensor, boolean isBlind) {
    ranges.setBlind(sensor, isBlind);
  }

  /**
   * Its hand closes.
   *
   * @param hand where, metres, robot's frame
   * @return kilograms of the box there, 0 where there is none; empty where no boxes are simulated
   */
  OptionalDouble grasp(Vec2 hand) {
    return surroundings.grasp(inMap(hand));
  }

  /** Its hand opens there, metres, robot's frame. */
  void release(Vec2 hand) {
    surroundings.release(inMap(hand));
  }

  private Vec2 inMap(Vec2 hand) {
    return state.truePose().compose(new Pose(hand.x(), hand.y(), 0)).position();
  }

  @Override
  public void close() {
    if (arm != null) {
      arm.close();
    }
    file.close();
  }

  private void simulate(long nanos) {
    long left = Math.max(0, commandNanos + COMMAND_LIFE_NANOS - lastNanos);
    double commanded = Math.min(nanos, left) / 1e9;
    if (queue == null) {
      move(state.command(), commanded);
    } else {
      driveAlong(queue, commanded);
    }
    if (nanos > left) {
      queue = null;
      state = state.withCommand(Twist.ZERO);
      move(Twist.ZERO, (nanos - left) / 1e9);
    }
  }

  private void driveAlong(SegmentQueue path, double seconds) {
    for (double left = seconds; left > 1e-9; left -= LONGEST_STEP_SECONDS) {
      double step = Math.min(left, LONGEST_STEP_SECONDS);
      state = state.withCommand(path.steer(state.odometry(), step));
      move(state.command(), step);
    }
  }

  /** The body of a daemon that ended: its last command ran out, then it came to a standstill. */
  private void stopWheels() {
    move(state.command(), COMMAND_LIFE_NANOS / 1e9);
    while (state.wheelSpeeds().largest() > STANDING_SPEED) {
      move(Twist.ZERO, LONGEST_STEP_SECONDS);
    }
  }

  private void move(Twist command, double seconds) {
    if (command.equals(Twist.ZERO) && state.wheelSpeeds().largest() < STANDING_SPEED) {
      stand(seconds);
      return;
    }
    double left = seconds;
    while (left > 1e-9) {
      double step = Math.min(left, LONGEST_STEP_SECONDS);
      move(kinematics.speeds(command).limited(MAX_WHEEL_SPEED), step);
      left -= step;
    }
  }

  /** Nothing moves: what is left of the wheels' speeds is lost in friction. */
  private void stand(double seconds) {
    if (seconds > 0) {
      state =
          state.stopped(
              battery.isDocked(state.truePose())
                  ? battery.levelAfterCharging(state.battery(), seconds)
                  : battery.levelAfterDriving(state.battery(), seconds, 0, load),
              (long) Math.ceil(seconds / LONGEST_STEP_SECONDS - 1e-6));
    }
  }

  private void move(WheelSpeeds wanted, double dt) {
    // first-order lag; the acceleration limited alike for all wheels, so that its direction stays
    WheelSpeeds change =
        wanted
            .minus(state.wheelSpeeds())
            .times(1 - Math.exp(-dt / MOTOR_LAG_SECONDS))
            .limited(WHEEL_ACCELERATION * dt);
    WheelSpeeds speeds = frozen ? WheelSpeeds.ZERO : state.wheelSpeeds().plus(change);
    WheelSpeeds mean = frozen ? WheelSpeeds.ZERO : state.wheelSpeeds().plus(speeds).times(0.5);
    ThreeWheels turns = ThreeWheels.turned(mean, dt);
    ThreeWheels turned = state.wheelTurns().plus(turns);
    ThreeWheels rolled =
        new ThreeWheels(slip(turns.one()), slip(turns.two()), slip(turns.three()))
            .times(wheelSizes)
            .times(grip);
    Twist moves = kinematics.twist(rolled.perSecond());
    double metres = Math.hypot(moves.vx(), moves.vy());
    boolean isCharged = speeds.largest() < STANDING_SPEED && battery.isDocked(state.truePose());
    state =
        new SimulatedChassisState(
            state.powerCycle(),
            state.start(),
            state.truePose().advanced(moves, 1),
            turned,
            speeds,
            odometry.update(counts(turned)),
            state.command(),
            isCharged
                ? battery.levelAfterCharging(state.battery(), dt)
                : battery.levelAfterDriving(state.battery(), dt, metres, load),
            state.steps() + 1);
    if (state.powerCycle() == 1 && surroundings.isMarked(state.truePose().position())) {
      state = state.withOdometry(state.start().relative(state.truePose()));
      odometry = odometryOf(state);
    }
  }

  private double slip(double turns) {
    return turns * (1 + noise * random.nextGaussian());
  }

  private static ThreeWheels wheelSizes(double error, long seed) {
    SplittableRandom random = new SplittableRandom(~seed);
    return new ThreeWheels(
        1 + error * random.nextGaussian(),
        1 + error * random.nextGaussian(),
        1 + error * random.nextGaussian());
  }

  private Odometry odometryOf(SimulatedChassisState ofState) {
    return new Odometry(
        kinematics,
        Odometry.COUNTS_PER_WHEEL_TURN,
        ofState.odometry(),
        counts(ofState.wheelTurns()));
  }

  /** Whole counts; the counters wrap around like the 32-bit registers that they simulate. */
  private int[] counts(ThreeWheels turned) {
    double[] radians = turned.values(kinematics.wheelCount());
    int[] counts = new int[radians.length];
    for (int i = 0; i < counts.length; i++) {
      counts[i] = count(radians[i]);
    }
    return counts;
  }

  private static int count(double turned) {
    return (int) (long) Math.floor(turned / RADIANS_A_COUNT);
  }
}
