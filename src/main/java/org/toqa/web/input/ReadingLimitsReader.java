package org.toqa.web.input;

import org.toqa.telemetry.ReadingLimits;

/** Reads between which a manager wants a robot's readings. */
public final class ReadingLimitsReader {
  private ReadingLimitsReader() {}

  /**
   * What it reads means something only where no sentence was filed.
   *
   * @param robot whose reading it is
   * @param reading its name, wherever it was given
   */
  public static ReadingLimits read(String robot, String reading, Fields fields) {
    InputRules rules = fields.rules();
    ReadingLimits limits =
        new ReadingLimits(
            robot,
            rules.readingName("reading", reading),
            rules.limit("low", fields.number("low")),
            rules.limit("high", fields.number("high")));
    rules.limitsInOrder("high", limits.low(), limits.high());
    fields.refuseUnknown();
    return limits;
  }
}
