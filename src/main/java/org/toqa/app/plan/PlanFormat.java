package org.toqa.app.plan;

import org.toqa.app.command.WordConverter;

/** {@code --format}: how a plan is shown. */
enum PlanFormat {
  TABLE,
  JSON,
  SVG;

  String render(PlannedDrive drive) {
    return switch (this) {
      case TABLE -> PlanTable.of(drive);
      case JSON -> PlanJson.of(drive);
      case SVG -> PlanSvg.of(drive);
    };
  }

  String render(SmoothDrive drive) {
    return switch (this) {
      case TABLE -> SmoothTable.of(drive);
      case JSON -> SmoothJson.of(drive);
      case SVG -> SmoothSvg.of(drive);
    };
  }

  /** Reads what a user types. */
  static final class Converter extends WordConverter<PlanFormat> {
    Converter() {
      super(values());
    }
  }
}
