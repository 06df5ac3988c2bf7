package org.toqa.app.plan;

import java.util.Locale;
import org.toqa.app.command.WordConverter;

/** {@code --moves} of a plan: moves from cell to cell, or a smooth curve. */
enum PlanMoves {
  OCTILE,
  HEADING,
  SMOOTH;

  /** As a user types it. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Reads what a user types. */
  static final class Converter extends WordConverter<PlanMoves> {
    Converter() {
      super(values());
    }
  }
}
