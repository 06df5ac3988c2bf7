package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.history.EventArchive.Entry;
import org.toqa.fleet.history.EventArchive.Filter;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.HistoryQueryReader;
import org.toqa.wording.Sentence;

/** Everything that has happened, newest first. */
public final class HistoryResource extends ApiHandler {
  private static final int DEFAULT_LIMIT = 100;
  private static final int MAX_LIMIT = 1000;

  /**
   * @param next what {@code before} must be for the next ones; null: there are no more
   */
  private record HistoryJson(List<EntryJson> events, @Nullable Long next) {}

  private record EntryJson(
      long id,
      Instant at,
      String kind,
      @Nullable Long task,
      @Nullable String robot,
      String who,
      Sentence text,
      @Nullable String floor) {
    static EntryJson of(Entry entry) {
      EventRecord e = entry.event();
      return new EntryJson(
          entry.id(), e.at(), e.kind(), e.task(), e.robot(), e.who(), e.sentence(), e.floor());
    }
  }

  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    FieldErrors errors = new FieldErrors();
    HistoryQueryReader reader = new HistoryQueryReader(request, errors);
    Filter filter = reader.filter();
    long before = reader.before();
    throwIfAny(errors);
    int limit = queryNumber(request, "limit", DEFAULT_LIMIT, 1, MAX_LIMIT);
    List<Entry> entries = services(request).history().events(filter, before, limit);
    Json.send(
        request,
        response,
        200,
        new HistoryJson(
            entries.stream().map(EntryJson::of).toList(),
            entries.size() < limit ? null : entries.getLast().id()));
  }
}
