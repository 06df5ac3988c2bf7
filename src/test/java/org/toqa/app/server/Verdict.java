package org.toqa.app.server;

/** What becomes of an attack where a person or a program gives a word. */
enum Verdict {
  /** A sentence says what it must be. */
  REFUSED,

  /** It is no number, or no "true" or "false", where an address must have one. */
  UNREADABLE,

  /** There is no floor of that name. */
  NOT_FOUND,

  /** Nobody is known by that name and password. */
  UNKNOWN_USER,

  /** It is no version that the page was filled from, or no moment for this order. */
  CONFLICT,

  /** There is no such link. */
  GONE,

  /** Nobody may, whatever it is. */
  FORBIDDEN,

  /** It is kept elsewhere than in the address. */
  REDIRECTED,

  /** Any text is, or it does not matter. */
  TAKEN,

  /** It is a text without control characters, of so many characters. */
  NAME_OF_100,
  NAME_OF_64,

  /** It is such a name of 64 characters that can stand in an address. */
  NAME_IN_ADDRESS,

  /** It is a password that nobody guesses if it is as long as one. */
  PASSWORD;

  /**
   * @param good the status where nothing is wrong
   */
  int status(Attack attack, int good) {
    return switch (this) {
      case REFUSED -> 422;
      case UNREADABLE -> 400;
      case NOT_FOUND -> 404;
      case UNKNOWN_USER -> 401;
      case CONFLICT -> 409;
      case GONE -> 410;
      case FORBIDDEN -> 403;
      case REDIRECTED -> 303;
      case TAKEN -> good;
      case NAME_OF_100 -> attack.isNameWithin(100) ? good : 422;
      case NAME_OF_64 -> attack.isNameWithin(64) ? good : 422;
      case NAME_IN_ADDRESS -> attack.isNameWithin(64) && attack.isOneSegment() ? good : 422;
      case PASSWORD -> attack.isPassword() ? good : 422;
    };
  }
}
