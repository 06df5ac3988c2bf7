package org.toqa.telemetry;

import java.util.Locale;

/** Why a message is not believed, or was passed over. */
public enum Refusal {
  /** More bytes than any reading needs. */
  TOO_LARGE,
  /** No JSON object in UTF-8; or a connection that is neither online nor offline. */
  UNREADABLE,
  /** A field is missing, or is not of its kind. */
  WRONG_FIELD,
  /** A number that no sensor measures. */
  OUT_OF_BOUNDS,
  /** The broker has kept it: nobody knows how old it is. */
  RETAINED,
  /** More kinds of readings than a robot may have. */
  TOO_MANY_READINGS,
  /** A newer one came before there was time for it. */
  TOO_OFTEN;

  /** As the API writes it. */
  public String word() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
