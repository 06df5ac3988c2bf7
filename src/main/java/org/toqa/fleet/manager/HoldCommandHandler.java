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
import org.toqa.fleet.PendingResume;
import org.toqa.fleet.StoreWriter;
import org.toqa.fleet.floor.FloorMessage;
import org.toqa.fleet.robot.RobotAgents;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * What is on hold by an operator: all robots, or those of a floor. Robots hold at once, and go on
 * only when that is stored and no hold has come meanwhile. Confined to the manager's agent.
 */
final class HoldCommandHandler {
  private final FleetStore store;
  private final StoreWriter writer;
  private final InstantSource clock;
  private final ActorRef<ManagerMessage> manager;
  private final Map<String, ActorRef<FloorMessage>> floors;
  private final RobotAgents robots;
  private final Map<String, Hold> floorHolds;
  private final Map<String, PendingResume> floorResumes = new HashMap<>();
  private final PendingResume resume = new PendingResume();
  private @Nullable Hold pause;

  /**
   * @param floors by name; to be filled before anybody wants something
   */
  HoldCommandHandler(
      FleetStore store,
      StoreWriter writer,
      InstantSource clock,
      ActorRef<ManagerMessage> manager,
      Map<String, ActorRef<FloorMessage>> floors,
      RobotAgents robots) {
    this.store = store;
    this.writer = writer;
    this.clock = clock;
    this.manager = manager;
    this.floors = floors;
    this.robots = robots;
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

  /** Why no task of the floor is begun now; null: robots may drive. */
  @Nullable Sentence reasonToWait(String floor) {
    Hold all = pause;
    Hold here = floorHolds.get(floor);
    if (all != null) {
      return all.ofAll();
    }
    return here == null ? null : here.ofFloor(floor);
  }

  void setPause(ManagerMessage.SetPause m) {
    Hold inForce = pause;
    if (isAsked(m.pause(), inForce, resume)) {
      storePause(m.pause() ? inForce : null, m.replyTo());
      return;
    }
    Instant at = clock.instant();
    if (m.pause()) {
      Hold next = new Hold(m.user(), at);
      resume.cancel();
      applyPause(next);
      storePause(next, m.replyTo());
    } else {
      EventRecord event =
          event(at, EventKind.FLEET_RESUMED, m.user(), Phrase.ALL_LET_GO_ON.with(m.user()));
      long number = resume.begin();
      writer.write(
          () -> store.savePause(null, List.of(event)),
          () -> {
            manager.tell(new ManagerMessage.PauseEnded(number));
            answer(m.replyTo(), null);
          },
          refusal -> {
            manager.tell(new ManagerMessage.PauseLasts(number));
            m.replyTo().tell(StatusReply.error(refusal));
          });
    }
  }

  /**
   * Stores it, also when that was asked for before: it may have been refused then. What was stored
   * twice is stored once, and told once.
   *
   * @param hold null: all go on, as is stored
   */
  private void storePause(
      @Nullable Hold hold, ActorRef<StatusReply<Answer<Optional<Hold>>>> replyTo) {
    writer.write(
        () -> {
          if (hold != null) {
            Sentence text = Phrase.ALL_PAUSED.with(hold.user());
            store.savePause(
                hold, List.of(event(hold.since(), EventKind.FLEET_PAUSED, hold.user(), text)));
          }
        },
        () -> answer(replyTo, hold),
        refusal -> replyTo.tell(StatusReply.error(refusal)));
  }

  /** Whether somebody has asked for that already, and nobody for something else since. */
  private static boolean isAsked(boolean hold, @Nullable Hold now, PendingResume resume) {
    return hold == (now != null && !resume.isPending());
  }

  void pauseEnded(long number) {
    if (resume.complete(number)) {
      applyPause(null);
    }
  }

  /** The resume of that number can never be stored: all stay paused, and may be resumed anew. */
  void pauseLasts(long number) {
    var _ = resume.complete(number);
  }

  private void applyPause(@Nullable Hold next) {
    pause = next;
    floors.values().forEach(f -> f.tell(new FloorMessage.SetPause(next)));
    if (next != null) {
      robots.hold(_ -> true);
    }
  }

  void setFloorHold(ManagerMessage.HoldFloor m) {
    String floor = m.floor();
    if (!floors.containsKey(floor)) {
      m.replyTo().tell(StatusReply.success(new Answer.Unknown<>(Phrase.NO_SUCH_FLOOR.with(floor))));
      return;
    }
    PendingResume floorResume = floorResumes.computeIfAbsent(floor, _ -> new PendingResume());
    Hold inForce = floorHolds.get(floor);
    if (isAsked(m.hold(), inForce, floorResume)) {
      storeFloorHold(floor, m.hold() ? inForce : null, m.replyTo());
      return;
    }
    Instant at = clock.instant();
    if (m.hold()) {
      Hold next = new Hold(m.user(), at);
      floorResume.cancel();
      applyFloorHold(floor, next);
      storeFloorHold(floor, next, m.replyTo());
    } else {
      EventRecord event =
          event(
              at, EventKind.FLOOR_RESUMED, m.user(), Phrase.FLOOR_LET_GO_ON.with(m.user(), floor));
      long number = floorResume.begin();
      writer.write(
          () -> store.saveFloorHold(floor, null, List.of(event)),
          () -> {
            manager.tell(new ManagerMessage.FloorHoldEnded(floor, number));
            answer(m.replyTo(), null);
          },
          refusal -> {
            manager.tell(new ManagerMessage.FloorHoldLasts(floor, number));
            m.replyTo().tell(StatusReply.error(refusal));
          });
    }
  }

  /** As {@link #storePause}. */
  private void storeFloorHold(
      String floor, @Nullable Hold hold, ActorRef<StatusReply<Answer<Optional<Hold>>>> replyTo) {
    writer.write(
        () -> {
          if (hold != null) {
            Sentence text = Phrase.FLOOR_PUT_ON_HOLD.with(hold.user(), floor);
            store.saveFloorHold(
                floor, hold, List.of(event(hold.since(), EventKind.FLOOR_HELD, hold.user(), text)));
          }
        },
        () -> answer(replyTo, hold),
        refusal -> replyTo.tell(StatusReply.error(refusal)));
  }

  void floorHoldEnded(ManagerMessage.FloorHoldEnded m) {
    PendingResume floorResume = floorResumes.get(m.floor());
    if (floorResume != null && floorResume.complete(m.number())) {
      applyFloorHold(m.floor(), null);
    }
  }

  /** As {@link #pauseLasts}. */
  void floorHoldLasts(ManagerMessage.FloorHoldLasts m) {
    PendingResume floorResume = floorResumes.get(m.floor());
    if (floorResume != null) {
      var _ = floorResume.complete(m.number());
    }
  }

  private void applyFloorHold(String floor, @Nullable Hold next) {
    if (next == null) {
      floorHolds.remove(floor);
    } else {
      floorHolds.put(floor, next);
    }
    Objects.requireNonNull(floors.get(floor)).tell(new FloorMessage.HoldFloor(next));
    if (next != null) {
      robots.hold(robot -> robot.floor().equals(floor));
    }
  }

  private static EventRecord event(Instant at, EventKind kind, String user, Sentence text) {
    return new EventRecord(at, kind, null, null, user, text);
  }

  private static void answer(
      ActorRef<StatusReply<Answer<Optional<Hold>>>> replyTo, @Nullable Hold hold) {
    replyTo.tell(StatusReply.success(new Answer.Accepted<>(Optional.ofNullable(hold))));
  }
}
