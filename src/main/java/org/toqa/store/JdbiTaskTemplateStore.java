package org.toqa.store;

import java.sql.SQLIntegrityConstraintViolationException;
import java.time.InstantSource;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.jdbi.v3.core.JdbiException;
import org.jdbi.v3.core.statement.Update;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskTemplate;
import org.toqa.fleet.TaskTemplateStore;
import org.toqa.fleet.TemplateUse;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Phrase;
import tools.jackson.databind.json.JsonMapper;

/** The templates of tasks on H2 and on MySQL. */
public final class JdbiTaskTemplateStore implements TaskTemplateStore {
  private static final JsonMapper MAPPER = JsonMapper.builder().build();

  private static final String SELECT =
      """
      select id, name, floor, task_order, parameters, shared, user_name, user_id, changed_at
      from task_templates
      """;

  private final SqlExecutor sql;
  private final InstantSource clock;

  public JdbiTaskTemplateStore(Jdbi jdbi, InstantSource clock) {
    this.sql = new SqlExecutor(jdbi);
    this.clock = clock;
  }

  @Override
  public List<TaskTemplate> templates() {
    return sql.withHandle(
        h ->
            h.createQuery(SELECT + "order by name_key")
                .mapTo(TaskTemplateRow.class)
                .map(TaskTemplateRow::toTemplate)
                .list());
  }

  @Override
  public Optional<TaskTemplate> template(long id) {
    return sql.withHandle(h -> template(h, id));
  }

  private static Optional<TaskTemplate> template(Handle h, long id) {
    return h.createQuery(SELECT + "where id = :id")
        .bind("id", id)
        .mapTo(TaskTemplateRow.class)
        .map(TaskTemplateRow::toTemplate)
        .findOne();
  }

  @Override
  public Optional<TaskTemplate> add(TaskTemplate template) {
    try {
      return sql.inTransaction(
          h -> {
            long id =
                bind(
                        h.createUpdate(
                            """
                            insert into task_templates (name, name_key, floor, task_order, parameters, shared,
                              user_name, user_id, changed_at)
                            values (:name, :key, :floor, :order, :parameters, :shared, :user, :owner,
                              :at)
                            """),
                        template)
                    .bind("user", template.user())
                    .bind("owner", AccountTable.ownerOfNew(h, template.user(), template.owner()))
                    .executeAndReturnGeneratedKeys("id")
                    .mapTo(Long.class)
                    .one();
            tell(h, EventKind.TEMPLATE_ADDED, template, template.user(), Phrase.TEMPLATE_ADDED);
            return template(h, id);
          });
    } catch (StoreException e) {
      if (isNameTaken(e)) {
        return Optional.empty();
      }
      throw e;
    }
  }

  private static boolean isNameTaken(StoreException e) {
    return e.getCause() instanceof JdbiException refused
        && refused.getCause() instanceof SQLIntegrityConstraintViolationException;
  }

  private static Update bind(Update update, TaskTemplate template) {
    return update
        .bind("name", template.name())
        .bind("key", template.name().toLowerCase(Locale.ROOT))
        .bind("floor", template.floor())
        .bind("order", template.order())
        .bind("parameters", MAPPER.writeValueAsString(template.parameters()))
        .bind("shared", template.shared())
        .bind("at", template.changedAt().truncatedTo(ChronoUnit.MILLIS));
  }

  @Override
  public Change replace(
      TaskTemplate seen, TaskTemplate changed, Map<Long, TaskOrder> orders, String by) {
    try {
      return sql.inTransaction(
          h -> {
            TemplateUse use = new TemplateUse(seen.id(), seen.name(), seen.changedAt(), "");
            if (!TemplateTable.isStill(h, use)
                || !Set.copyOf(schedulesOf(h, seen.id())).equals(orders.keySet())) {
              return Change.OUTDATED;
            }
            bind(
                    h.createUpdate(
                        """
                        update task_templates set name = :name, name_key = :key, floor = :floor,
                          task_order = :order, parameters = :parameters, shared = :shared,
                          changed_at = :at
                        where id = :id
                        """),
                    changed)
                .bind("id", seen.id())
                .execute();
            orders.forEach((id, order) -> JdbiScheduleStore.saveOrder(h, id, order));
            tell(h, EventKind.TEMPLATE_CHANGED, changed, by, Phrase.TEMPLATE_CHANGED_BY);
            return Change.DONE;
          });
    } catch (StoreException e) {
      if (isNameTaken(e)) {
        return Change.NAME_TAKEN;
      }
      throw e;
    }
  }

  private static List<Long> schedulesOf(Handle h, long template) {
    return h.createQuery("select id from schedules where template_id = :id order by id")
        .bind("id", template)
        .mapTo(Long.class)
        .list();
  }

  @Override
  public List<Long> delete(TaskTemplate template, String by) {
    return sql.inTransaction(
        h -> {
          boolean isThere =
              h.createQuery("select id from task_templates where id = :id for update")
                  .bind("id", template.id())
                  .mapTo(Long.class)
                  .findOne()
                  .isPresent();
          List<Long> schedules = schedulesOf(h, template.id());
          if (isThere && schedules.isEmpty()) {
            h.execute("delete from task_templates where id = ?", template.id());
            tell(h, EventKind.TEMPLATE_DELETED, template, by, Phrase.TEMPLATE_DELETED);
          }
          return schedules;
        });
  }

  private void tell(Handle h, EventKind kind, TaskTemplate template, String by, Phrase phrase) {
    EventTable.addAll(
        h,
        List.of(
            new EventRecord(clock.instant(), kind, null, null, by, phrase.with(by, template.name()))
                .onFloor(template.floor())));
  }
}
