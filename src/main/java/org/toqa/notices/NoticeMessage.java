package org.toqa.notices;

import java.time.Instant;
import java.util.UUID;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.json.JsonMapper;

/**
 * What a webhook is sent: JSON in English, the same each time it is tried.
 *
 * @param type {@code notice.begun}, {@code notice.ended} or {@code notice.test}
 * @param timestamp when that was
 */
record NoticeMessage(String type, Instant timestamp, Data data) {
  private static final JsonMapper MAPPER = JsonMapper.builder().build();

  /**
   * @param id of the notice, the same in what tells its begin and its end
   * @param endedAt null in what tells the begin
   */
  record Data(
      String id,
      String site,
      String kind,
      String text,
      @Nullable String floor,
      @Nullable Long task,
      @Nullable String robot,
      Instant begunAt,
      @Nullable Instant endedAt) {}

  /** Of no notice. */
  static String test(String site, Instant now) {
    return MAPPER.writeValueAsString(
        new NoticeMessage(
            "notice.test",
            now,
            new Data(
                new UUID(0, 0).toString(),
                site,
                "test",
                "This is a test: nothing has happened.",
                null,
                null,
                null,
                now,
                now)));
  }

  static String json(String site, Notice notice, boolean ending) {
    Condition condition = notice.condition();
    Instant end = ending ? notice.endedAt() : null;
    return MAPPER.writeValueAsString(
        new NoticeMessage(
            ending ? "notice.ended" : "notice.begun",
            end == null ? notice.begunAt() : end,
            new Data(
                notice.uid().toString(),
                site,
                condition.kind().word(),
                condition.english(),
                condition.floor(),
                condition.task(),
                condition.robot(),
                notice.begunAt(),
                end)));
  }
}
