package org.toqa.web;

import java.time.DateTimeException;
import java.time.ZoneId;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.BatchAnswer;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskView;
import org.toqa.store.Account;

/** Puts in the tasks of a table that somebody sends: all of them, or none. */
public final class TaskImport {
  /** Bytes of a table. */
  public static final int LARGEST = 1024 * 1024;

  private final Services services;
  private final Texts texts;

  public TaskImport(Services services, Texts texts) {
    this.services = services;
    this.texts = texts;
  }

  /** What became of a table. */
  public sealed interface Outcome {

    /** All its tasks are there, in its order; now, or since the same table came before. */
    record Imported(List<TaskView> tasks) implements Outcome {}

    /** Nothing was stored. */
    record Faulty(LineFaults faults) implements Outcome {}

    /** The table's key came before with another table. */
    record OtherTable() implements Outcome {}
  }

  /**
   * @param zone of deadlines that name none
   * @param key the same one for the same table
   */
  public Outcome run(byte[] file, ZoneId zone, Account user, UUID key) {
    OrderTable table = OrderTable.read(file, zone, services.clock().instant(), texts);
    List<TaskOrder> orders = table.rows().stream().map(OrderTable.Row::order).toList();
    if (!table.faults().isEmpty()) {
      return faulty(table, FleetAnswers.await(services.fleet().refusals(orders, user.name())));
    }
    return switch (services.submissions().submitAll(orders, user, key)) {
      case Submissions.BatchOutcome.Answered(BatchAnswer.Accepted(var tasks)) ->
          new Outcome.Imported(tasks);
      case Submissions.BatchOutcome.Answered(BatchAnswer.Refused(var refusals)) ->
          faulty(table, refusals);
      case Submissions.BatchOutcome.Repeated(var tasks) -> new Outcome.Imported(tasks);
      case Submissions.BatchOutcome.OtherOrders() -> new Outcome.OtherTable();
    };
  }

  private Outcome faulty(OrderTable table, List<BatchAnswer.Refusal> refusals) {
    refusals.forEach(
        refusal ->
            table
                .faults()
                .add(
                    new LineFault(
                        table.rows().get(refusal.place()).line(),
                        refusal.field(),
                        texts.say(refusal.sentence()))));
    return new Outcome.Faulty(table.faults());
  }

  /** The time zone of that name, if there is one; UTC where none is named. */
  public static Optional<ZoneId> zone(@Nullable String name) {
    try {
      return Optional.of(ZoneId.of(name == null || name.isBlank() ? "UTC" : name));
    } catch (DateTimeException e) {
      return Optional.empty();
    }
  }
}
