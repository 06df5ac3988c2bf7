package org.toqa.agent.config;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.agent.EndedCommand;
import org.toqa.agent.chassis.SimulatedBattery;
import org.toqa.agent.drive.MotionLimits;
import org.toqa.agent.firmware.ArmSettings;
import org.toqa.agent.firmware.ArmSettings.JointWiring;
import org.toqa.agent.firmware.FirmwareSettings;
import org.toqa.formation.Gains;
import org.toqa.formation.NonHolonomicLaw;
import org.toqa.geometry.Pose;
import org.toqa.motion.DriveKind;

class AgentConfigTest {

  private static final String LEAST = "{name: r1, dataDir: data, chassis: {type: simulated}}";

  @TempDir Path folder;

  @Test
  void shippedFileExplainsAWorkingConfiguration() throws ConfigException {
    AgentConfig config = AgentConfig.read(Path.of("raspberry-agent", "agent.yaml"));

    assertEquals("r1", config.name());
    assertEquals(7275, config.port());
    assertEquals(new MotionLimits(0.5, 3.5, 0.5, 3), config.limits());
    assertEquals(
        new ChassisConfig.Simulated(new Pose(13.35, 3, 0), SimulatedBattery.FULL, 0.01, 1, 1),
        config.chassis());
  }

  @Test
  void simulatedMicrocontrollerIsFoundBesideTheFile() throws ConfigException, IOException {
    AgentConfig config =
        AgentConfig.read(
            file("{name: r1, dataDir: d, chassis: {type: simulated-firmware, socket: spi.sock}}"));

    assertEquals(
        new ChassisConfig.SimulatedFirmware(folder.resolve("spi.sock"), null, true),
        config.chassis());
  }

  @Test
  void spiBusHasTheClockThatTheFirmwareCanFollow() throws ConfigException, IOException {
    AgentConfig config = AgentConfig.read(file("{name: r1, dataDir: d, chassis: {type: spi}}"));

    assertEquals(
        new ChassisConfig.Spi(
            Path.of("/dev/spidev0.0"), 1_000_000, 16, true, FirmwareSettings.DEFAULT),
        config.chassis());
  }

  @Test
  void serialPortHasTheRateAtWhichTwoFramesFitIntoATick() throws ConfigException, IOException {
    AgentConfig config = AgentConfig.read(file("{name: r1, dataDir: d, chassis: {type: serial}}"));

    assertEquals(
        new ChassisConfig.Serial(Path.of("/dev/serial0"), 115_200, true, FirmwareSettings.DEFAULT),
        config.chassis());
  }

  @Test
  void adHocNetworkHasTheKeyOfItsFile() throws ConfigException, IOException {
    Path key = Files.writeString(folder.resolve("fleet.key"), "ab".repeat(32) + "\n");
    String network =
        LEAST.replace("}}", "}, adHocNetwork: {interfaces: [wlan0, eth0], key: fleet.key}}");
    Files.setPosixFilePermissions(key, PosixFilePermissions.fromString("rw-r-----"));

    assertEquals(
        new AdHocNetwork(List.of("wlan0", "eth0"), 1, "ab".repeat(32)),
        AgentConfig.read(file(network)).adHocNetwork());

    Files.setPosixFilePermissions(key, PosixFilePermissions.fromString("rw-r--r--"));
    assertRefused(network, "a file that nobody else may read or write (chmod o-rw)");
    Files.setPosixFilePermissions(key, PosixFilePermissions.fromString("rw-------"));
    Files.writeString(key, "secret");
    assertRefused(network, "a file with 64 hexadecimal digits");
    Files.delete(key);
    assertRefused(network, "a file that can be read");
  }

  private void assertRefused(String content, String sentence) {
    String said =
        assertThrows(ConfigException.class, () -> AgentConfig.read(file(content))).getMessage();
    assertTrue(said.contains(sentence), said);
  }

  @Test
  void leftOutKeysHaveTheDefaultsOfTheShippedFile() throws ConfigException, IOException {
    AgentConfig least = AgentConfig.read(file(LEAST));
    AgentConfig shipped = AgentConfig.read(Path.of("raspberry-agent", "agent.yaml"));

    assertEquals(shipped.limits(), least.limits());
    assertEquals(shipped.following(), least.following());
    assertEquals(AgentConfig.Following.DEFAULT, least.following());
    assertEquals(shipped.port(), least.port());
    assertEquals(shipped.address(), least.address());
    assertEquals(shipped.maxLoad(), least.maxLoad());
    assertEquals(shipped.footprint(), least.footprint());
    assertEquals(folder.resolve("data"), least.dataDir(), "it lies beside the file");
  }

  @Test
  void robotThatCannotGoSidewaysFollowsByTheLawForIt() throws ConfigException, IOException {
    AgentConfig config =
        AgentConfig.read(
            file("{name: r1, dataDir: d, kind: differential, chassis: {type: simulated}}"));

    assertEquals(DriveKind.DIFFERENTIAL, config.kind());
    assertEquals(new NonHolonomicLaw(Gains.DEFAULT), config.following().law());
  }

  @Test
  void robotOnTwoWheelsMayHaveFourAgentsAndEightSensors() throws ConfigException, IOException {
    String kind = "{name: r1, dataDir: d, kind: differential, chassis: {type: simulated}%s}";
    AgentConfig usual = AgentConfig.read(file(kind.formatted("")));
    AgentConfig config = AgentConfig.read(file(kind.formatted(", avoidance: four-agents")));

    assertEquals(Avoidance.WEIGHTED_DIRECTIONS, usual.avoidance());
    assertEquals(Avoidance.FOUR_AGENTS, config.avoidance());
    assertEquals(3, usual.rangeSensors().beams().size());
    assertEquals(8, config.rangeSensors().beams().size());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          {name: r1, dataDir: d, maxSped: 1}  | there is no key "maxSped"; did you mean "maxSpeed"?
          {name: r1, dataDir: d, chassis: {type: simulated, nois: 0}} | there is no key "chassis.nois"; did you mean "chassis.noise"?
          {name: r1, dataDir: d, chassis: {type: simulated, start: {X: 1}}} | there is no key "chassis.start.X"; did you mean "chassis.start.x"?
          {name: r1, dataDir: d, chassis: {type: wheels}} | "chassis.type" is wheels; it must be simulated, simulated-firmware, spi or serial.
          {name: r1, dataDir: d, chassis: {type: spi, clock: 4000000}} | "chassis.clock" is 4000000; it must be a whole number from 100000 to 2000000.
          {name: r1, dataDir: d, chassis: {type: spi, wordDelay: 8}} | "chassis.wordDelay" is 8; it must be a whole number from 12 to 100.
          {name: r1, dataDir: d, chassis: {type: spi, wheelRadius: 0.1}} | "chassis.wheelRadius" is 0.1; it must be a number from 0.01 to 0.065.
          {name: r1, dataDir: d, chassis: {type: spi, centreToWheel: 1}} | "chassis.centreToWheel" is 1; it must be a number from 0.03 to 0.5.
          {name: r1, dataDir: d, chassis: {type: spi, floorThresholds: [1, 1, 1, 1]}} | "chassis.floorThresholds" is [1, 1, 1, 1]; it must be a list of 5 numbers from 0.1 to 4.9.
          {name: r1, dataDir: d, chassis: {type: serial, floorThresholds: [1, 1, 5, 1, 1]}} | "chassis.floorThresholds" is [1, 1, 5, 1, 1]; it must be a list of 5 numbers from 0.1 to 4.9.
          {name: r1, dataDir: d, chassis: {type: serial, baud: 9600}} | "chassis.baud" is 9600; it must be a whole number from 115200 to 1000000.
          {name: r1, dataDir: d, chassis: {type: simulated-firmware}} | the key "chassis.socket" is missing.
          {name: r1, dataDir: d, following: {law: fly}} | "following.law" is fly; it must be omni or non-holonomic.
          {name: r1, dataDir: d, kind: legs} | "kind" is legs; it must be omni or differential.
          {name: r1, dataDir: d, avoidance: luck} | "avoidance" is luck; it must be weighted-directions or four-agents.
          {name: r1, dataDir: d, avoidance: four-agents, chassis: {type: simulated}} | "avoidance: four-agents" is for robots on two wheels; set "kind: differential", or remove it.
          {name: r1, dataDir: d, avoidance: four-agents, kind: differential, chassis: {type: serial}} | "avoidance: four-agents" needs eight range sensors, which a chassis of the type simulated has; remove it, or change the chassis.
          {name: r1, dataDir: d, kind: differential, following: {law: omni}} | "following.law" is omni; it must be non-holonomic for a robot that cannot go sideways.
          {name: r1, dataDir: d, kind: differential, chassis: {type: spi}} | "kind" is differential; it must be omni: this project's microcontroller turns three omni wheels.
          {name: r1, dataDir: d, following: {placeGain: 50}} | "following.placeGain" is 50; it must be a number from 0.1 to 5.
          {name: r1, dataDir: d, chassis: {type: simulated}, adHocNetwork: {}} | "adHocNetwork.interfaces" is []; it must be 1 to 8 network interfaces, as in [wlan0].
          {name: r1, dataDir: d, chassis: {type: simulated}, adHocNetwork: {interfaces: wlan0}} | "adHocNetwork.interfaces" is wlan0; it must be a list of texts, as in [wlan0].
          {name: r1, dataDir: d, chassis: {type: simulated}, adHocNetwork: {interfaces: ["a b"]}} | "adHocNetwork.interfaces" is [a b]; it must be 1 to 8 network interfaces, as in [wlan0].
          {name: r1, dataDir: d, chassis: {type: simulated}, adHocNetwork: {interfaces: [wlan0], hello: 0}} | "adHocNetwork.hello" is 0; it must be a number from 0.1 to 60.
          {name: r1, dataDir: d, chassis: {type: simulated}, adHocNetwork: {interfaces: [wlan0], keys: k}} | there is no key "adHocNetwork.keys"; did you mean "adHocNetwork.key"?
          {name: r1, dataDir: d}              | the key "chassis.type" is missing.
          {dataDir: d}                        | the key "name" is missing.
          {name: a b, dataDir: d}             | "name" is a b; it must be 1 to 64 letters, digits, dots, - and _, and begin with a letter or digit.
          {name: 7, dataDir: d}               | "name" is 7; it must be a text.
          {name: r1, dataDir: d, port: 70000} | "port" is 70000; it must be a whole number from 0 to 65535.
          {name: r1, dataDir: d, port: 1.5}   | "port" is 1.5; it must be a whole number from 0 to 65535.
          {name: r1, dataDir: d, maxSpeed: 9} | "maxSpeed" is 9; it must be a number from 0.01 to 5.
          {name: r1, dataDir: d, maxSpeed: 2, chassis: {type: spi}} | "maxSpeed" is 2; it must be a number from 0.01 to 1.
          {name: r1, dataDir: d, maxSpeed: .nan} | "maxSpeed" is NaN; it must be a number from 0.01 to 5.
          {name: r1, dataDir: d, maxSpeed: fast} | "maxSpeed" is fast; it must be a number from 0.01 to 5.
          {name: r1, dataDir: d, plainTcpOffLoopback: maybe} | "plainTcpOffLoopback" is maybe; it must be true or false.
          {name: r1, dataDir: d, chassis: 3}  | "chassis" is 3; it must be keys of its own, indented below it.
          just words                          | this is not a list of keys and values.
          """)
  void wrongFileIsToldInOneLine(String yaml, String line) throws IOException {
    Path file = file(yaml);

    ConfigException e = assertThrows(ConfigException.class, () -> AgentConfig.read(file));
    assertEquals(file + ": " + line, e.getMessage());
  }

  @Test
  void armIsReadInDegreesAndHasTheMeasuresOfTheShippedFileWhereNothingIsSaid()
      throws ConfigException, IOException {
    assertNull(AgentConfig.read(file(LEAST)).arm());
    ArmConfig usual = AgentConfig.read(file(withArm("{}"))).arm();
    String shipped =
        Files.readString(Path.of("raspberry-agent", "agent.yaml"))
            .replaceAll("(?m)^# ?(arm:|  )", "$1");
    ArmConfig explained = AgentConfig.read(file(shipped)).arm();
    assertEquals(usual, explained);
    ArmConfig own =
        Objects.requireNonNull(
            AgentConfig.read(
                    file(withArm("{upperLink: 0.4, elbow: {least: 0, most: 90}, boxWeight: 1.5}")))
                .arm());
    assertEquals(0.4, own.arm().upperLink());
    assertEquals(Math.PI / 2, own.arm().elbow().most(), 1e-12);
    assertEquals(0, own.arm().rest().elbow(), "the nearest to the usual one");
    assertEquals(1.5, own.boxWeight());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "{upperLink: 0} | \"arm.upperLink\" is 0; it must be a number from 0.02 to 10.",
        "{shoulder: {least: 100, most: 50}} | \"arm.shoulder.most\" is 50; it must be a number from 101 to 360.",
        "{elbow: {least: -90, most: 90}, rest: {elbow: 91}} | \"arm.rest.elbow\" is 91; it must be a number from -90 to 90.",
        "{shoulder: {pulses: [500, 550]}} | \"arm.shoulder.pulses\" is [500.0, 550.0]; it must be two numbers at least 100.0 apart.",
        "{elbow: {volts: [1, 6]}} | \"arm.elbow.volts\" is [1, 6]; it must be a list of 2 numbers from 0 to 5.",
        "{hand: {openPulse: 3000}} | \"arm.hand.openPulse\" is 3000; it must be a number from 400 to 2600.",
        "{loadSensor: {voltsPerKilogram: 0}} | \"arm.loadSensor.voltsPerKilogram\" is 0; it must be a number from 0.1 to 5.",
        "{lenght: 1} | there is no key \"arm.lenght\"; there are: upperLink, ",
        "5 | \"arm\" is 5; it must be keys of its own, indented below it.",
      })
  void armThatCannotBeIsRefused(String arm, String sentence) throws IOException {
    Path file = file(withArm(arm));
    ConfigException e = assertThrows(ConfigException.class, () -> AgentConfig.read(file));
    assertTrue(String.valueOf(e.getMessage()).startsWith(file + ": " + sentence), e.getMessage());
  }

  @Test
  void microcontrollerMovesAnArmThatIsWiredAsIsSaid() throws ConfigException, IOException {
    String arm =
        "{elbow: {pulses: [2400, 600], volts: [4.5, 0.5]}, hand: {openPulse: 900},"
            + " loadSensor: {emptyVolts: 1}}";
    ArmConfig read =
        Objects.requireNonNull(
            AgentConfig.read(file(withArm(arm).replace("type: simulated", "type: spi"))).arm());
    ArmSettings settings = read.settings();
    assertEquals(JointWiring.DEFAULT, settings.shoulder());
    assertEquals(new JointWiring(2_400, 600, 4.5, 0.5), settings.elbow());
    assertEquals(900, settings.openPulse());
    assertEquals(1, settings.emptyVolts());
  }

  private static String withArm(String arm) {
    return LEAST.replace("}}", "}, arm: " + arm + "}");
  }

  @Test
  void brokenYamlIsToldWithItsLine() throws IOException {
    Path file = file("name: r1\nport: [1\n");

    ConfigException e = assertThrows(ConfigException.class, () -> AgentConfig.read(file));
    assertTrue(String.valueOf(e.getMessage()).startsWith(file + ", line 3: this is not YAML: "));
  }

  @Test
  void keyThatStandsTwiceIsRefused() throws IOException {
    Path file = file("name: r1\nname: r2\n");

    assertThrows(ConfigException.class, () -> AgentConfig.read(file));
  }

  @Test
  void namedPermissionOpensTheLink() throws IOException, ConfigException {
    Path file = file(LEAST.replace("}}", "}, address: 0.0.0.0, plainTcpOffLoopback: true}"));

    assertEquals(InetAddress.getByName("0.0.0.0"), AgentConfig.read(file).address());
  }

  @Test
  void commandLineEndsWithTwoAfterAWrongConfiguration() throws IOException {
    Path wrong = file("{name: r1, dataDir: d, prot: 1, chassis: {type: simulated}}");

    assertEquals(
        new EndedCommand(
            2, "toqa: " + wrong + ": there is no key \"prot\"; did you mean \"port\"?\n"),
        EndedCommand.of("--config", wrong.toString()));
    assertEquals(
        new EndedCommand(2, "toqa: " + folder.resolve("none") + ": there is no such file.\n"),
        EndedCommand.of("--config", folder.resolve("none").toString()));
    assertEquals(2, EndedCommand.of().exitCode());
    assertEquals(2, EndedCommand.of("--confg", "x").exitCode());
    assertEquals(0, EndedCommand.of("--help").exitCode());
  }

  @Test
  void commandLineEndsWithOneWhereThePortIsTaken() throws IOException {
    try (ServerSocket taken = new ServerSocket(0)) {
      Path file = file(LEAST.replace("}}", "}, port: " + taken.getLocalPort() + "}"));

      EndedCommand ended = EndedCommand.of("--config", file.toString());
      assertEquals(1, ended.exitCode());
      assertEquals(1, ended.errors().lines().count(), ended.errors());
    }
  }

  private Path file(String yaml) throws IOException {
    return Files.writeString(folder.resolve("agent.yaml"), yaml);
  }
}
