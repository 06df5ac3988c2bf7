package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.EventArchive.Entry;
import org.toqa.fleet.EventArchive.Filter;
import org.toqa.fleet.EventRecord;
import org.toqa.web.FieldErrors;
import org.toqa.web.HistoryFilter;
import org.toqa.wording.Sentence;

/** Everything that has happened, newest first. */
public final class HistoryServlet extends ApiServlet {
  private static final int USUAL_LIMIT = 100;
  private static final int HIGHEST_LIMIT = 1000;

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
      Sentence text) {
    static EntryJson of(Entry entry) {
      EventRecord e = entry.event();
      return new EntryJson(entry.id(), e.at(), e.kind(), e.task(), e.robot(), e.who(), e.said());
    }
  }

  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    FieldErrors errors = new FieldErrors();
    HistoryFilter reader = new HistoryFilter(request, errors);
    Filter filter = reader.read();
    long before = reader.before();
    refuseIfAny(errors);
    int limit = queryNumber(request, "limit", USUAL_LIMIT, 1, HIGHEST_LIMIT);
    List<Entry> entries = services().history().events(filter, before, limit);
    Json.send(
        request,
        response,
        200,
        new HistoryJson(
            entries.stream().map(EntryJson::of).toList(),
            entries.size() < limit ? null : entries.getLast().id()));
  }
}
