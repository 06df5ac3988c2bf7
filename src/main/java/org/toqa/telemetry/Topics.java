package org.toqa.telemetry;

import java.util.Optional;
import java.util.regex.Pattern;

/**
 * The MQTT topics of a site, as {@code docs/telemetry.md} has them. Names of sites and robots have
 * no character that means something in a topic.
 *
 * @param site its name
 */
public record Topics(String site) {
  public static final String ROOT = "toqa/v1/";

  /** The server's own, beside the readings of a robot. */
  public static final String STATE = "state";

  /** Whether the robot's client is connected, and its last will. */
  public static final String CONNECTION = "connection";

  private static final Pattern READING = Pattern.compile("[a-z0-9_-]{1,32}");

  /** Whose reading it is. */
  public record Origin(String robot, String reading) {}

  /** All of them begin with it. */
  public String prefix() {
    return ROOT + site + "/";
  }

  /** Whether the server is connected. */
  public String server() {
    return prefix() + "server";
  }

  /** All of a robot begin with it. */
  public String robot(String robot) {
    return prefix() + "robot/" + robot + "/";
  }

  public String state(String robot) {
    return robot(robot) + STATE;
  }

  public String task(long id) {
    return prefix() + "task/" + id;
  }

  /** A filter for all readings, and states. */
  public String ofRobots() {
    return prefix() + "robot/+/+";
  }

  public String ofTasks() {
    return prefix() + "task/+";
  }

  /** Whether the server publishes it and keeps it at the broker, but {@link #server}. */
  public boolean isState(String topic) {
    return topic.startsWith(prefix() + "task/")
        || (topic.startsWith(prefix() + "robot/") && topic.endsWith("/" + STATE));
  }

  /** Of whom a robot's topic is; empty: it is none of a robot of this site. */
  public Optional<Origin> origin(String topic) {
    String start = prefix() + "robot/";
    if (!topic.startsWith(start)) {
      return Optional.empty();
    }
    String[] levels = topic.substring(start.length()).split("/", -1);
    return levels.length == 2 && isReading(levels[1])
        ? Optional.of(new Origin(levels[0], levels[1]))
        : Optional.empty();
  }

  /** Whether a robot may call a reading so. */
  public static boolean isReading(String name) {
    return READING.matcher(name).matches() && !name.equals(STATE);
  }
}
