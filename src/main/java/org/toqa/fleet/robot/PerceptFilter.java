package org.toqa.fleet.robot;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.link.message.AgentMessage.Hello;
import org.toqa.link.message.AgentMessage.State;

/**
 * Which of the obstacles that a robot reports are believed: those within the range of its sensors
 * round where it is, so many at most, and none for a while after it has been where it cannot have
 * driven. It knows no clock: time is handed in.
 */
final class PerceptFilter {
  /** In one state. */
  static final int MAX_PERCEPTS = 64;

  /** Metres: round what a robot sees ahead it tells what it saw beside that a moment before. */
  private static final double MEMORY_REACH = 0.5;

  /**
   * Metres that a pose may be farther than the robot can have driven: a mark on the floor corrects
   * it, and states come unevenly. All jumps together take of it.
   */
  private static final double MAX_CORRECTION = 0.5;

  /** Metres a second by which that comes back; far more than odometry errs. */
  private static final double CORRECTION_SPEED = 0.05;

  /** Metres a second; no robot here is faster, whatever it says. */
  private static final double MAX_SPEED = 3;

  private static final Duration DISTRUST_AFTER_JUMP = Duration.ofSeconds(5);

  private @Nullable Vec2 lastPosition;
  private Instant lastAt = Instant.EPOCH;

  /** Metres. */
  private double correctionLeft = MAX_CORRECTION;

  private Instant jumpedAt = Instant.EPOCH;

  /** The robot has connected: where it is now is the first that is known. */
  void reset() {
    lastPosition = null;
  }

  /**
   * @param now of the time that ticks bring
   * @return metres, map frame
   */
  List<Vec2> believable(State state, Hello hello, Instant now) {
    Vec2 position = state.pose().position();
    correctionLeft += driven(hello, now) - moved(position);
    if (correctionLeft < 0) {
      jumpedAt = now;
      correctionLeft = MAX_CORRECTION;
    }
    correctionLeft = Math.min(MAX_CORRECTION, correctionLeft);
    lastPosition = position;
    lastAt = now;
    if (!state.localised() || now.isBefore(jumpedAt.plus(DISTRUST_AFTER_JUMP))) {
      return List.of();
    }
    double reach = hello.sensorRange() + hello.footprint() + MEMORY_REACH;
    return state.obstacles().stream()
        .filter(percept -> percept.distanceTo(position) <= reach)
        .limit(MAX_PERCEPTS)
        .toList();
  }

  /** Metres that it may have moved since its last state. */
  private double driven(Hello hello, Instant now) {
    double seconds = Duration.between(lastAt, now).toMillis() / 1e3;
    return (Math.min(hello.maxSpeed(), MAX_SPEED) + CORRECTION_SPEED) * seconds;
  }

  private double moved(Vec2 position) {
    return lastPosition == null ? 0 : lastPosition.distanceTo(position);
  }
}
