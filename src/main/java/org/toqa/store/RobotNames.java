package org.toqa.store;

import java.util.List;
import org.jspecify.annotations.Nullable;

/** Names of robots in one column, with blanks between: no name has a blank. */
final class RobotNames {
  private RobotNames() {}

  /** Null where there are none. */
  static @Nullable String write(List<String> names) {
    return names.isEmpty() ? null : String.join(" ", names);
  }

  static List<String> read(@Nullable String column) {
    return column == null ? List.of() : List.of(column.split(" ", -1));
  }
}
