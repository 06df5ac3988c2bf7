package org.toqa.notices;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.icegreen.greenmail.util.GreenMail;
import com.icegreen.greenmail.util.ServerSetup;
import com.sun.net.httpserver.HttpServer;
import jakarta.mail.internet.MimeMessage;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalTime;
import java.time.ZoneOffset;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.toqa.accounts.AccountStore;
import org.toqa.accounts.Role;
import org.toqa.app.server.MailToTest;
import org.toqa.notices.Delivery.Outcome;
import org.toqa.notices.Delivery.State;
import org.toqa.notices.NoticeStore.Filter;
import org.toqa.store.Database;
import org.toqa.store.JdbiAccountStore;
import org.toqa.store.JdbiNoticeStore;
import org.toqa.store.LastKnownUsers;
import org.toqa.store.MemoryDatabase;
import org.toqa.web.MailSender;
import org.toqa.web.NoticeLetters;
import org.toqa.wording.Phrase;

/** What is stored to be told arrives at a real mail server and a real receiver of HTTP. */
class OutboxTest {
  private static final Instant START = Instant.parse("2026-11-27T08:00:00Z");
  private static final Duration LOOK = Duration.ofMillis(5);
  private static final Duration LIMIT = Duration.ofSeconds(20);

  private final Database database = MemoryDatabase.open("outbox-" + System.nanoTime());
  private final JdbiNoticeStore store = new JdbiNoticeStore(database.jdbi());
  private volatile Instant now = START;
  private final GreenMail mail =
      new GreenMail(new ServerSetup(0, "127.0.0.1", ServerSetup.PROTOCOL_SMTP));
  private final List<Request> requests = new CopyOnWriteArrayList<>();

  /** With what the receiver answers, the first one first; then with 204. */
  private final List<Integer> answers = new CopyOnWriteArrayList<>();

  private HttpServer receiver;
  private long clara;

  private record Request(String id, String stamp, String signature, String body) {}

  @BeforeEach
  void start() throws IOException {
    mail.start();
    receiver = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    receiver.createContext(
        "/hook",
        exchange -> {
          requests.add(
              new Request(
                  exchange.getRequestHeaders().getFirst("webhook-id"),
                  exchange.getRequestHeaders().getFirst("webhook-timestamp"),
                  exchange.getRequestHeaders().getFirst("webhook-signature"),
                  new String(exchange.getRequestBody().readAllBytes(), StandardCharsets.UTF_8)));
          int answer = answers.isEmpty() ? 204 : answers.removeFirst();
          if (answer == 302) {
            exchange.getResponseHeaders().set("Location", url("/elsewhere").toString());
          }
          exchange.sendResponseHeaders(answer, -1);
          exchange.close();
        });
    receiver.createContext(
        "/elsewhere",
        exchange -> {
          requests.add(new Request("elsewhere", "", "", ""));
          exchange.sendResponseHeaders(204, -1);
          exchange.close();
        });
    receiver.start();
    AccountStore accounts = new JdbiAccountStore(database.jdbi(), this::now, new LastKnownUsers());
    clara =
        accounts.add("Clara", "clara@example.org", "none", Role.CLERK, "toqa").orElseThrow().id();
  }

  @AfterEach
  void stop() {
    receiver.stop(0);
    mail.stop();
    database.close();
  }

  private Instant now() {
    return now;
  }

  private URI url(String path) {
    return URI.create("http://127.0.0.1:" + receiver.getAddress().getPort() + path);
  }

  private static WebhookAddresses loopback() {
    return new WebhookAddresses(List.of(WebhookAddresses.Network.parse("127.0.0.1").orElseThrow()));
  }

  private Outbox outbox(WebhookAddresses addresses) {
    return outbox(store, MailToTest.at(mail.getSmtp().getPort()), addresses);
  }

  private Outbox outbox(NoticeStore over, @Nullable MailSender sender, WebhookAddresses addresses) {
    return new Outbox(
        over,
        sender == null ? null : new NoticeLetters(sender),
        new WebhookPoster("main", addresses, this::now),
        this::now,
        LOOK);
  }

  private Webhook addWebhook(URI url) {
    return store.addWebhook(url, WebhookSecret.random(), NoticeKind.ALL, START, "Max");
  }

  private void wantLetters(String language) {
    wantLetters(language, null);
  }

  private void wantLetters(String language, @Nullable QuietHours quiet) {
    store.setPreferences(
        clara,
        new NoticePreferences(
            Map.of(NoticeKind.ROBOT_LOST, EnumSet.of(Channel.EMAIL)),
            false,
            true,
            quiet,
            ZoneOffset.UTC,
            language));
  }

  private static Notice lost() {
    return new Notice(
        0,
        UUID.randomUUID(),
        new Condition(
            NoticeKind.ROBOT_LOST,
            "r1",
            "hall",
            null,
            "r1",
            null,
            Phrase.NOTICE_OF_ROBOT.with("r1", Phrase.NOTICE_ROBOT_LOST.with())),
        START,
        null);
  }

  private void accept(Notice notice, boolean ending) {
    DeliveryPlan plan = new DeliveryPlan(store.people(), store.webhooks());
    store.add(List.of(plan.change(notice, ending, now)), now, _ -> false);
  }

  private List<Outcome> outcomes() {
    return store.entries(new Filter(false, null), Long.MAX_VALUE, 10).stream()
        .flatMap(entry -> entry.deliveries().stream())
        .toList();
  }

  private static void await(BooleanSupplier condition) throws InterruptedException {
    long end = System.nanoTime() + LIMIT.toNanos();
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, "it takes too long");
      Thread.sleep(2);
    }
  }

  private void awaitStates(State... states) throws InterruptedException {
    await(() -> outcomes().stream().map(Outcome::state).toList().equals(List.of(states)));
  }

  @Test
  void aLetterArrivesInTheLanguageOfWhoGetsIt() throws Exception {
    wantLetters("ar");
    Notice notice = lost();
    accept(notice, false);
    try (Outbox _ = outbox(loopback())) {
      awaitStates(State.SENT);
    }

    MimeMessage letter = mail.getReceivedMessages()[0];
    assertEquals("clara@example.org", letter.getAllRecipients()[0].toString());
    assertTrue(letter.getSubject().contains("روبوت مفقود"), letter.getSubject());
    assertTrue(letter.getContent().toString().contains("https://toqa.example.org/notices"));
    assertTrue(letter.getMessageID().endsWith("@example.org>"), letter.getMessageID());
  }

  @Test
  void whatBeganAndEndedBeforeItsLetterIsOneLetter() throws Exception {
    wantLetters("en");
    Notice notice = lost();
    accept(notice, false);
    accept(notice.ended(START.plusSeconds(60)), true);
    try (Outbox _ = outbox(loopback())) {
      awaitStates(State.SENT, State.SENT);
    }

    assertEquals(1, mail.getReceivedMessages().length);
    assertEquals("Toqa: Robot lost (ended)", mail.getReceivedMessages()[0].getSubject());
    assertTrue(mail.getReceivedMessages()[0].getContent().toString().contains("8:01:00"));
  }

  @Test
  void aReceiverThatFailsFirstGetsItLaterWithTheSameIdAndAGoodSignature() throws Exception {
    Webhook webhook = addWebhook(url("/hook"));
    answers.addAll(List.of(500, 404));
    Notice notice = lost();
    accept(notice, false);
    try (Outbox _ = outbox(loopback())) {
      await(() -> outcomes().getFirst().attempts() == 1);
      assertTrue(
          String.valueOf(outcomes().getFirst().failure())
              .contains("answered with the status 500;"));
      assertEquals(START.plusSeconds(5), outcomes().getFirst().nextAt());
      now = START.plusSeconds(5);
      await(() -> outcomes().getFirst().attempts() == 2);
      now = START.plusSeconds(25);
      awaitStates(State.SENT);
    }

    assertEquals(3, requests.size());
    assertEquals(1, requests.stream().map(Request::id).distinct().count());
    assertEquals(1, requests.stream().map(Request::body).distinct().count());
    for (Request request : requests) {
      assertEquals(
          webhook.secret().signature(request.id(), Long.parseLong(request.stamp()), request.body()),
          request.signature());
    }
    assertEquals(
        List.of(0L, 5L, 25L),
        requests.stream().map(r -> Long.parseLong(r.stamp()) - START.getEpochSecond()).toList());
    assertTrue(requests.getFirst().body().contains(notice.uid().toString()));
  }

  @Test
  void theEndComesAfterTheBeginAlsoWhereThatFailedFirst() throws Exception {
    addWebhook(url("/hook"));
    answers.add(503);
    Notice notice = lost();
    accept(notice, false);
    accept(notice.ended(START.plusSeconds(1)), true);
    try (Outbox _ = outbox(loopback())) {
      await(() -> outcomes().getFirst().attempts() == 1);
      now = START.plusSeconds(5);
      awaitStates(State.SENT, State.SENT);
    }

    assertEquals(
        List.of("notice.begun", "notice.begun", "notice.ended"),
        requests.stream()
            .map(r -> r.body().replaceAll(".*\"type\":\"([^\"]*)\".*", "$1"))
            .toList());
    assertNotEquals(requests.get(1).id(), requests.get(2).id());
  }

  @Test
  void afterADayItIsGivenUpAndToldSo() throws Exception {
    addWebhook(url("/hook"));
    accept(lost(), false);
    answers.add(500);
    now = START.plus(Duration.ofHours(24));
    try (Outbox _ = outbox(loopback())) {
      awaitStates(State.GIVEN_UP);
    }

    assertTrue(
        String.valueOf(outcomes().getFirst().failure()).contains("answered with the status 500;"));
    assertEquals(State.GIVEN_UP, store.lastOutcomes().values().iterator().next().state());
  }

  @Test
  void whatAClockThatWasAheadHasPutOffIsToldWhenItIsSetBack() throws Exception {
    addWebhook(url("/hook"));
    answers.addAll(List.of(500, 500, 500));
    now = START.plus(Duration.ofDays(1000));
    accept(lost(), false);
    try (Outbox _ = outbox(loopback())) {
      await(() -> outcomes().getFirst().attempts() == 1);
      now = START;
      await(() -> outcomes().getFirst().attempts() == 2);
      assertEquals(START.plusSeconds(20), outcomes().getFirst().nextAt());
    }
    now = START.minus(Duration.ofDays(1)); // while no server runs
    try (Outbox _ = outbox(loopback())) {
      await(() -> outcomes().getFirst().attempts() == 3);
      now = START;
      awaitStates(State.SENT);
    }
  }

  @Test
  void aLetterThatAClockAheadHasPutOffWaitsForTheEndOfQuietHoursOnly() throws Exception {
    wantLetters("en", new QuietHours(LocalTime.of(22, 0), LocalTime.of(9, 0), ZoneOffset.UTC));
    now = START.plus(Duration.ofDays(1000));
    accept(lost(), false);
    now = START;
    try (Outbox _ = outbox(loopback())) {
      await(() -> outcomes().getFirst().nextAt().equals(START.plus(Duration.ofHours(1))));
      now = START.plus(Duration.ofHours(1));
      awaitStates(State.SENT);
    }
  }

  @Test
  void aRedirectIsNotFollowed() throws Exception {
    addWebhook(url("/hook"));
    answers.add(302);
    accept(lost(), false);
    try (Outbox _ = outbox(loopback())) {
      await(() -> outcomes().getFirst().attempts() == 1);
    }

    assertTrue(
        String.valueOf(outcomes().getFirst().failure())
            .startsWith("127.0.0.1 answered with the status 302;"),
        outcomes()::toString);
    assertFalse(requests.stream().anyMatch(request -> request.id().equals("elsewhere")));
  }

  @Test
  void loopbackIsReachedOnlyWhereTheConfigurationNamesIt() throws Exception {
    URI encrypted = URI.create(url("/hook").toString().replace("http:", "https:"));
    addWebhook(url("/hook"));
    addWebhook(encrypted);
    addWebhook(URI.create(encrypted.toString().replace("127.0.0.1", "localhost")));
    accept(lost(), false);
    try (Outbox _ = outbox(new WebhookAddresses(List.of()))) {
      await(() -> outcomes().stream().allMatch(outcome -> outcome.attempts() == 1));
    }

    for (Outcome outcome : outcomes()) {
      assertTrue(
          String.valueOf(outcome.failure()).contains("webhooks.networks"), outcome::toString);
    }
    assertEquals(List.of(), requests);
  }

  @Test
  void aDeadMailServerDelaysNoWebhook() throws Exception {
    wantLetters("en");
    addWebhook(url("/hook"));
    ServerSocket silent = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
    accept(lost(), false);
    try (Outbox _ = outbox(store, MailToTest.at(silent.getLocalPort()), loopback());
        Socket _ = silent.accept()) { // the letter is on its way, and nobody says a word
      awaitStates(State.WAITING, State.SENT);
      assertEquals(1, requests.size());
    } finally {
      silent.close();
    }
  }

  @Test
  void whoHasNoAddressAnyMoreIsGivenUp() throws Exception {
    wantLetters("en");
    accept(lost(), false);
    new JdbiAccountStore(database.jdbi(), this::now, new LastKnownUsers())
        .changeEmail(clara, null, null, "Max");
    try (Outbox _ = outbox(loopback())) {
      awaitStates(State.GIVEN_UP);
    }
    assertEquals(0, mail.getReceivedMessages().length);
  }

  @Test
  void withoutAMailServerLettersAreGivenUp() throws Exception {
    wantLetters("en");
    accept(lost(), false);
    try (Outbox _ = outbox(store, null, loopback())) {
      awaitStates(State.GIVEN_UP);
    }
    assertEquals("No mail server is configured.", outcomes().getFirst().failure());
  }

  @Test
  void aWebhookThatIsDisabledWaits() throws Exception {
    Webhook off = addWebhook(url("/hook"));
    Webhook on = addWebhook(url("/hook"));
    accept(lost(), false);
    store.changeWebhook(off.id(), off.url(), Set.of(NoticeKind.ROBOT_LOST), false, START, "Max");
    try (Outbox _ = outbox(loopback())) {
      await(() -> requests.size() == 1);
      assertEquals(
          on.secret()
              .signature(
                  requests.getFirst().id(),
                  Long.parseLong(requests.getFirst().stamp()),
                  requests.getFirst().body()),
          requests.getFirst().signature());
      store.changeWebhook(off.id(), off.url(), Set.of(NoticeKind.ROBOT_LOST), true, START, "Max");
      await(() -> requests.size() == 2);
    }
  }
}
