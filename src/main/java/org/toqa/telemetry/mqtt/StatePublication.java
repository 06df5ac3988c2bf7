package org.toqa.telemetry.mqtt;

import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.telemetry.Topics;

/**
 * What is to be published so that the broker keeps what a snapshot says, and nothing else. Confined
 * to one connection to a broker.
 */
final class StatePublication {
  static final byte[] NOTHING = {};

  private final Topics topics;
  private final StateWriter writer;
  private final Map<String, byte[]> kept = new HashMap<>();

  /** Topics that the broker keeps something for, from earlier connections. */
  private final Set<String> found = new HashSet<>();

  StatePublication(Topics topics, StateWriter writer) {
    this.topics = topics;
    this.writer = writer;
  }

  /** The broker keeps something for that topic that this connection has not published. */
  synchronized void addFound(String topic) {
    found.add(topic);
  }

  /** Everything is to be published again. */
  synchronized void startAnew() {
    found.addAll(kept.keySet());
    kept.clear();
  }

  /**
   * What makes the broker keep that snapshot, by topic: what has changed, and {@link #NOTHING} for
   * what is no more. It counts as published.
   */
  synchronized Map<String, byte[]> changes(FleetSnapshot snapshot) {
    Map<String, byte[]> now = new LinkedHashMap<>();
    snapshot.robots().forEach(robot -> put(now, topics.state(robot.name()), writer.robot(robot)));
    snapshot.tasks().forEach(task -> put(now, topics.task(task.id()), writer.task(task)));
    Map<String, byte[]> changes = new LinkedHashMap<>();
    now.forEach(
        (topic, body) -> {
          if (!Arrays.equals(body, kept.get(topic))) {
            changes.put(topic, body);
          }
        });
    found.addAll(kept.keySet());
    found.removeAll(now.keySet());
    found.forEach(topic -> changes.put(topic, NOTHING));
    found.clear();
    kept.clear();
    kept.putAll(now);
    return changes;
  }

  /** One that the broker would not take is left out. */
  private static void put(Map<String, byte[]> states, String topic, byte[] body) {
    if (body.length + topic.length() < EmbeddedBroker.MAX_BYTES - 64) {
      states.put(topic, body);
    }
  }
}
