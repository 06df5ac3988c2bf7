package org.toqa.store;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.statement.Query;
import org.toqa.fleet.TaskArchive.Filter;
import org.toqa.fleet.TaskArchive.Sort;

/** Asks for those tasks that a filter wants. */
final class TaskQuery {
  private final List<String> conditions = new ArrayList<>();
  private final Map<String, Object> values = new LinkedHashMap<>();

  TaskQuery(Filter filter) {
    if (!filter.states().isEmpty()) {
      conditions.add(
          filter.states().stream()
              .map(state -> "'" + state.name() + "'")
              .sorted()
              .collect(Collectors.joining(", ", "state in (", ")")));
    }
    if (filter.robot() != null) {
      add(
          """
          exists (select 1 from task_robots c join robots r on r.id = c.robot_id
            where c.task_id = tasks.id and r.name = :robot)
          """,
          "robot",
          filter.robot());
    }
    if (filter.user() != null) {
      add("lower(user_name) = :user", "user", filter.user().toLowerCase(Locale.ROOT));
    }
    if (filter.text() != null) {
      addText(filter.text());
    }
    if (filter.from() != null) {
      add("created_at >= :from", "from", filter.from());
    }
    if (filter.until() != null) {
      add("created_at < :until", "until", filter.until());
    }
    if (filter.floor() != null) {
      add("floor = :floor", "floor", filter.floor());
    }
    if (filter.follower() != null) {
      add(
          "exists (select 1 from traces f where f.task_id = tasks.id and f.user_id = :follower)",
          "follower",
          filter.follower());
    }
  }

  private void addText(String text) {
    String inName = "locate(:text, lower(name)) > 0";
    boolean isNumber = text.matches("[0-9]{1,18}");
    add(
        isNumber ? "(id = :number or " + inName + ")" : inName,
        "text",
        text.toLowerCase(Locale.ROOT));
    if (isNumber) {
      values.put("number", Long.valueOf(text));
    }
  }

  private void add(String condition, String name, Object value) {
    conditions.add(condition);
    values.put(name, value);
  }

  /**
   * @param columns the columns
   * @param suffix what follows the conditions
   */
  Query select(Handle h, String columns, String suffix) {
    String where = conditions.isEmpty() ? "" : " where " + String.join(" and ", conditions);
    Query query = h.createQuery("select " + columns + " from tasks" + where + suffix);
    values.forEach(query::bind);
    return query;
  }

  static String orderBy(Sort sort) {
    String column =
        switch (sort.by()) {
          case ID -> "id";
          case NAME -> "lower(name)";
          case STATE -> "state";
          case LOAD -> "load_kg";
          case USER -> "lower(user_name)";
          case CREATED -> "created_at";
        };
    return " order by " + column + (sort.descending() ? " desc" : "") + ", id desc";
  }
}
