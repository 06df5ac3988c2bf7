package org.toqa.notices;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.toqa.fleet.PeriodicWork;
import org.toqa.notices.Delivery.Due;
import org.toqa.notices.Delivery.Receiver;
import org.toqa.notices.NoticeStore.Change;
import org.toqa.persistence.StoreException;

/**
 * Tells what is stored to be told, until it is told or given up.
 *
 * <ol>
 *   <li>Letters, and each webhook, are a lane of their own: one that hangs holds up no other.
 *   <li>Within a lane one is tried after the other. After a failure the lane rests until the next
 *       look, and what failed waits longer each time ({@link BackOff}).
 *   <li>What was told is noted after it was told: of a process that is killed between the two the
 *       next one tells it again, with the same id.
 * </ol>
 */
public final class Outbox implements AutoCloseable {
  private static final Logger log = LoggerFactory.getLogger(Outbox.class);
  private static final Duration PERIOD = Duration.ofSeconds(1);
  private static final Duration END_LIMIT = Duration.ofSeconds(3);

  /** Of one look at a lane, so that one that is busy ends when the server does. */
  private static final int MOST_IN_A_ROW = 50;

  /** A clock that is set back by less was put right. */
  private static final Duration CLOCK_JITTER = Duration.ofMinutes(1);

  private static final int LONGEST_FAILURE = 300;
  private static final String NOBODY_TO_TELL =
      "The user may not sign in any more, or has no e-mail address.";
  private static final String NO_MAIL_SERVER = "No mail server is configured.";
  private static final Lane LETTERS = new Lane(null);

  private final NoticeStore store;
  private final @Nullable LetterSender letters;
  private final InstantSource clock;
  private final WebhookPoster webhooks;
  private final ExecutorService threads =
      Executors.newThreadPerTaskExecutor(Thread.ofVirtual().name("outbox ", 0).factory());
  private final PeriodicWork work;

  /** What was told without the store, which does not know it yet. */
  private final Set<UUID> toldDirectly = ConcurrentHashMap.newKeySet();

  /** Lanes that were at work at the last look; of the periodic work's thread. */
  private final Map<Lane, Future<?>> busy = new HashMap<>();

  /** Null: there was none yet; of the periodic work's thread. */
  private @Nullable Instant lastLook;

  private volatile boolean closed;

  /**
   * @param webhook its id; null: letters
   */
  private record Lane(@Nullable Long webhook) {}

  /**
   * @param letters null: no mail server is configured
   */
  public Outbox(
      NoticeStore store,
      @Nullable LetterSender letters,
      WebhookPoster webhooks,
      InstantSource clock) {
    this(store, letters, webhooks, clock, PERIOD);
  }

  /**
   * @param period between two looks
   */
  Outbox(
      NoticeStore store,
      @Nullable LetterSender letters,
      WebhookPoster webhooks,
      InstantSource clock,
      Duration period) {
    this.store = store;
    this.letters = letters;
    this.clock = clock;
    this.webhooks = webhooks;
    this.work = new PeriodicWork("outbox", period, this::look);
  }

  private void look() {
    try {
      bringForward();
      List<Webhook> all = store.webhooks();
      Set<Lane> lanes = new HashSet<>();
      run(LETTERS, store::firstLetter, this::sendLetter);
      lanes.add(LETTERS);
      for (Webhook webhook : all) {
        Lane lane = new Lane(webhook.id());
        lanes.add(lane);
        if (webhook.enabled()) {
          run(
              lane,
              now -> store.first(webhook, now),
              due -> webhooks.post(webhook, due.delivery(), due.notice()));
        }
      }
      busy.keySet().retainAll(lanes);
    } catch (StoreException e) {
      log.debug("The outbox cannot be read; it waits.", e);
    }
  }

  /** What a clock that was ahead has put off is told by the clock now. */
  private void bringForward() {
    Instant now = clock.instant();
    Instant last = lastLook;
    boolean isSetBack = last != null && now.isBefore(last.minus(CLOCK_JITTER));
    if (last == null || isSetBack) {
      for (Due due : store.putOff(now, isSetBack ? now : now.plus(BackOff.LONGEST))) {
        Instant accepted = due.createdAt().isBefore(now) ? due.createdAt() : now;
        store.bringForward(due, accepted, whenDisturbable(due.delivery().receiver(), now));
      }
    }
    lastLook = now;
  }

  private Instant whenDisturbable(Receiver receiver, Instant now) {
    return switch (receiver) {
      case Receiver.OfPerson(long account) ->
          store
              .person(account)
              .map(person -> person.preferences().whenDisturbable(now))
              .orElse(now);
      case Receiver.OfWebhook _ -> now;
    };
  }

  private void run(Lane lane, Function<Instant, Optional<Due>> next, Telling telling) {
    Future<?> before = busy.get(lane);
    if (before == null || before.isDone()) {
      busy.put(lane, threads.submit(() -> tellAll(next, telling)));
    }
  }

  /** Tells it. */
  private interface Telling {
    /**
     * @throws IOException it could not be told; the message says why
     * @throws NobodyException there is nobody to tell it
     */
    void tell(Due due) throws IOException, NobodyException;
  }

  /** Nobody is there who could be told, also not later. */
  private static final class NobodyException extends Exception {
    private static final long serialVersionUID = 1;

    NobodyException(String message) {
      super(message);
    }
  }

  private void tellAll(Function<Instant, Optional<Due>> next, Telling telling) {
    try {
      for (int i = 0; i < MOST_IN_A_ROW && !closed; i++) {
        Optional<Due> due = next.apply(clock.instant());
        if (due.isEmpty() || !tell(due.get(), telling)) {
          return;
        }
      }
    } catch (StoreException e) {
      log.debug("The outbox cannot be read; it waits.", e);
    } catch (RuntimeException e) {
      log.error("Notices could not be told; it is tried again.", e);
    }
  }

  /** Whether the lane goes on. */
  private boolean tell(Due due, Telling telling) {
    try {
      telling.tell(due);
      store.setSent(due, clock.instant());
      return true;
    } catch (NobodyException e) {
      store.giveUp(due, String.valueOf(e.getMessage()), clock.instant());
      return true;
    } catch (IOException e) {
      noteFailure(due, e);
      return false;
    }
  }

  private void noteFailure(Due due, IOException failure) {
    String why = String.valueOf(failure.getMessage());
    String kept = why.substring(0, Math.min(why.length(), LONGEST_FAILURE));
    Instant now = clock.instant();
    Optional<Instant> next = BackOff.next(due.attempts() + 1, due.createdAt(), now);
    if (next.isPresent()) {
      log.info("A notice could not be told, and is tried again: {}", kept);
      store.setFailed(due, kept, next.get());
    } else {
      log.warn("A notice could not be told for a day, and is given up: {}", kept);
      store.giveUp(due, kept, now);
    }
  }

  private void sendLetter(Due due) throws IOException, NobodyException {
    Receiver.OfPerson receiver = (Receiver.OfPerson) due.delivery().receiver();
    Optional<Person> person = store.person(receiver.account());
    if (person.isEmpty()) {
      throw new NobodyException(NOBODY_TO_TELL);
    }
    sendLetter(person.get(), due.delivery(), due.notice());
  }

  private void sendLetter(Person person, Delivery delivery, Notice notice)
      throws IOException, NobodyException {
    LetterSender sender = letters;
    if (sender == null) {
      throw new NobodyException(NO_MAIL_SERVER);
    }
    sender.send(person.email(), person.preferences(), delivery, notice);
  }

  /**
   * Tries once to tell what cannot be stored now: that the database is away must be told although
   * it is. What is told so is not told again when it can be stored.
   *
   * @param plan with the receivers as the store had them last
   */
  void tellDirectly(Change change, DeliveryPlan plan) {
    for (Delivery delivery : change.deliveries()) {
      if (!delivery.notBefore().isAfter(clock.instant())) {
        var _ = threads.submit(() -> tellDirectly(delivery, change.notice(), plan));
      }
    }
  }

  private void tellDirectly(Delivery delivery, Notice notice, DeliveryPlan plan) {
    try {
      switch (delivery.receiver()) {
        case Receiver.OfPerson(long id) ->
            sendLetter(plan.person(id).orElseThrow(), delivery, notice);
        case Receiver.OfWebhook(long id) ->
            webhooks.post(plan.webhook(id).orElseThrow(), delivery, notice);
      }
      toldDirectly.add(delivery.uid());
    } catch (IOException | NobodyException e) {
      log.info("A notice could not be told while the database is away: {}", e.getMessage());
    } catch (RuntimeException e) {
      log.error("A notice could not be told while the database is away.", e);
    }
  }

  boolean isToldDirectly(UUID delivery) {
    return toldDirectly.contains(delivery);
  }

  /** The store knows by now what was told without it. */
  void forgetToldDirectly(List<Change> changes) {
    changes.forEach(
        change -> change.deliveries().forEach(delivery -> toldDirectly.remove(delivery.uid())));
  }

  /**
   * What is being told is not interrupted: where it does not end soon, it is told again after the
   * next start.
   */
  @Override
  public void close() {
    closed = true;
    work.close();
    threads.shutdown();
    try {
      if (!threads.awaitTermination(END_LIMIT.toMillis(), TimeUnit.MILLISECONDS)) {
        log.info("A receiver of notices does not answer; it is told after the next start.");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
