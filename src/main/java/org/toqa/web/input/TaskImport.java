package org.toqa.web.input;

import java.time.DateTimeException;
import java.time.ZoneId;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Account;
import org.toqa.fleet.BatchAnswer;
import org.toqa.fleet.PartsOrder;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskView;
import org.toqa.mission.OrderPart;
import org.toqa.web.FleetAnswers;
import org.toqa.web.IdempotentSubmitter;
import org.toqa.web.Services;
import org.toqa.web.Texts;

/** Puts in the tasks of a table that somebody sends: all of them, or none. */
public final class TaskImport {
  /** Bytes of a table. */
  public static final int MAX_BYTES = 1024 * 1024;

  private final Services services;
  private final Texts texts;
  private final TemplateFiller templates;

  /**
   * @param templates those that the tables may use
   */
  public TaskImport(Services services, Texts texts, TemplateFiller templates) {
    this.services = services;
    this.texts = texts;
    this.templates = templates;
  }

  /** What became of a table. */
  public sealed interface Outcome {

    /** All its tasks are there, in its order; now, or since the same table came before. */
    record Imported(List<TaskView> tasks) implements Outcome {}

    /** Nothing was stored. */
    record Faulty(LineFaults faults) implements Outcome {}

    /** The table's key came before with another table. */
    record KeyReused() implements Outcome {}
  }

  /**
   * @param zone of deadlines that name none
   * @param key the same one for the same table
   */
  public Outcome run(byte[] file, ZoneId zone, Account user, UUID key) {
    TaskOrderTable table =
        TaskOrderTable.read(file, zone, services.clock().instant(), templates, texts);
    List<PartsOrder> orders = table.rows().stream().map(TaskOrderTable.Row::order).toList();
    if (!table.faults().isEmpty()) {
      List<TaskOrder> first = orders.stream().map(order -> order.tasks().getFirst()).toList();
      return withRefusals(
          table, table.rows(), FleetAnswers.await(services.fleet().rejections(first, user.name())));
    }
    return switch (services.submitter().submitTable(orders, user, key)) {
      case IdempotentSubmitter.BatchOutcome.Answered(BatchAnswer.Accepted(var tasks)) ->
          new Outcome.Imported(tasks);
      case IdempotentSubmitter.BatchOutcome.Answered(BatchAnswer.Rejected(var refusals)) ->
          withRefusals(table, rowsOfTasks(table), refusals);
      case IdempotentSubmitter.BatchOutcome.Repeated(var tasks) -> new Outcome.Imported(tasks);
      case IdempotentSubmitter.BatchOutcome.KeyReused() -> new Outcome.KeyReused();
    };
  }

  /** For each task the row that orders it. */
  private static List<TaskOrderTable.Row> rowsOfTasks(TaskOrderTable table) {
    return table.rows().stream()
        .flatMap(row -> row.order().tasks().stream().map(_ -> row))
        .toList();
  }

  /**
   * @param rows which row each refused order comes from
   */
  private Outcome withRefusals(
      TaskOrderTable table, List<TaskOrderTable.Row> rows, List<BatchAnswer.Rejection> refusals) {
    Set<List<Object>> told = new HashSet<>(); // of all pieces of a row the same
    for (BatchAnswer.Rejection refusal : refusals) {
      TaskOrderTable.Row row = rows.get(refusal.index());
      String column =
          column(row, refusal.index() - rows.indexOf(row), refusal.field()); // its parts follow it
      if (row.isReadable(column) && told.add(List.of(row, refusal.sentence()))) {
        table.faults().add(new LineFault(row.line(), column, texts.text(refusal.sentence())));
      }
    }
    return new Outcome.Faulty(table.faults());
  }

  /**
   * Where a stop that was refused stands in the row.
   *
   * @param part of the row's order, from 0
   */
  private static @Nullable String column(TaskOrderTable.Row row, int part, @Nullable String field) {
    if (field == null) {
      return null;
    }
    if (row.ofTemplate() != null) {
      return row.ofTemplate().entered(field, "");
    }
    if (field.startsWith("stops.")) {
      int stop = Integer.parseInt(field.substring("stops.".length()));
      boolean isDrive = row.order().tasks().getFirst().isDrive() && row.isReadable("load");
      return OrderRejections.entered(isDrive ? stop + 1 : stop, "stops");
    }
    boolean isLeg = row.order().kind() == OrderPart.Kind.STOPS;
    return isLeg && (field.equals("start") || field.equals("goal"))
        ? OrderRejections.entered(part + (field.equals("goal") ? 1 : 0), "stops")
        : field;
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
