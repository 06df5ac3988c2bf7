package org.toqa.accounts;

import java.util.Locale;
import java.util.regex.Pattern;

/**
 * People, robots and floors that know nothing of those of other sites on the same server.
 *
 * @param id never another site's
 * @param name as it was typed; unique without regard to case
 */
public record Site(long id, String name) {
  /**
   * The id of the site whose users log in without its name, and whose administrators make others.
   */
  public static final long FIRST_ID = 1;

  /**
   * What follows the @ when somebody logs in: neither a dot nor another @, unlike a mail's host.
   */
  private static final Pattern NAME = Pattern.compile("[\\p{L}\\p{N}][\\p{L}\\p{N}_-]{0,31}");

  public boolean isFirst() {
    return id == FIRST_ID;
  }

  public static boolean isName(String given) {
    return NAME.matcher(given).matches();
  }

  /** By which a name is unique. */
  public static String key(String name) {
    return name.strip().toLowerCase(Locale.ROOT);
  }
}
