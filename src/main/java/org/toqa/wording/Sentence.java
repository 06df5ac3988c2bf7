package org.toqa.wording;

import java.text.MessageFormat;
import java.time.Duration;
import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.ResourceBundle;
import java.util.concurrent.ConcurrentHashMap;
import org.toqa.geometry.Vec2;

/**
 * What is said to people, in any of their languages.
 *
 * @param values texts, numbers and sentences
 */
public record Sentence(Phrase phrase, List<Object> values) {
  private static final String BUNDLE = "org.toqa.wording.sentences";

  /** Stands for a value that not everybody may read. */
  private static final String BLANK = "…";

  private static final Map<Wording, MessageFormat> FORMATS = new ConcurrentHashMap<>();

  public Sentence {
    values = List.copyOf(values);
  }

  /** What was said elsewhere, and is the same in every language. */
  public static Sentence verbatim(String text) {
    return Phrase.AS_SAID.with(text);
  }

  /**
   * @param point metres, map frame
   */
  public static Sentence of(Vec2 point) {
    return Phrase.POINT.with(point.x(), point.y());
  }

  /** In two units at most, and at least a second. */
  public static Sentence of(Duration duration) {
    if (duration.toDays() > 0) {
      return Phrase.DAYS_AND_HOURS.with(duration.toDays(), duration.toHoursPart());
    }
    if (duration.toHours() > 0) {
      return Phrase.HOURS_AND_MINUTES.with(duration.toHours(), duration.toMinutesPart());
    }
    return duration.toMinutes() == 0
        ? Phrase.SECONDS.with(Math.max(1, duration.toSeconds()))
        : Phrase.MINUTES_AND_SECONDS.with(duration.toMinutes(), duration.toSecondsPart());
  }

  /** Names one after the other. */
  public static Sentence names(Collection<String> names) {
    return joined(Phrase.LISTED, names.stream().map(Sentence::verbatim).toList());
  }

  /**
   * @param parts at least one
   */
  public static Sentence joined(Phrase link, List<Sentence> parts) {
    return parts.stream().reduce(link::with).orElseThrow();
  }

  public boolean isVerbatim() {
    return phrase == Phrase.AS_SAID;
  }

  /** Whether it has the values that its phrase needs; what was stored long ago may not. */
  public boolean isComplete() {
    boolean hasAll =
        format(Locale.ENGLISH).getFormatsByArgumentIndex().length == values.size()
            && values.stream().allMatch(v -> !(v instanceof Sentence part) || part.isComplete());
    try {
      return hasAll && !english().isEmpty();
    } catch (IllegalArgumentException e) { // a text for a number
      return false;
    }
  }

  /** For logs, for programs and for the history. */
  public String english() {
    return text(Locale.ENGLISH);
  }

  /** The same for who may not know what is named: its values are left open if one is a name. */
  public Sentence withoutNames() {
    boolean hasName = values.stream().anyMatch(value -> value instanceof String);
    return new Sentence(
        phrase,
        values.stream()
            .map(
                value ->
                    value instanceof Sentence part
                        ? (Object) part.withoutNames()
                        : hasName ? BLANK : value)
            .toList());
  }

  public String text(Locale locale) {
    MessageFormat format = format(locale);
    for (int i = 0; i < values.size(); i++) {
      if (values.get(i).equals(BLANK)) {
        format.setFormatByArgumentIndex(i, null); // also where there would be a number
      }
    }
    return format.format(
        values.stream()
            .map(value -> value instanceof Sentence part ? part.text(locale) : value)
            .toArray());
  }

  /**
   * A copy, since one format is for one thread; to parse it anew each time costs ten times more.
   */
  private MessageFormat format(Locale locale) {
    return (MessageFormat)
        FORMATS.computeIfAbsent(new Wording(phrase, locale), Wording::format).clone();
  }

  private record Wording(Phrase phrase, Locale locale) {
    MessageFormat format() {
      ResourceBundle bundle =
          ResourceBundle.getBundle(
              BUNDLE,
              locale,
              ResourceBundle.Control.getNoFallbackControl(
                  ResourceBundle.Control.FORMAT_PROPERTIES));
      return new MessageFormat(bundle.getString(phrase.name()), locale);
    }
  }

  @Override
  public String toString() {
    return english();
  }
}
