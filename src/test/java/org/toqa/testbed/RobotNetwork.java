package org.toqa.testbed;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * Network namespaces of Linux, one for each robot, on one switch with this machine. A robot's cable
 * can be pulled: nothing goes through then, and nobody is told, as when the Wi-Fi is gone.
 */
public final class RobotNetwork implements AutoCloseable {

  private static final int LIMIT_SECONDS = 10;

  /**
   * So that two runs on one machine do not meet: names have at most 15 characters. The full suite
   * chooses it, and removes what bears it when it is killed.
   */
  static final long RUN = Long.getLong("toqa.run", ProcessHandle.current().pid()) % 10_000;

  private static final String SWITCH = "tq" + RUN + "s";
  private static final String SUBNET = "10.231.%d.".formatted(RUN % 250);

  private final int robots;
  private final NetworkLock lock;

  /** Whether this user may make such a network here. */
  public static boolean isAllowed() throws InterruptedException {
    String probe = "tq" + RUN + "probe";
    try {
      run(List.of("ip", "netns", "add", probe));
      run(List.of("ip", "netns", "delete", probe));
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  public RobotNetwork(int robots) throws IOException, InterruptedException {
    this.robots = robots;
    this.lock = NetworkLock.toChange();
    ip("link add %s type bridge".formatted(SWITCH));
    ip("address add %s1/24 dev %s".formatted(SUBNET, SWITCH));
    ip("link set %s up".formatted(SWITCH));
    for (int robot = 0; robot < robots; robot++) {
      add(robot);
    }
  }

  private void add(int robot) throws IOException, InterruptedException {
    String space = namespace(robot);
    ip("netns add " + space);
    ip("link add %s type veth peer name eth0 netns %s".formatted(cable(robot), space));
    ip("-n %s address add %s/24 dev eth0".formatted(space, address(robot)));
    ip("-n %s link set lo up".formatted(space));
    ip("-n %s link set eth0 up".formatted(space));
    ip("link set %s master %s up".formatted(cable(robot), SWITCH));
  }

  public String address(int robot) {
    return SUBNET + (robot + 2);
  }

  /** The interface by which this machine is on the switch. */
  public String link() {
    return SWITCH;
  }

  /** All addresses of the switch, such as {@code 10.231.7.0/24}. */
  public String subnet() {
    return SUBNET + "0/24";
  }

  /** From now on it has none, and must ask for one. */
  public void removeAddress(int robot) throws IOException, InterruptedException {
    ip("-n %s address flush dev eth0".formatted(namespace(robot)));
  }

  /** The command, to be run as that robot. */
  public String[] as(int robot, List<String> command) {
    List<String> all = new ArrayList<>(List.of("ip", "netns", "exec", namespace(robot)));
    all.addAll(command);
    return all.toArray(String[]::new);
  }

  /** From now on nobody hears the robot, and it hears nobody. */
  public void cut(int robot) throws IOException, InterruptedException {
    ip("link set %s down".formatted(cable(robot)));
  }

  /** What waited here for the robot's answer, to be sent to it, is not sent any more. */
  public void mend(int robot) throws IOException, InterruptedException {
    ip("neigh flush dev %s to %s".formatted(SWITCH, address(robot)));
    ip("link set %s up".formatted(cable(robot)));
  }

  @Override
  public void close() throws IOException {
    try (lock) {
      for (int robot = 0; robot < robots; robot++) {
        // Goes with its namespace too, but that is taken down some time after it was deleted.
        ip("link delete " + cable(robot));
        ip("netns delete " + namespace(robot));
      }
      ip("link delete " + SWITCH);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private static String namespace(int robot) {
    return "tq%dr%d".formatted(RUN, robot + 1);
  }

  private static String cable(int robot) {
    return "tq%dc%d".formatted(RUN, robot + 1);
  }

  static void ip(String arguments) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of("ip"));
    command.addAll(List.of(arguments.split(" ", -1)));
    run(command);
  }

  static void run(List<String> command) throws IOException, InterruptedException {
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    if (!process.waitFor(LIMIT_SECONDS, TimeUnit.SECONDS) || process.exitValue() != 0) {
      throw new IOException(String.join(" ", command) + ": " + said);
    }
  }
}
