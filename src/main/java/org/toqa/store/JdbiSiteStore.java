package org.toqa.store;

import java.time.InstantSource;
import java.util.List;
import java.util.Optional;
import org.jdbi.v3.core.Jdbi;
import org.toqa.accounts.Site;
import org.toqa.accounts.SiteStore;
import org.toqa.fleet.EventKind;
import org.toqa.wording.Phrase;

/** The sites that share a server. */
public final class JdbiSiteStore implements SiteStore {
  private final SqlExecutor sql;
  private final InstantSource clock;

  /**
   * @param jdbi of the first site's database
   */
  public JdbiSiteStore(Jdbi jdbi, InstantSource clock) {
    this.sql = new SqlExecutor(jdbi);
    this.clock = clock;
  }

  @Override
  public List<Site> sites() {
    return sql.withHandle(
        h ->
            h.createQuery("select id, name from sites where complete order by id")
                .mapTo(Site.class)
                .list());
  }

  @Override
  public Optional<Site> reserve(String name) {
    return sql.inTransaction(
        h -> {
          int added =
              h.createUpdate(
                      """
                      insert ignore into sites (name_key, name, complete)
                      values (:key, :name, false)
                      """)
                  .bind("key", Site.key(name))
                  .bind("name", name)
                  .execute();
          if (added == 0) {
            return Optional.empty();
          }
          return Optional.of(
              h.createQuery("select id, name from sites where name_key = :key")
                  .bind("key", Site.key(name))
                  .mapTo(Site.class)
                  .one());
        });
  }

  @Override
  public void complete(Site site, String by) {
    sql.inTransaction(
        h -> {
          h.execute("update sites set complete = true where id = ?", site.id());
          EventTable.addAccountEvent(
              h,
              clock.instant(),
              EventKind.SITE_ADDED,
              by,
              Phrase.SITE_ADDED.with(by, site.name()));
          return null;
        });
  }

  @Override
  public void discardReserved() {
    sql.withHandle(h -> h.execute("delete from sites where not complete"));
  }

  @Override
  public void remove(Site site, String by) {
    if (site.isFirst()) {
      throw new IllegalArgumentException("The first site stays.");
    }
    sql.inTransaction(
        h -> {
          if (h.execute("delete from sites where id = ?", site.id()) > 0) {
            EventTable.addAccountEvent(
                h,
                clock.instant(),
                EventKind.SITE_REMOVED,
                by,
                Phrase.SITE_REMOVED.with(by, site.name()));
          }
          return null;
        });
  }
}
