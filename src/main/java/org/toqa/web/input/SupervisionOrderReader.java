package org.toqa.web.input;

import java.util.List;
import java.util.Map;
import org.toqa.fleet.supervision.SupervisionOrder;
import org.toqa.geometry.Vec2;

/** Reads which robots are to carry which boxes of a floor, and where to. */
public final class SupervisionOrderReader {
  private SupervisionOrderReader() {}

  /** It means something only when no error was filed. */
  public static SupervisionOrder read(Fields fields, String floor) {
    String supervisor =
        fields.rules().robotName(fields.path("supervisor"), fields.text("supervisor"));
    List<String> workers =
        fields.rules().robotNames(fields.path("workers"), fields.choices("workers"));
    if (workers.isEmpty()) {
      fields.errors().add(fields.path("workers"), fields.texts().get("error.supervision.workers"));
    }
    boolean isSequential = fields.flag("sequential");
    Map<Integer, Vec2> targets = fields.boxTargets("boxes", SupervisionOrder.MAX_BOXES);
    if (targets.isEmpty()) {
      fields.errors().add(fields.path("boxes"), fields.texts().get("error.supervision.boxes"));
    }
    fields.refuseUnknown();
    return new SupervisionOrder(floor, supervisor, workers, !isSequential, targets);
  }
}
