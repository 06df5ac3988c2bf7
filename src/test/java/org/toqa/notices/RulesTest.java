package org.toqa.notices;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.NoRouteToHostException;
import java.net.SocketException;
import java.net.SocketTimeoutException;
import java.net.URI;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalTime;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.notices.Delivery.Receiver;
import org.toqa.outbound.OutboundHttp;
import org.toqa.wording.Sentence;

/** The rules of who is told what and when, and how it is signed. */
class RulesTest {
  private static final ZoneId BERLIN = ZoneId.of("Europe/Berlin");
  private static final Instant NOON = Instant.parse("2026-11-27T11:00:00Z"); // 12:00 in Berlin

  private static QuietHours quiet(String from, String until) {
    return new QuietHours(LocalTime.parse(from), LocalTime.parse(until), BERLIN);
  }

  private static Notice notice(NoticeKind kind, @Nullable Long owner) {
    return new Notice(
        1,
        new UUID(0, 5),
        new Condition(kind, "x", "hall", 7L, null, owner, Sentence.verbatim("said")),
        NOON,
        null);
  }

  private static NoticePreferences preferences(
      Channel channel, boolean ownTasksOnly, boolean ends, @Nullable QuietHours quiet) {
    return new NoticePreferences(
        Map.of(
            NoticeKind.ROBOT_LOST, EnumSet.of(channel),
            NoticeKind.TASK_QUESTION, EnumSet.of(channel)),
        ownTasksOnly,
        ends,
        quiet,
        BERLIN,
        "en");
  }

  @Test
  void quietHoursMayGoOverMidnight() {
    assertTrue(quiet("22:00", "06:30").contains(Instant.parse("2026-11-27T22:30:00Z")));
    assertTrue(quiet("22:00", "06:30").contains(Instant.parse("2026-11-27T21:00:00Z")));
    assertTrue(quiet("22:00", "06:30").contains(Instant.parse("2026-11-27T05:29:00Z")));
    assertFalse(quiet("22:00", "06:30").contains(Instant.parse("2026-11-27T05:30:00Z")));
    assertFalse(quiet("22:00", "06:30").contains(NOON));
    assertTrue(quiet("11:00", "12:01").contains(NOON));
  }

  @Test
  void quietHoursEndAtTheirEndThere() {
    assertEquals(
        Instant.parse("2026-11-28T05:30:00Z"),
        quiet("22:00", "06:30").endAfter(Instant.parse("2026-11-27T22:30:00Z")));
    assertEquals(
        Instant.parse("2026-11-27T05:30:00Z"),
        quiet("22:00", "06:30").endAfter(Instant.parse("2026-11-27T02:00:00Z")));
    assertEquals(NOON, quiet("22:00", "06:30").endAfter(NOON));
  }

  @Test
  void whatFailsIsTriedLaterEachTimeAndForADay() {
    List<Long> pauses = new ArrayList<>();
    for (int attempts = 1; attempts <= 8; attempts++) {
      pauses.add(BackOff.pause(attempts).toSeconds());
    }
    // 5 s four times as long each time, at most two hours
    assertEquals(List.of(5L, 20L, 80L, 320L, 1280L, 5120L, 7200L, 7200L), pauses);

    int attempts = 0;
    Instant now = NOON;
    for (Optional<Instant> next = Optional.of(NOON); next.isPresent(); attempts++) {
      now = next.get();
      next = BackOff.next(attempts + 1, NOON, now);
    }
    assertFalse(now.isAfter(NOON.plus(Duration.ofDays(1))));
    assertTrue(now.isAfter(NOON.plus(Duration.ofHours(22))), now::toString);
    // the first, 6 within 114 min, and 11 every 2 h until a day is over
    assertEquals(18, attempts);
  }

  @Test
  void aPersonIsToldWhatHeChose() {
    Person anybody = new Person(1, "a@b.org", preferences(Channel.EMAIL, false, false, null));
    Person ofOwn = new Person(2, "b@b.org", preferences(Channel.EMAIL, true, true, null));
    Person byBadge = new Person(3, "c@b.org", preferences(Channel.BADGE, false, true, null));
    DeliveryPlan plan = new DeliveryPlan(List.of(anybody, ofOwn, byBadge), List.of());

    assertEquals(List.of(1L), told(plan, notice(NoticeKind.TASK_QUESTION, 9L), false));
    assertEquals(List.of(1L), told(plan, notice(NoticeKind.TASK_QUESTION, null), false));
    assertEquals(List.of(1L, 2L), told(plan, notice(NoticeKind.TASK_QUESTION, 2L), false));
    assertEquals(List.of(1L, 2L), told(plan, notice(NoticeKind.ROBOT_LOST, null), false));
    assertEquals(List.of(2L), told(plan, notice(NoticeKind.ROBOT_LOST, null), true));
    assertEquals(List.of(), told(plan, notice(NoticeKind.STANDSTILL, null), false));
  }

  private static List<Long> told(DeliveryPlan plan, Notice notice, boolean ending) {
    return plan.change(notice, ending, NOON).deliveries().stream()
        .map(one -> ((Receiver.OfPerson) one.receiver()).account())
        .toList();
  }

  @Test
  void lettersWaitForTheEndOfQuietHours() {
    Person sleeper =
        new Person(1, "a@b.org", preferences(Channel.EMAIL, false, false, quiet("11:00", "15:00")));
    DeliveryPlan plan = new DeliveryPlan(List.of(sleeper), List.of());

    assertEquals(
        Instant.parse("2026-11-27T14:00:00Z"),
        plan.change(notice(NoticeKind.ROBOT_LOST, null), false, NOON)
            .deliveries()
            .getFirst()
            .notBefore());
  }

  @Test
  void webhooksAreToldBeginsAndEndsOfTheirKinds() {
    Webhook on = webhook(1, true);
    DeliveryPlan plan = new DeliveryPlan(List.of(), List.of(on, webhook(2, false)));

    for (boolean ending : new boolean[] {false, true}) {
      assertEquals(
          List.of(new Receiver.OfWebhook(1)),
          plan.change(notice(NoticeKind.ROBOT_LOST, null), ending, NOON).deliveries().stream()
              .map(Delivery::receiver)
              .toList());
    }
    assertEquals(List.of(), plan.change(notice(NoticeKind.SERVER, null), false, NOON).deliveries());
  }

  private static Webhook webhook(long id, boolean enabled) {
    return new Webhook(
        id,
        URI.create("https://example.org/" + id),
        WebhookSecret.random(),
        Set.of(NoticeKind.ROBOT_LOST),
        enabled,
        NOON,
        "Max");
  }

  /** The example that libraries of Standard Webhooks are tested by. */
  @Test
  void theSignatureIsThatOfTheSpecification() {
    assertEquals(
        "v1,g0hM9SsE+OTPJTGt/tmIKtSyZlE3uFJELVlNIOLJ1OE=",
        new WebhookSecret("whsec_MfKQ9r8GKYqrTwjUPD8ILPZIo2LaLaSw")
            .signature("msg_p5jXN8AQM9LWM0D4loKWxJek", 1_614_265_330, "{\"test\": 2432232314}"));
  }

  /** What docs/notices.md computes by openssl. */
  @Test
  void theSignatureIsThatOfTheDocument() {
    assertEquals(
        "v1,bjtN0M6J9iC7WTQ7gHLtC68l2VCFvkXpmF6HvtRoCis=",
        new WebhookSecret("whsec_MDEyMzQ1Njc4OWFiY2RlZjAxMjM0NTY3ODlhYmNkZWY=")
            .signature("m1", 1_700_000_000, "{}"));
  }

  @Test
  void aSecretIsNotWrittenToLogs() {
    WebhookSecret secret = WebhookSecret.random();

    assertTrue(secret.text().matches("whsec_[A-Za-z0-9+/]{43}="), secret.text());
    assertFalse(webhook(1, true).toString().contains("whsec_"));
  }

  @Test
  void theMessageIsTheSameEachTime() {
    assertEquals(
        "{\"type\":\"notice.begun\",\"timestamp\":\"2026-11-27T11:00:00Z\",\"data\":{"
            + "\"id\":\"00000000-0000-0000-0000-000000000005\",\"site\":\"main\","
            + "\"kind\":\"robot-lost\",\"text\":\"said\",\"floor\":\"hall\",\"task\":7,"
            + "\"robot\":null,\"begunAt\":\"2026-11-27T11:00:00Z\",\"endedAt\":null}}",
        NoticeMessage.json("main", notice(NoticeKind.ROBOT_LOST, null).ended(NOON), false));
    assertTrue(
        NoticeMessage.json("main", notice(NoticeKind.ROBOT_LOST, null).ended(NOON), true)
            .startsWith("{\"type\":\"notice.ended\""));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "127.0.0.1",
        "127.255.0.9",
        "0.0.0.0",
        "10.1.2.3",
        "172.16.0.1",
        "172.31.255.255",
        "192.168.1.1",
        "169.254.169.254",
        "100.64.0.1",
        "224.0.0.1",
        "255.255.255.255",
        "198.18.0.1",
        "::1",
        "::",
        "fe80::1",
        "fd12::1",
        "ff02::1",
        "::ffff:127.0.0.1",
        "64:ff9b::7f00:1",
        "2002:7f00:1::",
        "2001:db8::1",
        "2001::1"
      })
  void privateAddressesAreNoneOfAWebhook(String address) {
    assertFalse(new WebhookAddresses(List.of()).allows(InetAddress.ofLiteral(address)));
  }

  @ParameterizedTest
  @ValueSource(strings = {"8.8.8.8", "172.15.0.1", "172.32.0.1", "100.128.0.1", "2606:4700::1111"})
  void publicAddressesAre(String address) {
    assertTrue(new WebhookAddresses(List.of()).allows(InetAddress.ofLiteral(address)));
  }

  @Test
  void theConfigurationNamesOthers() {
    WebhookAddresses addresses =
        new WebhookAddresses(
            List.of(
                WebhookAddresses.Network.parse("10.2.0.0/16").orElseThrow(),
                WebhookAddresses.Network.parse(" fd00::7").orElseThrow()));

    assertTrue(addresses.allows(InetAddress.ofLiteral("10.2.255.1")));
    assertFalse(addresses.allows(InetAddress.ofLiteral("10.3.0.1")));
    assertTrue(addresses.allows(InetAddress.ofLiteral("fd00::7")));
    assertFalse(addresses.allows(InetAddress.ofLiteral("fd00::8")));
    for (String wrong : List.of("10.2.0.0/33", "10.2.0.0/", "host", "", "10.2.0.0/-1")) {
      assertTrue(WebhookAddresses.Network.parse(wrong).isEmpty(), wrong);
    }
  }

  @Test
  void aReceiverThatBrokeNothingOffIsNotSaidToHave() {
    String unreachable =
        "example.org cannot be reached: it is off, or the network has no way there. Check the"
            + " address, and the network of the server.";
    assertEquals(unreachable, sentenceOf(new NoRouteToHostException("No route to host")));
    assertEquals(unreachable, sentenceOf(new SocketException("Network is unreachable")));
    assertEquals(
        "example.org does not answer within 20 s. Check that the receiver runs and answers at once.",
        sentenceOf(
            new OutboundHttp.WholeLimitException(
                Duration.ofSeconds(20), new SocketException("Socket closed"))));
    assertEquals(
        "example.org broke the connection off: Connection reset",
        sentenceOf(new SocketException("Connection reset")));
  }

  private static String sentenceOf(IOException failure) {
    URI url = URI.create("https://example.org/hook");
    return WebhookException.of(url, failure, Duration.ofSeconds(10)).sentence().english();
  }

  @Test
  void aSilentReceiverIsToldToPeopleInTheirLanguage() {
    WebhookException failure =
        WebhookException.of(
            URI.create("https://example.org:8443/hook"),
            new SocketTimeoutException("Read timed out"),
            Duration.ofSeconds(10));

    assertEquals(
        "example.org does not answer within 10 s. Check that the receiver runs and answers at once.",
        failure.getMessage());
    String arabic = failure.sentence().text(Locale.forLanguageTag("ar"));
    assertTrue(arabic.contains("10") && !arabic.contains("timed out"), arabic);
  }
}
