package org.toqa.web.api;

import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.wording.Sentence;

/**
 * Snapshots as server-sent events in one language. The newest is written once, however many read
 * it.
 */
final class SnapshotEvents {

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
          snapshot.queued(),
          snapshot.floors().stream().map(FloorJson::of).toList(),
          HoldJson.of(snapshot.pause()),
          snapshot.alerts());
    }
  }

  private record Written(long version, byte[] event) {}

  /** Versions begin anew with the server: an id of its life before is not one of this life. */
  private final String life = UUID.randomUUID().toString();

  private final Locale language;
  private final AtomicReference<@Nullable Written> newest = new AtomicReference<>();

  SnapshotEvents(Locale language) {
    this.language = language;
  }

  /** What a reader shows who has this snapshot. */
  String id(FleetSnapshot snapshot) {
    return life + "-" + snapshot.version();
  }

  /** The event's bytes; callers must not change them. */
  byte[] event(FleetSnapshot snapshot) {
    Written written = newest.get();
    if (written == null || written.version != snapshot.version()) {
      written = new Written(snapshot.version(), write(snapshot));
      newest.set(written);
    }
    return written.event;
  }

  private byte[] write(FleetSnapshot snapshot) {
    return "event: snapshot\nid: %s\ndata: %s\n\n"
        .formatted(id(snapshot), Json.in(language).writeValueAsString(SnapshotJson.of(snapshot)))
        .getBytes(StandardCharsets.UTF_8);
  }
}
