package org.toqa.lab.experiment;

/**
 * A published figure beside the measured one.
 *
 * @param name what it is, for a person, such as {@code robot 1: path length}
 * @param published as the paper has it
 * @param measured with what Toqa implements
 * @param bound the true optimum, or the best that is possible; {@link Value#NONE} where nobody
 *     knows
 * @param reason why the verdict is as it is, in a sentence; empty where the numbers say it
 */
public record Figure(
    String name, Value published, Value measured, Value bound, Verdict verdict, String reason) {

  /**
   * A figure that a paper says is not exceeded.
   *
   * @param published the limit
   */
  public static Figure atMost(String name, double published, double measured, String unit) {
    return new Figure(
        name,
        Value.of(published, unit),
        Value.of(measured, unit),
        Value.NONE,
        measured <= published ? Verdict.REPRODUCED : Verdict.REFUTED,
        "");
  }

  /**
   * A figure that is reproduced where both are equal but for a share of the published one.
   *
   * @param tolerance such as 0.01 for one percent
   */
  public static Figure near(
      String name, double published, double measured, double tolerance, String unit) {
    boolean isNear = Math.abs(measured - published) <= tolerance * Math.abs(published);
    return new Figure(
        name,
        Value.of(published, unit),
        Value.of(measured, unit),
        Value.NONE,
        isNear ? Verdict.REPRODUCED : Verdict.REFUTED,
        "");
  }

  /**
   * A figure whose input is not published.
   *
   * @param reason which input
   */
  public static Figure notComparable(String name, Value published, Value measured, String reason) {
    return new Figure(name, published, measured, Value.NONE, Verdict.NOT_COMPARABLE, reason);
  }

  /** The same beside the best that is possible. */
  public Figure withBound(Value best) {
    return new Figure(name, published, measured, best, verdict, reason);
  }

  /** The same with another reason. */
  public Figure because(String why) {
    return new Figure(name, published, measured, bound, verdict, why);
  }
}
