package org.toqa.text;

import java.util.regex.Pattern;

/**
 * Text that somebody else wrote, as it may stand in a line of a log: without line breaks, control
 * characters, terminal escapes and what turns the direction of writing, and not too long.
 */
public final class CleanText {
  /** So long is a sentence of a robot at most, characters. */
  public static final int LONGEST = 500;

  private static final String CUT = "...";

  /** ECMA-48: commands with parameters, strings up to their end, and commands of one letter. */
  private static final Pattern TERMINAL_ESCAPE =
      Pattern.compile(
          "(?:\u001b\\[|\u009b)[0-?]*[ -/]*[@-~]"
              + "|\u001b[\\]PX^_][^\u0007\u001b\u009c]*(?:\u0007|\u001b\\\\|\u009c)?"
              + "|\u001b[ -/]*[0-~]");

  /** Joiners (U+200C, U+200D) belong to words of some languages; they stay. */
  private static final Pattern UNPRINTABLE =
      Pattern.compile("[\\p{Cc}\\p{Cs}\\p{Zl}\\p{Zp}\\p{Co}\\p{Cn}[\\p{Cf}&&[^\u200c\u200d]]]+");

  private CleanText() {}

  /** Whether nothing would be taken out of it. */
  public static boolean isClean(String text) {
    return !UNPRINTABLE.matcher(text).find();
  }

  /** At most {@link #LONGEST} characters of it, and three dots where there were more. */
  public static String of(String foreign) {
    return of(foreign, LONGEST);
  }

  /**
   * @param longest characters that are left of it at most; three dots tell that there were more
   */
  public static String of(String foreign, int longest) {
    String text = foreign;
    if (UNPRINTABLE.matcher(text).find()) {
      text = TERMINAL_ESCAPE.matcher(text).replaceAll("");
      text = UNPRINTABLE.matcher(text).replaceAll(" ");
    }
    if (text.length() <= longest) {
      return text;
    }
    int end = Character.isHighSurrogate(text.charAt(longest - 1)) ? longest - 1 : longest;
    return text.substring(0, end) + CUT;
  }
}
