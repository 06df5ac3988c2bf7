package org.toqa.app.plan;

import org.toqa.app.command.WordConverter;

/** {@code --format}: how a plan is shown. */
enum Format {
  TABLE,
  JSON,
  SVG;

  String text(PlannedDrive drive) {
    return switch (this) {
      case TABLE -> PlanTable.of(drive);
      case JSON -> PlanJson.of(drive);
      case SVG -> PlanPicture.of(drive);
    };
  }

  /** Reads what a user types. */
  static final class Converter extends WordConverter<Format> {
    Converter() {
      super(values());
    }
  }
}
