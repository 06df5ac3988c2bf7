package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.toqa.notices.Channel;
import org.toqa.notices.Condition;
import org.toqa.notices.Notice;
import org.toqa.notices.NoticeKind;
import org.toqa.notices.NoticePreferences;
import org.toqa.notices.NoticeStore.Entry;
import org.toqa.notices.NoticeStore.Filter;
import org.toqa.notices.NoticeStore.Seen;
import org.toqa.notices.Notices;
import org.toqa.notices.QuietHours;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.Fields;
import org.toqa.web.input.JsonFields;
import org.toqa.web.input.NoticePreferencesReader;
import org.toqa.web.input.NoticeQueryReader;
import org.toqa.wording.Sentence;

/** What needed attention, who has seen it, and how its reader wants to be told. */
public final class NoticesResource extends ApiHandler {
  private static final int DEFAULT_LIMIT = 50;
  private static final int MAX_LIMIT = 500;

  /**
   * @param next what {@code before} must be for the next ones; null: there are no more
   */
  private record NoticesJson(List<NoticeJson> notices, @Nullable Long next) {}

  private record NoticeJson(
      long id,
      String uid,
      String kind,
      Sentence text,
      @Nullable String floor,
      @Nullable Long task,
      @Nullable String robot,
      Instant begunAt,
      @Nullable Instant endedAt,
      List<SeenJson> seen) {
    static NoticeJson of(Entry entry) {
      Notice notice = entry.notice();
      Condition condition = notice.condition();
      return new NoticeJson(
          notice.id(),
          notice.uid().toString(),
          condition.kind().word(),
          condition.text(),
          condition.floor(),
          condition.task(),
          condition.robot(),
          notice.begunAt(),
          notice.endedAt(),
          entry.seen().stream().map(SeenJson::of).toList());
    }
  }

  private record SeenJson(String user, Instant at) {
    static SeenJson of(Seen seen) {
      return new SeenJson(seen.name(), seen.at());
    }
  }

  /**
   * What pages tell.
   *
   * @param latest the id of the newest notice; 0: there is none
   */
  private record NewsJson(int unseen, long latest, List<ToldJson> told) {}

  /**
   * @param title of its kind, in words
   */
  private record ToldJson(
      long id, String uid, String title, Sentence text, boolean sound, boolean browser) {}

  /**
   * @param channels by the kind's word
   * @param quietFrom such as 22:00; null with the other: there are no quiet hours
   */
  private record SettingsJson(
      Map<String, List<String>> channels,
      boolean ownTasksOnly,
      boolean ends,
      @Nullable String quietFrom,
      @Nullable String quietUntil,
      String zone) {
    static SettingsJson of(NoticePreferences preferences) {
      Map<String, List<String>> channels = new TreeMap<>();
      for (NoticeKind kind : NoticeKind.values()) {
        channels.put(
            kind.word(),
            preferences.channels().getOrDefault(kind, Set.of()).stream()
                .map(Channel::word)
                .sorted()
                .toList());
      }
      QuietHours quiet = preferences.quiet();
      return new SettingsJson(
          channels,
          preferences.ownTasksOnly(),
          preferences.ends(),
          quiet == null ? null : quiet.from().toString(),
          quiet == null ? null : quiet.until().toString(),
          preferences.zone().getId());
    }
  }

  public static void list(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    FieldErrors errors = new FieldErrors();
    NoticeQueryReader reader = new NoticeQueryReader(request, errors);
    Filter filter = reader.filter();
    long before = reader.before();
    throwIfAny(errors);
    int limit = queryNumber(request, "limit", DEFAULT_LIMIT, 1, MAX_LIMIT);
    List<Entry> entries = services(request).notices().store().entries(filter, before, limit);
    Json.send(
        request,
        response,
        200,
        new NoticesJson(
            entries.stream().map(NoticeJson::of).toList(),
            entries.size() < limit ? null : entries.getLast().notice().id()));
  }

  /** How the caller wants to be told; as everybody is at first where he has chosen nothing. */
  public static NoticePreferences preferences(HttpServletRequest request) {
    return services(request)
        .notices()
        .store()
        .preferences(Caller.of(request).account().id())
        .orElseGet(
            () ->
                NoticePreferences.initial(
                    ZoneOffset.UTC, Texts.of(request).locale().toLanguageTag()));
  }

  public static void news(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Caller caller = Caller.of(request);
    Texts texts = Texts.of(request);
    Notices.News news =
        caller.isVisitor()
            ? Notices.News.NONE
            : services(request)
                .notices()
                .news(caller.account().id(), preferences(request), caller.account().createdAt());
    Json.send(
        request,
        response,
        200,
        new NewsJson(
            news.unseen(),
            news.latest(),
            news.told().stream()
                .map(
                    told ->
                        new ToldJson(
                            told.notice().id(),
                            told.notice().uid().toString(),
                            texts.get("notices.kind." + told.notice().condition().kind().word()),
                            told.notice().condition().text(),
                            told.sound(),
                            told.browser()))
                .toList()));
  }

  public static void see(HttpServletRequest request, HttpServletResponse response) {
    Caller caller = Caller.of(request);
    if (!services(request)
        .notices()
        .markSeen(RequestPath.number(request, "id"), caller.account().id(), caller.name())) {
      throw Problem.of(404, Texts.of(request).get("problem.noSuchNotice")).exception();
    }
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  /** All up to the newest that was shown. */
  public static void seeAll(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Caller caller = Caller.of(request);
    long upTo = readBody(request, fields -> upTo(request, fields));
    services(request).notices().markAllSeen(upTo, caller.account().id(), caller.name());
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  private static long upTo(HttpServletRequest request, Fields fields) {
    Double upTo = fields.number("upTo");
    fields.refuseUnknown();
    if (upTo == null || upTo < 1 || upTo != Math.rint(upTo) || upTo > Long.MAX_VALUE / 2.0) {
      fields.errors().add("upTo", Texts.of(request).get("error.notices.upTo"));
      return 0;
    }
    return upTo.longValue();
  }

  public static void settings(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Json.send(request, response, 200, SettingsJson.of(preferences(request)));
  }

  public static void changeSettings(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    FieldErrors errors = new FieldErrors();
    JsonFields fields = JsonBody.read(request, errors);
    NoticePreferences read = NoticePreferencesReader.read(fields, fields::flag);
    throwIfAny(errors);
    services(request).notices().setPreferences(Caller.of(request).account().id(), read);
    settings(request, response);
  }
}
