package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.agent.firmware.FirmwareBuild;
import org.toqa.agent.firmware.SimulatorProbe;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.motion.Segment;
import org.toqa.sim.SimulatedMicrocontroller;
import org.toqa.testbed.Needed;
import org.toqa.testbed.ToqaProcess;

/**
 * The service that {@code docs/robot.md} has people install: what it installs lies in a folder that
 * stands for the robot's file system, and there the unit's own line is run, over the firmware.
 */
@Tag("full")
@Timeout(180)
class ServiceUnitIT {
  private static final Path UNIT = Path.of("raspberry-agent/toqa-agent.service");
  private static final Path GUIDE = Path.of("docs/robot.md");
  private static final Pattern INSTALLED =
      Pattern.compile("(?m)^ +install -D -m (\\d+) (\\S+) (/\\S+)$");

  private static final double SPEED = 0.25; // m/s

  /** After its last word, from the daemon's end or by the firmware's own watch over the link. */
  private static final Duration STAND_LIMIT = Duration.ofMillis(250);

  @TempDir private Path root;
  private SystemdUnit unit;
  private String guide;

  @BeforeEach
  void read() throws IOException {
    unit = SystemdUnit.read(UNIT);
    guide = Files.readString(GUIDE);
  }

  @Test
  void systemdUnderstandsEveryLine() throws Exception {
    Path systemd = Path.of("/usr/bin/systemd-analyze");
    Needed.orLeftOut(Files.isExecutable(systemd), systemd + " (Debian: apt-get install systemd)");
    String program = unit.command().getFirst();
    assertEquals("/usr/bin/java", program); // where Debian's packages of Java put it
    Path copy =
        Files.writeString(
            root.resolve(UNIT.getFileName()),
            Files.readString(UNIT).replace("ExecStart=" + program, "ExecStart=" + java()));

    Process check =
        new ProcessBuilder(systemd.toString(), "--man=no", "verify", copy.toString())
            .redirectErrorStream(true)
            .start();

    // it ends with 0 also where it ignores a line
    assertEquals("", new String(check.getInputStream().readAllBytes(), StandardCharsets.UTF_8));
    assertEquals(0, check.waitFor());
  }

  @Test
  void unitAgreesWithWhatTheGuideSays() {
    assertTrue(guide.contains("useradd --system --home-dir /var/lib/toqa " + unit.service("User")));
    assertTrue(guide.contains("takes a Java 25 runtime and 64 MB of heap"));
    assertTrue(unit.command().contains("-Xmx64m"), unit.command()::toString);
    assertTrue(guide.contains("tries again every " + unit.seconds("RestartSec") + " s"));
    // where nothing else is said, systemd gives up at the fifth start in 10 s
    assertTrue(unit.seconds("RestartSec") * 5 >= 10);
    assertTrue(unit.isRestartedWhenFailed());
    assertEquals("/var/lib/" + unit.service("StateDirectory"), dataFolder());
  }

  @Test
  void toldToEndWhileItDrivesItEndsInTimeAndTheRobotStands() throws Exception {
    try (SimulatedMicrocontroller microcontroller = FirmwareBuild.LM629_AT_16_MHZ.start(root);
        SimulatorProbe probe = new SimulatorProbe(microcontroller.socket())) {
      install(
          "{type: simulated-firmware, socket: %s, start: {x: 2, y: 3}}"
              .formatted(microcontroller.socket()));
      try (ToqaProcess daemon = start();
          FormationServer server = FormationServer.plain(port(daemon))) {
        server.assertAccepted(
            new Drive(
                1,
                5L,
                1,
                server.awaitHello().pose(),
                List.of(new Segment(SPEED, 0, 60)),
                1,
                true,
                0));
        server.awaitState(state -> state.twist().v() > 0.9 * SPEED);

        daemon.terminate();
        int exitCode = daemon.exitCode(Duration.ofSeconds(unit.seconds("TimeoutStopSec")));

        assertTrue(unit.isSuccess(exitCode), () -> "ended with " + exitCode);
        // the simulated world goes on without the daemon
        probe.advance(STAND_LIMIT);
        Duration rolledOn = probe.truth().rolledOn();
        assertTrue(rolledOn.compareTo(STAND_LIMIT) <= 0, rolledOn::toString);
      }
    }
  }

  @Test
  void killedItIsStartedAgainKnowsWhereItIsAndWritesOnlyWhereItMay() throws Exception {
    install("{type: simulated, noise: 0, start: {x: 2, y: 3}}");
    Set<Path> installed = files();
    try (ToqaProcess daemon = start();
        FormationServer server = FormationServer.plain(port(daemon))) {
      server.assertAccepted(
          new Drive(
              1, 5L, 1, server.awaitHello().pose(), List.of(new Segment(SPEED, 0, 2)), 1, true, 0));
      server.awaitDone();
      daemon.kill();
      assertNotEquals(0, daemon.exitCode());
    }
    assertTrue(unit.isRestartedWhenKilled());
    try (ToqaProcess daemon = start();
        FormationServer server = FormationServer.plain(port(daemon))) {
      assertTrue(server.awaitHello().localised());
      assertEquals(2.5, server.awaitHello().pose().x(), 0.02); // 2 m + 2 s * 0.25 m/s
      daemon.terminate();
      assertTrue(unit.isSuccess(daemon.exitCode()));
    }
    Path state = root.resolve("var/lib").resolve(unit.service("StateDirectory"));
    Set<Path> written = files();
    written.removeAll(installed);
    assertTrue(written.stream().anyMatch(file -> file.startsWith(state)), written::toString);
    written.removeIf(file -> file.startsWith(state) || file.startsWith(root.resolve("cache")));
    assertEquals(Set.of(), written);
  }

  /** As the guide's commands do it. */
  private void install(String chassis) throws IOException {
    Path config =
        Files.writeString(
            root.resolve("agent.yaml"),
            """
            name: r1
            port: 0
            dataDir: %s
            chassis: %s
            """
                .formatted(root + dataFolder(), chassis));
    for (MatchResult command : INSTALLED.matcher(guide).results().toList()) {
      Path source =
          switch (command.group(2)) {
            case "toqa-agent.jar" -> Path.of("target/toqa-agent.jar");
            case "toqa-agent.service" -> UNIT;
            case "agent.yaml" -> config;
            default -> throw new AssertionError(command.group(2) + " is not known");
          };
      Path target = Path.of(root + command.group(3));
      Files.createDirectories(Objects.requireNonNull(target.getParent()));
      Files.copy(source, target);
    }
    Files.createDirectories(root.resolve("usr/bin"));
    Files.createSymbolicLink(root.resolve("usr/bin/java"), java());
    Files.createDirectories(root.resolve("var/lib").resolve(unit.service("StateDirectory")));
  }

  private String dataFolder() {
    MatchResult row =
        Pattern.compile("\\| `dataDir` \\| `(\\S+)` \\|")
            .matcher(guide)
            .results()
            .findFirst()
            .get();
    return row.group(1);
  }

  private ToqaProcess start() throws IOException {
    return ToqaProcess.command(root, unit.commandIn(root).toArray(String[]::new));
  }

  private static int port(ToqaProcess daemon) throws InterruptedException {
    return Integer.parseInt(daemon.awaitErr("listening on .* port (\\d+)").group(1));
  }

  private Set<Path> files() throws IOException {
    try (Stream<Path> all = Files.walk(root)) {
      return all.filter(Files::isRegularFile).collect(Collectors.toCollection(HashSet::new));
    }
  }

  private static Path java() {
    return Path.of(System.getProperty("java.home"), "bin", "java");
  }
}
