package org.toqa.fleet.manager;

import java.time.Instant;
import java.time.InstantSource;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.pattern.StatusReply;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.Hold;
import org.toqa.fleet.StoreWriter;
import org.toqa.fleet.floor.FloorMessage;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * What is on hold by an operator: all robots, or those of a floor. Robots hold at once, and go on
 * only when that is stored. Confined to the manager's agent.
 */
final class HoldCommandHandler {
  private final FleetStore store;
  private final StoreWriter writer;
  private final InstantSource clock;
  private final ActorRef<ManagerMessage> manager;
  private final Map<String, ActorRef<FloorMessage>> floors;
  private final Map<String, Hold> floorHolds;
  private @Nullable Hold pause;

  /**
   * @param floors by name; to be filled before anybody wants something
   */
  HoldCommandHandler(
      FleetStore store,
      StoreWriter writer,
      InstantSource clock,
      ActorRef<ManagerMessage> manager,
      Map<String, ActorRef<FloorMessage>> floors) {
    this.store = store;
    this.writer = writer;
    this.clock = clock;
    this.manager = manager;
    this.floors = floors;
    this.floorHolds = new HashMap<>(store.floorHolds());
    this.pause = store.pause().orElse(null);
  }

  /** Null while not all robots are paused. */
  @Nullable Hold pause() {
    return pause;
  }

  @Nullable Hold floorHold(String floor) {
    return floorHolds.get(floor);
  }

  void setPause(ManagerMessage.SetPause m) {
    if (m.pause() == (pause != null)) {
      answer(m.replyTo(), pause);
      return;
    }
    Instant at = clock.instant();
    Hold next = m.pause() ? new Hold(m.user(), at) : null;
    EventRecord event =
        event(
            at,
            m.pause() ? EventKind.FLEET_PAUSED : EventKind.FLEET_RESUMED,
            m.user(),
            (m.pause() ? Phrase.ALL_PAUSED : Phrase.ALL_LET_GO_ON).with(m.user()));
    if (next != null) {
      applyPause(next);
    }
    writer.write(
        () -> store.savePause(next, List.of(event)),
        () -> {
          if (next == null) {
            manager.tell(new ManagerMessage.PauseEnded());
          }
          answer(m.replyTo(), next);
        });
  }

  void pauseEnded() {
    applyPause(null);
  }

  private void applyPause(@Nullable Hold next) {
    pause = next;
    floors.values().forEach(f -> f.tell(new FloorMessage.SetPause(next)));
  }

  void setFloorHold(ManagerMessage.HoldFloor m) {
    if (!floors.containsKey(m.floor())) {
      m.replyTo()
          .tell(StatusReply.success(new Answer.Unknown<>(Phrase.NO_SUCH_FLOOR.with(m.floor()))));
      return;
    }
    Hold now = floorHolds.get(m.floor());
    if (m.hold() == (now != null)) {
      answer(m.replyTo(), now);
      return;
    }
    Instant at = clock.instant();
    Hold next = m.hold() ? new Hold(m.user(), at) : null;
    EventRecord event =
        event(
            at,
            m.hold() ? EventKind.FLOOR_HELD : EventKind.FLOOR_RESUMED,
            m.user(),
            (m.hold() ? Phrase.FLOOR_PUT_ON_HOLD : Phrase.FLOOR_LET_GO_ON)
                .with(m.user(), m.floor()));
    if (next != null) {
      applyFloorHold(m.floor(), next);
    }
    writer.write(
        () -> store.saveFloorHold(m.floor(), next, List.of(event)),
        () -> {
          if (next == null) {
            manager.tell(new ManagerMessage.FloorHoldEnded(m.floor()));
          }
          answer(m.replyTo(), next);
        });
  }

  void floorHoldEnded(String floor) {
    applyFloorHold(floor, null);
  }

  private void applyFloorHold(String floor, @Nullable Hold next) {
    if (next == null) {
      floorHolds.remove(floor);
    } else {
      floorHolds.put(floor, next);
    }
    Objects.requireNonNull(floors.get(floor)).tell(new FloorMessage.HoldFloor(next));
  }

  private static EventRecord event(Instant at, EventKind kind, String user, Sentence text) {
    return new EventRecord(at, kind, null, null, user, text);
  }

  private static void answer(
      ActorRef<StatusReply<Answer<Optional<Hold>>>> replyTo, @Nullable Hold hold) {
    replyTo.tell(StatusReply.success(new Answer.Accepted<>(Optional.ofNullable(hold))));
  }
}
