package org.toqa.agent.routing;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.NetworkInterface;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.agent.config.AdHocNetwork;

/** Of a machine as its files in {@code /proc} tell it, with the interfaces of this one. */
class HostCheckTest {
  private static final String NET_ADMIN = "0000000000001000";
  private static final String NOTHING = "0000000000000000";

  @TempDir private Path folder;
  private HostCheck host;
  private String loopback;

  @BeforeEach
  void start() throws Exception {
    host = new HostCheck(List.of(folder), folder);
    loopback =
        NetworkInterface.networkInterfaces()
            .filter(this::isLoopback)
            .findAny()
            .orElseThrow()
            .getName();
  }

  private boolean isLoopback(NetworkInterface one) {
    return one.inetAddresses().anyMatch(address -> address.getHostAddress().equals("127.0.0.1"));
  }

  private void write(String file, String content) throws IOException {
    Path path = folder.resolve(file);
    Files.createDirectories(path.getParent());
    Files.writeString(path, content);
  }

  private void setUser(int id, String effective, String ambient) throws IOException {
    write(
        "self/status",
        "Name:\tjava\nUid:\t%1$d\t%1$d\t%1$d\t%1$d\nCapEff:\t%2$s\nCapAmb:\t%3$s\n"
            .formatted(id, effective, ambient));
  }

  private static AdHocNetwork on(String... interfaces) {
    return new AdHocNetwork(List.of(interfaces), 1, null);
  }

  private static void assertRefused(String sentence, Executable check) {
    String said = assertThrows(IOException.class, check).getMessage();
    assertTrue(said.contains(sentence), said);
  }

  @Test
  void saysThatBabeldIsNotInstalled() throws Exception {
    assertRefused("babeld is not installed", () -> host.program("babeld"));

    write("babeld", "#!/bin/sh\n");
    assertTrue(folder.resolve("babeld").toFile().setExecutable(true));
    assertEquals(folder.resolve("babeld"), host.program("babeld"));
  }

  @Test
  void saysWhichInterfacesThereAre() throws Exception {
    setUser(0, NET_ADMIN, NOTHING);

    assertRefused("no network interface wlan9 here", () -> host.check(on("wlan9")));
    assertRefused(loopback, () -> host.check(on(loopback, "wlan9")));
  }

  @Test
  void needsIpv6OnTheInterface() throws Exception {
    setUser(0, NET_ADMIN, NOTHING);
    write("sys/net/ipv6/conf/" + loopback + "/disable_ipv6", "1\n");

    assertRefused("IPv6 is switched off", () -> host.check(on(loopback)));
  }

  @Test
  void childOfAUserMayChangeRoutesOnlyByAnAmbientCapability() throws Exception {
    setUser(1000, NET_ADMIN, NOTHING);
    assertRefused("AmbientCapabilities=CAP_NET_ADMIN", () -> host.check(on(loopback)));
    setUser(0, NOTHING, NOTHING);
    assertRefused("AmbientCapabilities=CAP_NET_ADMIN", () -> host.check(on(loopback)));

    setUser(1000, NET_ADMIN, NET_ADMIN);
    assertDoesNotThrow(() -> host.check(on(loopback)));
    setUser(0, NET_ADMIN, NOTHING);
    assertDoesNotThrow(() -> host.check(on(loopback)));
  }

  @Test
  void secondBabeldIsRefused() throws Exception {
    String sockets =
        """
          sl  local_address                         remote_address                        st
         1: 00000000000000000000000000000000:14E9 00000000000000000000000000000000:0000 07
        """;
    write("self/net/udp6", sockets);
    assertDoesNotThrow(host::checkAlone);

    write("self/net/udp6", sockets.replace("14E9", "1A28"));
    assertRefused("Another babeld runs", host::checkAlone);
  }
}
