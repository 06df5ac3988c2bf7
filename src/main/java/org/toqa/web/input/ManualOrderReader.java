package org.toqa.web.input;

import org.toqa.fleet.ManualOrder;

/** Reads what a person who drives a robot by hand wants of it for the next moment. */
public final class ManualOrderReader {
  private ManualOrderReader() {}

  /** What it reads means something only where no sentence was filed. */
  public static ManualOrder read(Fields fields) {
    InputRules rules = fields.rules();
    ManualOrder order =
        new ManualOrder(
            rules.lease("lease", fields.text("lease")),
            rules.orderNumber("number", fields.number("number")),
            rules.manualSpeed("v", fields.number("v"), ManualOrder.MAX_SPEED),
            rules.manualSpeed("w", fields.number("w"), ManualOrder.MAX_TURN_RATE));
    fields.refuseUnknown();
    return order;
  }
}
