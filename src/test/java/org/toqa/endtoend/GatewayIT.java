package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.Timeout.ThreadMode;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.link.trust.IdentityFile;
import org.toqa.testbed.Needed;
import org.toqa.testbed.PrivateNetwork;
import org.toqa.testbed.ToqaProcess;
import tools.jackson.databind.JsonNode;

/** A packaged server, and a site behind address translation with a gateway and a paired robot. */
@Tag("full")
@Timeout(value = 240, threadMode = ThreadMode.SEPARATE_THREAD)
class GatewayIT {
  private static final int ROBOT_PORT = 7275;

  @TempDir private Path folder;

  private PrivateNetwork network;

  /** Waits until nobody browses, which takes nothing of the test's time. */
  @BeforeEach
  void openNetwork() throws Exception {
    Needed.orLeftOut(
        PrivateNetwork.isAllowed(),
        "network namespaces with address translation: run it as root, with ip and nft (Debian:"
            + " iproute2, nftables)");
    network = new PrivateNetwork();
  }

  @AfterEach
  void closeNetwork() throws Exception {
    if (network != null) {
      network.close();
    }
  }

  @Test
  void aRobotOnAPrivateAddressIsPairedAndServedThroughAGateway() throws Exception {
    try (RunningServer server = server()) {
      try (ToqaProcess daemon = daemon();
          ToqaProcess gateway = gateway(server)) {
        String code = daemon.awaitErr("Pairing code: (\\S+)").group(1);
        gateway.awaitErr("Connected to the server");
        assertThrows(IOException.class, () -> connectDirectly(), "it is private");

        server.api().post("robots", robot(code));
        JsonNode paired =
            server.await("robots/r1", robot -> robot.get("state").asString().equals("IDLE"));
        assertEquals("dock", paired.get("gateway").asString());
        JsonNode connected = server.api().get("fleet").get("gateways").get(0);
        assertEquals(network.router(), connected.get("address").asString());

        long task = server.addTask("gearbox", "Packing 1", "Packing 2");
        server.awaitState(task, "CARRYING");
        network.cut();
        JsonNode lost =
            server.await(
                "robots/r1",
                robot ->
                    robot.get("state").asString().equals("LOST") && !robot.get("alert").isNull());
        assertTrue(lost.get("alert").asString().contains("its gateway dock is not connected"));
        network.mend();
        server.awaitState(task, "DONE");
      }
    }
  }

  private RunningServer server() throws Exception {
    String dock = fingerprint("gateway-data");
    Path config =
        Files.writeString(
            folder.resolve("server.yaml"),
            """
            data: data
            gateways: {trusted: "dock=%s", address: %s, port: 0}
            """
                .formatted(dock, network.server()));
    return new RunningServer(folder, "--config", config.toString());
  }

  /** Of the key that it will find in its data folder. */
  private String fingerprint(String data) throws IOException {
    return IdentityFile.open(Files.createDirectories(folder.resolve(data))).fingerprint().hex();
  }

  private ToqaProcess gateway(RunningServer server) throws Exception {
    int port = Integer.parseInt(server.awaitErr("Gateways connect to port (\\d+)").group(1));
    Path config =
        Files.writeString(
            folder.resolve("gateway.yaml"),
            """
            server: %s
            port: %d
            fingerprint: %s
            data: gateway-data
            robots: [%s]
            """
                .formatted(network.server(), port, fingerprint("data"), network.plant()));
    return java("target/toqa.war", "gateway", "--config", config.toString());
  }

  private ToqaProcess daemon() throws Exception {
    Path config =
        Files.writeString(
            folder.resolve("agent.yaml"),
            """
            name: r1
            address: %s
            port: %d
            dataDir: robot
            chassis: {type: simulated, start: {x: 7.95, y: 3.15, heading: 0}, speed: 4}
            """
                .formatted(network.plant(), ROBOT_PORT));
    return java("target/toqa-agent.jar", "--config", config.toString(), "--pair");
  }

  private ToqaProcess java(String jar, String... arguments) throws IOException {
    List<String> command =
        new ArrayList<>(
            List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx64m",
                "-XX:TieredStopAtLevel=1",
                "-XX:+UseSerialGC",
                "-jar",
                Path.of(jar).toAbsolutePath().toString()));
    command.addAll(List.of(arguments));
    return ToqaProcess.command(folder, network.inside(command));
  }

  private Map<String, Object> robot(String code) {
    return Map.of(
        "name",
        "r1",
        "host",
        network.plant(),
        "port",
        ROBOT_PORT,
        "maxLoad",
        5,
        "code",
        code,
        "gateway",
        "dock");
  }

  private void connectDirectly() throws IOException {
    try (Socket socket = new Socket()) {
      socket.connect(new InetSocketAddress(network.plant(), ROBOT_PORT), 500);
    }
  }
}
