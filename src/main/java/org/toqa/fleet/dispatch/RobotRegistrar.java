package org.toqa.fleet.dispatch;

import java.time.InstantSource;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.FleetRuntime;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.StoreWriter;
import org.toqa.fleet.StoredRobot;
import org.toqa.link.PairingResult;
import org.toqa.link.RobotLinkFactory;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.PairingCode;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Pairs robots and stores them; on threads of its own. */
final class RobotRegistrar {

  private final RobotLinkFactory links;
  private final FleetStore store;
  private final StoreWriter writer;
  private final InstantSource clock;
  private final FleetRuntime runtime;

  RobotRegistrar(
      RobotLinkFactory links,
      FleetStore store,
      StoreWriter writer,
      InstantSource clock,
      FleetRuntime runtime) {
    this.links = links;
    this.store = store;
    this.writer = writer;
    this.clock = clock;
    this.runtime = runtime;
  }

  /**
   * Who asked for it, and who is answered.
   *
   * @param eventKind of the history's line
   * @param text of that line
   */
  record Request(String user, EventKind eventKind, Sentence text, Listener listener) {}

  /** Is told one of these, by a thread of the registrar's. */
  interface Listener {
    void stored(RobotRecord robot);

    void rejected(Answer<RobotView> why);

    void failed(StoreException e);
  }

  /**
   * Adds a robot.
   *
   * @param code null: it is not paired
   */
  void add(RobotRecord robot, @Nullable PairingCode code, Request request) {
    if (code == null) {
      store(robot, request);
    } else {
      pair(robot, code, request, shown -> store(robot.withFingerprint(shown), request));
    }
  }

  private void store(RobotRecord robot, Request request) {
    List<EventRecord> events = List.of(event(request.eventKind(), robot, request, request.text()));
    write(
        () -> {
          store.saveRobot(robot, events);
          return true;
        },
        robot,
        request.listener());
  }

  /**
   * Stores nothing but what is to be said when it fails.
   *
   * @param paired gets the certificate that the robot shows
   */
  void pair(RobotRecord robot, PairingCode code, Request request, Consumer<Fingerprint> paired) {
    runtime
        .threadPerTaskExecutor("pairing-" + robot.name())
        .execute(
            () -> {
              switch (links.pair(robot.address(), code)) {
                case PairingResult.Paired(Fingerprint shown) -> paired.accept(shown);
                case PairingResult.Refused(Sentence sentence) ->
                    reject("code", sentence, robot, request);
                case PairingResult.Unreachable(Sentence sentence) ->
                    reject("host", sentence, robot, request);
              }
            });
  }

  /** Changes a robot that is stored, unless it has become another one. */
  void update(RobotRecord before, RobotRecord after, Request request) {
    List<EventRecord> events = List.of(event(request.eventKind(), after, request, request.text()));
    write(() -> store.updateRobot(before, after, events), after, request.listener());
  }

  /**
   * @param change answers whether it was made
   */
  private void write(BooleanSupplier change, RobotRecord after, Listener listener) {
    AtomicBoolean isStored = new AtomicBoolean();
    writer.tryOnce(
        () -> isStored.set(change.getAsBoolean()),
        () -> {
          if (isStored.get()) {
            listener.stored(after);
          } else {
            listener.rejected(new Answer.Outdated<>());
          }
        },
        failure -> lookWhetherStored(after, listener, failure));
  }

  /** Nobody knows whether it was stored: that is seen when the store answers again. */
  private void lookWhetherStored(RobotRecord after, Listener listener, StoreException failure) {
    AtomicBoolean isStored = new AtomicBoolean();
    writer.write(
        () -> isStored.set(store.robots().contains(after)),
        () -> {
          if (isStored.get()) {
            listener.stored(after);
          } else {
            listener.failed(failure);
          }
        });
  }

  /**
   * Reads what is stored of a robot.
   *
   * @param found gets null where there is none
   */
  void reread(String robot, Consumer<@Nullable StoredRobot> found) {
    AtomicReference<@Nullable StoredRobot> stored = new AtomicReference<>();
    writer.write(
        () ->
            stored.set(
                store.storedRobots().stream()
                    .filter(known -> known.name().equals(robot))
                    .findFirst()
                    .orElse(null)),
        () -> found.accept(stored.get()));
  }

  private void reject(String field, Sentence sentence, RobotRecord robot, Request request) {
    Sentence text = Phrase.ROBOT_NOT_PAIRED.with(request.user(), robot.name(), sentence);
    EventRecord event = event(EventKind.ROBOT_PAIRING_REFUSED, robot, request, text);
    writer.write(
        () -> store.addEvents(List.of(event)),
        () -> request.listener().rejected(new Answer.Rejected<>(field, sentence)));
  }

  private EventRecord event(EventKind kind, RobotRecord robot, Request request, Sentence text) {
    return new EventRecord(clock.instant(), kind, null, robot.name(), request.user(), text);
  }
}
