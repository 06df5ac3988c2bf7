package org.toqa.app.config;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import org.toqa.agent.config.Avoidance;
import org.toqa.app.config.ValueRange.Choice;
import org.toqa.app.config.ValueRange.Decimal;
import org.toqa.app.config.ValueRange.WholeNumber;
import org.toqa.app.config.ValueRange.WholeNumbers;
import org.toqa.grid.Margins;

/** What can be configured: the key in the file, and what its value may be. */
public enum Setting {
  ADDRESS("address", "127.0.0.1", "a host name or IP address of this machine"),
  PORT("port", "8080", new WholeNumber(0, 65_535, "", "; 0 takes any free port")),
  HOSTS("hosts", "", "host names with commas between, such as toqa,toqa.example.org"),
  TLS_CERTIFICATE(
      "tls.certificate", "", "a PEM file with the certificate and those that vouch for it"),
  TLS_KEY("tls.key", "", "a PEM file with the certificate's private key, without a password"),
  PROXY("proxy", "", "the IP address of the proxy in front of this server"),
  REQUESTS_PER_SECOND(
      "requestsPerSecond", "300", new WholeNumber(0, 100_000, "", "; 0 sets no limit")),
  REQUESTS_AT_ONCE("requestsAtOnce", "200", new WholeNumber(1, 100_000)),
  CHECKS_PER_USER("checksPerUser", "8", new WholeNumber(1, 10_000)),
  STREAMS_PER_USER("streamsPerUser", "30", new WholeNumber(1, 100_000)),
  STREAMS_PER_ADDRESS("streamsPerAddress", "200", new WholeNumber(1, 100_000)),
  CONNECTIONS("connections", "8192", new WholeNumber(16, 100_000)),
  CONNECTIONS_PER_ADDRESS("connectionsPerAddress", "300", new WholeNumber(4, 100_000)),
  REQUEST_SECONDS("requestSeconds", "30", new WholeNumber(1, 3600, "seconds")),
  SESSION_HOURS("sessionHours", "168", new WholeNumber(1, 8760, "hours")),
  SESSIONS_PER_USER("sessionsPerUser", "50", new WholeNumber(1, 10_000)),
  DATA("data", "toqa-data", "a folder"),
  MAP("map", "", "a .yaml (ROS map_server) or .map (MovingAI) file"),
  DATABASE_URL("database.url", "", "a JDBC URL that begins with jdbc:mysql: or jdbc:h2:"),
  DATABASE_USER("database.user", "", "a user of the database"),
  DATABASE_PASSWORD("database.password", "", "that user's password"),
  ALLOCATOR("allocator", "optimal", new Choice("zones", "contract-net", "optimal")),
  FIRMWARE("firmware", "", "the folder of the built firmware, with toqa.hex and toqa-sim"),
  SIMULATE("simulate", "0", new WholeNumbers(0, 500, "")),
  SIMULATE_BATTERIES("simulateBatteries", "100", new WholeNumbers(5, 100, "percent")),
  SIMULATE_AVOIDANCE(
      "simulateAvoidance",
      Avoidance.WEIGHTED_DIRECTIONS.word(),
      new Choice(Avoidance.WEIGHTED_DIRECTIONS.word(), Avoidance.FOUR_AGENTS.word())),
  SIMULATE_BOXES("simulateBoxes", "", "a .yaml file with boxes for simulated robots"),
  WIDEST_ROBOT("widestRobot", "1", new Decimal(0.1, 10, "metres")),
  MARGINS_ROBOT(
      "margins.robot", String.valueOf(Margins.USUAL.robot()), new Decimal(0, 1, "metres")),
  MARGINS_FORMATION(
      "margins.formation",
      String.valueOf(Margins.USUAL.formation()),
      new Decimal(Margins.LEAST, 1, "metres")),
  LOST_AFTER("lostAfter", "30", new WholeNumber(5, 3600, "seconds")),
  CHARGING_BELOW("charging.below", "20", new WholeNumber(5, 90, "percent")),
  CHARGING_UNTIL("charging.until", "95", new WholeNumber(10, 100, "percent")),
  CHARGING_AFTER_HOURS("charging.afterHours", "6", new Decimal(0.1, 24, "hours")),
  CHARGING_MINUTES("charging.minutes", "30", new WholeNumber(1, 1440, "minutes")),
  SPEED("speed", "1", new Decimal(0.1, 100, "")),
  KEEP_TRACKS("keepTracks", "90", new WholeNumber(1, 3650, "days")),
  KEEP_HISTORY("keepHistory", "730", new WholeNumber(1, 3650, "days")),
  MANAGER(
      "manager",
      "",
      "name:password of the first manager, or name: and the password's Argon2id hash"),
  URL("url", "", "the address of the pages as browsers have it, such as https://toqa.example.org"),
  MAIL_HOST("mail.host", "", "the host name of a mail server (SMTP)"),
  MAIL_PORT("mail.port", "587", new WholeNumber(1, 65_535)),
  MAIL_SECURITY("mail.security", "starttls", new Choice("starttls", "tls", "none")),
  MAIL_USER("mail.user", "", "a user of the mail server"),
  MAIL_PASSWORD("mail.password", "", "that user's password"),
  MAIL_FROM("mail.from", "", "the e-mail address that letters come from, such as toqa@example.org"),
  WEBHOOKS_NETWORKS(
      "webhooks.networks",
      "",
      "IP addresses or networks such as 10.2.0.0/16 or fd00::/8, with commas between"),
  PLAIN_LINKS("plainLinks", "false", new Choice("true", "false")),
  GATEWAYS_TRUSTED("gateways.trusted", "", GatewaySettings.DESCRIPTION),
  GATEWAYS_ADDRESS("gateways.address", "0.0.0.0", "a host name or IP address of this machine"),
  GATEWAYS_PORT("gateways.port", "7276", new WholeNumber(0, 65_535, "", "; 0 takes any free port")),
  MQTT_BROKER(
      "mqtt.broker",
      "",
      "embedded, or the address of a broker: mqtt://HOST:PORT or mqtts://HOST:PORT"),
  MQTT_ADDRESS("mqtt.address", "127.0.0.1", "a host name or IP address of this machine"),
  MQTT_PORT("mqtt.port", "1883", new WholeNumber(0, 65_535, "", "; 0 takes any free port")),
  MQTT_PLAIN("mqtt.plain", "false", new Choice("true", "false")),
  MQTT_CERTIFICATE(
      "mqtt.certificate", "", "a PEM file with the certificate and those that vouch for it"),
  MQTT_KEY("mqtt.key", "", "a PEM file with the certificate's private key, without a password"),
  MQTT_CA("mqtt.ca", "", "a PEM file with the certificates that vouch for the broker"),
  MQTT_USER("mqtt.user", "", "a user of the broker"),
  MQTT_PASSWORD("mqtt.password", "", "that user's password"),
  DHCP_SERVER("dhcp.server", "none", new Choice("none", "dnsmasq")),
  DHCP_SUBNET("dhcp.subnet", "", "the subnet that the DHCP server serves, such as 10.0.7.0/24"),
  DHCP_HOSTS("dhcp.hosts", "", "the file that dnsmasq reads as dhcp-hostsfile"),
  DHCP_LEASES("dhcp.leases", "/var/lib/misc/dnsmasq.leases", "the dhcp-leasefile of dnsmasq"),
  DHCP_PID("dhcp.pid", "", "the pid-file of dnsmasq"),
  LOG_LEVEL("logLevel", "INFO", new Choice("ERROR", "WARN", "INFO", "DEBUG", "TRACE")),
  LOG_FORMAT("logFormat", "text", new Choice("text", "json"));

  private final String key;
  private final String defaultValue;

  @SuppressWarnings("ImmutableEnumChecker") // records of values; the one list is a copy
  private final ValueRange range;

  Setting(String key, String defaultValue, ValueRange range) {
    this.key = key;
    this.defaultValue = defaultValue;
    this.range = range;
  }

  Setting(String key, String defaultValue, String description) {
    this(key, defaultValue, new ValueRange.Text(description));
  }

  /** In the file; a dot stands for a level of nesting. */
  String key() {
    return key;
  }

  /** The value where nobody gives one; empty: see {@link Configuration}. */
  String defaultValue() {
    return defaultValue;
  }

  /** What the setting of that old key is now. */
  static Optional<Setting> byOldKey(String key) {
    return key.equals("site") ? Optional.of(URL) : Optional.empty();
  }

  /** What the setting of that old environment variable is now. */
  static Optional<Setting> byOldEnvironmentVariable(String name) {
    return name.equals("TOQA_SITE") ? Optional.of(URL) : Optional.empty();
  }

  /** What the value may be. */
  ValueRange range() {
    return range;
  }

  /** What the value may be, for a sentence. */
  String allowedValues() {
    return range.description();
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
    return this == DATABASE_PASSWORD
        || this == MAIL_PASSWORD
        || this == MQTT_PASSWORD
        || this == MANAGER;
  }

  static Optional<Setting> byKey(String key) {
    return Arrays.stream(values()).filter(s -> s.key.equals(key)).findFirst();
  }
}
