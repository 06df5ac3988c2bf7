package org.toqa.web.input;

import jakarta.servlet.http.HttpServletRequest;
import java.util.List;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.toqa.grid.FloorMap;

/** Reads from a request's query of which floor a list is wanted. */
public final class FloorQueryReader {
  private final @Nullable String floor;

  /**
   * @param floors those that there are
   */
  public FloorQueryReader(HttpServletRequest request, FieldErrors errors, List<FloorMap> floors) {
    this.floor = new QueryFields(request, errors).floor(floors);
  }

  /** Null: all. */
  public @Nullable String floor() {
    return floor;
  }

  /**
   * What of a list is of the floor.
   *
   * @param floorOf where something is
   */
  public <T> List<T> filter(List<T> all, Function<T, String> floorOf) {
    return floor == null
        ? all
        : all.stream().filter(one -> floor.equals(floorOf.apply(one))).toList();
  }
}
