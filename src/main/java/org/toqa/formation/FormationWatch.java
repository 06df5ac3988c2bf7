package org.toqa.formation;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.toqa.formation.Verdict.Onward;
import org.toqa.formation.Verdict.Reason;
import org.toqa.formation.Verdict.Stop;

/**
 * What a leader makes of its followers' answers: the more the shape is strained, the slower it
 * drives, and it stops for a follower that is late, does not follow, or is out of tolerance. It
 * goes on by itself when that follower is well again.
 *
 * <p>Times are seconds on one monotonic clock of the leader's.
 */
public final class FormationWatch {

  /**
   * Two answers, 0.2 s apart, have not come (Tanta, level 2), and the third that would tell so need
   * not be waited for; two ticks for the way.
   */
  public static final double LATE_SECONDS = 0.44;

  /** The share of the tolerance from which the leader slows down. */
  private static final double SLOWING = 0.5;

  /** A follower that was out of tolerance is well again below this share of it. */
  private static final double HEALED = 0.5;

  /** A follower is at its place within this share of the tolerance. */
  private static final double CALM = 0.1;

  /** The pace just below the tolerance. */
  private static final double SLOWEST = 0.1;

  private final double tolerance;
  private final Map<String, Standing> followers = new LinkedHashMap<>();

  /** What is known of one follower. */
  private static final class Standing {
    private boolean heard;
    private double heardAt;
    private double error;
    private boolean follows;
    private boolean out;
  }

  /**
   * @param tolerance metres that a follower may be off its place
   */
  public FormationWatch(List<String> followers, double tolerance) {
    if (!(tolerance > 0)) {
      throw new IllegalArgumentException("A tolerance is more than 0 m, not " + tolerance + ".");
    }
    this.tolerance = tolerance;
    followers.forEach(name -> this.followers.put(name, new Standing()));
  }

  /**
   * A follower has answered; answers of strangers are ignored.
   *
   * @param error metres off its place
   * @param follows whether it can keep its place
   */
  public void answered(String follower, double error, boolean follows, double now) {
    Standing standing = followers.get(follower);
    if (standing != null) {
      standing.heard = true;
      standing.heardAt = now;
      standing.error = error;
      standing.follows = follows;
      standing.out = error > tolerance * (standing.out ? HEALED : 1);
    }
  }

  public Verdict verdict(double now) {
    double strain = 0;
    for (Map.Entry<String, Standing> entry : followers.entrySet()) {
      Standing standing = entry.getValue();
      Reason reason = reasonToStop(standing, now);
      if (reason != null) {
        return new Stop(reason, entry.getKey());
      }
      strain = Math.max(strain, standing.error / tolerance);
    }
    return new Onward(Math.clamp((1 - strain) / (1 - SLOWING), SLOWEST, 1));
  }

  /** Whether every follower was at its place when it answered last. */
  public boolean isCalm() {
    return followers.values().stream().allMatch(f -> f.heard && f.error <= tolerance * CALM);
  }

  private static @Nullable Reason reasonToStop(Standing standing, double now) {
    if (!standing.heard) {
      return Reason.NOT_READY;
    }
    if (now - standing.heardAt > LATE_SECONDS) {
      return Reason.LATE;
    }
    if (standing.out) {
      return Reason.OUT_OF_PLACE;
    }
    return standing.follows ? null : Reason.NOT_FOLLOWING;
  }
}
