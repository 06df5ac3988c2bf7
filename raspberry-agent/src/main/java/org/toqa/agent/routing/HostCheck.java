package org.toqa.agent.routing;

import java.io.IOException;
import java.net.Inet4Address;
import java.net.NetworkInterface;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.toqa.agent.config.AdHocNetwork;

/** Whether a machine can be a node of an ad hoc network: what it lacks is said before anything. */
final class HostCheck {

  private static final long CAP_NET_ADMIN = 1L << 12;

  /** 6696 in hexadecimal digits: babeld's port of UDP. */
  private static final String BABEL_PORT = ":1A28";

  private final List<Path> programs;
  private final Path proc;

  /**
   * @param programs folders where programs are
   * @param proc what the kernel tells, such as {@code /proc}
   */
  HostCheck(List<Path> programs, Path proc) {
    this.programs = programs;
    this.proc = proc;
  }

  /** This machine. */
  static HostCheck here() {
    String path = System.getenv().getOrDefault("PATH", "");
    return new HostCheck(
        Stream.concat(
                Arrays.stream(path.split(":", -1)).filter(folder -> folder.startsWith("/")),
                Stream.of("/usr/sbin", "/usr/local/sbin", "/sbin"))
            .map(Path::of)
            .toList(),
        Path.of("/proc"));
  }

  /**
   * Where a program is.
   *
   * @throws IOException with a sentence for people
   */
  Path program(String name) throws IOException {
    return programs.stream()
        .map(folder -> folder.resolve(name))
        .filter(Files::isExecutable)
        .findFirst()
        .orElseThrow(
            () ->
                new IOException(
                    "%s is not installed, so the robot can forward for no other: install it (Debian, Raspberry Pi OS: apt install babeld iproute2), or remove \"adHocNetwork\" from the configuration."
                        .formatted(name)));
  }

  /**
   * @throws IOException with a sentence for people: the first thing that the machine lacks
   */
  void check(AdHocNetwork network) throws IOException {
    for (String name : network.interfaces()) {
      checkInterface(name);
    }
    if (!mayChangeRoutes()) {
      throw new IOException(
          "The daemon may not change this machine's routes, which babeld needs: run it with"
              + " AmbientCapabilities=CAP_NET_ADMIN in its unit of systemd (docs/network.md), or as"
              + " root; or remove \"adHocNetwork\" from the configuration.");
    }
  }

  private void checkInterface(String name) throws IOException {
    NetworkInterface found = NetworkInterface.getByName(name);
    if (found == null) {
      throw new IOException(
          "There is no network interface %s here (adHocNetwork.interfaces); there are %s."
              .formatted(
                  name,
                  NetworkInterface.networkInterfaces()
                      .map(NetworkInterface::getName)
                      .sorted()
                      .collect(Collectors.joining(", "))));
    }
    if (found.inetAddresses().noneMatch(Inet4Address.class::isInstance)) {
      throw new IOException(
          "The network interface %s has no IPv4 address (adHocNetwork.interfaces), so nobody could reach the robot by it: give it a fixed one (docs/network.md)."
              .formatted(name));
    }
    if (isOn("sys/net/ipv6/conf/" + name + "/disable_ipv6")) {
      throw new IOException(
          "IPv6 is switched off on the network interface %s, and babeld speaks to its neighbours by IPv6: sysctl net.ipv6.conf.%s.disable_ipv6=0."
              .formatted(name, name));
    }
  }

  private boolean isOn(String setting) throws IOException {
    Path file = proc.resolve(setting);
    return Files.exists(file) && Files.readString(file).strip().equals("1");
  }

  /** What a child of this process may: all as root, else what is ambient. */
  private boolean mayChangeRoutes() throws IOException {
    List<String> status = Files.readAllLines(proc.resolve("self/status"));
    String user = value(status, "Uid:").split("\\s+", -1)[1];
    String capabilities = value(status, user.equals("0") ? "CapEff:" : "CapAmb:");
    return (Long.parseUnsignedLong(capabilities, 16) & CAP_NET_ADMIN) != 0;
  }

  private static String value(List<String> status, String name) throws IOException {
    return status.stream()
        .filter(line -> line.startsWith(name))
        .findFirst()
        .map(line -> line.substring(name.length()).strip())
        .orElseThrow(() -> new IOException("The kernel does not tell " + name));
  }

  /**
   * @throws IOException with a sentence for people: another babeld runs
   */
  void checkAlone() throws IOException {
    Path sockets = proc.resolve("self/net/udp6");
    if (Files.exists(sockets)
        && Files.readAllLines(sockets).stream()
            .map(line -> line.strip().split("\\s+", 3))
            .anyMatch(words -> words.length > 1 && words[1].endsWith(BABEL_PORT))) {
      throw new IOException(
          "Another babeld runs on this machine (UDP port 6696): stop it (systemctl disable --now"
              + " babeld), or remove \"adHocNetwork\" from the configuration.");
    }
  }
}
