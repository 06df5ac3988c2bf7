package org.toqa.web.input;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskOrder;

/** Reads the order of a task. What it reads means something only where no sentence was filed. */
public final class TaskOrderReader {
  private TaskOrderReader() {}

  /** An order that a program gives: its deadline may have passed already. */
  public static TaskOrder read(Fields fields) {
    return read(fields, deadline -> fields.rules().deadline(fields.path("deadline"), deadline));
  }

  /** An order that a person enters: a deadline that has passed is a slip. */
  public static TaskOrder readEntered(Fields fields, Instant now) {
    return read(
        fields, deadline -> fields.rules().futureDeadline(fields.path("deadline"), deadline, now));
  }

  /**
   * The same of a task that is edited.
   *
   * @param before its deadline, which counts to the second where the minute is left as it was
   */
  public static TaskOrder readEdited(Fields fields, Instant now, @Nullable Instant before) {
    return read(
        fields,
        deadline ->
            before != null && before.truncatedTo(ChronoUnit.MINUTES).equals(deadline)
                ? before
                : fields.rules().futureDeadline(fields.path("deadline"), deadline, now));
  }

  private static TaskOrder read(Fields fields, UnaryOperator<@Nullable Instant> deadlineRule) {
    InputRules rules = fields.rules();
    TaskOrder order =
        new TaskOrder(
            rules.taskName(fields.path("name"), fields.text("name")),
            rules.load(fields.path("load"), fields.number("load")),
            fields.place("start"),
            fields.place("goal"),
            fields.text("floor"),
            rules.priority(fields.path("priority"), fields.number("priority")),
            deadlineRule.apply(fields.moment("deadline", "error.deadline")),
            fields.size("size"));
    fields.refuseUnknown();
    return order;
  }
}
