package org.toqa.fleet.manager;

import java.time.InstantSource;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.FleetRuntime;
import org.toqa.fleet.FleetStore;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.StoreWriter;
import org.toqa.link.PairingResult;
import org.toqa.link.RobotLinkFactory;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.PairingCode;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Pairs a robot where there is a code, then stores it; on threads of its own. */
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
   * @param code null: the robot is not paired
   */
  void register(RobotRecord robot, @Nullable PairingCode code, Request request) {
    if (code == null) {
      store(robot, request);
    } else {
      runtime
          .threadPerTaskExecutor("pairing-" + robot.name())
          .execute(
              () ->
                  conclude(
                      links.pair(robot.name(), robot.host(), robot.port(), code), robot, request));
    }
  }

  private void conclude(PairingResult result, RobotRecord robot, Request request) {
    switch (result) {
      case PairingResult.Paired(Fingerprint paired) ->
          store(robot.withFingerprint(paired), request);
      case PairingResult.Refused(Sentence sentence) -> reject("code", sentence, robot, request);
      case PairingResult.Unreachable(Sentence sentence) -> reject("host", sentence, robot, request);
    }
  }

  private void store(RobotRecord robot, Request request) {
    EventRecord event = event(request.eventKind(), robot, request, request.text());
    writer.tryOnce(
        () -> {
          store.saveRobot(robot);
          store.addEvents(List.of(event));
        },
        () -> request.listener().stored(robot),
        request.listener()::failed);
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
