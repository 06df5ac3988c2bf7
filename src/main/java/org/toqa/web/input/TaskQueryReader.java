package org.toqa.web.input;

import jakarta.servlet.http.HttpServletRequest;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskArchive.Filter;
import org.toqa.fleet.TaskArchive.Sort;
import org.toqa.mission.TaskState;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;

/** Reads from a request's query which tasks are wanted, and in which order. */
public final class TaskQueryReader {
  /** What a state may be besides one of a task's own. */
  private static final String OPEN = "open";

  private static final String ENDED = "ended";

  private final FieldErrors errors;
  private final Texts texts;
  private final QueryFields fields;
  private final long caller;

  public TaskQueryReader(HttpServletRequest request, FieldErrors errors) {
    this.errors = errors;
    this.texts = Texts.of(request);
    this.fields = new QueryFields(request, errors);
    this.caller = Caller.of(request).account().id();
  }

  /** It means something only when no error was filed. */
  public Filter filter() {
    String text = fields.text("text");
    return new Filter(
        states(fields.text("state")),
        fields.text("robot"),
        fields.text("user"),
        text == null ? null : Digits.latin(text),
        fields.from(),
        fields.until(),
        follower(fields.text("followed")),
        fields.text("floor"));
  }

  /** The caller, where he wants those that he follows. */
  private @Nullable Long follower(@Nullable String followed) {
    if (followed == null || followed.equals("false")) {
      return null;
    }
    if (!followed.equals("true")) {
      errors.add("followed", texts.get("error.tasks.followed"));
    }
    return caller;
  }

  /** A column, or with a minus before it the same downwards. */
  public Sort sort() {
    String given = fields.text("sort");
    if (given == null) {
      return Sort.NEWEST_FIRST;
    }
    boolean descending = given.startsWith("-");
    return Arrays.stream(Sort.Column.values())
        .filter(column -> word(column).equals(descending ? given.substring(1) : given))
        .findFirst()
        .map(column -> new Sort(column, descending))
        .orElseGet(
            () -> {
              errors.add("sort", texts.get("error.tasks.sort", String.join(", ", sortColumns())));
              return Sort.NEWEST_FIRST;
            });
  }

  /** The columns by which the list can be sorted, as addresses name them. */
  public static List<String> sortColumns() {
    return Arrays.stream(Sort.Column.values()).map(TaskQueryReader::word).toList();
  }

  private Set<TaskState> states(@Nullable String given) {
    if (given == null) {
      return Set.of();
    }
    Predicate<TaskState> wanted =
        switch (given) {
          case OPEN -> state -> !state.isEnded();
          case ENDED -> TaskState::isEnded;
          default -> state -> state.name().equals(given);
        };
    Set<TaskState> states =
        Arrays.stream(TaskState.values()).filter(wanted).collect(Collectors.toSet());
    if (states.isEmpty()) {
      String words =
          Stream.concat(
                  Stream.of(OPEN, ENDED), Arrays.stream(TaskState.values()).map(TaskState::name))
              .collect(Collectors.joining(", "));
      errors.add("state", texts.get("error.tasks.state", words));
    }
    return states;
  }

  private static String word(Sort.Column column) {
    return column.name().toLowerCase(Locale.ROOT);
  }
}
