package org.toqa.agent.routing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.agent.config.AdHocNetwork;
import org.toqa.link.message.AgentMessage.NetworkRoute;
import org.toqa.testbed.Needed;
import org.toqa.testbed.RadioNetwork;

/** Four real babelds, each in a network of its own, whose neighbours come and go. */
@Tag("full")
class AdHocRoutingTest {
  private static final int NODES = 4;
  private static final Duration LIMIT = Duration.ofSeconds(60);
  private static final long BETWEEN_TRIES_NANOS = 50_000_000;
  private static final int PING_MILLIS = 200;
  private static final AdHocNetwork NETWORK =
      new AdHocNetwork(List.of("wlan0"), 0.2, "0123456789abcdef".repeat(4));

  @TempDir private Path folder;
  private RadioNetwork radio;
  private final List<BabeldProcess> processes = new ArrayList<>();
  private final List<ProcessHandle> handles = new ArrayList<>();
  private final List<Babeld> nodes = new ArrayList<>();

  @BeforeEach
  void start() throws Exception {
    Needed.orLeftOut(
        RadioNetwork.isAllowed() && isInstalled(),
        "network namespaces and babeld: run it as root, with ip, nft and babeld (Debian: iproute2,"
            + " nftables, babeld)");
    radio = new RadioNetwork(NODES);
    for (int node = 0; node < NODES; node++) {
      processes.add(process(node, configuration(node)));
      handles.add(processes.get(node).start());
      nodes.add(new Babeld("r" + node, processes.get(node), handles.get(node)));
    }
  }

  private static boolean isInstalled() {
    try {
      HostCheck.here().program("babeld");
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  @AfterEach
  void stop() throws Exception {
    nodes.forEach(Babeld::close);
    if (radio != null) {
      radio.close();
    }
    assertTrue(handles.stream().noneMatch(ProcessHandle::isAlive));
  }

  /** The base station announces the server that it is wired to. */
  private String configuration(int node) {
    String announced = node == 0 ? "redistribute ip " + radio.server() + "/32 allow\n" : "";
    return announced + BabeldFile.text(NETWORK);
  }

  private BabeldProcess process(int node, String configuration) throws IOException {
    Path own = Files.createDirectories(folder.resolve("n" + node));
    return new BabeldProcess(
        program(node, own, "babeld"), program(node, own, "ip"), own, configuration);
  }

  /** One that runs on that node. */
  private Path program(int node, Path own, String name) throws IOException {
    String command = String.join(" ", radio.on(node)) + " " + HostCheck.here().program(name);
    Path program = own.resolve(name);
    Files.writeString(program, "#!/bin/sh\nexec " + command + " \"$@\"\n");
    assertTrue(program.toFile().setExecutable(true));
    return program;
  }

  private static void await(Callable<Boolean> condition) throws Exception {
    long end = System.nanoTime() + LIMIT.toNanos();
    while (!condition.call()) {
      assertTrue(System.nanoTime() < end, "it does not come about");
      LockSupport.parkNanos(BETWEEN_TRIES_NANOS);
    }
  }

  private void awaitVia(int node, int nextHop) throws Exception {
    await(() -> nextHop(node).equals(Optional.of(radio.address(nextHop))));
    await(() -> InetAddress.getByName(radio.address(node)).isReachable(PING_MILLIS));
  }

  private Optional<NetworkRoute> route(int node) throws IOException {
    return nodes.get(node).routeTo(InetAddress.getByName(radio.server()));
  }

  private Optional<String> nextHop(int node) throws IOException {
    return route(node).map(NetworkRoute::nextHop);
  }

  @Test
  void chainIsHeldTogetherAndMendedWhicheverLinkIsCut() throws Exception {
    int[][] ring = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
    radio.join(0, 1);
    radio.join(1, 2);
    radio.join(2, 3);
    awaitVia(1, 0);
    awaitVia(2, 1);
    awaitVia(3, 2);
    await(() -> route(3).map(NetworkRoute::metric).filter(metric -> metric >= 700).isPresent());
    await(() -> route(3).map(NetworkRoute::quality).equals(Optional.of(1.0)));

    // of a ring each link in turn: what is left is a chain, whichever it is
    radio.join(3, 0);
    for (int[] link : ring) {
      radio.cut(link[0], link[1]);
      for (int node = 1; node < NODES; node++) {
        int asked = node;
        await(() -> InetAddress.getByName(radio.address(asked)).isReachable(PING_MILLIS));
      }
      radio.join(link[0], link[1]);
    }
  }

  @Test
  void whoIsCutOffHasNoRouteAndComesBack() throws Exception {
    radio.join(0, 1);
    awaitVia(1, 0);
    radio.cut(0, 1);
    await(() -> route(1).isEmpty());
    radio.join(0, 1);
    awaitVia(1, 0);
  }

  @Test
  void killedBabeldIsToldAndStartedAgain() throws Exception {
    radio.join(0, 1);
    radio.join(1, 2);
    awaitVia(2, 1);
    assertEquals(Optional.empty(), nodes.get(2).fault());

    handles.get(2).destroyForcibly();
    await(() -> nodes.get(2).fault().isPresent());
    assertEquals("ROUTING", nodes.get(2).fault().orElseThrow().code());
    radio.cut(1, 2); // what it had told the kernel leads nowhere
    radio.join(0, 2);
    awaitVia(2, 0);
    assertEquals(Optional.empty(), nodes.get(2).fault());
  }

  @Test
  void babeldOutlivesAKilledDaemonAndIsTakenOverByTheNext() throws Exception {
    BabeldProcess next = process(1, configuration(1));
    await(() -> next.takeOver().isPresent()); // it writes its number a moment after its start
    assertEquals(handles.get(1), next.takeOver().orElseThrow());

    BabeldProcess other = process(2, configuration(2).replace("0.20", "0.50"));
    await(() -> Files.exists(folder.resolve("n2/babeld.pid")));
    assertNotEquals(configuration(2), configuration(2).replace("0.20", "0.50"));
    assertEquals(Optional.empty(), other.takeOver());
    await(() -> !handles.get(2).isAlive());
  }
}
