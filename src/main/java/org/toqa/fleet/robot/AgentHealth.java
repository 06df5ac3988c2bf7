package org.toqa.fleet.robot;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.LongAdder;
import org.apache.pekko.actor.typed.ActorSystem;
import org.apache.pekko.actor.typed.Extension;
import org.apache.pekko.actor.typed.ExtensionId;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.RobotMessageKind;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * How the agents of one system do. They tell it here, and any thread may ask.
 *
 * <ol>
 *   <li>Whoever spawns an agent says so by {@link #expectStart}; {@link Supervision} tells how that
 *       went.
 *   <li>Supervision tells of every message that an agent failed at.
 *   <li>The clock's ticks are told, and that the agents have done what they ask.
 * </ol>
 *
 * Times are nanoseconds of a clock that never jumps.
 */
public final class AgentHealth implements Extension {
  /** So many failures within the window are more than a surprise. */
  private static final int MAX_FAILURES = 5;

  private static final Duration WINDOW = Duration.ofSeconds(10);

  /** An agent that failed too often is well again after so long without a failure. */
  private static final Duration RECOVERY = Duration.ofSeconds(30);

  /** How long agents may take for one tick. */
  private static final Duration TICK_LIMIT = Duration.ofSeconds(10);

  private static final Duration LEFT_OUT_SHOWN = Duration.ofHours(1);
  private static final int MAX_LEFT_OUT = 3;

  private static final ExtensionId<AgentHealth> ID =
      new ExtensionId<>() {
        @Override
        public AgentHealth createExtension(ActorSystem<?> system) {
          return new AgentHealth();
        }
      };

  private final CompletableFuture<Void> started = new CompletableFuture<>();

  private final CompletableFuture<Void> broken = new CompletableFuture<>();

  /** Agents that have not started yet; at first the root of all others. */
  private int starting = 1;

  private final Set<Sentence> ended = new LinkedHashSet<>();

  /** By agent: when it failed last, the newest last. */
  private final Map<Sentence, Deque<Long>> failures = new LinkedHashMap<>();

  /** By agent that failed too often: when it did so last. */
  private final Map<Sentence, Long> failing = new LinkedHashMap<>();

  /** Changes that were left out, and when; the newest last. */
  private final Map<Sentence, Long> leftOut = new LinkedHashMap<>();

  /** Of what robots said, by its kind: how many were left out. */
  private final Map<RobotMessageKind, LongAdder> passedOver = new ConcurrentHashMap<>();

  /** When the oldest tick was told that agents have not done; null: they have done all. */
  private @Nullable Long tickedAt;

  private volatile Instant floorTime = Instant.MAX;

  private AgentHealth() {}

  public static AgentHealth of(ActorSystem<?> system) {
    return system.registerExtension(ID);
  }

  /** An agent is spawned now. */
  public synchronized void expectStart() {
    starting++;
  }

  synchronized void recordStart() {
    starting--;
    if (starting == 0) {
      started.complete(null);
    }
  }

  /** The agent is not there, since it could not start. */
  synchronized void recordFailedStart(Sentence agent, Throwable cause) {
    ended.add(agent);
    started.completeExceptionally(
        new IllegalStateException(agent.english() + " cannot start: " + cause.getMessage(), cause));
  }

  /**
   * Completes when the first agent and all that were spawned meanwhile have started; else with an
   * {@link IllegalStateException} that says which one has not, and why.
   */
  public CompletionStage<Void> started() {
    return started;
  }

  synchronized void recordFailure(Sentence agent, long nanos) {
    Deque<Long> times = failures.computeIfAbsent(agent, unknown -> new ArrayDeque<>());
    times.addLast(nanos);
    if (times.size() > MAX_FAILURES) {
      times.removeFirst();
    }
    boolean isTooOften =
        times.size() == MAX_FAILURES && nanos - times.getFirst() <= WINDOW.toNanos();
    if (isTooOften || failing.containsKey(agent)) {
      failing.put(agent, nanos);
    }
  }

  /** The process has no memory left, or a part of the program is not there. */
  void recordFatalError() {
    broken.complete(null);
  }

  /**
   * Completes when an agent met an error after which its system ends, if it still can: do not wait
   * for that.
   */
  public CompletionStage<Void> broken() {
    return broken;
  }

  /** A change was not stored, since it never can be. */
  public synchronized void recordLeftOut(Sentence change, long nanos) {
    leftOut.remove(change);
    leftOut.put(change, nanos);
    if (leftOut.size() > MAX_LEFT_OUT) {
      leftOut.remove(leftOut.keySet().iterator().next());
    }
  }

  /** What people should know, though the fleet goes on. */
  public synchronized List<Sentence> warnings(long nanos) {
    leftOut.values().removeIf(at -> nanos - at > LEFT_OUT_SHOWN.toNanos());
    return List.copyOf(leftOut.keySet());
  }

  void recordPassedOver(RobotMessageKind kind, long count) {
    passedOver.computeIfAbsent(kind, _ -> new LongAdder()).add(count);
  }

  /** How many messages of that kind were left out, of all robots, since the start. */
  public long passedOver(RobotMessageKind kind) {
    LongAdder count = passedOver.get(kind);
    return count == null ? 0 : count.sum();
  }

  public synchronized void recordTick(long nanos) {
    if (tickedAt == null) {
      tickedAt = nanos;
    }
  }

  /**
   * The agents have done what ticks ask.
   *
   * @param openSince when the oldest was told that they have not done; empty: they have done all
   */
  public synchronized void recordTickDone(OptionalLong openSince) {
    tickedAt = openSince.isPresent() ? openSince.getAsLong() : null;
  }

  public void recordFloorTime(Instant time) {
    floorTime = time;
  }

  /** By that time all floors have done what was due, but for their last tick. */
  public Instant floorTime() {
    return floorTime;
  }

  /** What fails now; empty while all is well. */
  public synchronized List<Sentence> failures(long nanos) {
    List<Sentence> found = new ArrayList<>();
    ended.forEach(agent -> found.add(Phrase.PART_ENDED.with(agent)));
    failing.values().removeIf(last -> nanos - last > RECOVERY.toNanos());
    failing.keySet().forEach(agent -> found.add(Phrase.PART_FAILS.with(agent)));
    if (tickedAt != null && nanos - tickedAt > TICK_LIMIT.toNanos()) {
      found.add(Phrase.FLEET_STANDS.with(Duration.ofNanos(nanos - tickedAt).toSeconds()));
    }
    return found;
  }
}
