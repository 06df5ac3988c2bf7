package org.toqa.notices;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.Size;
import org.junit.jupiter.api.Test;
import org.toqa.wording.Sentence;

class NoticeTrackerTest {
  private static final Instant START = Instant.parse("2026-11-27T08:00:00Z");

  /** When a server that has just started may tell ends. */
  private static final Instant SETTLED = START.plus(NoticeTracker.SETTLING);

  private static final Condition LOST = condition(NoticeKind.ROBOT_LOST, "r1");
  private static final Condition QUESTION = condition(NoticeKind.TASK_QUESTION, "7");

  static Condition condition(NoticeKind kind, String subject) {
    return new Condition(kind, subject, "hall", null, null, null, Sentence.verbatim(subject));
  }

  private NoticeTracker tracker = NoticeTracker.of(List.of(), START);

  private NoticeTracker.Step at(Instant now, Condition... conditions) {
    NoticeTracker.Step step = tracker.next(List.of(conditions), now);
    tracker = step.tracker();
    return step;
  }

  @Test
  void aConditionThatLastsIsToldOnceAndItsEndOnce() {
    assertTrue(at(SETTLED, LOST).isEmpty());
    assertTrue(at(SETTLED.plusSeconds(9), LOST).isEmpty());

    List<Notice> begun = at(SETTLED.plusSeconds(10), LOST).begun(); // its patience
    assertEquals(1, begun.size());
    assertEquals(SETTLED, begun.getFirst().begunAt());
    for (int second = 11; second < 100; second++) {
      assertTrue(at(SETTLED.plusSeconds(second), LOST).isEmpty());
    }

    assertTrue(at(SETTLED.plusSeconds(100)).isEmpty());
    List<Notice> ended = at(SETTLED.plusSeconds(109)).ended(); // 10 s after it was there last
    assertEquals(List.of(begun.getFirst().uid()), ended.stream().map(Notice::uid).toList());
    assertEquals(SETTLED.plusSeconds(99), ended.getFirst().endedAt());
    assertTrue(at(SETTLED.plusSeconds(110)).isEmpty());
  }

  @Test
  void aClockThatIsSetBackProlongsNoWait() {
    Instant ahead = START.plus(Duration.ofDays(1000));
    tracker = NoticeTracker.of(List.of(), ahead);
    at(ahead.plusSeconds(1), LOST);

    assertTrue(at(START, LOST).isEmpty());
    Notice begun = at(START.plusSeconds(10), LOST).begun().getFirst(); // its patience
    assertEquals(START, begun.begunAt());

    at(ahead, LOST);
    assertTrue(at(START).isEmpty());
    assertEquals(1, at(SETTLED).ended().size());
  }

  @Test
  void oneThatComesAndGoesIsOneNotice() {
    at(SETTLED, QUESTION);
    assertEquals(1, at(SETTLED.plusSeconds(2), QUESTION).begun().size());

    for (int second = 3; second < 60; second += 2) {
      assertTrue(at(SETTLED.plusSeconds(second)).isEmpty());
      assertTrue(at(SETTLED.plusSeconds(second + 1), QUESTION).isEmpty());
    }
  }

  @Test
  void oneThatIsOverBeforeItsPatienceIsToldToNobody() {
    at(SETTLED, LOST);
    for (int second = 1; second < 60; second++) {
      assertTrue(at(SETTLED.plusSeconds(second)).isEmpty());
    }
  }

  @Test
  void whatWasOpenBeforeAStartIsToldNoSecondTimeAndEndsWhenTheFleetIsHeard() {
    at(SETTLED, LOST);
    Notice open = at(SETTLED.plusSeconds(10), LOST).begun().getFirst();
    Instant again = SETTLED.plusSeconds(3600);

    tracker = NoticeTracker.of(List.of(open), again);
    assertTrue(at(again.plusSeconds(59)).isEmpty());
    assertEquals(1, at(again.plusSeconds(60)).ended().size());

    tracker = NoticeTracker.of(List.of(open), again);
    assertTrue(at(again.plusSeconds(30), LOST).isEmpty());
    assertTrue(at(again.plusSeconds(300), LOST).isEmpty());
  }

  @Test
  void twoAtOnceOfTheSameNameAreOne() {
    at(SETTLED, QUESTION, QUESTION);
    assertEquals(1, at(SETTLED.plusSeconds(2), QUESTION, QUESTION).begun().size());
  }

  /** Begins and ends of one condition alternate, whenever it is there. */
  @Property(tries = 100)
  void beginsAndEndsAlternate(@ForAll @Size(max = 120) List<Boolean> isThere) {
    tracker = NoticeTracker.of(List.of(), START.minus(NoticeTracker.SETTLING));
    List<String> told = new ArrayList<>();
    Instant now = START;
    for (boolean present : isThere) {
      NoticeTracker.Step step = present ? at(now, QUESTION) : at(now);
      step.begun().forEach(notice -> told.add("begun " + notice.uid()));
      step.ended().forEach(notice -> told.add("ended " + notice.uid()));
      now = now.plus(Duration.ofSeconds(1));
    }
    for (int i = 0; i < told.size(); i++) {
      assertTrue(told.get(i).startsWith(i % 2 == 0 ? "begun" : "ended"), told::toString);
      assertTrue(i % 2 == 0 || told.get(i).endsWith(told.get(i - 1).substring(6)), told::toString);
    }
  }
}
