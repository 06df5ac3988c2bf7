package org.toqa.formation;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.toqa.formation.Verdict.Drive;
import org.toqa.formation.Verdict.Reason;
import org.toqa.formation.Verdict.Stop;

/**
 * What a leader makes of its followers' answers: the more the shape is strained, the slower it
 * drives, and it stops for a follower that is late, does not follow, or is out of tolerance. It
 * goes on by itself when that follower is well again.
 *
 * <p>Times are seconds on one monotonic clock of the leader's.
 */
public final class FormationMonitor {

  /**
   * Two answers, 0.2 s apart, have not come (Tanta, level 2), and the third that would tell so need
   * not be waited for; two ticks for the message.
   */
  public static final double LATE_SECONDS = 0.44;

  /** The share of the tolerance from which the leader slows down. */
  private static final double SLOWING_SHARE = 0.5;

  /** A follower that was out of tolerance is well again below this share of it. */
  private static final double RECOVERY_SHARE = 0.5;

  /** A follower is at its place within this share of the tolerance. */
  private static final double IN_PLACE_SHARE = 0.1;

  /** The pace just below the tolerance. */
  private static final double LEAST_PACE = 0.1;

  private final double tolerance;
  private final Map<String, FollowerState> followers = new LinkedHashMap<>();

  /** What is known of one follower. */
  private static final class FollowerState {
    private boolean hasAnswered;
    private double answeredAt;
    private double error;
    private boolean isFollowing;
    private boolean isOutOfPlace;
  }

  /**
   * @param tolerance metres that a follower may be off its place, above 0
   * @throws IllegalArgumentException if it is not
   */
  public FormationMonitor(List<String> followers, double tolerance) {
    if (!(tolerance > 0)) {
      throw new IllegalArgumentException("A tolerance is more than 0 m, not " + tolerance + ".");
    }
    this.tolerance = tolerance;
    followers.forEach(name -> this.followers.put(name, new FollowerState()));
  }

  /**
   * A follower has answered; answers of robots outside the formation are ignored.
   *
   * @param error metres off its place, at least 0
   * @param isFollowing whether it can keep its place
   * @param now when it was received, seconds on the leader's clock
   */
  public void recordAnswer(String follower, double error, boolean isFollowing, double now) {
    FollowerState state = followers.get(follower);
    if (state != null) {
      state.hasAnswered = true;
      state.answeredAt = now;
      state.error = error;
      state.isFollowing = isFollowing;
      state.isOutOfPlace = error > tolerance * (state.isOutOfPlace ? RECOVERY_SHARE : 1);
    }
  }

  /**
   * Whether the leader may drive, and how fast.
   *
   * @param now seconds on the leader's clock
   */
  public Verdict verdict(double now) {
    double strain = 0;
    for (Map.Entry<String, FollowerState> entry : followers.entrySet()) {
      FollowerState state = entry.getValue();
      Reason reason = reasonToStop(state, now);
      if (reason != null) {
        return new Stop(reason, entry.getKey());
      }
      strain = Math.max(strain, state.error / tolerance);
    }
    return new Drive(Math.clamp((1 - strain) / (1 - SLOWING_SHARE), LEAST_PACE, 1));
  }

  /** Whether every follower was at its place when it answered last. */
  public boolean isInPlace() {
    return followers.values().stream()
        .allMatch(f -> f.hasAnswered && f.error <= tolerance * IN_PLACE_SHARE);
  }

  private static @Nullable Reason reasonToStop(FollowerState state, double now) {
    if (!state.hasAnswered) {
      return Reason.NOT_READY;
    }
    if (now - state.answeredAt > LATE_SECONDS) {
      return Reason.LATE;
    }
    if (state.isOutOfPlace) {
      return Reason.OUT_OF_PLACE;
    }
    return state.isFollowing ? null : Reason.NOT_FOLLOWING;
  }
}
