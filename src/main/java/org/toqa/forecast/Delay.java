package org.toqa.forecast;

/**
 * How much longer robots take than if nobody hindered them, as measured lately: what they drove
 * for, waits included, over what that would take an empty floor. What is older counts less.
 *
 * @param driven seconds
 * @param planned seconds
 */
public record Delay(double driven, double planned) {
  /** Of what is so old, seconds, half counts. */
  private static final double HALF_LIFE = 600;

  /** As if robots had driven for so long without a wait, seconds. */
  private static final double BEFORE = 120;

  private static final double LEAST = 0.8;

  private static final double MOST = 10;

  /** Before anything was measured. */
  public static final Delay NONE = new Delay(0, 0);

  /**
   * @param elapsed seconds since the last time
   * @param driving seconds for which robots were to drive since then, summed over them
   * @param progress by how much less there was to drive afterwards, seconds, likewise
   */
  public Delay measured(double elapsed, double driving, double progress) {
    double kept = Math.pow(0.5, elapsed / HALF_LIFE);
    return new Delay(kept * driven + driving, kept * planned + progress);
  }

  /** What a drive takes, over what it would take if nobody hindered the robot. */
  public double factor() {
    double factor = (BEFORE + driven) / Math.max(1, BEFORE + planned);
    return Math.clamp(factor, LEAST, MOST);
  }
}
