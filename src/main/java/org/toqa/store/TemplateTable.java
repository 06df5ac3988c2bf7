package org.toqa.store;

import java.time.temporal.ChronoUnit;
import org.jdbi.v3.core.Handle;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TemplateUse;

/** What other tables ask of the templates of tasks. */
final class TemplateTable {
  private TemplateTable() {}

  /**
   * Whether the template is what it was when it was used; true where none was. It stays so until
   * the transaction ends.
   */
  static boolean isStill(Handle h, @Nullable TemplateUse use) {
    return use == null
        || h.createQuery(
                "select id from task_templates where id = :id and changed_at = :at for update")
            .bind("id", use.template())
            .bind("at", use.changedAt().truncatedTo(ChronoUnit.MILLIS))
            .mapTo(Long.class)
            .findOne()
            .isPresent();
  }
}
