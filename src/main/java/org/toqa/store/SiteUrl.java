package org.toqa.store;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Site;

/** JDBC URLs of the databases of sites, beside that of the first one. */
final class SiteUrl {
  /** What stands before the name of the database, the name, and the rest. */
  private static final Pattern MYSQL = Pattern.compile("(jdbc:mysql:.*//[^/]*/)([^/?]+)(\\?.*)?");

  private static final Pattern H2 = Pattern.compile("([^;]*)(;.*)?");

  private SiteUrl() {}

  /**
   * @param first the URL of the first site's database
   * @throws IllegalArgumentException it names no database
   */
  static String of(String first, Site site) {
    if (site.isFirst()) {
      return first;
    }
    boolean isH2 = H2Url.isH2(first);
    Matcher matcher = (isH2 ? H2 : MYSQL).matcher(first);
    if (!matcher.matches()) {
      throw new IllegalArgumentException("The database's address names no database.");
    }
    return isH2
        ? matcher.group(1) + "-site-" + site.id() + rest(matcher.group(2))
        : matcher.group(1)
            + matcher.group(2)
            + "_site_"
            + site.id()
            + withCreation(rest(matcher.group(3)));
  }

  private static String rest(@Nullable String found) {
    return found == null ? "" : found;
  }

  /** MySQL's driver makes the database where its user may. */
  private static String withCreation(String parameters) {
    return parameters.isEmpty()
        ? "?createDatabaseIfNotExist=true"
        : parameters + "&createDatabaseIfNotExist=true";
  }
}
