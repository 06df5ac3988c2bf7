package org.toqa.app.config;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** What can be configured: the key in the file, and what its value may be. */
public enum Setting {
  ADDRESS("address", "127.0.0.1", "a host name or IP address of this machine"),
  PORT("port", "8080", "a whole number from 0 to 65535; 0 takes any free port"),
  TLS_CERTIFICATE(
      "tls.certificate", "", "a PEM file with the certificate and those that vouch for it"),
  TLS_KEY("tls.key", "", "a PEM file with the certificate's private key, without a password"),
  PROXY("proxy", "", "the IP address of the proxy in front of this server"),
  REQUESTS_PER_SECOND(
      "requestsPerSecond", "300", "a whole number from 0 to 100000; 0 sets no limit"),
  DATA("data", "toqa-data", "a folder"),
  MAP("map", "", "a .yaml (ROS map_server) or .map (MovingAI) file"),
  DATABASE_URL("database.url", "", "a JDBC URL that begins with jdbc:mysql: or jdbc:h2:"),
  DATABASE_USER("database.user", "", "a user of the database"),
  DATABASE_PASSWORD("database.password", "", "that user's password"),
  ALLOCATOR("allocator", "optimal", "zones, contract-net or optimal"),
  FIRMWARE("firmware", "", "the folder of the built firmware, with toqa.hex and toqa-sim"),
  SIMULATE("simulate", "0", "a whole number from 0 to 500"),
  SIMULATE_BATTERIES(
      "simulateBatteries",
      "100",
      "whole numbers of percent from 5 to 100 with commas between them"),
  LOST_AFTER("lostAfter", "30", "a whole number of seconds from 5 to 3600"),
  CHARGING_BELOW("charging.below", "20", "a whole number of percent from 5 to 90"),
  CHARGING_UNTIL("charging.until", "95", "a whole number of percent from 10 to 100"),
  CHARGING_AFTER_HOURS("charging.afterHours", "6", "a number of hours from 0.1 to 24"),
  CHARGING_MINUTES("charging.minutes", "30", "a whole number of minutes from 1 to 1440"),
  SPEED("speed", "1", "a number from 0.1 to 100"),
  KEEP_TRACKS("keepTracks", "90", "a whole number of days from 1 to 3650"),
  KEEP_HISTORY("keepHistory", "730", "a whole number of days from 1 to 3650"),
  MANAGER("manager", "", "name:password of the first manager"),
  SITE(
      "site", "", "the address of the pages as browsers have it, such as https://toqa.example.org"),
  MAIL_HOST("mail.host", "", "the host name of a mail server (SMTP)"),
  MAIL_PORT("mail.port", "587", "a whole number from 1 to 65535"),
  MAIL_SECURITY("mail.security", "starttls", "starttls, tls or none"),
  MAIL_USER("mail.user", "", "a user of the mail server"),
  MAIL_PASSWORD("mail.password", "", "that user's password"),
  MAIL_FROM("mail.from", "", "the e-mail address that letters come from, such as toqa@example.org"),
  PLAIN_LINKS("plainLinks", "false", "true or false"),
  LOG_LEVEL("logLevel", "INFO", "one of ERROR, WARN, INFO, DEBUG, TRACE"),
  LOG_FORMAT("logFormat", "text", "text or json");

  private final String key;
  private final String defaultValue;
  private final String allowedValues;

  Setting(String key, String fallback, String allowed) {
    this.key = key;
    this.defaultValue = fallback;
    this.allowedValues = allowed;
  }

  /** In the file; a dot stands for a level of nesting. */
  String key() {
    return key;
  }

  /** The value where nobody gives one; empty: see {@link Configuration}. */
  String defaultValue() {
    return defaultValue;
  }

  /** What the value may be, for a sentence. */
  String allowedValues() {
    return allowedValues;
  }

  /** The environment variable, such as {@code TOQA_DATABASE_URL}. */
  String environmentVariable() {
    return "TOQA_" + name();
  }

  /** The option of the command line, such as {@code --port}. */
  String commandLineOption() {
    return "--" + key.toLowerCase(Locale.ROOT);
  }

  boolean isSecret() {
    return this == DATABASE_PASSWORD || this == MAIL_PASSWORD || this == MANAGER;
  }

  static Optional<Setting> byKey(String key) {
    return Arrays.stream(values()).filter(s -> s.key.equals(key)).findFirst();
  }
}
