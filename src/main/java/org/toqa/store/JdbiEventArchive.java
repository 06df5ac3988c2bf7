package org.toqa.store;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jdbi.v3.core.Jdbi;
import org.jdbi.v3.core.statement.Query;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.history.EventArchive;

/** The history on H2 and on MySQL. */
public final class JdbiEventArchive implements EventArchive {
  private final SqlExecutor sql;

  public JdbiEventArchive(Jdbi jdbi) {
    this.sql = new SqlExecutor(jdbi);
  }

  @Override
  public List<Entry> events(Filter filter, long before, int limit) {
    Map<String, Object> conditions = new LinkedHashMap<>();
    conditions.put("id < :a", before);
    add(conditions, "task_id = :b", filter.task());
    add(conditions, "robot = :c", filter.robot());
    add(conditions, "who = :d", filter.user());
    if (filter.kind() != null) {
      boolean isFamily = filter.kind().indexOf('.') < 0;
      conditions.put(
          isFamily ? "kind like :e" : "kind = :e",
          isFamily ? filter.kind().replaceAll("[%_]", "") + ".%" : filter.kind());
    }
    add(conditions, "kind not like :h", filter.users() ? null : "user.%");
    add(conditions, "kind not like :k", filter.users() ? null : "notice.%");
    add(conditions, "kind not like :j", filter.sites() ? null : "site.%");
    add(conditions, "at >= :f", filter.from());
    add(conditions, "at < :g", filter.until());
    add(conditions, "floor = :i", filter.floor());
    return sql.withHandle(
        h -> {
          Query query =
              h.createQuery(
                  "select id, "
                      + EventTable.COLUMNS
                      + " from events where "
                      + String.join(" and ", conditions.keySet())
                      + " order by id desc limit :limit");
          conditions.forEach(
              (condition, value) ->
                  query.bind(condition.substring(condition.indexOf(':') + 1), value));
          return query
              .bind("limit", limit)
              .mapTo(EventTable.EventRow.class)
              .map(row -> new Entry(row.id(), row.toRecord()))
              .list();
        });
  }

  @Override
  public List<String> robots() {
    return sql.withHandle(
        h -> h.createQuery("select name from robots order by name").mapTo(String.class).list());
  }

  private static void add(
      Map<String, Object> conditions, String condition, @Nullable Object value) {
    if (value != null) {
      conditions.put(condition, value);
    }
  }
}
