package org.toqa.fleet.robot;

import java.time.Duration;
import java.time.Instant;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import org.toqa.link.message.ServerMessage;
import org.toqa.link.message.ServerMessage.Command;

/**
 * The commands that were sent over a connection and that the robot has not answered, and for how
 * long it owes an answer: by the time that its agent was there to hear it.
 */
final class UnansweredCommands {
  /** A robot that answers nothing is told so many at most that are remembered. */
  private static final int MAX = 1_000;

  /** A daemon answers as soon as its disk has what it was told. */
  private static final Duration PATIENCE = Duration.ofSeconds(10);

  /** Of the time between two ticks no more than this counts. */
  private static final Duration LONGEST_STEP = Duration.ofMillis(500);

  /** By the commands' numbers: the drive that the command is to change, if it is such a one. */
  private final Map<Long, OptionalLong> drives = new LinkedHashMap<>();

  /** The numbers of those that an answer is owed to, the oldest first. */
  private final Set<Long> owed = new LinkedHashSet<>();

  /** For how long the oldest of them waits for it. */
  private Duration owedFor = Duration.ZERO;

  private Instant lastTick;

  UnansweredCommands(Instant now) {
    lastTick = now;
  }

  void add(Command command) {
    drives.put(
        command.seq(),
        switch (command) {
          case ServerMessage.Extend extend -> OptionalLong.of(extend.drive());
          case ServerMessage.Release release -> OptionalLong.of(release.drive());
          default -> OptionalLong.empty();
        });
    if (drives.size() > MAX) {
      Iterator<Long> oldest = drives.keySet().iterator();
      oldest.next();
      oldest.remove();
    }
    // a ping asks for nothing, and what clears a stop is repeated and given up by its sender
    boolean isOwed =
        !(command instanceof ServerMessage.Ping) && !(command instanceof ServerMessage.Clear);
    if (isOwed && owed.size() < MAX) {
      owed.add(command.seq());
    }
  }

  /** Whether the command of that number asks for something that the robot has not answered. */
  boolean isOwed(long seq) {
    return owed.contains(seq);
  }

  /**
   * The command of that number is answered.
   *
   * @return the drive that it is to change, if it is such a one; empty: no such command waits for
   *     an answer
   */
  Optional<OptionalLong> take(long seq) {
    boolean isOldest = !owed.isEmpty() && owed.iterator().next() == seq;
    owed.remove(seq);
    if (isOldest) {
      owedFor = Duration.ZERO;
    }
    return Optional.ofNullable(drives.remove(seq));
  }

  /**
   * Whether an answer is owed for too long. To be called at each tick.
   *
   * @param isHeard whether the robot is heard now: else it may have answered
   */
  boolean isOverdue(Instant now, boolean isHeard) {
    Duration step = Duration.between(lastTick, now);
    lastTick = now;
    if (owed.isEmpty() || !isHeard) {
      owedFor = Duration.ZERO;
    } else {
      owedFor = owedFor.plus(step.compareTo(LONGEST_STEP) < 0 ? step : LONGEST_STEP);
    }
    return owedFor.compareTo(PATIENCE) > 0;
  }

  /** No answer is owed to what was sent until now. */
  void forgive() {
    owed.clear();
    owedFor = Duration.ZERO;
  }

  void clear() {
    drives.clear();
    forgive();
  }
}
