package org.toqa.web.input;

import org.toqa.exploration.ExplorationOrder;
import org.toqa.geometry.Vec2;

/** Reads who is to explore a floor, over which ground, and whereto. */
public final class ExplorationReader {
  /** A larger seed is not the same number in every program that reads JSON. */
  private static final double MAX_SEED = 9_007_199_254_740_991.0;

  private final Fields fields;
  private final boolean isForm;

  /**
   * What it reads means something only where no sentence was filed.
   *
   * @param ground as {@link org.toqa.fleet.exploration.Explorer#ground} reads it
   */
  public record GroundAndOrder(String ground, ExplorationOrder order) {}

  private ExplorationReader(Fields fields, boolean isForm) {
    this.fields = fields;
    this.isForm = isForm;
  }

  /** Where points are two fields each: {@code startX}, {@code startY}. */
  public static GroundAndOrder readForm(Fields fields) {
    return new ExplorationReader(fields, true).read();
  }

  /** The same, where points are objects with x and y. */
  public static GroundAndOrder readJson(Fields fields) {
    return new ExplorationReader(fields, false).read();
  }

  private GroundAndOrder read() {
    String ground = fields.text("ground");
    if (ground == null) {
      fields.errors().add(fields.path("ground"), fields.texts().get("error.exploration.ground"));
    }
    double robots = whole("robots", 1, ExplorationOrder.MOST_ROBOTS);
    Vec2 start = point("start");
    Vec2 target = point("target");
    double seed = whole("seed", 0, MAX_SEED);
    fields.refuseUnknown();
    return new GroundAndOrder(
        ground == null ? "" : ground,
        new ExplorationOrder((int) robots, start, target, (long) seed));
  }

  /** One where nothing is given. */
  private double whole(String field, double least, double most) {
    Double given = fields.number(field);
    if (given == null) {
      return 1;
    }
    if (given != Math.rint(given) || !(given >= least && given <= most)) {
      fields
          .errors()
          .add(
              fields.path(field),
              fields.texts().get("error.laboratory.whole", text(least), text(most)));
      return 1;
    }
    return given;
  }

  private static String text(double number) {
    return Long.toString((long) number);
  }

  private Vec2 point(String name) {
    Fields point = isForm ? fields : fields.object(name);
    String x = isForm ? name + "X" : "x";
    String y = isForm ? name + "Y" : "y";
    Vec2 read =
        new Vec2(
            point.rules().coordinateOfPose(point.path(x), point.number(x)),
            point.rules().coordinateOfPose(point.path(y), point.number(y)));
    if (!isForm) {
      point.refuseUnknown();
    }
    return read;
  }
}
