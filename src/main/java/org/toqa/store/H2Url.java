package org.toqa.store;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;

/** JDBC URLs of H2 databases, with the settings that Toqa relies on. */
final class H2Url {
  private static final String PREFIX = "jdbc:h2:";

  /** Databases of H2 that are no file which this process alone writes. */
  private static final Pattern ELSEWHERE =
      Pattern.compile(Pattern.quote(PREFIX) + "(?!file:|nio:)\\p{Alpha}{2,}:.*");

  /** SQL as MySQL's. */
  private static final Map<String, String> DIALECT =
      Map.of(
          "MODE", "MySQL",
          "DATABASE_TO_LOWER", "TRUE",
          "CASE_INSENSITIVE_IDENTIFIERS", "TRUE");

  /** Without WRITE_DELAY=0 a killed process loses rows that it had committed. */
  private static final Map<String, String> DURABILITY =
      Map.of(
          "WRITE_DELAY", "0",
          "DB_CLOSE_ON_EXIT", "FALSE", // the server closes it, as its last part
          "RETENTION_TIME", String.valueOf(H2Compactor.RETENTION.toMillis()),
          "TRACE_LEVEL_FILE", "0"); // what goes wrong stands in our log

  private H2Url() {}

  static boolean isH2(String url) {
    return url.startsWith(PREFIX);
  }

  /** Whether this process alone writes the file. */
  static boolean isOwnFile(String url) {
    return isH2(url) && !ELSEWHERE.matcher(url).matches();
  }

  /**
   * @param file without its ending {@code .mv.db}
   */
  static String ofFile(Path file) {
    return PREFIX + "file:" + file;
  }

  /** The URL of an H2 database with the settings that it does not say. */
  static String withSettings(String url) {
    Map<String, String> settings = new TreeMap<>(DIALECT);
    if (isOwnFile(url)) {
      settings.putAll(DURABILITY);
    }
    String said = url.toUpperCase(Locale.ROOT);
    StringBuilder result = new StringBuilder(url);
    settings.forEach(
        (name, value) -> {
          if (!said.contains(';' + name + '=')) {
            result.append(';').append(name).append('=').append(value);
          }
        });
    return result.toString();
  }
}
