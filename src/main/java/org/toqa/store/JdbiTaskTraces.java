package org.toqa.store;

import java.time.InstantSource;
import org.jdbi.v3.core.Jdbi;
import org.toqa.fleet.TaskTraces;

/** Who follows which task, on H2 and on MySQL. */
public final class JdbiTaskTraces implements TaskTraces {
  private final SqlExecutor sql;
  private final InstantSource clock;

  public JdbiTaskTraces(Jdbi jdbi, InstantSource clock) {
    this.sql = new SqlExecutor(jdbi);
    this.clock = clock;
  }

  /** A task or a user that is gone is followed by nobody, in the same statement. */
  @Override
  public void setFollowed(long user, long task, boolean followed) {
    String statement =
        followed
            ? """
              insert ignore into traces (user_id, task_id, since)
              select u.id, t.id, :at from users u, tasks t where u.id = :user and t.id = :task
              """
            : "delete from traces where user_id = :user and task_id = :task";
    sql.withHandle(
        h ->
            h.createUpdate(statement)
                .bind("user", user)
                .bind("task", task)
                .bind("at", clock.instant())
                .execute());
  }

  @Override
  public boolean isFollowed(long user, long task) {
    return sql.withHandle(
        h ->
            h.createQuery("select count(*) from traces where user_id = :user and task_id = :task")
                .bind("user", user)
                .bind("task", task)
                .mapTo(Boolean.class)
                .one());
  }
}
