package org.toqa.testbed;

import static org.toqa.testbed.RobotNetwork.RUN;
import static org.toqa.testbed.RobotNetwork.ip;
import static org.toqa.testbed.RobotNetwork.run;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/**
 * A site whose addresses nobody else knows, in network namespaces of Linux: one machine behind a
 * router that translates addresses. It can connect to this machine; this machine cannot connect to
 * it. The router's line can be cut: nothing goes through then, and nobody is told.
 */
public final class PrivateNetwork implements AutoCloseable {
  private static final String PLANT = "tq" + RUN + "plant";
  private static final String ROUTER = "tq" + RUN + "router";
  private static final String LINE = "tq" + RUN + "s90";
  private static final String INSIDE = "10.232.%d.".formatted(RUN % 250);
  private static final String OUTSIDE = "10.233.%d.".formatted(RUN % 250);

  private final NetworkLock lock;

  /** Whether addresses can be translated here, besides what {@link RobotNetwork} needs. */
  public static boolean isAllowed() throws InterruptedException {
    try {
      run(List.of("nft", "--version"));
      return RobotNetwork.isAllowed();
    } catch (IOException e) {
      return false;
    }
  }

  public PrivateNetwork() throws IOException, InterruptedException {
    lock = NetworkLock.toChange();
    ip("netns add " + PLANT);
    ip("netns add " + ROUTER);
    ip("link add eth0 netns %s type veth peer name in0 netns %s".formatted(PLANT, ROUTER));
    ip("link add %s type veth peer name out0 netns %s".formatted(LINE, ROUTER));
    address(PLANT, "eth0", plant());
    address(ROUTER, "in0", INSIDE + 1);
    address(ROUTER, "out0", OUTSIDE + 2);
    ip("-n %s link set lo up".formatted(PLANT));
    ip("-n %s route add default via %s1".formatted(PLANT, INSIDE));
    ip("address add %s/24 dev %s".formatted(server(), LINE));
    ip("link set %s up".formatted(LINE));
    ip("route add unreachable %s0/24".formatted(INSIDE)); // wherever else it would go
    run(in(ROUTER, List.of("sh", "-c", "echo 1 > /proc/sys/net/ipv4/ip_forward")));
    run(
        in(
            ROUTER,
            List.of(
                "nft",
                "add table ip nat;"
                    + " add chain ip nat out { type nat hook postrouting priority 100; };"
                    + " add rule ip nat out oifname out0 masquerade")));
  }

  private static void address(String space, String link, String address)
      throws IOException, InterruptedException {
    ip("-n %s address add %s/24 dev %s".formatted(space, address, link));
    ip("-n %s link set %s up".formatted(space, link));
  }

  /** This machine, as the site sees it. */
  public String server() {
    return OUTSIDE + 1;
  }

  /** The site's machine, in its own network. */
  public String plant() {
    return INSIDE + 2;
  }

  /** What this machine sees instead of it. */
  public String router() {
    return OUTSIDE + 2;
  }

  /** The command, to be run on the site's machine. */
  public String[] inside(List<String> command) {
    return in(PLANT, command).toArray(String[]::new);
  }

  public void cut() throws IOException, InterruptedException {
    ip("-n %s link set out0 down".formatted(ROUTER));
  }

  public void mend() throws IOException, InterruptedException {
    ip("-n %s link set out0 up".formatted(ROUTER));
  }

  @Override
  public void close() throws IOException {
    try (lock) {
      ip("route delete unreachable %s0/24".formatted(INSIDE));
      ip("link delete " + LINE);
      ip("netns delete " + PLANT);
      ip("netns delete " + ROUTER);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private static List<String> in(String space, List<String> command) {
    List<String> all = new ArrayList<>(List.of("ip", "netns", "exec", space));
    all.addAll(command);
    return all;
  }
}
