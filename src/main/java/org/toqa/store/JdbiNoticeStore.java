package org.toqa.store;

import java.net.URI;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.time.Instant;
import java.time.LocalTime;
import java.time.ZoneId;
import java.util.Arrays;
import java.util.Collection;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.Jdbi;
import org.jdbi.v3.core.statement.PreparedBatch;
import org.toqa.fleet.EventKind;
import org.toqa.notices.Channel;
import org.toqa.notices.Condition;
import org.toqa.notices.Delivery;
import org.toqa.notices.Delivery.Due;
import org.toqa.notices.Delivery.Outcome;
import org.toqa.notices.Delivery.Receiver;
import org.toqa.notices.Notice;
import org.toqa.notices.NoticeKind;
import org.toqa.notices.NoticePreferences;
import org.toqa.notices.NoticeStore;
import org.toqa.notices.Person;
import org.toqa.notices.QuietHours;
import org.toqa.notices.Webhook;
import org.toqa.notices.WebhookSecret;
import org.toqa.wording.Phrase;

/** Notices, and what is still to be told of them. */
public final class JdbiNoticeStore implements NoticeStore {
  private static final String COLUMNS =
      "n.id, n.uid, n.kind, n.subject, n.floor, n.task_id, n.robot, n.owner_id, n.text, n.said,"
          + " n.begun_at, n.ended_at";

  private static final String DUE =
      "select d.id as delivery_id, d.uid as delivery_uid, d.user_id, d.webhook_id, d.ending,"
          + " d.attempts, d.created_at, d.next_at, "
          + COLUMNS
          + " from notice_deliveries d join notices n on n.id = d.notice_id"
          + " where d.state = 'WAITING'";

  private static final String DELIVERIES =
      """
      select d.notice_id, d.user_id, d.webhook_id, d.ending, d.state, d.attempts, d.next_at,
        d.done_at, d.failure, u.name as user_name, w.url
      from notice_deliveries d
        left join users u on u.id = d.user_id left join webhooks w on w.id = d.webhook_id
      """;

  private static final String PERSON =
      """
      select p.user_id, u.email, p.own_tasks, p.ends, p.quiet_from, p.quiet_until, p.zone, p.language
      from notice_preferences p join users u on u.id = p.user_id
      where u.email is not null and not u.disabled
      """;

  private static final String BETWEEN = ",";

  private final SqlExecutor sql;

  public JdbiNoticeStore(Jdbi jdbi) {
    this.sql = new SqlExecutor(jdbi);
  }

  @Override
  public List<Notice> open() {
    return sql.withHandle(
        h ->
            h
                .createQuery("select " + COLUMNS + " from notices n where n.ended_at is null")
                .map((row, _) -> notice(row))
                .stream()
                .flatMap(Optional::stream)
                .toList());
  }

  /** Empty: of a kind that this version does not know. */
  private static Optional<Notice> notice(ResultSet row) throws SQLException {
    Optional<NoticeKind> kind = NoticeKind.ofWord(row.getString("kind"));
    if (kind.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new Notice(
            row.getLong("id"),
            UUID.fromString(row.getString("uid")),
            new Condition(
                kind.get(),
                row.getString("subject"),
                row.getString("floor"),
                row.getObject("task_id", Long.class),
                row.getString("robot"),
                row.getObject("owner_id", Long.class),
                SentenceJson.read(row.getString("said"), row.getString("text"))),
            DatabaseTypes.instant(row, "begun_at"),
            row.getString("ended_at") == null ? null : DatabaseTypes.instant(row, "ended_at")));
  }

  @Override
  public void add(List<Change> changes, Instant now, Predicate<UUID> isSent) {
    sql.inTransaction(
        h -> {
          for (Change change : changes) {
            Optional<Long> id =
                change.ending() ? end(h, change.notice()) : begin(h, change.notice());
            id.ifPresent(notice -> addDeliveries(h, notice, change.deliveries(), now, isSent));
          }
          return null;
        });
  }

  /** Its id; empty: it is stored already. */
  private static Optional<Long> begin(Handle h, Notice notice) {
    if (idOf(h, notice.uid()).isPresent()) {
      return Optional.empty();
    }
    Condition condition = notice.condition();
    h.createUpdate(
            """
            insert into notices (uid, kind, subject, floor, task_id, robot, owner_id, text, said,
              begun_at)
            values (:uid, :kind, :subject, :floor, :task, :robot, :owner, :text, :said, :begun)
            """)
        .bind("uid", notice.uid())
        .bind("kind", condition.kind().word())
        .bind("subject", condition.subject())
        .bind("floor", condition.floor())
        .bind("task", condition.task())
        .bind("robot", condition.robot())
        .bind("owner", condition.owner())
        .bind("text", condition.english())
        .bind("said", SentenceJson.write(condition.text()))
        .bind("begun", notice.begunAt())
        .execute();
    return idOf(h, notice.uid());
  }

  private static Optional<Long> end(Handle h, Notice notice) {
    boolean isNew =
        h.createUpdate("update notices set ended_at = :ended where uid = :uid and ended_at is null")
                .bind("ended", notice.endedAt())
                .bind("uid", notice.uid())
                .execute()
            == 1;
    return isNew ? idOf(h, notice.uid()) : Optional.empty();
  }

  private static Optional<Long> idOf(Handle h, UUID uid) {
    return h.createQuery("select id from notices where uid = :uid")
        .bind("uid", uid)
        .mapTo(Long.class)
        .findOne();
  }

  /** Those whose receivers are there no more are left out. */
  private static void addDeliveries(
      Handle h, long notice, List<Delivery> deliveries, Instant now, Predicate<UUID> isSent) {
    PreparedBatch batch =
        h.prepareBatch(
            """
            insert into notice_deliveries (uid, notice_id, user_id, webhook_id, ending, state,
              attempts, created_at, next_at, done_at)
            select :uid, :notice, u.id, w.id, :ending, :state, 0, :now, :next, :done
            from (select 1 as one) o left join users u on u.id = :user
              left join webhooks w on w.id = :webhook
            where u.id is not null or w.id is not null
            """);
    for (Delivery delivery : deliveries) {
      boolean sent = isSent.test(delivery.uid());
      batch
          .bind("uid", delivery.uid())
          .bind("notice", notice)
          .bind("user", delivery.receiver() instanceof Receiver.OfPerson(long id) ? id : null)
          .bind("webhook", delivery.receiver() instanceof Receiver.OfWebhook(long id) ? id : null)
          .bind("ending", delivery.ending())
          .bind("state", (sent ? Delivery.State.SENT : Delivery.State.WAITING).name())
          .bind("now", now)
          .bind("next", delivery.notBefore())
          .bind("done", sent ? now : null)
          .add();
    }
    if (batch.size() > 0) {
      batch.execute();
    }
  }

  @Override
  public List<Entry> entries(Filter filter, long before, int limit) {
    return sql.withHandle(
        h -> {
          List<Notice> notices =
              h
                  .createQuery(
                      "select "
                          + COLUMNS
                          + " from notices n where n.id < :before"
                          + (filter.open() ? " and n.ended_at is null" : "")
                          + (filter.unseenBy() == null
                              ? ""
                              : " and not exists (select 1 from notice_seen s"
                                  + " where s.notice_id = n.id and s.user_id = "
                                  + filter.unseenBy()
                                  + ")")
                          + " order by n.id desc limit :limit")
                  .bind("before", before)
                  .bind("limit", limit)
                  .map((row, _) -> notice(row))
                  .stream()
                  .flatMap(Optional::stream)
                  .toList();
          List<Long> ids = notices.stream().map(Notice::id).toList();
          Map<Long, List<Seen>> seen = seen(h, ids);
          Map<Long, List<Outcome>> outcomes = outcomes(h, ids);
          return notices.stream()
              .map(
                  notice ->
                      new Entry(
                          notice,
                          seen.getOrDefault(notice.id(), List.of()),
                          outcomes.getOrDefault(notice.id(), List.of())))
              .toList();
        });
  }

  private static Map<Long, List<Seen>> seen(Handle h, List<Long> notices) {
    if (notices.isEmpty()) {
      return Map.of();
    }
    return h
        .createQuery(
            """
            select notice_id, user_id, user_name, seen_at from notice_seen
            where notice_id in (<ids>) order by seen_at, user_id
            """)
        .bindList("ids", notices)
        .map(
            (row, _) ->
                Map.entry(
                    row.getLong("notice_id"),
                    new Seen(
                        row.getLong("user_id"),
                        row.getString("user_name"),
                        DatabaseTypes.instant(row, "seen_at"))))
        .stream()
        .collect(
            Collectors.groupingBy(
                Map.Entry::getKey,
                Collectors.mapping(Map.Entry::getValue, Collectors.toUnmodifiableList())));
  }

  private static Map<Long, List<Outcome>> outcomes(Handle h, List<Long> notices) {
    if (notices.isEmpty()) {
      return Map.of();
    }
    return h
        .createQuery(DELIVERIES + " where d.notice_id in (<ids>) order by d.id")
        .bindList("ids", notices)
        .map((row, _) -> Map.entry(row.getLong("notice_id"), outcome(row)))
        .stream()
        .collect(
            Collectors.groupingBy(
                Map.Entry::getKey,
                Collectors.mapping(Map.Entry::getValue, Collectors.toUnmodifiableList())));
  }

  private static Outcome outcome(ResultSet row) throws SQLException {
    Receiver receiver = receiver(row);
    return new Outcome(
        receiver,
        row.getString(receiver instanceof Receiver.OfPerson ? "user_name" : "url"),
        row.getBoolean("ending"),
        Delivery.State.valueOf(row.getString("state")),
        row.getInt("attempts"),
        DatabaseTypes.instant(row, "next_at"),
        row.getString("done_at") == null ? null : DatabaseTypes.instant(row, "done_at"),
        row.getString("failure"));
  }

  private static Receiver receiver(ResultSet row) throws SQLException {
    Long user = row.getObject("user_id", Long.class);
    return user == null
        ? new Receiver.OfWebhook(row.getLong("webhook_id"))
        : new Receiver.OfPerson(user);
  }

  @Override
  public int unseen(long account, NoticePreferences preferences, Instant since, int limit) {
    Set<NoticeKind> kinds = preferences.kindsBy(Channel.BADGE);
    if (kinds.isEmpty()) {
      return 0;
    }
    return sql.withHandle(
        h ->
            h.createQuery(
                    """
                    select count(*) from (
                      select n.id from notices n
                      where n.begun_at >= :since and n.kind in (<kinds>)
                        and (not :ownOnly or n.kind not in (<ofTasks>) or n.owner_id = :account)
                        and not exists (select 1 from notice_seen s
                          where s.notice_id = n.id and s.user_id = :account)
                      limit :limit) as unseen
                    """)
                .bind("since", since)
                .bindList("kinds", words(kinds))
                .bindList(
                    "ofTasks", words(NoticeKind.ALL.stream().filter(NoticeKind::isOfTask).toList()))
                .bind("ownOnly", preferences.ownTasksOnly())
                .bind("account", account)
                .bind("limit", limit)
                .mapTo(Integer.class)
                .one());
  }

  private static List<String> words(Collection<NoticeKind> kinds) {
    return kinds.stream().map(NoticeKind::word).sorted().toList();
  }

  @Override
  public List<Notice> newest(Instant since, int limit) {
    return sql.withHandle(
        h ->
            h
                .createQuery(
                    "select "
                        + COLUMNS
                        + " from notices n where n.begun_at >= :since order by n.id desc"
                        + " limit :limit")
                .bind("since", since)
                .bind("limit", limit)
                .map((row, _) -> notice(row))
                .stream()
                .flatMap(Optional::stream)
                .toList());
  }

  @Override
  public boolean markSeen(long id, long account, String name, Instant at) {
    return sql.inTransaction(
        h -> {
          boolean isThere =
              h.createQuery("select count(*) from notices where id = :id")
                      .bind("id", id)
                      .mapTo(Integer.class)
                      .one()
                  > 0;
          insertSeen(h, "n.id = :upTo", id, account, name, at);
          return isThere;
        });
  }

  @Override
  public void markAllSeen(long upTo, long account, String name, Instant at) {
    sql.inTransaction(h -> insertSeen(h, "n.id <= :upTo", upTo, account, name, at));
  }

  /** Two at once of the same person are one. */
  private static int insertSeen(
      Handle h, String which, long upTo, long account, String name, Instant at) {
    return h.createUpdate(
            "insert ignore into notice_seen (notice_id, user_id, user_name, seen_at)"
                + " select n.id, :account, :name, :at from notices n where "
                + which
                + " and not exists (select 1 from notice_seen s"
                + " where s.notice_id = n.id and s.user_id = :account)")
        .bind("upTo", upTo)
        .bind("account", account)
        .bind("name", name)
        .bind("at", at)
        .execute();
  }

  @Override
  public Optional<NoticePreferences> preferences(long account) {
    return sql.withHandle(
        h ->
            h.createQuery(
                    """
                    select user_id, own_tasks, ends, quiet_from, quiet_until, zone, language
                    from notice_preferences where user_id = :account
                    """)
                .bind("account", account)
                .map((row, _) -> preferences(row, choices(h, account)))
                .findOne());
  }

  private static NoticePreferences preferences(
      ResultSet row, Map<NoticeKind, Set<Channel>> channels) throws SQLException {
    ZoneId zone = ZoneId.of(row.getString("zone"));
    Integer from = row.getObject("quiet_from", Integer.class);
    Integer until = row.getObject("quiet_until", Integer.class);
    return new NoticePreferences(
        channels,
        row.getBoolean("own_tasks"),
        row.getBoolean("ends"),
        from == null || until == null ? null : new QuietHours(timeOf(from), timeOf(until), zone),
        zone,
        row.getString("language"));
  }

  private static LocalTime timeOf(int minutes) {
    return LocalTime.MIN.plusMinutes(minutes);
  }

  private static Map<NoticeKind, Set<Channel>> choices(Handle h, long account) {
    Map<NoticeKind, Set<Channel>> found = new EnumMap<>(NoticeKind.class);
    h.createQuery("select kind, channel from notice_choices where user_id = :account")
        .bind("account", account)
        .map(
            (row, _) ->
                Map.entry(
                    NoticeKind.ofWord(row.getString("kind")),
                    Channel.ofWord(row.getString("channel"))))
        .forEach(
            choice ->
                choice
                    .getKey()
                    .ifPresent(
                        kind ->
                            choice
                                .getValue()
                                .ifPresent(
                                    channel ->
                                        found
                                            .computeIfAbsent(
                                                kind, _ -> EnumSet.noneOf(Channel.class))
                                            .add(channel))));
    return found;
  }

  @Override
  public void setPreferences(long account, NoticePreferences preferences) {
    sql.inTransaction(
        h -> {
          h.execute("delete from notice_choices where user_id = ?", account);
          h.execute("delete from notice_preferences where user_id = ?", account);
          QuietHours quiet = preferences.quiet();
          h.createUpdate(
                  """
                  insert into notice_preferences (user_id, own_tasks, ends, quiet_from, quiet_until,
                    zone, language)
                  values (:account, :own, :ends, :from, :until, :zone, :language)
                  """)
              .bind("account", account)
              .bind("own", preferences.ownTasksOnly())
              .bind("ends", preferences.ends())
              .bind("from", quiet == null ? null : minutes(quiet.from()))
              .bind("until", quiet == null ? null : minutes(quiet.until()))
              .bind("zone", preferences.zone().getId())
              .bind("language", preferences.language())
              .execute();
          PreparedBatch batch =
              h.prepareBatch(
                  "insert into notice_choices (user_id, kind, channel)"
                      + " values (:account, :kind, :channel)");
          preferences
              .channels()
              .forEach(
                  (kind, channels) ->
                      channels.forEach(
                          channel ->
                              batch
                                  .bind("account", account)
                                  .bind("kind", kind.word())
                                  .bind("channel", channel.word())
                                  .add()));
          if (batch.size() > 0) {
            batch.execute();
          }
          return null;
        });
  }

  private static int minutes(LocalTime time) {
    return time.toSecondOfDay() / 60;
  }

  @Override
  public List<Person> people() {
    return sql.withHandle(h -> h.createQuery(PERSON).map((row, _) -> person(h, row)).list());
  }

  @Override
  public Optional<Person> person(long account) {
    return sql.withHandle(
        h ->
            h.createQuery(PERSON + " and u.id = :account")
                .bind("account", account)
                .map((row, _) -> person(h, row))
                .findOne());
  }

  private static Person person(Handle h, ResultSet row) throws SQLException {
    long account = row.getLong("user_id");
    return new Person(account, row.getString("email"), preferences(row, choices(h, account)));
  }

  @Override
  public List<Webhook> webhooks() {
    return sql.withHandle(
        h ->
            h.createQuery(
                    "select id, url, secret, kinds, enabled, created_at, created_by from webhooks"
                        + " order by id")
                .map((row, _) -> webhook(row))
                .list());
  }

  private static Webhook webhook(ResultSet row) throws SQLException {
    return new Webhook(
        row.getLong("id"),
        URI.create(row.getString("url")),
        new WebhookSecret(row.getString("secret")),
        Arrays.stream(row.getString("kinds").split(BETWEEN, -1))
            .flatMap(word -> NoticeKind.ofWord(word).stream())
            .collect(Collectors.toUnmodifiableSet()),
        row.getBoolean("enabled"),
        DatabaseTypes.instant(row, "created_at"),
        row.getString("created_by"));
  }

  @Override
  public Map<Long, Outcome> lastOutcomes() {
    return sql.withHandle(
        h -> {
          Map<Long, Outcome> last = new HashMap<>();
          h.createQuery(
                  DELIVERIES
                      + """
                         where d.id in (select max(id) from notice_deliveries
                          where webhook_id is not null and (attempts > 0 or state <> 'WAITING')
                          group by webhook_id)
                        """)
              .map((row, _) -> Map.entry(row.getLong("webhook_id"), outcome(row)))
              .forEach(entry -> last.put(entry.getKey(), entry.getValue()));
          return last;
        });
  }

  @Override
  public Webhook addWebhook(
      URI url, WebhookSecret secret, Set<NoticeKind> kinds, Instant now, String by) {
    return sql.inTransaction(
        h -> {
          long id =
              h.createUpdate(
                      """
                      insert into webhooks (url, secret, kinds, enabled, created_at, created_by)
                      values (:url, :secret, :kinds, true, :now, :by)
                      """)
                  .bind("url", url.toString())
                  .bind("secret", secret.text())
                  .bind("kinds", String.join(BETWEEN, words(kinds)))
                  .bind("now", now)
                  .bind("by", by)
                  .executeAndReturnGeneratedKeys("id")
                  .mapTo(Long.class)
                  .one();
          addEvent(h, now, EventKind.NOTICE_WEBHOOK_ADDED, Phrase.WEBHOOK_ADDED, id, url, by);
          return new Webhook(id, url, secret, kinds, true, now, by);
        });
  }

  @Override
  public boolean changeWebhook(
      long id, URI url, Set<NoticeKind> kinds, boolean enabled, Instant now, String by) {
    return sql.inTransaction(
        h -> {
          boolean done =
              h.createUpdate(
                          """
                          update webhooks set url = :url, kinds = :kinds, enabled = :enabled
                          where id = :id
                          """)
                      .bind("id", id)
                      .bind("url", url.toString())
                      .bind("kinds", String.join(BETWEEN, words(kinds)))
                      .bind("enabled", enabled)
                      .execute()
                  == 1;
          if (done) {
            addEvent(h, now, EventKind.NOTICE_WEBHOOK_CHANGED, Phrase.WEBHOOK_CHANGED, id, url, by);
          }
          return done;
        });
  }

  @Override
  public boolean setSecret(long id, WebhookSecret secret, Instant now, String by) {
    return sql.inTransaction(
        h -> {
          Optional<URI> url = webhookUrl(h, id);
          h.createUpdate("update webhooks set secret = :secret where id = :id")
              .bind("id", id)
              .bind("secret", secret.text())
              .execute();
          EventKind kind = EventKind.NOTICE_WEBHOOK_SECRET;
          url.ifPresent(to -> addEvent(h, now, kind, Phrase.WEBHOOK_SECRET_RENEWED, id, to, by));
          return url.isPresent();
        });
  }

  @Override
  public boolean deleteWebhook(long id, Instant now, String by) {
    return sql.inTransaction(
        h -> {
          Optional<URI> url = webhookUrl(h, id);
          h.createUpdate("delete from webhooks where id = :id").bind("id", id).execute();
          EventKind kind = EventKind.NOTICE_WEBHOOK_DELETED;
          url.ifPresent(to -> addEvent(h, now, kind, Phrase.WEBHOOK_DELETED, id, to, by));
          return url.isPresent();
        });
  }

  private static Optional<URI> webhookUrl(Handle h, long id) {
    return h.createQuery("select url from webhooks where id = :id")
        .bind("id", id)
        .mapTo(String.class)
        .findOne()
        .map(URI::create);
  }

  /** The host alone is told: what follows it may be secret. */
  private static void addEvent(
      Handle h, Instant at, EventKind kind, Phrase phrase, long id, URI url, String by) {
    EventTable.addAccountEvent(h, at, kind, by, phrase.with(by, id, String.valueOf(url.getHost())));
  }

  @Override
  public Optional<Due> firstLetter(Instant now) {
    return first("d.user_id is not null", "p.user_id = d.user_id", 0, now);
  }

  @Override
  public Optional<Due> first(Webhook webhook, Instant now) {
    return first("d.webhook_id = :webhook", "p.webhook_id = d.webhook_id", webhook.id(), now);
  }

  private Optional<Due> first(String which, String same, long webhook, Instant now) {
    String query =
        DUE
            + " and d.next_at <= :now and "
            + which
            + " and not exists (select 1 from notice_deliveries p where p.notice_id = d.notice_id"
            + " and p.id < d.id and p.state = 'WAITING' and "
            + same
            + ") order by d.next_at, d.id limit 1";
    return sql.withHandle(
        h ->
            h.createQuery(query)
                .bind("now", now)
                .bindMap(Map.of("webhook", webhook))
                .map((row, _) -> due(row))
                .findOne()
                .flatMap(due -> due));
  }

  @Override
  public List<Due> putOff(Instant now, Instant latest) {
    String query =
        DUE
            + " and (d.created_at > :now or d.attempts > 0 and d.next_at > :latest)"
            + " order by d.id";
    return sql.withHandle(
        h ->
            h
                .createQuery(query)
                .bind("now", now)
                .bind("latest", latest)
                .map((row, _) -> due(row))
                .stream()
                .flatMap(Optional::stream)
                .toList());
  }

  @Override
  public void bringForward(Due due, Instant createdAt, Instant next) {
    sql.withHandle(
        h ->
            h.createUpdate(
                    """
                    update notice_deliveries set created_at = :created, next_at = :next
                    where id = :id and state = 'WAITING'
                    """)
                .bind("created", createdAt)
                .bind("next", next)
                .bind("id", due.id())
                .execute());
  }

  private static Optional<Due> due(ResultSet row) throws SQLException {
    Optional<Notice> notice = notice(row);
    if (notice.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new Due(
            row.getLong("delivery_id"),
            new Delivery(
                UUID.fromString(row.getString("delivery_uid")),
                receiver(row),
                row.getBoolean("ending"),
                DatabaseTypes.instant(row, "next_at")),
            notice.get(),
            row.getInt("attempts"),
            DatabaseTypes.instant(row, "created_at")));
  }

  @Override
  public void setSent(Due due, Instant at) {
    sql.inTransaction(
        h -> {
          h.createUpdate(
                  "update notice_deliveries set state = 'SENT', done_at = :at, failure = null"
                      + " where id = :id")
              .bind("at", at)
              .bind("id", due.id())
              .execute();
          if (!due.notice().isOpen()
              && !due.delivery().ending()
              && due.delivery().receiver() instanceof Receiver.OfPerson(long account)) {
            h.createUpdate(
                    """
                    update notice_deliveries set state = 'SENT', done_at = :at
                    where notice_id = :notice and user_id = :account and ending
                      and state = 'WAITING'
                    """)
                .bind("at", at)
                .bind("notice", due.notice().id())
                .bind("account", account)
                .execute();
          }
          return null;
        });
  }

  @Override
  public void setFailed(Due due, String failure, Instant next) {
    sql.withHandle(
        h ->
            h.createUpdate(
                    """
                    update notice_deliveries set attempts = attempts + 1, failure = :failure,
                      next_at = :next
                    where id = :id
                    """)
                .bind("failure", failure)
                .bind("next", next)
                .bind("id", due.id())
                .execute());
  }

  @Override
  public void giveUp(Due due, String failure, Instant at) {
    sql.withHandle(
        h ->
            h.createUpdate(
                    """
                    update notice_deliveries set state = 'GIVEN_UP', attempts = attempts + 1,
                      failure = :failure, done_at = :at
                    where id = :id
                    """)
                .bind("failure", failure)
                .bind("at", at)
                .bind("id", due.id())
                .execute());
  }
}
