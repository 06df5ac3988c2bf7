package org.toqa.fleet.dispatch;

import java.util.List;
import org.apache.pekko.actor.typed.ActorRef;
import org.apache.pekko.pattern.StatusReply;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.Hold;
import org.toqa.fleet.OperatorHold;
import org.toqa.fleet.floor.FloorMessage;
import org.toqa.fleet.robot.RobotAgents;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Holds the floor's robots by an operator's word, for the floor alone or with all others. */
final class FloorHoldHandler {
  private final String name;
  private final OperatorHold hold;
  private final ActorRef<FloorMessage> floor;
  private final RobotAgents robots;

  /** Of all floors; null: there is none. */
  private @Nullable Hold pause;

  /**
   * @param stored the floor's own hold
   * @param pause of all floors
   */
  FloorHoldHandler(
      DispatchState state,
      ActorRef<DispatchMessage> self,
      RobotAgents robots,
      @Nullable Hold stored,
      @Nullable Hold pause) {
    this.name = state.floor.name();
    this.floor = state.floorAgent;
    this.robots = robots;
    this.pause = pause;
    this.hold =
        new OperatorHold(
            stored,
            state.writer,
            state.clock,
            new OperatorHold.Subject() {
              @Override
              public void apply(@Nullable Hold next) {
                applyHold(next);
              }

              @Override
              public void save(@Nullable Hold next, List<EventRecord> events) {
                state.store.saveFloorHold(
                    name, next, events.stream().map(event -> event.onFloor(name)).toList());
              }

              @Override
              public void tell(OperatorHold.ResumeEnded ended) {
                self.tell(new DispatchMessage.FloorResumeEnded(ended));
              }
            },
            new OperatorHold.Telling(
                EventKind.FLOOR_HELD,
                user -> Phrase.FLOOR_PUT_ON_HOLD.with(user, name),
                EventKind.FLOOR_RESUMED,
                user -> Phrase.FLOOR_LET_GO_ON.with(user, name)));
  }

  /** Null while not all floors are paused. */
  @Nullable Hold pause() {
    return pause;
  }

  /** Why no task is begun now; null: robots may drive. */
  @Nullable Sentence reasonToWait() {
    Hold all = pause;
    Hold here = hold.inForce();
    if (all != null) {
      return all.ofAll();
    }
    return here == null ? null : here.ofFloor(name);
  }

  void applyPause(@Nullable Hold next) {
    pause = next;
    floor.tell(new FloorMessage.SetPause(next));
    if (next != null) {
      robots.hold(_ -> true);
    }
  }

  void setFloorHold(DispatchMessage.HoldFloor m) {
    hold.set(
        m.hold(),
        m.user(),
        answer -> m.replyTo().tell(StatusReply.success(answer)),
        refusal -> m.replyTo().tell(StatusReply.error(refusal)));
  }

  void resumeEnded(OperatorHold.ResumeEnded ended) {
    hold.end(ended);
  }

  private void applyHold(@Nullable Hold next) {
    floor.tell(new FloorMessage.HoldFloor(next));
    if (next != null) {
      robots.hold(_ -> true);
    }
  }
}
