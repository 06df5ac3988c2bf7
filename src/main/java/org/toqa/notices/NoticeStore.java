package org.toqa.notices;

import java.net.URI;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.toqa.notices.Delivery.Due;

/**
 * Notices, who has seen them, how people want to be told, webhooks, and what is still to be told.
 *
 * <p>Any thread may call it and may have to wait. Every method throws {@link
 * org.toqa.persistence.StoreException} when the store does not answer.
 */
public interface NoticeStore {

  /** What is stored at once: a notice, or its end, with all that is to be told of it. */
  record Change(Notice notice, boolean ending, List<Delivery> deliveries) {
    public Change {
      deliveries = List.copyOf(deliveries);
    }
  }

  /** Those whose conditions last. */
  List<Notice> open();

  /**
   * Stores changes that are not stored yet, by the notice's uid.
   *
   * @param isSent of a delivery's uid: whether it was told already
   */
  void add(List<Change> changes, Instant now, Predicate<UUID> isSent);

  /**
   * Which notices are wanted.
   *
   * @param open those that last; false: all
   * @param unseenBy by the account of that id; null: all
   */
  record Filter(boolean open, @Nullable Long unseenBy) {}

  /** Somebody has seen it. */
  record Seen(long account, String name, Instant at) {}

  /**
   * A notice with what became of it.
   *
   * @param seen by whom, the first one first
   */
  record Entry(Notice notice, List<Seen> seen, List<Delivery.Outcome> deliveries) {
    public Entry {
      seen = List.copyOf(seen);
      deliveries = List.copyOf(deliveries);
    }

    public boolean isSeenBy(long account) {
      return seen.stream().anyMatch(one -> one.account() == account);
    }
  }

  /**
   * Newest first.
   *
   * @param before an id; those of later notices are higher
   * @param limit how many at most
   */
  List<Entry> entries(Filter filter, long before, int limit);

  /**
   * How many that he has not seen there are, up to a limit.
   *
   * @param preferences how he wants to be told; those count of which pages tell him
   * @param since from when on they count
   */
  int unseen(long account, NoticePreferences preferences, Instant since, int limit);

  /**
   * The newest ones.
   *
   * @param since from when on
   */
  List<Notice> newest(Instant since, int limit);

  /**
   * @return false: there is no such notice
   */
  boolean markSeen(long id, long account, String name, Instant at);

  /**
   * All that there are.
   *
   * @param upTo the id of the newest one that he was shown
   */
  void markAllSeen(long upTo, long account, String name, Instant at);

  /** Empty: he has chosen nothing. */
  Optional<NoticePreferences> preferences(long account);

  void setPreferences(long account, NoticePreferences preferences);

  /** Those who can be told by letter, and have chosen something. */
  List<Person> people();

  /**
   * In the order in which they were made. What is done with them is in the history, with the host
   * alone: the rest of an address may be secret.
   */
  List<Webhook> webhooks();

  /** What became last of what was to be told to each, by its id. */
  Map<Long, Delivery.Outcome> lastOutcomes();

  Webhook addWebhook(URI url, WebhookSecret secret, Set<NoticeKind> kinds, Instant now, String by);

  /**
   * @param by the name of who does so
   * @return false: there is no such webhook
   */
  boolean changeWebhook(
      long id, URI url, Set<NoticeKind> kinds, boolean enabled, Instant now, String by);

  /**
   * @param by the name of who does so
   * @return false: there is no such webhook
   */
  boolean setSecret(long id, WebhookSecret secret, Instant now, String by);

  /**
   * With all that was still to be told there.
   *
   * @param by the name of who does so
   * @return false: there is no such webhook
   */
  boolean deleteWebhook(long id, Instant now, String by);

  /**
   * The first of what may be told now; what tells an end comes after its begin. A letter that tells
   * a begin after its end tells both.
   */
  Optional<Due> firstLetter(Instant now);

  Optional<Due> first(Webhook webhook, Instant now);

  /** As he is now; empty: he may not sign in, has no e-mail address, or has chosen nothing. */
  Optional<Person> person(long account);

  void setSent(Due due, Instant at);

  /** It is tried again then. */
  void setFailed(Due due, String failure, Instant next);

  /**
   * What waits although it was accepted after {@code now}, or has failed and is tried again after
   * {@code latest}.
   */
  List<Due> putOff(Instant now, Instant latest);

  /** While it waits, it counts as accepted then, and is tried at {@code next}. */
  void bringForward(Due due, Instant createdAt, Instant next);

  void giveUp(Due due, String failure, Instant at);
}
