package org.toqa.web.input;

import jakarta.servlet.http.HttpServletRequest;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Schedule;
import org.toqa.grid.FloorMap;
import org.toqa.web.Texts;

/** Reads from a request's query which schedules are wanted: by name or user, state and floor. */
public final class ScheduleQueryReader {
  private final SearchText text;
  private final @Nullable State state;
  private final FloorQueryReader floor;
  private final List<FloorMap> floors;

  /** What becomes of a schedule. */
  public enum State {
    /** It puts in its next task when that is due. */
    ACTIVE,
    /** A person has paused it, or its user may not log in. */
    PAUSED,
    /** It is never due again. */
    ENDED;

    static State of(Schedule schedule) {
      if (schedule.due() == null) {
        return ENDED;
      }
      return schedule.paused() || schedule.resting() ? PAUSED : ACTIVE;
    }

    /** As addresses name it. */
    public String word() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  /**
   * @param floors those that there are
   */
  public ScheduleQueryReader(
      HttpServletRequest request, FieldErrors errors, List<FloorMap> floors) {
    QueryFields fields = new QueryFields(request, errors);
    text = SearchText.of(fields);
    String word = fields.text("state");
    Optional<State> found =
        Arrays.stream(State.values()).filter(one -> one.word().equals(word)).findFirst();
    if (word != null && found.isEmpty()) {
      String words =
          Arrays.stream(State.values()).map(State::word).collect(Collectors.joining(", "));
      errors.add("state", Texts.of(request).get("error.schedules.state", words));
    }
    state = found.orElse(null);
    floor = new FloorQueryReader(request, errors, floors);
    this.floors = floors;
  }

  /** Whether not all are wanted. */
  public boolean isFiltered() {
    return text.isGiven() || state != null || floor.floor() != null;
  }

  /** Those of the schedules that are wanted, in their order. */
  public List<Schedule> filter(List<Schedule> all) {
    return floor.filter(all, schedule -> schedule.floor(floors)).stream()
        .filter(schedule -> state == null || State.of(schedule) == state)
        .filter(
            schedule ->
                text.isIn(Long.toString(schedule.id()), schedule.order().name(), schedule.user()))
        .toList();
  }
}
