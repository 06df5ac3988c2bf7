package org.toqa.fleet;

import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Sentence;

/**
 * What an operator holds: all robots, or those of a floor. They hold at once, and go on only when
 * that is stored and no hold has come meanwhile. Confined to one agent.
 */
public final class OperatorHold {
  private final StoreWriter writer;
  private final InstantSource clock;
  private final Subject subject;
  private final PendingResume resume = new PendingResume();
  private @Nullable Hold inForce;

  /** Whose robots these are, and how they are held. */
  public interface Subject {
    /** Lets them hold, or go on where it is null. */
    void apply(@Nullable Hold hold);

    /** Stores it; null: they go on. It may wait. */
    void save(@Nullable Hold hold, List<EventRecord> events);

    /** Tells the agent, from any thread, that this is over. */
    void tell(ResumeEnded ended);
  }

  /** How it is told in the history. */
  public record Telling(
      EventKind held,
      Function<String, Sentence> heldText,
      EventKind resumed,
      Function<String, Sentence> resumedText) {}

  /**
   * A resume is over: see {@link #end}.
   *
   * @param number of the resume
   * @param isStored else it never can be: all stay held, and may be resumed anew
   */
  public record ResumeEnded(long number, boolean isStored) {}

  private final Telling telling;

  /**
   * @param stored what is in force from the start
   */
  public OperatorHold(
      @Nullable Hold stored,
      StoreWriter writer,
      InstantSource clock,
      Subject subject,
      Telling telling) {
    this.inForce = stored;
    this.writer = writer;
    this.clock = clock;
    this.subject = subject;
    this.telling = telling;
  }

  /** Null while they may drive. */
  public @Nullable Hold inForce() {
    return inForce;
  }

  /**
   * An operator holds them, or lets them go on.
   *
   * @param stored is told, on the writer's thread, what is in force when that is safe
   * @param refused is told why it can never be stored
   */
  public void set(
      boolean hold,
      String user,
      Consumer<Answer<Optional<Hold>>> stored,
      Consumer<StoreException> refused) {
    Hold now = inForce;
    if (hold == (now != null && !resume.isPending())) { // asked for already, and not undone since
      save(hold ? now : null, stored, refused);
    } else if (hold) {
      Hold next = new Hold(user, clock.instant());
      resume.cancel();
      apply(next);
      save(next, stored, refused);
    } else {
      resume(user, stored, refused);
    }
  }

  private void resume(
      String user, Consumer<Answer<Optional<Hold>>> stored, Consumer<StoreException> refused) {
    EventRecord event = event(clock.instant(), telling.resumed(), user, telling.resumedText());
    long number = resume.begin();
    writer.write(
        () -> subject.save(null, List.of(event)),
        () -> {
          subject.tell(new ResumeEnded(number, true));
          stored.accept(new Answer.Accepted<>(Optional.empty()));
        },
        refusal -> {
          subject.tell(new ResumeEnded(number, false));
          refused.accept(refusal);
        });
  }

  /**
   * Stores it, also when that was asked for before: it may have been refused then. What was stored
   * twice is stored once, and told once.
   *
   * @param hold null: they go on, as is stored
   */
  private void save(
      @Nullable Hold hold,
      Consumer<Answer<Optional<Hold>>> stored,
      Consumer<StoreException> refused) {
    writer.write(
        () -> {
          if (hold != null) {
            subject.save(
                hold,
                List.of(event(hold.since(), telling.held(), hold.user(), telling.heldText())));
          }
        },
        () -> stored.accept(new Answer.Accepted<>(Optional.ofNullable(hold))),
        refused);
  }

  public void end(ResumeEnded ended) {
    if (resume.complete(ended.number()) && ended.isStored()) {
      apply(null);
    }
  }

  private void apply(@Nullable Hold next) {
    inForce = next;
    subject.apply(next);
  }

  private static EventRecord event(
      Instant at, EventKind kind, String user, Function<String, Sentence> text) {
    return new EventRecord(at, kind, null, null, user, text.apply(user));
  }
}
