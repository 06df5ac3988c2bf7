package org.toqa.agent.config;

import java.nio.file.Path;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.chassis.SimulatedBattery;
import org.toqa.agent.chassis.SimulatedWheels;
import org.toqa.agent.chassis.Surroundings;
import org.toqa.agent.firmware.FirmwareSettings;
import org.toqa.geometry.Pose;
import org.toqa.link.http.ExchangeListener;
import org.toqa.link.http.HttpRobotClient;
import org.toqa.link.http.RobotDescription;
import org.toqa.localisation.RangeSource;
import org.toqa.motion.DriveKind;
import org.toqa.motion.ThreeWheelKinematics;

/** The body under a daemon, as its configuration names it. */
public sealed interface ChassisConfig {

  /** How many times faster than real time it and its daemon live. */
  default double timeFactor() {
    return 1;
  }

  /** Whether it may be a body on two wheels: one that this project's firmware does not drive. */
  default boolean canBeOnTwoWheels() {
    return switch (this) {
      case Simulated _, Serial _, Http _ -> true;
      case SimulatedFirmware _, Spi _ -> false;
    };
  }

  /** Metres a second: no faster may it be told to drive. */
  default double mostSpeed() {
    return 1;
  }

  /** Radians a second, likewise. */
  default double mostTurnRate() {
    return 10;
  }

  /** Metres between the wheels of a robot that has two; 0: it has others, or nobody said it. */
  default double track(DriveKind kind) {
    return 0;
  }

  /**
   * Where the range sensors on its rim look: radians, counter-clockwise from straight ahead, from
   * right to left; empty: as is usual.
   */
  default List<Double> rangeAngles() {
    return List.of();
  }

  /**
   * A body that is simulated as a whole.
   *
   * @param start where a new body is put, map frame
   * @param battery its battery, and where it is charged
   * @param noise standard deviation of a wheel's slip, as a share of what it turns
   * @param timeFactor how many times faster than real time it and its daemon live
   * @param surroundings what is round it
   * @param rangeAngles as above
   */
  record Simulated(
      Pose start,
      SimulatedBattery battery,
      double noise,
      long seed,
      double timeFactor,
      Surroundings surroundings,
      List<Double> rangeAngles)
      implements ChassisConfig {

    @Override
    public double mostSpeed() {
      return 5;
    }

    @Override
    public double mostTurnRate() {
      return 20;
    }

    @Override
    public double track(DriveKind kind) {
      return SimulatedWheels.of(kind, 0).track();
    }

    /** One with the usual range sensors. */
    public Simulated(
        Pose start,
        SimulatedBattery power,
        double noise,
        long seed,
        double speed,
        Surroundings surroundings) {
      this(start, power, noise, seed, speed, surroundings, List.of());
    }

    /** One on an endless empty floor. */
    public Simulated(Pose start, SimulatedBattery power, double noise, long seed, double speed) {
      this(start, power, noise, seed, speed, Surroundings.EMPTY);
    }
  }

  /**
   * The real firmware in a simulated microcontroller.
   *
   * @param socket where that one listens
   * @param start where the body was when it was switched on for the first time, map frame; null
   *     where nobody knows
   * @param rangeSensors whether it has some, and so avoids obstacles
   * @param settings what was measured of this robot
   */
  record SimulatedFirmware(
      Path socket, @Nullable Pose start, boolean rangeSensors, FirmwareSettings settings)
      implements ChassisConfig {

    /** One that nobody has measured. */
    public SimulatedFirmware(Path socket, @Nullable Pose start, boolean rangeSensors) {
      this(socket, start, rangeSensors, FirmwareSettings.DEFAULT);
    }
  }

  /**
   * The robot's microcontroller on the SPI bus.
   *
   * @param device such as {@code /dev/spidev0.0}
   * @param hertz of the bus's clock
   * @param wordDelayMicros pause after each byte
   * @param rangeSensors whether it has some, and so avoids obstacles
   * @param settings what was measured of this robot
   */
  record Spi(
      Path device, int hertz, int wordDelayMicros, boolean rangeSensors, FirmwareSettings settings)
      implements ChassisConfig {}

  /**
   * The robot's microcontroller on a serial port.
   *
   * @param device such as {@code /dev/serial0}
   * @param baud bits a second
   * @param rangeSensors whether it has some, and so avoids obstacles
   * @param settings what was measured of this robot
   */
  record Serial(Path device, int baud, boolean rangeSensors, FirmwareSettings settings)
      implements ChassisConfig {}

  /**
   * A body that takes the speeds of its wheels over HTTP. No file names it: the server runs its
   * daemon.
   *
   * @param robot is closed by whoever made it, after the daemon
   * @param description what it said of itself
   * @param listener is told of each exchange, in the thread that ticks
   * @param ranges that it publishes, for a robot whose place they correct
   */
  record Http(
      HttpRobotClient robot,
      RobotDescription description,
      ExchangeListener listener,
      RangeSource ranges)
      implements ChassisConfig {

    @Override
    public double track(DriveKind kind) {
      return description.track();
    }

    @Override
    public List<Double> rangeAngles() {
      return description.rangeAngles();
    }
  }

  /**
   * @param file of the configuration; a relative path in it counts from there
   * @param top its whole content
   */
  static ChassisConfig read(Path file, ConfigSection top) throws ConfigException {
    ConfigSection body =
        top.section(
            "chassis",
            "type",
            "start",
            "battery",
            "chargers",
            "noise",
            "seed",
            "speed",
            "socket",
            "device",
            "clock",
            "wordDelay",
            "baud",
            "rangeSensors",
            "wheelRadius",
            "centreToWheel",
            "floorThresholds");
    String type = body.text("type");
    return switch (type) {
      case "simulated" ->
          new Simulated(
              start(body),
              new SimulatedBattery(body.number("battery", 1, 0, 1), body.points("chargers")),
              body.number("noise", 0.01, 0, 1),
              body.integer("seed", 1, Long.MIN_VALUE, Long.MAX_VALUE),
              body.number("speed", 1, 0.1, 100));
      case "simulated-firmware" ->
          new SimulatedFirmware(
              file.toAbsolutePath().resolveSibling(body.text("socket")).normalize(),
              body.has("start") ? start(body) : null,
              body.flag("rangeSensors", true),
              settings(body));
      case "spi" ->
          new Spi(
              Path.of(body.text("device", "/dev/spidev0.0")),
              (int) body.integer("clock", 1_000_000, 100_000, 2_000_000),
              (int) body.integer("wordDelay", 16, 12, 100),
              body.flag("rangeSensors", true),
              settings(body));
      case "serial" ->
          new Serial(
              Path.of(body.text("device", "/dev/serial0")),
              (int) body.integer("baud", 115_200, 115_200, 1_000_000),
              body.flag("rangeSensors", true),
              settings(body));
      default -> throw body.invalid("type", type, "simulated, simulated-firmware, spi or serial");
    };
  }

  private static FirmwareSettings settings(ConfigSection body) throws ConfigException {
    ThreeWheelKinematics usual = FirmwareSettings.DEFAULT.wheels();
    return new FirmwareSettings(
        new ThreeWheelKinematics(
            body.number(
                "wheelRadius",
                usual.wheelRadius(),
                FirmwareSettings.LEAST_WHEEL_RADIUS,
                FirmwareSettings.MOST_WHEEL_RADIUS),
            body.number(
                "centreToWheel",
                usual.centreToWheel(),
                FirmwareSettings.LEAST_CENTRE_TO_WHEEL,
                FirmwareSettings.MOST_CENTRE_TO_WHEEL)),
        body.numbers(
            "floorThresholds",
            FirmwareSettings.DEFAULT.floorVolts(),
            FirmwareSettings.LEAST_FLOOR_VOLTS,
            FirmwareSettings.MOST_FLOOR_VOLTS));
  }

  private static Pose start(ConfigSection body) throws ConfigException {
    ConfigSection start = body.section("start", "x", "y", "heading");
    return new Pose(
        start.number("x", 0, -100_000, 100_000),
        start.number("y", 0, -100_000, 100_000),
        Math.toRadians(start.number("heading", 0, -360, 360)));
  }
}
