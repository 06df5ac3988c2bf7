package org.toqa.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.store.Database;
import org.toqa.store.JdbiDeviceStore;
import org.toqa.store.MemoryDatabase;
import org.toqa.testbed.Needed;
import org.toqa.testbed.RobotNetwork;

/** A real dnsmasq, and a real DHCP client in a network of its own, whose cable is pulled. */
@Tag("full")
class DhcpTest {
  private static final String USER = "Max";

  /** A silent neighbour is given up by Linux after 8 s or so. */
  private static final Duration LIMIT = Duration.ofSeconds(60);

  private static final long BETWEEN_TRIES_NANOS = 100_000_000;

  @TempDir private Path folder;
  private RobotNetwork cables;
  private Database database;
  private Network network;
  private Process dnsmasq;

  @BeforeEach
  void start() throws Exception {
    Needed.orLeftOut(
        RobotNetwork.isAllowed() && isInstalled("dnsmasq") && isInstalled("udhcpc"),
        "network namespaces, dnsmasq and udhcpc: run it as root, with ip"
            + " (Debian: iproute2, dnsmasq-base, udhcpc)");
    cables = new RobotNetwork(1);
    cables.removeAddress(0);
    database = MemoryDatabase.open("dhcp-" + System.nanoTime());
    network =
        new Network(
            new JdbiDeviceStore(database.jdbi(), InstantSource.system()),
            new DhcpSettings(
                Subnet.parse(cables.subnet()).orElseThrow(),
                folder.resolve("reservations"),
                folder.resolve("leases"),
                folder.resolve("pid")),
            InstantSource.system());
    Files.createFile(folder.resolve("reservations"));
    dnsmasq =
        new ProcessBuilder(
                "dnsmasq",
                "--keep-in-foreground",
                "--conf-file=/dev/null",
                "--user=root",
                "--port=0",
                "--bind-interfaces",
                "--interface=" + cables.link(),
                "--dhcp-range=" + address(100) + "," + address(150) + ",255.255.255.0,10m",
                "--dhcp-authoritative",
                "--no-ping",
                "--dhcp-hostsfile=" + folder.resolve("reservations"),
                "--dhcp-leasefile=" + folder.resolve("leases"),
                "--pid-file=" + folder.resolve("pid"))
            .redirectErrorStream(true)
            .redirectOutput(folder.resolve("dnsmasq.log").toFile())
            .start();
    await(() -> Files.exists(folder.resolve("pid")));
  }

  @AfterEach
  void stop() throws Exception {
    network.close();
    database.close();
    endDnsmasq();
    cables.close();
  }

  private static boolean isInstalled(String program) {
    return Stream.of("/usr/sbin", "/usr/bin", "/sbin", "/bin")
        .anyMatch(place -> Files.isExecutable(Path.of(place, program)));
  }

  private void endDnsmasq() throws InterruptedException {
    dnsmasq.destroy();
    assertTrue(dnsmasq.waitFor(LIMIT.toSeconds(), TimeUnit.SECONDS));
  }

  private String address(int host) {
    return cables.subnet().replaceFirst("0/24$", String.valueOf(host));
  }

  /** The address that the device is given when it asks now, as it does when it is switched on. */
  private String askForAddress() throws IOException, InterruptedException {
    Path script = folder.resolve("client.sh");
    Files.writeString(
        script,
        """
        #!/bin/sh
        if [ "$1" = bound ]; then
          ip address flush dev "$interface"
          ip address add "$ip/24" dev "$interface"
          echo "address $ip"
        fi
        """);
    assertTrue(script.toFile().setExecutable(true));
    Process client =
        new ProcessBuilder(
                cables.as(
                    0,
                    List.of(
                        "udhcpc",
                        "-f",
                        "-q",
                        "-n",
                        "-t",
                        "10",
                        "-i",
                        "eth0",
                        "-x",
                        "hostname:spare",
                        "-s",
                        script.toString())))
            .redirectErrorStream(true)
            .start();
    String said = new String(client.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, client.waitFor(), said);
    return said.replaceFirst("(?s).*address ([0-9.]+).*", "$1");
  }

  private void await(BooleanSupplier condition) {
    long end = System.nanoTime() + LIMIT.toNanos();
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, "it does not come about");
      LockSupport.parkNanos(BETWEEN_TRIES_NANOS);
    }
  }

  private NetworkEntry only() {
    List<NetworkEntry> entries = network.entries(List.of());
    assertEquals(1, entries.size(), entries::toString);
    return entries.getFirst();
  }

  private Device stored(DeviceAnswer answer) {
    return assertInstanceOf(DeviceAnswer.Stored.class, answer, answer::toString).device();
  }

  @Test
  void deviceIsKnownByItsLeaseGetsTheAddressThatIsReservedAndLosesItAgain() throws Exception {
    String first = askForAddress();

    assertTrue(only().isUnknown());
    assertEquals(first, only().address());
    assertEquals("spare", only().name());
    HardwareAddress hardware = Optional.ofNullable(only().hardware()).orElseThrow();

    Device camera =
        stored(
            network.add(
                new DeviceOrder(
                    "gate",
                    DeviceKind.CAMERA,
                    hardware,
                    Ipv4Address.parse(address(20)).orElseThrow()),
                List.of(),
                USER));
    assertEquals(Optional.empty(), network.trouble());
    assertEquals(first, String.valueOf(only().otherAddress()), "until it asks again");
    assertEquals(address(20), askForAddress());
    assertEquals(null, only().otherAddress());

    assertTrue(network.delete(camera.id(), USER));
    assertNotEquals(address(20), askForAddress());
    assertTrue(only().isUnknown());
  }

  @Test
  void whoIsPulledOffTheNetworkIsNotReachable() throws Exception {
    askForAddress();
    network.refresh();
    assertEquals(true, only().reachable());

    cables.cut(0);
    await(
        () -> {
          network.refresh();
          return Boolean.FALSE.equals(only().reachable());
        });
    assertTrue(only().heardAt() != null);

    cables.mend(0);
    await(
        () -> {
          network.refresh();
          return Boolean.TRUE.equals(only().reachable());
        });
  }

  @Test
  void dnsmasqThatDoesNotRunReadsTheReservationsWhenItIsThereAgain() throws Exception {
    endDnsmasq();
    HardwareAddress hardware = HardwareAddress.parse("02:00:00:00:00:0a").orElseThrow();

    stored(
        network.add(
            new DeviceOrder(
                "gate", DeviceKind.CAMERA, hardware, Ipv4Address.parse(address(20)).orElseThrow()),
            List.of(),
            USER));

    assertEquals(
        Optional.of(DhcpTrouble.Kind.NOT_RUNNING), network.trouble().map(DhcpTrouble::kind));
    assertTrue(
        Files.readString(folder.resolve("reservations"))
            .endsWith("02:00:00:00:00:0a," + address(20) + "\n"));
  }
}
