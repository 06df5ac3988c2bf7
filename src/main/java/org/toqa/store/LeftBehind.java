package org.toqa.store;

import java.time.Instant;
import java.util.List;
import org.jdbi.v3.core.Handle;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Account;
import org.toqa.fleet.EventKind;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * What a user leaves behind who is about to be deleted, within the transaction that deletes him.
 *
 * @param by who deletes him
 */
record LeftBehind(Handle handle, Account user, Instant now, String by) {

  /** A schedule or a token. */
  record Item(long id, String name) {}

  /**
   * @param heir null: nobody, they are removed
   */
  void handOverSchedules(@Nullable Account heir) {
    for (Item schedule : items("select id, name from schedules where user_id = :user")) {
      if (heir == null) {
        handle.execute("delete from schedules where id = ?", schedule.id());
        record(
            EventKind.SCHEDULE_DELETED,
            Phrase.SCHEDULE_DELETED.with(by, schedule.id(), schedule.name()));
      } else {
        handle.execute(
            "update schedules set user_id = ?, user_name = ? where id = ?",
            heir.id(),
            heir.name(),
            schedule.id());
        record(
            EventKind.SCHEDULE_HANDED_OVER,
            Phrase.SCHEDULE_HANDED_OVER.with(by, schedule.id(), user.name(), heir.name()));
      }
    }
  }

  /**
   * @param heir null: nobody, they end with their user
   */
  void handOverTokens(@Nullable Account heir) {
    if (heir == null) {
      return;
    }
    for (Item token :
        items("select id, name from sessions where user_id = :user and kind = 'TOKEN'")) {
      handle.execute("update sessions set user_id = ? where id = ?", heir.id(), token.id());
      record(
          EventKind.USER_TOKEN,
          Phrase.TOKEN_HANDED_OVER.with(by, token.name(), user.name(), heir.name()));
    }
  }

  private List<Item> items(String query) {
    return handle.createQuery(query).bind("user", user.id()).mapTo(Item.class).list();
  }

  private void record(EventKind kind, Sentence said) {
    EventTable.addAccountEvent(handle, now, kind, by, said);
  }
}
