package org.toqa.notices;

import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Predicate;

/**
 * The notices of a site as its pages use them.
 *
 * @see NoticeStore
 */
public final class Notices {
  /** More unseen ones are not counted. */
  public static final int MOST_COUNTED = 100;

  /** So many of the newest ones are looked at for what a page is told. */
  private static final int MOST_NEWEST = 50;

  /** A page opens no more windows at once. */
  private static final int MOST_NEWS = 10;

  private final NoticeStore store;
  private final boolean canMail;
  private final WebhookAddresses addresses;
  private final WebhookPoster webhooks;
  private final InstantSource clock;
  private final AtomicLong version = new AtomicLong();

  /**
   * @param canMail whether there is a mail server
   * @param addresses where webhooks may lead
   */
  public Notices(
      NoticeStore store,
      boolean canMail,
      WebhookAddresses addresses,
      WebhookPoster webhooks,
      InstantSource clock) {
    this.store = store;
    this.canMail = canMail;
    this.addresses = addresses;
    this.webhooks = webhooks;
    this.clock = clock;
  }

  public NoticeStore store() {
    return store;
  }

  public boolean canMail() {
    return canMail;
  }

  public WebhookAddresses addresses() {
    return addresses;
  }

  public WebhookPoster webhooks() {
    return webhooks;
  }

  /** Another one: what somebody would be told may have changed. */
  public long version() {
    return version.get();
  }

  /**
   * What a page tells its reader.
   *
   * @param unseen how many, up to {@link #MOST_COUNTED}
   * @param latest the id of the newest notice, whatever it is about; 0: there is none
   * @param told those of the newest that last, disturb him now, and are not seen by him
   */
  public record News(int unseen, long latest, List<Told> told) {
    public static final News NONE = new News(0, 0, List.of());

    public News {
      told = List.copyOf(told);
    }
  }

  /**
   * @param sound whether by sound
   * @param browser whether by the browser
   */
  public record Told(Notice notice, boolean sound, boolean browser) {}

  /**
   * @param account his id
   * @param since when the account was made
   */
  public News news(long account, NoticePreferences preferences, Instant since) {
    int unseen = store.unseen(account, preferences, since, MOST_COUNTED);
    List<Notice> newest = store.newest(since, MOST_NEWEST);
    boolean isQuiet = preferences.isQuiet(clock.instant());
    return new News(
        unseen,
        newest.isEmpty() ? 0 : newest.getFirst().id(),
        newest.stream()
            .filter(notice -> notice.isOpen() && !isQuiet)
            .map(
                notice ->
                    new Told(
                        notice,
                        preferences.wants(notice.condition(), Channel.SOUND, account),
                        preferences.wants(notice.condition(), Channel.BROWSER, account)))
            .filter(told -> told.sound() || told.browser())
            .limit(MOST_NEWS)
            .toList());
  }

  /** Stores changes; pages are told. */
  public void add(List<NoticeStore.Change> changes, Instant now, Predicate<UUID> isSent) {
    store.add(changes, now, isSent);
    version.incrementAndGet();
  }

  /**
   * @return false: there is no such notice
   */
  public boolean markSeen(long id, long account, String name) {
    boolean done = store.markSeen(id, account, name, clock.instant());
    version.incrementAndGet();
    return done;
  }

  /**
   * @param upTo the id of the newest one that he was shown
   */
  public void markAllSeen(long upTo, long account, String name) {
    store.markAllSeen(upTo, account, name, clock.instant());
    version.incrementAndGet();
  }

  public void setPreferences(long account, NoticePreferences preferences) {
    store.setPreferences(account, preferences);
    version.incrementAndGet();
  }
}
