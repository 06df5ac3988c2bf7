package org.toqa.agent.config;

import java.io.IOException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.charset.MalformedInputException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.drive.MotionLimits;
import org.toqa.avoidance.RangeSensors;
import org.toqa.avoidance.fouragents.RangeRing;
import org.toqa.formation.FollowerLaw;
import org.toqa.formation.FollowerLawType;
import org.toqa.formation.Gains;
import org.toqa.formation.SingleIntegratorLaw;
import org.toqa.motion.DriveKind;
import org.toqa.yaml.YamlParser;
import org.toqa.yaml.YamlSyntaxException;

/**
 * What a daemon is started with. The keys of the file are explained in {@code
 * raspberry-agent/agent.yaml}.
 *
 * @param name the robot's
 * @param address to listen on
 * @param port of TCP to listen on, 0 to 65535; 0 for any free one
 * @param plainOffLoopback whether the link of a robot that was never paired may do without
 *     encryption off loopback too
 * @param dataDir where the journal and a simulated body are kept
 * @param maxLoad kilograms
 * @param footprint diameter in metres
 * @param kind how it can move
 * @param arm null: it has none
 * @param avoidance how it gets round what it sees
 * @param adHocNetwork that it forwards in; null: it is in none
 */
public record AgentConfig(
    String name,
    InetAddress address,
    int port,
    boolean plainOffLoopback,
    Path dataDir,
    double maxLoad,
    double footprint,
    DriveKind kind,
    MotionLimits limits,
    Following following,
    ChassisConfig chassis,
    @Nullable ArmConfig arm,
    Avoidance avoidance,
    @Nullable AdHocNetwork adHocNetwork) {

  private static final String[] KEYS = {
    "name",
    "address",
    "port",
    "plainTcpOffLoopback",
    "dataDir",
    "maxLoad",
    "footprint",
    "kind",
    "avoidance",
    "maxSpeed",
    "maxTurnRate",
    "acceleration",
    "turnAcceleration",
    "following",
    "chassis",
    "arm",
    "adHocNetwork"
  };

  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9][A-Za-z0-9._-]{0,63}");

  /**
   * How it keeps its place beside a leader.
   *
   * @param linkDelay seconds that a leader's pose usually takes to arrive
   */
  public record Following(FollowerLaw law, double linkDelay) {
    public static final Following DEFAULT =
        new Following(new SingleIntegratorLaw(Gains.DEFAULT), 0.02);

    /** The usual of robots of a kind. */
    public static Following of(DriveKind kind) {
      return new Following(FollowerLawType.of(kind).withGains(Gains.DEFAULT), DEFAULT.linkDelay());
    }
  }

  /** Whether it can lead a group sideways, and follow so. */
  public boolean canShift() {
    return kind.canGoSideways() && following.law() instanceof SingleIntegratorLaw;
  }

  /** With the usual avoidance, in no ad hoc network. */
  public AgentConfig(
      String name,
      InetAddress address,
      int port,
      boolean plainOffLoopback,
      Path dataDir,
      double maxLoad,
      double footprint,
      DriveKind kind,
      MotionLimits limits,
      Following following,
      ChassisConfig chassis,
      @Nullable ArmConfig arm) {
    this(
        name,
        address,
        port,
        plainOffLoopback,
        dataDir,
        maxLoad,
        footprint,
        kind,
        limits,
        following,
        chassis,
        arm,
        Avoidance.WEIGHTED_DIRECTIONS,
        null);
  }

  /** That of a robot without an arm. */
  public AgentConfig(
      String name,
      InetAddress address,
      int port,
      boolean plainOffLoopback,
      Path dataDir,
      double maxLoad,
      double footprint,
      DriveKind kind,
      MotionLimits limits,
      Following following,
      ChassisConfig chassis) {
    this(
        name,
        address,
        port,
        plainOffLoopback,
        dataDir,
        maxLoad,
        footprint,
        kind,
        limits,
        following,
        chassis,
        null);
  }

  /** The same with that arm. */
  public AgentConfig withArm(ArmConfig mounted) {
    return new AgentConfig(
        name,
        address,
        port,
        plainOffLoopback,
        dataDir,
        maxLoad,
        footprint,
        kind,
        limits,
        following,
        chassis,
        mounted,
        avoidance,
        adHocNetwork);
  }

  /** The same with that avoidance. */
  public AgentConfig withAvoidance(Avoidance other) {
    return new AgentConfig(
        name,
        address,
        port,
        plainOffLoopback,
        dataDir,
        maxLoad,
        footprint,
        kind,
        limits,
        following,
        chassis,
        arm,
        other,
        adHocNetwork);
  }

  /** Where the range sensors of its body are and look, if it has any. */
  public RangeSensors rangeSensors() {
    if (!chassis.rangeAngles().isEmpty()) {
      return RangeSensors.onRim(footprint / 2, chassis.rangeAngles());
    }
    return switch (avoidance) {
      case WEIGHTED_DIRECTIONS -> new RangeSensors(footprint / 2);
      case FOUR_AGENTS ->
          new RangeSensors(new RangeRing(footprint / 2, RangeSensors.FARTHEST).beamsRightToLeft());
    };
  }

  /**
   * Reads a file; a relative data folder lies beside it.
   *
   * @throws ConfigException with a sentence for people: the key, its value and what is allowed
   */
  public static AgentConfig read(Path file) throws ConfigException {
    ConfigSection top = new ConfigSection(file.toString(), "", readKeys(file), KEYS);
    DriveKind kind = kind(top);
    Avoidance avoidance = avoidance(top);
    AgentConfig config =
        new AgentConfig(
            robotName(top),
            address(top),
            (int) top.integer("port", 7275, 0, 65_535),
            top.flag("plainTcpOffLoopback", false),
            file.toAbsolutePath().resolveSibling(top.text("dataDir")).normalize(),
            top.number("maxLoad", 5, 0, 10_000),
            top.number("footprint", 0.255, 0.05, 5),
            kind,
            limits(top),
            following(
                kind, top.section("following", "law", "placeGain", "headingGain", "linkDelay")),
            ChassisConfig.read(file, top),
            ArmConfig.read(top),
            avoidance,
            AdHocNetwork.read(file, top));
    if (!kind.canGoSideways() && !config.chassis.canBeOnTwoWheels()) {
      throw top.invalid(
          "kind", kind.word(), "omni: this project's microcontroller turns three omni wheels");
    }
    if (config.avoidance == Avoidance.FOUR_AGENTS) {
      checkFourAgents(file, config);
    }
    // the body is asked last, so that mistakes are told in the order of the keys
    top.number("maxSpeed", config.limits.speed(), 0.01, config.chassis.mostSpeed());
    top.number("maxTurnRate", config.limits.turnRate(), 0.01, config.chassis.mostTurnRate());
    return config;
  }

  private static Map<?, ?> readKeys(Path file) throws ConfigException {
    try {
      if (YamlParser.parse(Files.readString(file)) instanceof Map<?, ?> map) {
        return map;
      }
      throw new ConfigException(file + ": this is not a list of keys and values.");
    } catch (NoSuchFileException e) {
      throw new ConfigException(file + ": there is no such file.");
    } catch (MalformedInputException e) {
      throw new ConfigException(file + ": this is not text in UTF-8.");
    } catch (IOException e) {
      throw new ConfigException(file + ": cannot be read: " + e.getMessage());
    } catch (YamlSyntaxException e) {
      throw new ConfigException(
          e.line().isPresent()
              ? "%s, line %d: this is not YAML: %s."
                  .formatted(file, e.line().getAsInt(), e.problem())
              : file + ": this is not YAML.");
    }
  }

  private static String robotName(ConfigSection top) throws ConfigException {
    String name = top.text("name");
    if (!NAME.matcher(name).matches()) {
      throw top.invalid(
          "name", name, "1 to 64 letters, digits, dots, - and _, and begin with a letter or digit");
    }
    return name;
  }

  private static InetAddress address(ConfigSection top) throws ConfigException {
    String text = top.text("address", "127.0.0.1");
    try {
      return InetAddress.getByName(text);
    } catch (UnknownHostException e) {
      throw top.invalid("address", text, "an address of this machine");
    }
  }

  private static DriveKind kind(ConfigSection top) throws ConfigException {
    String word = top.text("kind", DriveKind.OMNI.word());
    for (DriveKind kind : DriveKind.values()) {
      if (kind.word().equals(word)) {
        return kind;
      }
    }
    throw top.invalid("kind", word, "omni or differential");
  }

  private static Avoidance avoidance(ConfigSection top) throws ConfigException {
    String word = top.text("avoidance", Avoidance.WEIGHTED_DIRECTIONS.word());
    for (Avoidance avoidance : Avoidance.values()) {
      if (avoidance.word().equals(word)) {
        return avoidance;
      }
    }
    throw top.invalid("avoidance", word, "weighted-directions or four-agents");
  }

  private static void checkFourAgents(Path file, AgentConfig config) throws ConfigException {
    if (config.kind != DriveKind.DIFFERENTIAL) {
      throw new ConfigException(
          "%s: \"avoidance: four-agents\" is for robots on two wheels; set \"kind: differential\", or remove it."
              .formatted(file));
    }
    if (!(config.chassis instanceof ChassisConfig.Simulated)) {
      throw new ConfigException(
          "%s: \"avoidance: four-agents\" needs eight range sensors, which a chassis of the type simulated has; remove it, or change the chassis."
              .formatted(file));
    }
  }

  private static MotionLimits limits(ConfigSection top) throws ConfigException {
    return new MotionLimits(
        top.number("maxSpeed", 0.5, 0.01, 5),
        top.number("maxTurnRate", 3.5, 0.01, 20),
        top.number("acceleration", 0.5, 0.01, 10),
        top.number("turnAcceleration", 3, 0.01, 50));
  }

  private static Following following(DriveKind kind, ConfigSection following)
      throws ConfigException {
    Gains usual = Gains.DEFAULT;
    Gains gains =
        new Gains(
            following.number("placeGain", usual.place(), Gains.SMALLEST, Gains.LARGEST),
            following.number("headingGain", usual.heading(), Gains.SMALLEST, Gains.LARGEST),
            usual.mostSpeed(),
            usual.mostTurnRate());
    double linkDelay = following.number("linkDelay", Following.DEFAULT.linkDelay(), 0, 0.2);
    FollowerLawType usualLaw = FollowerLawType.of(kind);
    String law = following.text("law", usualLaw.word());
    if (law.equals(FollowerLawType.OMNI.word()) && !kind.canGoSideways()) {
      throw following.invalid("law", law, "non-holonomic for a robot that cannot go sideways");
    }
    for (FollowerLawType type : FollowerLawType.values()) {
      if (type.word().equals(law)) {
        return new Following(type.withGains(gains), linkDelay);
      }
    }
    String allowed =
        Arrays.stream(FollowerLawType.values())
            .map(FollowerLawType::word)
            .collect(Collectors.joining(" or "));
    throw following.invalid("law", law, allowed);
  }
}
