package org.toqa.store;

import static java.util.Objects.requireNonNull;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URI;
import java.time.Instant;
import java.time.LocalTime;
import java.time.ZoneId;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.toqa.accounts.AccountStore;
import org.toqa.accounts.Role;
import org.toqa.fleet.history.EventArchive;
import org.toqa.notices.Channel;
import org.toqa.notices.Condition;
import org.toqa.notices.Delivery;
import org.toqa.notices.Delivery.Receiver;
import org.toqa.notices.Delivery.State;
import org.toqa.notices.Notice;
import org.toqa.notices.NoticeKind;
import org.toqa.notices.NoticePreferences;
import org.toqa.notices.NoticeStore.Change;
import org.toqa.notices.NoticeStore.Entry;
import org.toqa.notices.NoticeStore.Filter;
import org.toqa.notices.NoticeStore.Seen;
import org.toqa.notices.QuietHours;
import org.toqa.notices.Webhook;
import org.toqa.notices.WebhookSecret;
import org.toqa.wording.Phrase;

/** What every database must do for notices; here H2, in {@code MySqlNoticeStoreTest} MySQL. */
class NoticeStoreTest extends DatabaseTest {
  private static final Instant AT = Instant.parse("2026-11-27T10:00:00.123Z");
  private static final Filter ALL = new Filter(false, null);

  private JdbiNoticeStore store;
  private AccountStore accounts;
  private long clara;

  @BeforeEach
  void openStore() {
    store = new JdbiNoticeStore(database.jdbi());
    accounts = new JdbiAccountStore(database.jdbi(), () -> AT, new LastKnownUsers());
    clara =
        accounts.add("Clara", "clara@example.org", "none", Role.CLERK, "toqa").orElseThrow().id();
  }

  private static Notice notice(NoticeKind kind, String subject, @Nullable Long owner) {
    return new Notice(
        0,
        UUID.randomUUID(),
        new Condition(
            kind,
            subject,
            "Halle für Zoë",
            owner == null ? null : 7L,
            "r1",
            owner,
            Phrase.NOTICE_OF_ROBOT.with("r1", Phrase.NOTICE_ROBOT_LOST.with())),
        AT,
        null);
  }

  private void begin(Notice notice, Delivery... deliveries) {
    store.add(List.of(new Change(notice, false, List.of(deliveries))), AT, _ -> false);
  }

  private List<Entry> entries(Filter filter) {
    return store.entries(filter, Long.MAX_VALUE, 100);
  }

  private Delivery toClara(boolean ending) {
    return new Delivery(UUID.randomUUID(), new Receiver.OfPerson(clara), ending, AT);
  }

  @Test
  void aNoticeComesBackWithEveryFieldAndItsEnd() {
    Notice begun = notice(NoticeKind.ROBOT_LOST, "r1", clara);
    begin(begun);
    Notice open = store.open().getFirst();
    assertEquals(begun.uid(), open.uid());
    assertEquals(begun.condition(), open.condition());
    assertEquals(AT, open.begunAt());
    assertTrue(open.isOpen());

    Notice ended = new Notice(open.id(), open.uid(), open.condition(), AT, AT.plusMillis(90_001));
    store.add(List.of(new Change(ended, true, List.of())), AT, _ -> false);
    assertEquals(List.of(), store.open());
    assertEquals(ended, entries(ALL).getFirst().notice());
  }

  @Test
  void whatIsStoredTwiceIsThereOnce() {
    Notice begun = notice(NoticeKind.ROBOT_LOST, "r1", null);
    Delivery letter = toClara(false);
    begin(begun, letter);
    begin(begun, letter);
    Notice ended = new Notice(0, begun.uid(), begun.condition(), AT, AT.plusSeconds(1));
    Change end = new Change(ended, true, List.of(toClara(true)));
    store.add(List.of(end), AT, _ -> false);
    store.add(List.of(end), AT, _ -> false);

    assertEquals(1, entries(ALL).size());
    assertEquals(
        List.of(false, true),
        entries(ALL).getFirst().deliveries().stream().map(Delivery.Outcome::ending).toList());
  }

  @Test
  void whatWasToldDirectlyIsSent() {
    Delivery told = toClara(false);
    Delivery untold = toClara(false);
    store.add(
        List.of(new Change(notice(NoticeKind.SERVER, "x", null), false, List.of(told, untold))),
        AT,
        told.uid()::equals);

    assertEquals(
        List.of(State.SENT, State.WAITING),
        entries(ALL).getFirst().deliveries().stream().map(Delivery.Outcome::state).toList());
    assertEquals(untold.uid(), store.firstLetter(AT).orElseThrow().delivery().uid());
  }

  @Test
  void whatAClockThatWasAheadHasPutOffIsFoundAndBroughtForward() {
    begin(notice(NoticeKind.ROBOT_LOST, "r1", null), toClara(false));
    Delivery.Due due = store.firstLetter(AT).orElseThrow();
    Instant late = AT.plusSeconds(7200);
    assertEquals(List.of(), store.putOff(AT, AT));
    assertEquals(1, store.putOff(AT.minusMillis(1), late).size(), "accepted later");

    store.setFailed(due, "nobody answers", late);
    assertEquals(List.of(), store.putOff(AT, late));
    assertEquals(1, store.putOff(AT, late.minusMillis(1)).size(), "tried later");

    Instant before = AT.minusSeconds(60);
    store.bringForward(due, before, before);
    Delivery.Due again = store.firstLetter(before).orElseThrow();
    assertEquals(before, again.createdAt());
    assertEquals(1, again.attempts());
  }

  @Test
  void seenIsByWhomAndWhenAndOnce() {
    begin(notice(NoticeKind.ROBOT_LOST, "r1", null));
    begin(notice(NoticeKind.ROBOT_LOST, "r2", null));
    begin(notice(NoticeKind.ROBOT_LOST, "r3", null));
    List<Long> ids = entries(ALL).stream().map(entry -> entry.notice().id()).toList();

    assertTrue(store.markSeen(ids.get(2), clara, "Clara", AT));
    assertTrue(store.markSeen(ids.get(2), clara, "Clara", AT.plusSeconds(9)));
    assertFalse(store.markSeen(999_999, clara, "Clara", AT));
    assertEquals(List.of(new Seen(clara, "Clara", AT)), entries(ALL).getLast().seen());
    assertEquals(
        ids.subList(0, 2),
        entries(new Filter(false, clara)).stream().map(entry -> entry.notice().id()).toList());

    store.markAllSeen(ids.get(1), clara, "Clara", AT.plusSeconds(5));
    assertEquals(
        List.of(ids.getFirst()),
        entries(new Filter(false, clara)).stream().map(entry -> entry.notice().id()).toList());
    accounts.delete(clara, "Max");
    assertEquals(List.of(new Seen(clara, "Clara", AT)), entries(ALL).getLast().seen());
  }

  @Test
  void unseenAreCountedAsTheirReaderWantsThem() {
    begin(notice(NoticeKind.ROBOT_LOST, "r1", null));
    begin(notice(NoticeKind.TASK_QUESTION, "7", clara));
    begin(notice(NoticeKind.TASK_QUESTION, "8", clara + 1));
    begin(notice(NoticeKind.SERVER, "x", null));
    NoticePreferences usual = NoticePreferences.initial(ZoneId.of("UTC"), "en");

    assertEquals(4, store.unseen(clara, usual, AT, 100));
    assertEquals(3, store.unseen(clara, usual, AT, 3));
    assertEquals(0, store.unseen(clara, usual, AT.plusMillis(1), 100));
    assertEquals(
        3,
        store.unseen(
            clara,
            new NoticePreferences(usual.channels(), true, false, null, usual.zone(), "en"),
            AT,
            100));
    assertEquals(
        1,
        store.unseen(
            clara,
            new NoticePreferences(
                Map.of(
                    NoticeKind.SERVER, EnumSet.of(Channel.BADGE),
                    NoticeKind.ROBOT_LOST, EnumSet.of(Channel.EMAIL)),
                false,
                false,
                null,
                usual.zone(),
                "en"),
            AT,
            100));
    store.markAllSeen(Long.MAX_VALUE, clara, "Clara", AT);
    assertEquals(0, store.unseen(clara, usual, AT, 100));
  }

  @Test
  void preferencesComeBackWithEveryField() {
    ZoneId zone = ZoneId.of("America/Argentina/Buenos_Aires");
    NoticePreferences all =
        new NoticePreferences(
            Map.of(
                NoticeKind.ROBOT_LOST, EnumSet.allOf(Channel.class),
                NoticeKind.SERVER, EnumSet.of(Channel.EMAIL)),
            true,
            true,
            new QuietHours(LocalTime.of(22, 15), LocalTime.of(6, 30), zone),
            zone,
            "ar");
    assertEquals(Optional.empty(), store.preferences(clara));
    store.setPreferences(clara, NoticePreferences.initial(zone, "en"));
    store.setPreferences(clara, all);

    assertEquals(Optional.of(all), store.preferences(clara));
    assertEquals("clara@example.org", store.people().getFirst().email());
    assertEquals(all, store.person(clara).orElseThrow().preferences());
    accounts.update(clara, Role.CLERK, true, "Max");
    assertEquals(List.of(), store.people());
  }

  @Test
  void webhooksComeBackAndGoWithWhatWasToBeTold() {
    URI url = URI.create("https://example.org/hook?a=b");
    WebhookSecret secret = WebhookSecret.random();
    Webhook added = store.addWebhook(url, secret, NoticeKind.ALL, AT, "Max");
    assertEquals(List.of(added), store.webhooks());
    begin(
        notice(NoticeKind.SERVER, "x", null),
        new Delivery(UUID.randomUUID(), new Receiver.OfWebhook(added.id()), false, AT));
    assertTrue(store.first(added, AT).isPresent());
    assertEquals(Optional.empty(), store.first(added, AT.minusMillis(1)));
    assertEquals(Map.of(), store.lastOutcomes());
    store.setFailed(store.first(added, AT).orElseThrow(), "no", AT.plusSeconds(5));
    assertEquals("no", requireNonNull(store.lastOutcomes().get(added.id())).failure());

    URI other = URI.create("https://example.org/other");
    assertTrue(store.changeWebhook(added.id(), other, Set.of(NoticeKind.SERVER), false, AT, "Mia"));
    WebhookSecret renewed = WebhookSecret.random();
    assertTrue(store.setSecret(added.id(), renewed, AT, "Mia"));
    assertEquals(
        List.of(
            new Webhook(added.id(), other, renewed, Set.of(NoticeKind.SERVER), false, AT, "Max")),
        store.webhooks());

    assertTrue(store.deleteWebhook(added.id(), AT, "Mia"));
    assertFalse(store.deleteWebhook(added.id(), AT, "Mia"));
    assertFalse(store.changeWebhook(added.id(), url, NoticeKind.ALL, true, AT, "Mia"));
    assertFalse(store.setSecret(added.id(), secret, AT, "Mia"));
    assertEquals(
        List.of(
            "Mia removed webhook %d to example.org",
            "Mia renewed the secret of webhook %d to example.org",
            "Mia changed webhook %d to example.org",
            "Max added webhook %d to example.org"),
        history(true).stream().map(text -> text.replace(" " + added.id() + " ", " %d ")).toList());
    assertEquals(List.of(), history(false), "only managers may know");
    assertEquals(List.of(), entries(ALL).getFirst().deliveries());
  }

  private List<String> history(boolean isManager) {
    EventArchive.Filter filter =
        new EventArchive.Filter(null, null, null, "notice", null, null, isManager);
    return new JdbiEventArchive(database.jdbi())
        .events(filter, Long.MAX_VALUE, 10).stream().map(entry -> entry.event().text()).toList();
  }

  @Test
  void endedNoticesGoWithTheHistory() {
    Notice old = notice(NoticeKind.ROBOT_LOST, "r1", null);
    begin(old, toClara(false));
    begin(notice(NoticeKind.ROBOT_LOST, "r2", null));
    store.add(
        List.of(new Change(new Notice(0, old.uid(), old.condition(), AT, AT), true, List.of())),
        AT,
        _ -> false);
    store.markAllSeen(Long.MAX_VALUE, clara, "Clara", AT);

    new HistoryPruner(database.jdbi()).pruneHistory(AT.plusSeconds(1));
    assertEquals(
        List.of("r2"),
        entries(ALL).stream().map(entry -> entry.notice().condition().subject()).toList());
  }
}
