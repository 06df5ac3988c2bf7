package org.toqa.web.live;

import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.web.api.HoldJson;
import org.toqa.web.api.Json;
import org.toqa.web.api.RobotJson;
import org.toqa.web.api.TaskJson;
import org.toqa.wording.Sentence;
import tools.jackson.databind.ObjectWriter;
import tools.jackson.databind.node.ObjectNode;

/** Snapshots as server-sent events in one language, each written once, however many read it. */
final class SnapshotEventWriter {

  private record SnapshotJson(
      long version,
      Instant at,
      List<RobotJson> robots,
      List<TaskJson> tasks,
      int queued,
      List<FloorJson> floors,
      @Nullable HoldJson pause,
      List<Sentence> alerts) {

    static SnapshotJson of(FleetSnapshot snapshot) {
      return new SnapshotJson(
          snapshot.version(),
          snapshot.at(),
          snapshot.robots().stream().map(RobotJson::of).toList(),
          snapshot.tasks().stream().map(TaskJson::of).toList(),
          snapshot.queuedCount(),
          snapshot.floors().stream().map(FloorJson::of).toList(),
          HoldJson.of(snapshot.pause()),
          snapshot.alerts());
    }
  }

  private record Step(long before, long now) {}

  private static final long NO_VERSION = -1;
  private static final int MAX_ENTRIES =
      16; // readers are at a few versions only, and mostly at the same

  /** Versions begin anew with the server: an id of its life before is not one of this life. */
  private final String serverId = UUID.randomUUID().toString();

  private final Map<Long, ObjectNode> trees = new LatestEntries<>();
  private final Map<Step, byte[]> events = new LatestEntries<>();
  private final ObjectWriter writer;

  SnapshotEventWriter(Locale language) {
    writer = Json.writer(language);
  }

  /** What a reader shows who has this snapshot. */
  String id(FleetSnapshot snapshot) {
    return serverId + "-" + snapshot.version();
  }

  /** All of it, for who has nothing. Callers must not change the event's bytes. */
  synchronized byte[] snapshotEvent(FleetSnapshot snapshot) {
    return events.computeIfAbsent(
        new Step(NO_VERSION, snapshot.version()), _ -> event("snapshot", snapshot, tree(snapshot)));
  }

  /** What has changed, for who has the one before. Callers must not change the event's bytes. */
  synchronized byte[] changeEvent(FleetSnapshot before, FleetSnapshot now) {
    return events.computeIfAbsent(
        new Step(before.version(), now.version()),
        _ -> event("change", now, SnapshotChange.between(tree(before), tree(now))));
  }

  private ObjectNode tree(FleetSnapshot snapshot) {
    return trees.computeIfAbsent(
        snapshot.version(), _ -> writer.valueToTree(SnapshotJson.of(snapshot)));
  }

  private byte[] event(String name, FleetSnapshot snapshot, ObjectNode data) {
    return "event: %s\nid: %s\ndata: %s\n\n"
        .formatted(name, id(snapshot), writer.writeValueAsString(data))
        .getBytes(StandardCharsets.UTF_8);
  }

  private static final class LatestEntries<K, V> extends LinkedHashMap<K, V> {
    @Override
    protected boolean removeEldestEntry(Map.Entry<K, V> eldest) {
      return size() > MAX_ENTRIES;
    }
  }
}
