package org.toqa.notices;

import java.time.Instant;
import java.time.ZoneId;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/**
 * Of what somebody wants to be told, by what, and when.
 *
 * @param channels by what of each kind; of one that is missing by none
 * @param ownTasksOnly whether of tasks only his own count
 * @param ends whether a letter tells the end too
 * @param quiet when neither sounds, the browser nor letters disturb; null: never
 * @param zone where he is
 * @param language the tag of the language of letters
 */
public record NoticePreferences(
    Map<NoticeKind, Set<Channel>> channels,
    boolean ownTasksOnly,
    boolean ends,
    @Nullable QuietHours quiet,
    ZoneId zone,
    String language) {

  public NoticePreferences {
    channels =
        channels.entrySet().stream()
            .filter(entry -> !entry.getValue().isEmpty())
            .collect(
                Collectors.toUnmodifiableMap(
                    Map.Entry::getKey, entry -> Set.copyOf(entry.getValue())));
  }

  /** Those of who has chosen nothing: every page counts everything, and nothing disturbs. */
  public static NoticePreferences initial(ZoneId zone, String language) {
    Map<NoticeKind, Set<Channel>> badges = new EnumMap<>(NoticeKind.class);
    NoticeKind.ALL.forEach(kind -> badges.put(kind, EnumSet.of(Channel.BADGE)));
    return new NoticePreferences(badges, false, false, null, zone, language);
  }

  public boolean has(NoticeKind kind, Channel channel) {
    return channels.getOrDefault(kind, Set.of()).contains(channel);
  }

  /** Of which he is told by that. */
  public Set<NoticeKind> kindsBy(Channel channel) {
    return channels.entrySet().stream()
        .filter(entry -> entry.getValue().contains(channel))
        .map(Map.Entry::getKey)
        .collect(Collectors.toUnmodifiableSet());
  }

  /**
   * Whether he is told of that by that, at any time.
   *
   * @param account his id
   */
  public boolean wants(Condition condition, Channel channel, long account) {
    Long owner = condition.owner();
    boolean isOthers = condition.kind().isOfTask() && (owner == null || owner != account);
    return has(condition.kind(), channel) && !(ownTasksOnly && isOthers);
  }

  public boolean isQuiet(Instant at) {
    return quiet != null && quiet.contains(at);
  }

  /** That moment, or the end of the quiet hours that it is in. */
  Instant whenDisturbable(Instant at) {
    return quiet == null ? at : quiet.endAfter(at);
  }
}
