package org.toqa.text;

/** What people call things: the one rule for the names of tasks, tokens, floors and places. */
public final class GivenName {
  private GivenName() {}

  /**
   * Whether something may be called so: somebody who reads it sees something, and sees all of it,
   * in the order in which it was written.
   *
   * @param longest letters that it has at most
   */
  public static boolean isName(String given, int longest) {
    return hasLetters(given) && length(given) <= longest && CleanText.isClean(given);
  }

  /** Whether somebody who reads it sees anything. */
  public static boolean hasLetters(String given) {
    return given
        .codePoints()
        .anyMatch(
            letter ->
                !Character.isWhitespace(letter)
                    && !Character.isSpaceChar(letter)
                    && Character.getType(letter) != Character.FORMAT);
  }

  /** Letters, as people count them; some are two characters of a string. */
  public static int length(String given) {
    return given.codePointCount(0, given.length());
  }
}
