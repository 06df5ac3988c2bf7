package org.toqa.app.config;

import ch.qos.logback.classic.Level;
import java.net.InetAddress;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.toqa.agent.config.Avoidance;
import org.toqa.allocation.Policy;
import org.toqa.fleet.ChargingRules;
import org.toqa.grid.Margins;
import org.toqa.network.DhcpSettings;
import org.toqa.notices.WebhookAddresses;
import org.toqa.telemetry.mqtt.BrokerSettings;

/**
 * How this server is to run, every value checked. {@code docs/configuration.md} explains each.
 *
 * @param address where HTTP listens
 * @param port TCP port; 0: any free one
 * @param hosts names at which browsers find the pages, besides localhost and IP addresses
 * @param tls what the pages are encrypted with; null: they are not
 * @param proxy the address of the proxy that says for whom it asks; null: none
 * @param requestsPerSecond how many requests of one caller are answered a second; 0: all
 * @param limits how much anybody may have at once
 * @param sessionLimit how long after its begin a login ends for good
 * @param data the folder for what the server keeps
 * @param maps of the floors that a server without floors begins with, the first one the default
 * @param shippedMap with which sites beside the first one begin
 * @param allocationPolicy who decides which robots carry what
 * @param simulatedRobots how many simulated robots, floor by floor
 * @param simulatedBatteries charge of new simulated robots as a share of a full battery, 0 to 1,
 *     robot by robot; the last one counts for all others
 * @param simulatedAvoidance how simulated robots avoid things; with four agents they have two
 *     wheels and eight range sensors
 * @param simulatedBoxes the file of boxes on a floor, and of the simulated robots that see and lift
 *     them; null: there are none
 * @param firmware the folder of the built firmware that drives the first simulated robot, in a
 *     simulated microcontroller; null: every body is simulated as a whole
 * @param widestRobot the largest diameter that is believed of a robot, metres
 * @param margins what is kept from walls
 * @param reassignAfter how long a robot is silent until its task goes to another
 * @param charging when robots charge
 * @param simulationSpeed how many times faster than real time simulated time passes
 * @param trackRetention how long robots' positions are kept
 * @param historyRetention how long ended tasks, events and what robots did are kept
 * @param firstManager the manager to make while there is none
 * @param mailServer sends e-mail; null: none is sent
 * @param webhooks where webhooks may lead
 * @param plainLinks whether links to robots on other machines may be unencrypted
 * @param gateways where gateways are listened for; null: nowhere
 * @param broker of MQTT; null: none is used
 * @param dhcp the DHCP server that is configured and read; null: none
 * @param settings all of them as they were given, without what is secret
 */
public record Configuration(
    InetAddress address,
    int port,
    Set<String> hosts,
    @Nullable TlsFiles tls,
    @Nullable InetAddress proxy,
    int requestsPerSecond,
    Limits limits,
    Duration sessionLimit,
    Path data,
    List<Path> maps,
    Path shippedMap,
    DatabaseSettings database,
    Policy allocationPolicy,
    List<Integer> simulatedRobots,
    List<Double> simulatedBatteries,
    Avoidance simulatedAvoidance,
    @Nullable Path simulatedBoxes,
    @Nullable Path firmware,
    double widestRobot,
    Margins margins,
    Duration reassignAfter,
    ChargingRules charging,
    double simulationSpeed,
    Duration trackRetention,
    Duration historyRetention,
    @Nullable FirstManager firstManager,
    @Nullable MailServer mailServer,
    WebhookAddresses webhooks,
    boolean plainLinks,
    @Nullable GatewaySettings gateways,
    @Nullable BrokerSettings broker,
    @Nullable DhcpSettings dhcp,
    Level logLevel,
    LogFormat logFormat,
    List<ConfiguredSetting> settings) {

  /**
   * The same for a site beside the first one: with data, a database and first floors of its own;
   * without what is of the whole server or of the first site alone.
   *
   * @param data the folder for what that site keeps
   * @param database that site's
   */
  public Configuration ofSite(Path data, DatabaseSettings database) {
    return new Configuration(
        address,
        port,
        hosts,
        tls,
        proxy,
        requestsPerSecond,
        limits,
        sessionLimit,
        data,
        List.of(shippedMap),
        shippedMap,
        database,
        allocationPolicy,
        List.of(),
        simulatedBatteries,
        simulatedAvoidance,
        null,
        null,
        widestRobot,
        margins,
        reassignAfter,
        charging,
        1,
        trackRetention,
        historyRetention,
        null,
        mailServer,
        webhooks,
        plainLinks,
        null,
        null,
        null,
        logLevel,
        logFormat,
        List.of());
  }

  /** Whether any robots are simulated. */
  public boolean isSimulated() {
    return simulatedRobots.stream().anyMatch(count -> count > 0);
  }

  /**
   * How much of the server one user, one address or all together may have at once. Addresses of
   * IPv6 count by /64.
   *
   * @param requestsAtOnce of one address, that are being answered
   * @param checksPerUser orders and previews that are being checked
   * @param streamsPerUser live streams
   * @param streamsPerAddress live streams
   * @param connections TCP connections, of all together
   * @param connectionsPerAddress TCP connections, but those of the proxy
   * @param requestTime how long a request may take to come in, header and body together
   * @param sessionsPerUser logins of browsers, logins of programs, and tokens: so many of each
   */
  public record Limits(
      int requestsAtOnce,
      int checksPerUser,
      int streamsPerUser,
      int streamsPerAddress,
      int connections,
      int connectionsPerAddress,
      Duration requestTime,
      int sessionsPerUser) {}

  /**
   * @param url JDBC
   */
  public record DatabaseSettings(String url, @Nullable String user, @Nullable String password) {
    /** The same user's database at another address. */
    public DatabaseSettings at(String other) {
      return new DatabaseSettings(other, user, password);
    }

    @Override
    public String toString() {
      return "Database[" + url + "]";
    }
  }

  /** PEM files. */
  public record TlsFiles(Path certificate, Path key) {}

  /**
   * @param port TCP port
   * @param from an e-mail address
   * @param url the address of the pages, for links in e-mail; without a slash at its end
   */
  public record MailServer(
      String host,
      int port,
      MailSecurity security,
      @Nullable String user,
      @Nullable String password,
      String from,
      String url) {
    @Override
    public String toString() {
      return "MailServer[" + host + ":" + port + "]";
    }
  }

  /** How the connection to the mail server is encrypted. */
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
   * @param shippedMap the first floor's map where none is configured
   * @param layers the first one that gives a setting decides
   * @throws ConfigurationException a value cannot be used; names it and what it must be
   */
  public static Configuration of(Path shippedMap, List<SettingSource> layers)
      throws ConfigurationException {
    return new ConfigurationReader(layers).read(shippedMap);
  }
}
