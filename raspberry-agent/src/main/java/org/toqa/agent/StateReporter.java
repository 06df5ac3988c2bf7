package org.toqa.agent;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.link.message.AgentMessage;
import org.toqa.link.message.AgentMessage.ActEnd;
import org.toqa.link.message.AgentMessage.Acted;
import org.toqa.link.message.AgentMessage.ArmState;
import org.toqa.link.message.AgentMessage.Done;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.link.message.AgentMessage.NetworkRoute;
import org.toqa.link.message.AgentMessage.PhaseEnd;
import org.toqa.link.message.AgentMessage.State;

/**
 * Reports to the server: the state five times a second and at once when it has changed, the end of
 * a phase once a second until the server has stored it. Times are nanoseconds on the daemon's
 * monotonic clock. For one thread.
 */
final class StateReporter {

  /** Half a tick early, since a tick is never quite on time. */
  private static final long STATE_INTERVAL_NANOS = 190_000_000;

  private static final long DONE_INTERVAL_NANOS = 990_000_000;

  private final Consumer<AgentMessage> sender;
  private volatile Consumer<Pose> poseListener = pose -> {};
  private @Nullable State lastState;
  private long lastStateNanos;
  private @Nullable PhaseEnd lastDone;
  private long lastDoneNanos;
  private @Nullable ActEnd lastActed;
  private long lastActedNanos;

  /**
   * @param sender sends to the server, if there is one, without waiting
   */
  StateReporter(Consumer<AgentMessage> sender) {
    this.sender = sender;
  }

  /**
   * @param listener gets each pose before it is sent; it does not wait
   */
  void setPoseListener(Consumer<Pose> listener) {
    poseListener = listener;
  }

  /**
   * A server has connected: it is sent the state at once; the hello has reported a phase's end
   * already.
   *
   * @param done the last phase that was driven to its end
   * @param acted how the last act ended
   */
  void restart(State state, Optional<PhaseEnd> done, Optional<ActEnd> acted, long nanos) {
    lastActed = acted.orElse(null);
    lastActedNanos = nanos;
    send(state, nanos);
    lastDone = done.orElse(null);
    lastDoneNanos = nanos;
  }

  /**
   * Sends what is due.
   *
   * @param end the last phase that was driven to its end
   * @param actEnd how the last act ended
   */
  void report(State state, Optional<PhaseEnd> end, Optional<ActEnd> actEnd, long nanos) {
    if (nanos - lastStateNanos >= STATE_INTERVAL_NANOS || hasChanged(state)) {
      send(state, nanos);
    }
    PhaseEnd done = end.orElse(null);
    if (done != null && (!done.equals(lastDone) || nanos - lastDoneNanos >= DONE_INTERVAL_NANOS)) {
      sender.accept(new Done(done.task(), done.phase(), done.drive()));
      lastDoneNanos = nanos;
    }
    lastDone = done;
    ActEnd acted = actEnd.orElse(null);
    if (acted != null
        && (!acted.equals(lastActed) || nanos - lastActedNanos >= DONE_INTERVAL_NANOS)) {
      sender.accept(Acted.of(acted));
      lastActedNanos = nanos;
    }
    lastActed = acted;
  }

  private void send(State state, long nanos) {
    poseListener.accept(state.pose());
    sender.accept(state);
    lastState = state;
    lastStateNanos = nanos;
  }

  private boolean hasChanged(State state) {
    State before = lastState;
    return before == null
        || state.mode() != before.mode()
        || state.localised() != before.localised()
        || state.drive() != before.drive()
        || state.segment() != before.segment()
        || state.released() != before.released()
        || state.phase() != before.phase()
        || state.room() != before.room()
        || !Objects.equals(state.task(), before.task())
        || hasChanged(state.arm(), before.arm())
        || !Objects.equals(nextHop(state), nextHop(before))
        || !haveSameCodes(state.errors(), before.errors());
  }

  private static boolean hasChanged(@Nullable ArmState now, @Nullable ArmState before) {
    return now != null
        && before != null
        && (now.step() != before.step() || !Objects.equals(now.act(), before.act()));
  }

  private static @Nullable String nextHop(State state) {
    NetworkRoute route = state.networkRoute();
    return route == null ? null : route.nextHop();
  }

  private static boolean haveSameCodes(List<Fault> some, List<Fault> others) {
    return some.size() == others.size()
        && IntStream.range(0, some.size())
            .allMatch(i -> some.get(i).code().equals(others.get(i).code()));
  }
}
