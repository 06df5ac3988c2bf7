package org.toqa.web.input;

import jakarta.servlet.http.HttpServletRequest;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.grid.FloorMap;
import org.toqa.web.Texts;

/** Reads from a request's query which robots are wanted: by name or address, state and floor. */
public final class RobotQueryReader {
  private final SearchText text;
  private final @Nullable RobotState state;
  private final FloorQueryReader floor;

  /**
   * @param floors those that there are
   */
  public RobotQueryReader(HttpServletRequest request, FieldErrors errors, List<FloorMap> floors) {
    QueryFields fields = new QueryFields(request, errors);
    text = SearchText.of(fields);
    String word = fields.text("state");
    Optional<RobotState> found =
        Arrays.stream(RobotState.values()).filter(one -> one.name().equals(word)).findFirst();
    if (word != null && found.isEmpty()) {
      String words =
          Arrays.stream(RobotState.values()).map(Enum::name).collect(Collectors.joining(", "));
      errors.add("state", Texts.of(request).get("error.robots.state", words));
    }
    state = found.orElse(null);
    floor = new FloorQueryReader(request, errors, floors);
  }

  /** Whether not all are wanted. */
  public boolean isFiltered() {
    return text.isGiven() || state != null || floor.floor() != null;
  }

  /** Those of the robots that are wanted, in their order. */
  public List<RobotView> filter(List<RobotView> all) {
    return floor.filter(all, RobotView::floor).stream()
        .filter(robot -> state == null || robot.state() == state)
        .filter(
            robot -> text.isIn(robot.name(), robot.record().host() + ":" + robot.record().port()))
        .toList();
  }
}
