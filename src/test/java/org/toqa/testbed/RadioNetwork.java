package org.toqa.testbed;

import static org.toqa.testbed.RobotNetwork.RUN;
import static org.toqa.testbed.RobotNetwork.ip;
import static org.toqa.testbed.RobotNetwork.run;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;

/**
 * An ad hoc network without an access point, in network namespaces of Linux: each node has one
 * radio, {@code wlan0}, and is heard by those in its reach alone, which a test changes. Node 0 is a
 * base station, to which this machine has a cable; at first nobody hears anybody.
 */
public final class RadioNetwork implements AutoCloseable {
  private static final String AIR = "tq" + RUN + "radio";
  private static final String CABLE = "tq" + RUN + "s91";
  private static final String RADIO = "10.234.%d.".formatted(RUN % 250);
  private static final String WIRED = "10.235.%d.".formatted(RUN % 250);

  private final int nodes;
  private final NetworkLock lock;

  /** Whether such a network can be made here. */
  public static boolean isAllowed() throws InterruptedException {
    return PrivateNetwork.isAllowed();
  }

  /**
   * @param nodes with the base station
   */
  public RadioNetwork(int nodes) throws IOException, InterruptedException {
    this.nodes = nodes;
    lock = NetworkLock.toChange();
    ip("netns add " + AIR);
    ip("-n %s link add air type bridge".formatted(AIR));
    ip("-n %s link set air up".formatted(AIR));
    for (int node = 0; node < nodes; node++) {
      add(node);
    }
    filter("add table bridge reach");
    filter("add set bridge reach hears { type ifname . ifname; }");
    filter("add chain bridge reach air { type filter hook forward priority 0; policy drop; }");
    filter("add rule bridge reach air iifname . oifname @hears accept");
    ip("link add %s type veth peer name eth0 netns %s".formatted(CABLE, namespace(0)));
    ip("address add %s/24 dev %s".formatted(server(), CABLE));
    ip("link set %s up".formatted(CABLE));
    ip("-n %s address add %s2/24 dev eth0".formatted(namespace(0), WIRED));
    ip("-n %s link set eth0 up".formatted(namespace(0)));
    // a route to the server alone, which the base station can announce
    ip("-n %s route add %s/32 dev eth0 proto static".formatted(namespace(0), server()));
    ip("route add %s0/24 via %s2 dev %s".formatted(RADIO, WIRED, CABLE));
  }

  private void add(int node) throws IOException, InterruptedException {
    String space = namespace(node);
    ip("netns add " + space);
    ip("link add wlan0 netns %s type veth peer name radio%d netns %s".formatted(space, node, AIR));
    ip("-n %s address add %s/24 dev wlan0".formatted(space, address(node)));
    ip("-n %s link set lo up".formatted(space));
    ip("-n %s link set wlan0 up".formatted(space));
    ip("-n %s link set radio%d master air up".formatted(AIR, node));
  }

  /** What goes before a command that runs on that node. */
  public List<String> on(int node) {
    return List.of("ip", "netns", "exec", namespace(node));
  }

  public String address(int node) {
    return RADIO + (node + 1);
  }

  /** This machine, as the base station sees it. */
  public String server() {
    return WIRED + 1;
  }

  /** From now on the two hear each other. */
  public void join(int one, int other) throws IOException, InterruptedException {
    filter("add element bridge reach hears " + both(one, other));
  }

  /** From now on they do not, and nobody is told. */
  public void cut(int one, int other) throws IOException, InterruptedException {
    filter("delete element bridge reach hears " + both(one, other));
  }

  private static String both(int one, int other) {
    return "{ \"radio%1$d\" . \"radio%2$d\", \"radio%2$d\" . \"radio%1$d\" }".formatted(one, other);
  }

  private static void filter(String command) throws IOException, InterruptedException {
    run(List.of("ip", "netns", "exec", AIR, "nft", command));
  }

  @Override
  public void close() throws IOException {
    try (lock) {
      List<String> spaces = new ArrayList<>(List.of(AIR));
      for (int node = 0; node < nodes; node++) {
        spaces.add(namespace(node));
      }
      ip("link delete " + CABLE);
      for (String space : spaces) {
        ip("netns delete " + space);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private static String namespace(int node) {
    return AIR + node;
  }
}
