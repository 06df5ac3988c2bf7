package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.geometry.Pose;
import org.toqa.link.message.AgentMessage.Mode;
import org.toqa.link.message.AgentMessage.State;
import org.toqa.link.message.ServerMessage.Drive;
import org.toqa.motion.Segment;
import org.toqa.testbed.Needed;
import org.toqa.testbed.ToqaProcess;

/** A packaged daemon whose wall clock is set in the middle of a drive, as a time server does it. */
@Tag("full")
@Timeout(120)
class ClockJumpIT {
  /** 4 m. */
  private static final List<Segment> SEGMENTS = List.of(new Segment(0.25, 0, 16));

  @TempDir private Path folder;

  @Test
  void robotDrivesOnAsIfNothingHadHappened() throws Exception {
    Optional<Path> library = library();
    Needed.orLeftOut(
        library.isPresent(),
        "libfaketime, which sets the clock (Debian: apt-get install faketime)");
    Path clock = Files.writeString(folder.resolve("clock"), "+0");
    try (ToqaProcess daemon = daemon(library.get(), clock);
        FormationServer server =
            FormationServer.plain(
                Integer.parseInt(daemon.awaitErr("listening on .* port (\\d+)").group(1)))) {
      Pose start = server.awaitHello().pose();
      server.assertAccepted(new Drive(1, 5L, 1, start, SEGMENTS, 1, true, 0));
      long before = server.awaitState(s -> s.pose().x() > start.x() + 0.5).stamp();

      Files.writeString(clock, "+3600");
      State later = server.awaitState(s -> s.pose().x() > start.x() + 1.5);
      assertTrue(between(before, later.stamp()).compareTo(Duration.ofMinutes(59)) > 0, "it jumped");
      Files.writeString(clock, "-86400");
      State yesterday = server.awaitState(s -> s.pose().x() > start.x() + 2.5);
      assertTrue(between(before, yesterday.stamp()).isNegative(), "it jumped back");

      State atEnd = server.awaitState(s -> s.mode() == Mode.IDLE);
      assertEquals(start.x() + 4, atEnd.pose().x(), 0.02);
      assertEquals(5L, server.awaitDone().task());
      assertTrue(
          server.states().stream().allMatch(s -> s.mode() != Mode.HOLDING && s.errors().isEmpty()));
    }
  }

  private static Duration between(long from, long to) {
    return Duration.ofMillis(to - from);
  }

  /** Programs that load this ask a file what time it is. */
  private static Optional<Path> library() throws IOException {
    try (Stream<Path> found =
        Files.find(
            Path.of("/usr/lib"), 3, (path, _) -> path.endsWith("faketime/libfaketimeMT.so.1"))) {
      return found.findFirst();
    }
  }

  private ToqaProcess daemon(Path library, Path clock) throws IOException {
    Path config =
        Files.writeString(
            folder.resolve("r1.yaml"),
            """
            name: r1
            port: 0
            dataDir: r1
            chassis: {type: simulated, noise: 0, start: {x: 1, y: 1}}
            """);
    return ToqaProcess.command(
        folder,
        "env",
        "LD_PRELOAD=" + library,
        "FAKETIME_TIMESTAMP_FILE=" + clock,
        "FAKETIME_CACHE_DURATION=1",
        "FAKETIME_DISABLE_SHM=1",
        "FAKETIME_DONT_FAKE_MONOTONIC=1",
        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
        "-Xmx64m",
        "-jar",
        Path.of("target/toqa-agent.jar").toAbsolutePath().toString(),
        "--config",
        config.toString());
  }
}
