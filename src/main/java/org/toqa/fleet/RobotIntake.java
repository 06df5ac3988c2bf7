package org.toqa.fleet;

import java.time.InstantSource;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetStore.StoreException;
import org.toqa.link.PairingResult;
import org.toqa.link.RobotLinks;
import org.toqa.link.trust.Fingerprint;
import org.toqa.link.trust.PairingCode;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Pairs a robot where there is a code, then stores it; on threads of its own. */
final class RobotIntake {

  private final RobotLinks links;
  private final FleetStore store;
  private final StoreWriter writer;
  private final InstantSource clock;

  RobotIntake(RobotLinks links, FleetStore store, StoreWriter writer, InstantSource clock) {
    this.links = links;
    this.store = store;
    this.writer = writer;
    this.clock = clock;
  }

  /**
   * Whose wish it is, and who is told.
   *
   * @param kind of the history's line, such as {@code robot.added}
   * @param text of that line
   */
  record Wish(String user, String kind, Sentence text, Asker asker) {}

  /** Is told one of these, by a thread of the intake's. */
  interface Asker {
    void stored(RobotRecord robot);

    void refused(Answer<RobotView> why);

    void failed(StoreException e);
  }

  /**
   * @param code null: the robot is not paired
   */
  void take(RobotRecord robot, @Nullable PairingCode code, Wish wish) {
    if (code == null) {
      store(robot, wish);
    } else {
      Thread.ofVirtual()
          .name("pairing-" + robot.name())
          .start(
              () ->
                  conclude(
                      links.pair(robot.name(), robot.host(), robot.port(), code), robot, wish));
    }
  }

  private void conclude(PairingResult result, RobotRecord robot, Wish wish) {
    switch (result) {
      case PairingResult.Paired(Fingerprint paired) -> store(robot.pairedAs(paired), wish);
      case PairingResult.Refused(Sentence sentence) -> refuse("code", sentence, robot, wish);
      case PairingResult.Unreachable(Sentence sentence) -> refuse("host", sentence, robot, wish);
    }
  }

  private void store(RobotRecord robot, Wish wish) {
    EventRecord event = event(wish.kind(), robot, wish, wish.text());
    writer.tryOnce(
        () -> {
          store.saveRobot(robot);
          store.addEvents(List.of(event));
        },
        () -> wish.asker().stored(robot),
        wish.asker()::failed);
  }

  private void refuse(String field, Sentence sentence, RobotRecord robot, Wish wish) {
    Sentence text = Phrase.ROBOT_NOT_PAIRED.with(wish.user(), robot.name(), sentence);
    EventRecord event = event("robot.pairing-refused", robot, wish, text);
    writer.write(
        () -> store.addEvents(List.of(event)),
        () -> wish.asker().refused(new Answer.Refused<>(field, sentence)));
  }

  private EventRecord event(String kind, RobotRecord robot, Wish wish, Sentence text) {
    return new EventRecord(clock.instant(), kind, null, robot.name(), wish.user(), text);
  }
}
