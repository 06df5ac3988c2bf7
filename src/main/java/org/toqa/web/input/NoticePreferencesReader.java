package org.toqa.web.input;

import java.time.DateTimeException;
import java.time.LocalTime;
import java.time.ZoneId;
import java.time.ZoneOffset;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.toqa.notices.Channel;
import org.toqa.notices.NoticeKind;
import org.toqa.notices.NoticePreferences;
import org.toqa.notices.QuietHours;

/**
 * Reads how somebody wants to be told: by what of each kind ({@code channels} with a list for each
 * kind), {@code ownTasksOnly}, {@code ends}, and the quiet hours {@code quietFrom} and {@code
 * quietUntil} in the time zone {@code zone}.
 */
public final class NoticePreferencesReader {
  private static final String QUIET_FROM = "quietFrom";
  private static final String QUIET_UNTIL = "quietUntil";

  private final Fields fields;

  private NoticePreferencesReader(Fields fields) {
    this.fields = fields;
  }

  /**
   * What of it is right; the rest gets sentences.
   *
   * @param isSet whether a field says yes
   */
  public static NoticePreferences read(Fields fields, Predicate<String> isSet) {
    NoticePreferencesReader reader = new NoticePreferencesReader(fields);
    ZoneId zone = reader.zone();
    NoticePreferences read =
        new NoticePreferences(
            reader.channels(),
            isSet.test("ownTasksOnly"),
            isSet.test("ends"),
            reader.quiet(zone),
            zone,
            fields.texts().locale().toLanguageTag());
    fields.refuseUnknown();
    return read;
  }

  private Map<NoticeKind, Set<Channel>> channels() {
    Map<NoticeKind, Set<Channel>> channels = new EnumMap<>(NoticeKind.class);
    Fields ofKinds = fields.object("channels");
    for (NoticeKind kind : NoticeKind.values()) {
      Set<Channel> chosen = EnumSet.noneOf(Channel.class);
      for (String word : ofKinds.choices(kind.word())) {
        Optional<Channel> channel = Channel.ofWord(word);
        channel.ifPresent(chosen::add);
        if (channel.isEmpty()) {
          refuse(ofKinds.path(kind.word()), "error.notices.channel");
        }
      }
      channels.put(kind, chosen);
    }
    if (ofKinds != fields) {
      ofKinds.refuseUnknown();
    }
    return channels;
  }

  private ZoneId zone() {
    String given = fields.text("zone");
    try {
      return given == null ? ZoneOffset.UTC : ZoneId.of(given);
    } catch (DateTimeException e) {
      refuse(fields.path("zone"), "error.statistics.zone");
      return ZoneOffset.UTC;
    }
  }

  private @Nullable QuietHours quiet(ZoneId zone) {
    LocalTime from = time(QUIET_FROM);
    LocalTime until = time(QUIET_UNTIL);
    if (!fields.has(QUIET_FROM) && !fields.has(QUIET_UNTIL)) {
      return null;
    }
    if (!fields.has(QUIET_FROM) || !fields.has(QUIET_UNTIL)) {
      refuse(
          fields.path(fields.has(QUIET_FROM) ? QUIET_UNTIL : QUIET_FROM),
          "error.notices.quiet.both");
      return null;
    }
    if (from != null && from.equals(until)) {
      refuse(fields.path(QUIET_UNTIL), "error.notices.quiet.same");
    }
    return from == null || until == null ? null : new QuietHours(from, until, zone);
  }

  private @Nullable LocalTime time(String name) {
    String given = fields.text(name);
    if (given == null) {
      return null;
    }
    String time = Digits.latin(given.strip());
    if (time.matches("([01][0-9]|2[0-3]):[0-5][0-9]")) {
      return LocalTime.parse(time);
    }
    refuse(fields.path(name), "error.notices.time");
    return null;
  }

  private void refuse(String field, String key) {
    fields.errors().add(field, fields.texts().get(key));
  }
}
