package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.Timeout.ThreadMode;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.Needed;
import org.toqa.testbed.RadioNetwork;
import org.toqa.testbed.ToqaProcess;
import tools.jackson.databind.JsonNode;

/**
 * A packaged server behind a base station, and a chain of paired robots: r1 hears the base, r2
 * hears r1, r3 hears r2 alone; until that link is cut while r3 carries, and r3 hears r1.
 */
@Tag("full")
@Timeout(value = 240, threadMode = ThreadMode.SEPARATE_THREAD)
class AdHocNetworkIT {
  private static final int ROBOTS = 3;
  private static final int ROBOT_PORT = 7275;

  /** Surely, also on a busy machine. */
  private static final Duration REACHED_WITHIN = Duration.ofMinutes(5);

  private static final Duration BETWEEN_TRIES = Duration.ofMillis(50);
  private static final String KEY = "00112233445566778899aabbccddeeff".repeat(2);

  /** Where they are at first; r3 is nearest to the load. */
  private static final String[] STARTS = {
    "x: 13.35, y: 1.05", "x: 14.25, y: 1.05", "x: 7.95, y: 3.15"
  };

  @TempDir private Path folder;
  private RadioNetwork radio;

  /** Waits until nobody browses, which takes nothing of the test's time. */
  @BeforeEach
  void openNetwork() throws Exception {
    Needed.orLeftOut(
        RadioNetwork.isAllowed() && Files.isExecutable(Path.of("/usr/sbin/babeld")),
        "network namespaces and babeld: run it as root, with ip, nft and babeld (Debian: iproute2,"
            + " nftables, babeld)");
    radio = new RadioNetwork(ROBOTS + 1);
  }

  @AfterEach
  void closeNetwork() throws Exception {
    if (radio != null) {
      radio.close();
    }
  }

  @Test
  void aRobotCarriesATaskThroughARouteThatMends() throws Exception {
    List<ToqaProcess> daemons = new ArrayList<>();
    try (ToqaProcess base = base();
        RunningServer server = new RunningServer(folder)) {
      radio.join(0, 1);
      radio.join(1, 2);
      radio.join(2, 3);
      try {
        for (int robot = 1; robot <= ROBOTS; robot++) {
          daemons.add(daemon(robot));
        }
        for (int robot = 1; robot <= ROBOTS; robot++) {
          String code = daemons.get(robot - 1).awaitErr("Pairing code: (\\S+)").group(1);
          awaitReached(radio.address(robot));
          server.api().post("robots", robot(robot, code));
        }
        for (int robot = 1; robot <= ROBOTS; robot++) {
          awaitRoute(server, robot, radio.address(robot - 1), "IDLE");
        }
        JsonNode farthest = server.api().get("robots/r3");
        assertTrue(farthest.get("networkRoute").get("metric").asInt() >= 3 * 256 * 9 / 10);
        assertTrue(farthest.get("fingerprint").isString(), "it is paired");

        long task = server.addTask("gearbox", "Packing 1", "Packing 2");
        server.awaitState(task, "CARRYING");
        assertEquals("r3", server.task(task).get("robots").get(0).asString());
        radio.cut(2, 3);
        radio.join(1, 3);
        awaitRoute(server, 3, radio.address(1), "");
        server.awaitState(task, "DONE");
      } finally {
        daemons.forEach(ToqaProcess::terminate);
        for (ToqaProcess daemon : daemons) {
          daemon.exitCode();
        }
      }
      base.terminate();
      base.exitCode();
    }
  }

  /**
   * @param state that it is in; empty: any
   */
  private static void awaitRoute(RunningServer server, int robot, String nextHop, String state)
      throws Exception {
    server.await(
        "robots/r" + robot,
        now ->
            now.get("networkRoute").isObject()
                && now.get("networkRoute").get("nextHop").asString().equals(nextHop)
                && (state.isEmpty() || now.get("state").asString().equals(state)));
  }

  /** As it is set up by docs/network.md. */
  private ToqaProcess base() throws Exception {
    Path config =
        Files.writeString(
            folder.resolve("babeld.conf"),
            """
            random-id true
            key id fleet type hmac-sha256 value %s
            interface wlan0 type wireless hello-interval 0.2 key fleet
            redistribute ip %s/32 allow
            redistribute local ip 0.0.0.0/0 if wlan0 allow
            redistribute local deny
            redistribute deny
            in ip 0.0.0.0/0 ge 32 allow
            in deny
            """
                .formatted(KEY, radio.server()));
    List<String> command = new ArrayList<>(radio.on(0));
    command.addAll(List.of("babeld", "-c", config.toString(), "-I", ""));
    command.addAll(List.of("-S", folder.resolve("babel-state").toString()));
    return ToqaProcess.command(folder, command.toArray(String[]::new));
  }

  private ToqaProcess daemon(int robot) throws IOException {
    Path key = folder.resolve("fleet.key");
    Files.writeString(key, KEY);
    Files.setPosixFilePermissions(key, PosixFilePermissions.fromString("rw-------"));
    Path config =
        Files.writeString(
            folder.resolve("r%d.yaml".formatted(robot)),
            """
            name: r%1$d
            address: %2$s
            port: %3$d
            dataDir: r%1$d
            adHocNetwork: {interfaces: [wlan0], hello: 0.2, key: fleet.key}
            chassis: {type: simulated, speed: 4, start: {%4$s, heading: 0}}
            """
                .formatted(robot, radio.address(robot), ROBOT_PORT, STARTS[robot - 1]));
    return ToqaProcess.agentBy(radio.on(robot), folder, "--config", config.toString(), "--pair");
  }

  /** Routes take a moment. */
  private static void awaitReached(String address) throws IOException {
    long end = System.nanoTime() + REACHED_WITHIN.toNanos();
    while (true) {
      try (Socket socket = new Socket()) {
        socket.connect(new InetSocketAddress(address, ROBOT_PORT), 500);
        return;
      } catch (IOException e) {
        if (System.nanoTime() > end) {
          throw e;
        }
        LockSupport.parkNanos(BETWEEN_TRIES.toNanos());
      }
    }
  }

  private Map<String, Object> robot(int robot, String code) {
    return Map.of(
        "name",
        "r" + robot,
        "host",
        radio.address(robot),
        "port",
        ROBOT_PORT,
        "maxLoad",
        5,
        "code",
        code);
  }
}
