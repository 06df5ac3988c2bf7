package org.toqa.web.input;

import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskOrder.StopOrder;
import org.toqa.fleet.TaskOrder.Where;

/**
 * How forms and tables write a stop: the name of a station, {@code charge} for a charging point
 * that the robot chooses or {@code charge@NAME} for one; and for what is waited for there {@code
 * person}, a number of seconds, or a percentage to which the robot charges.
 */
public final class StopWords {
  private static final String CHARGE = "charge";
  private static final String PERSON = "person";

  private StopWords() {}

  /** A charging point, or else the station of that name. */
  public static Where place(String given) {
    String word = given.toLowerCase(Locale.ROOT);
    if (word.equals(CHARGE)) {
      return new Where.Charger(null);
    }
    return word.startsWith(CHARGE + "@")
        ? new Where.Charger(given.substring(CHARGE.length() + 1).strip())
        : new Where.Station(given);
  }

  /**
   * The stop with what is waited for there.
   *
   * @param field that gets the sentence where that cannot be
   * @param wait null: nothing is said
   * @param number reads a number as this kind of input writes it
   */
  public static StopOrder stop(
      Fields fields,
      String field,
      Where where,
      @Nullable String wait,
      Function<String, Optional<Double>> number) {
    if (wait == null || wait.isBlank()) {
      return new StopOrder(where, false, null);
    }
    if (wait.equalsIgnoreCase(PERSON)) {
      return new StopOrder(where, true, null);
    }
    if (!wait.endsWith("%")) {
      double seconds = number.apply(wait).orElse(Double.NaN);
      return new StopOrder(where, false, fields.rules().stopWait(field, seconds));
    }
    if (!(where instanceof Where.Charger)) {
      fields.errors().add(field, fields.texts().get("error.charge.notThere"));
    }
    double percent = number.apply(wait.substring(0, wait.length() - 1).strip()).orElse(Double.NaN);
    return new StopOrder(where, false, null, fields.rules().chargeLevel(field, percent / 100));
  }
}
