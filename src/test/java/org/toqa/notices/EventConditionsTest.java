package org.toqa.notices;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.history.EventArchive;
import org.toqa.persistence.StoreException;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

class EventConditionsTest {
  private static final Instant AT = Instant.parse("2026-11-21T10:00:00Z");

  private final List<EventRecord> stored = new ArrayList<>();
  private boolean isAway;
  private final EventConditions events = new EventConditions(new Archive());

  private final class Archive implements EventArchive {
    @Override
    public List<Entry> events(Filter filter, long before, int limit) {
      if (isAway) {
        throw new StoreException(StoreException.Kind.UNAVAILABLE, "away", new RuntimeException());
      }
      return stored.reversed().stream()
          .filter(event -> event.kind().equals(filter.kind()))
          .filter(event -> filter.from() == null || !event.at().isBefore(filter.from()))
          .map(event -> new Entry(1, event))
          .toList();
    }

    @Override
    public List<String> robots() {
      return List.of();
    }
  }

  @Test
  void aRefusedScheduleIsOneNoticeForAnHour() {
    refuse(3, AT);
    stored.add(event("schedule.began", Phrase.SCHEDULE_BEGAN.with(4, "Max"), AT));
    NoticeTracker tracker = NoticeTracker.of(List.of(), AT);
    NoticeTracker.Step first = tracker.next(events.at(AT), AT);
    assertEquals(
        List.of("Schedule 3 of Max could not create a task: no way"),
        first.begun().stream().map(notice -> notice.condition().english()).toList());

    refuse(3, AT.plusSeconds(1800));
    Instant later = AT.plusSeconds(3601);
    NoticeTracker.Step again = first.tracker().next(events.at(later), later);
    assertEquals(List.of(), again.begun(), "once, not each time");
    assertEquals(List.of(), again.ended());

    Instant over = AT.plusSeconds(1800 + 3601);
    assertEquals(1, again.tracker().next(events.at(over), over).ended().size());
  }

  @Test
  void whileTheStoreIsAwayItIsAsItWas() {
    refuse(3, AT);
    assertEquals(1, events.at(AT).size());
    isAway = true;

    assertEquals(1, events.at(AT.plusSeconds(60)).size());
  }

  private void refuse(long schedule, Instant at) {
    Sentence why = Sentence.verbatim("no way");
    stored.add(event("schedule.refused", Phrase.SCHEDULE_REFUSED.with(schedule, "Max", why), at));
  }

  private static EventRecord event(String kind, Sentence said, Instant at) {
    return new EventRecord(at, kind, null, null, EventRecord.SYSTEM, said);
  }
}
