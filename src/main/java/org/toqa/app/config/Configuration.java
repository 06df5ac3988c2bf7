package org.toqa.app.config;

import ch.qos.logback.classic.Level;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.toqa.allocation.Policy;
import org.toqa.fleet.ChargingRules;

/**
 * How this server is to run, every value checked. {@code docs/configuration.md} explains each.
 *
 * @param address where HTTP listens
 * @param port 0: any free one
 * @param tls what the pages are encrypted with; null: they are not
 * @param proxy the address of the proxy that says for whom it asks; null: none
 * @param requestsPerSecond how many of one caller are answered; 0: all
 * @param data the folder for what the server keeps
 * @param map the floor's map
 * @param allocationPolicy who decides which robots carry what
 * @param simulatedRobots how many simulated robots
 * @param simulatedBatteries what the batteries of new simulated robots have, 0 to 1, robot by
 *     robot; the last one counts for all others
 * @param firmware the folder of the built firmware that drives the first simulated robot, in a
 *     simulated microcontroller; null: every body is simulated as a whole
 * @param reassignAfter how long a robot is silent until its task goes to another
 * @param charging when robots charge
 * @param simulationSpeed how many times faster than real time the simulated robots live
 * @param trackRetention how long it is kept where robots were
 * @param historyRetention how long ended tasks, events and what robots did are kept
 * @param firstManager the manager to make while there is none
 * @param mailServer who takes letters; null: none are sent
 * @param plainLinks whether robots on other machines may be spoken to without encryption
 */
public record Configuration(
    InetAddress address,
    int port,
    @Nullable TlsFiles tls,
    @Nullable InetAddress proxy,
    int requestsPerSecond,
    Path data,
    Path map,
    DatabaseSettings database,
    Policy allocationPolicy,
    int simulatedRobots,
    List<Double> simulatedBatteries,
    @Nullable Path firmware,
    Duration reassignAfter,
    ChargingRules charging,
    double simulationSpeed,
    Duration trackRetention,
    Duration historyRetention,
    @Nullable FirstManager firstManager,
    @Nullable MailServer mailServer,
    boolean plainLinks,
    Level logLevel,
    LogFormat logFormat) {

  /**
   * @param url JDBC
   */
  public record DatabaseSettings(String url, @Nullable String user, @Nullable String password) {
    @Override
    public String toString() {
      return "Database[" + url + "]";
    }
  }

  /** PEM files. */
  public record TlsFiles(Path certificate, Path key) {}

  /**
   * @param from an e-mail address
   * @param site the address of the pages, for links in letters; without a slash at its end
   */
  public record MailServer(
      String host,
      int port,
      MailSecurity security,
      @Nullable String user,
      @Nullable String password,
      String from,
      String site) {
    @Override
    public String toString() {
      return "MailServer[" + host + ":" + port + "]";
    }
  }

  /** How the way to the mail server is encrypted. */
  public enum MailSecurity {
    STARTTLS,
    TLS,
    NONE
  }

  /** How a line of the log is written. */
  public enum LogFormat {
    TEXT,
    JSON
  }

  /** The account that a new installation begins with. */
  public record FirstManager(String name, String password) {
    @Override
    public String toString() {
      return "FirstManager[" + name + "]";
    }
  }

  /**
   * @param webapp the folder of the web application, which holds the shipped map
   * @param layers the first one that gives a setting decides
   */
  public static Configuration of(Path webapp, List<SettingSource> layers)
      throws ConfigurationException {
    return new Reader(layers).read(webapp.resolve("WEB-INF/maps/lab.yaml"));
  }

  private record Reader(List<SettingSource> layers) {

    Configuration read(Path shippedMap) throws ConfigurationException {
      Path data = folder(Setting.DATA);
      int simulate = wholeNumber(Setting.SIMULATE, 0, 500);
      Duration lostAfter = Duration.ofSeconds(wholeNumber(Setting.LOST_AFTER, 5, 3600));
      double speed = number(Setting.SPEED, 0.1, 100);
      if (speed != 1 && simulate == 0) {
        throw invalid(
            Setting.SPEED, "only simulated robots can be made faster: set simulate as well.");
      }
      return new Configuration(
          address(),
          wholeNumber(Setting.PORT, 0, 65_535),
          tls(),
          proxy(),
          wholeNumber(Setting.REQUESTS_PER_SECOND, 0, 100_000),
          data,
          map(shippedMap),
          database(data),
          allocationPolicy(),
          simulate,
          batteries(),
          firmware(simulate),
          lostAfter,
          charging(),
          speed,
          Duration.ofDays(wholeNumber(Setting.KEEP_TRACKS, 1, 3650)),
          Duration.ofDays(wholeNumber(Setting.KEEP_HISTORY, 1, 3650)),
          firstManager(),
          mailServer(),
          flag(Setting.PLAIN_LINKS),
          logLevel(),
          logFormat());
    }

    private List<Double> batteries() throws ConfigurationException {
      List<Double> batteries = new ArrayList<>();
      for (String word : text(Setting.SIMULATE_BATTERIES).split(",", -1)) {
        if (!word.strip().matches("[1-9][0-9]{0,2}")) {
          throw outOfRange(Setting.SIMULATE_BATTERIES);
        }
        int percent = Integer.parseInt(word.strip());
        if (percent < 5 || percent > 100) {
          throw outOfRange(Setting.SIMULATE_BATTERIES);
        }
        batteries.add(percent / 100.0);
      }
      return List.copyOf(batteries);
    }

    private ChargingRules charging() throws ConfigurationException {
      int below = wholeNumber(Setting.CHARGING_BELOW, 5, 90);
      int until = wholeNumber(Setting.CHARGING_UNTIL, 10, 100);
      if (until <= below) {
        throw invalid(
            Setting.CHARGING_UNTIL, "it must be more than charging.below, which is " + below + ".");
      }
      return new ChargingRules(
          below / 100.0,
          until / 100.0,
          Duration.ofSeconds(Math.round(3600 * number(Setting.CHARGING_AFTER_HOURS, 0.1, 24))),
          Duration.ofMinutes(wholeNumber(Setting.CHARGING_MINUTES, 1, 1440)),
          ChargingRules.USUAL.patience());
    }

    private InetAddress address() throws ConfigurationException {
      String text = text(Setting.ADDRESS);
      try {
        return InetAddress.getByName(text);
      } catch (UnknownHostException e) {
        throw outOfRange(Setting.ADDRESS);
      }
    }

    private @Nullable TlsFiles tls() throws ConfigurationException {
      if (text(Setting.TLS_CERTIFICATE).isEmpty() && text(Setting.TLS_KEY).isEmpty()) {
        return null;
      }
      return new TlsFiles(pem(Setting.TLS_CERTIFICATE), pem(Setting.TLS_KEY));
    }

    private Path pem(Setting setting) throws ConfigurationException {
      if (text(setting).isEmpty()) {
        throw outOfRange(setting);
      }
      Path file = path(setting);
      if (!Files.isRegularFile(file) || !Files.isReadable(file)) {
        throw invalid(setting, "there is no such file that can be read.");
      }
      return file;
    }

    private @Nullable InetAddress proxy() throws ConfigurationException {
      String text = text(Setting.PROXY).strip();
      try {
        return text.isEmpty() ? null : InetAddress.ofLiteral(text);
      } catch (IllegalArgumentException e) {
        throw outOfRange(Setting.PROXY);
      }
    }

    private int wholeNumber(Setting setting, int least, int most) throws ConfigurationException {
      int number = parsed(setting, Integer::valueOf);
      if (number < least || number > most) {
        throw outOfRange(setting);
      }
      return number;
    }

    private double number(Setting setting, double least, double most)
        throws ConfigurationException {
      double number = parsed(setting, Double::valueOf);
      if (!(number >= least && number <= most)) {
        throw outOfRange(setting);
      }
      return number;
    }

    private <T> T parsed(Setting setting, Function<String, T> parser)
        throws ConfigurationException {
      try {
        return parser.apply(text(setting).strip());
      } catch (NumberFormatException e) {
        throw outOfRange(setting);
      }
    }

    private Path folder(Setting setting) throws ConfigurationException {
      Path folder = path(setting);
      if (Files.exists(folder) && !Files.isDirectory(folder)) {
        throw invalid(setting, "this is a file; it must be a folder.");
      }
      Path present = folder;
      while (!Files.exists(present) && present.getParent() != null) {
        present = present.getParent();
      }
      if (!Files.isWritable(present)) {
        throw invalid(setting, "nothing can be written to " + present + "; name another folder.");
      }
      return folder;
    }

    private @Nullable Path firmware(int simulate) throws ConfigurationException {
      if (text(Setting.FIRMWARE).isEmpty()) {
        return null;
      }
      if (simulate == 0) {
        throw invalid(Setting.FIRMWARE, "only simulated robots need it: set simulate as well.");
      }
      Path folder = path(Setting.FIRMWARE);
      if (!Files.isExecutable(folder.resolve("toqa-sim"))) {
        throw outOfRange(Setting.FIRMWARE);
      }
      return folder;
    }

    private Path map(Path shipped) throws ConfigurationException {
      if (text(Setting.MAP).isEmpty()) {
        return shipped;
      }
      Path file = path(Setting.MAP);
      if (!file.toString().matches(".*\\.(yaml|map)")) {
        throw outOfRange(Setting.MAP);
      }
      if (!Files.isReadable(file)) {
        throw invalid(Setting.MAP, "there is no such file that can be read.");
      }
      return file;
    }

    private Path path(Setting setting) throws ConfigurationException {
      SettingSource.Value value = value(setting);
      if (value.text().isBlank()) {
        throw outOfRange(setting);
      }
      try {
        return value.folder().resolve(value.text()).toAbsolutePath().normalize();
      } catch (InvalidPathException e) {
        throw outOfRange(setting);
      }
    }

    private DatabaseSettings database(Path data) throws ConfigurationException {
      String url = text(Setting.DATABASE_URL);
      if (url.isEmpty()) {
        // Without WRITE_DELAY=0 a killed process loses rows that it had committed.
        return new DatabaseSettings(
            "jdbc:h2:file:"
                + data.resolve("toqa")
                + ";MODE=MySQL;DATABASE_TO_LOWER=TRUE;CASE_INSENSITIVE_IDENTIFIERS=TRUE"
                + ";WRITE_DELAY=0",
            null,
            null);
      }
      if (!url.startsWith("jdbc:mysql:") && !url.startsWith("jdbc:h2:")) {
        throw outOfRange(Setting.DATABASE_URL);
      }
      return new DatabaseSettings(
          url,
          nullIfEmpty(text(Setting.DATABASE_USER)),
          nullIfEmpty(text(Setting.DATABASE_PASSWORD)));
    }

    private Policy allocationPolicy() throws ConfigurationException {
      String text = text(Setting.ALLOCATOR).strip();
      return Arrays.stream(Policy.values())
          .filter(policy -> policy.word().equals(text))
          .findFirst()
          .orElseThrow(() -> outOfRange(Setting.ALLOCATOR));
    }

    private @Nullable FirstManager firstManager() throws ConfigurationException {
      String text = text(Setting.MANAGER);
      if (text.isEmpty()) {
        return null;
      }
      int colon = text.indexOf(':');
      if (colon < 1 || colon == text.length() - 1) {
        throw outOfRange(Setting.MANAGER);
      }
      return new FirstManager(text.substring(0, colon), text.substring(colon + 1));
    }

    private @Nullable MailServer mailServer() throws ConfigurationException {
      String host = text(Setting.MAIL_HOST).strip();
      if (host.isEmpty()) {
        return null;
      }
      return new MailServer(
          host,
          wholeNumber(Setting.MAIL_PORT, 1, 65_535),
          mailSecurity(),
          nullIfEmpty(text(Setting.MAIL_USER)),
          nullIfEmpty(text(Setting.MAIL_PASSWORD)),
          matching(Setting.MAIL_FROM, "[^\\s@<>,;]+@[^\\s@<>,;]+"),
          matching(Setting.SITE, "https?://[^\\s/?#]+(/[^\\s?#]*)?").replaceFirst("/+$", ""));
    }

    private MailSecurity mailSecurity() throws ConfigurationException {
      return switch (text(Setting.MAIL_SECURITY).strip()) {
        case "starttls" -> MailSecurity.STARTTLS;
        case "tls" -> MailSecurity.TLS;
        case "none" -> MailSecurity.NONE;
        default -> throw outOfRange(Setting.MAIL_SECURITY);
      };
    }

    private String matching(Setting setting, String pattern) throws ConfigurationException {
      String text = text(setting).strip();
      if (!text.matches(pattern)) {
        throw outOfRange(setting);
      }
      return text;
    }

    private boolean flag(Setting setting) throws ConfigurationException {
      return switch (text(setting).strip()) {
        case "true" -> true;
        case "false" -> false;
        default -> throw outOfRange(setting);
      };
    }

    private LogFormat logFormat() throws ConfigurationException {
      return switch (text(Setting.LOG_FORMAT).strip()) {
        case "text" -> LogFormat.TEXT;
        case "json" -> LogFormat.JSON;
        default -> throw outOfRange(Setting.LOG_FORMAT);
      };
    }

    private Level logLevel() throws ConfigurationException {
      String text = text(Setting.LOG_LEVEL).toUpperCase(Locale.ROOT);
      if (!Set.of("ERROR", "WARN", "INFO", "DEBUG", "TRACE").contains(text)) {
        throw outOfRange(Setting.LOG_LEVEL);
      }
      return Level.valueOf(text);
    }

    private String text(Setting setting) {
      return value(setting).text();
    }

    private SettingSource.Value value(Setting setting) {
      for (SettingSource layer : layers) {
        SettingSource.Value value = layer.value(setting);
        if (value != null) {
          return value;
        }
      }
      return new SettingSource.Value(setting.defaultValue(), setting.key(), Path.of(""));
    }

    private ConfigurationException outOfRange(Setting setting) {
      return invalid(setting, "it must be " + setting.allowedValues() + ".");
    }

    private ConfigurationException invalid(Setting setting, String remedy) {
      SettingSource.Value value = value(setting);
      String shown = setting.isSecret() ? "" : " \"" + abbreviated(value.text()) + "\"";
      return new ConfigurationException(value.origin() + shown + ": " + remedy);
    }

    private static String abbreviated(String text) {
      return text.length() <= 100 ? text : text.substring(0, 100) + "...";
    }

    private static @Nullable String nullIfEmpty(String text) {
      return text.isEmpty() ? null : text;
    }
  }
}
