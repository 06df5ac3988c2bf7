package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpResponse;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.sql.ResultSet;
import java.sql.SQLException;
import java.sql.Statement;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Role;
import org.toqa.app.config.Configuration;
import org.toqa.app.config.ConfigurationException;
import org.toqa.app.config.Setting;
import org.toqa.app.config.SettingSource;
import org.toqa.testbed.CheapPassword;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;

/**
 * The whole server with simulated robots, which attackers reach by way of a proxy, each from an
 * address of his own. At its end all that was logged is searched for all secrets that were used.
 */
final class AttackedServer implements AutoCloseable {
  static final String MANAGER = WebTestServer.MANAGER;

  /** Somebody else, whose account and password managers change. */
  static final String CLERK = WebTestServer.CLERK;

  /** Of a robot that is nowhere: 26 letters and digits, as a robot shows them. */
  static final String PAIRING_CODE = "ABCD-EFGH-JKLM-NPQR-STUVW-XYZ23";

  private static final Path WEBAPP = Path.of("target/webapp").toAbsolutePath();

  private static final Pattern SECRET_OF_A_PAGE =
      Pattern.compile(
          "name=\"_csrf\" value=\"([^\"]+)|class=\"secret\"[^>]*>([^<]*)"
              + "|\"(?:token|secret)\":\"([^\"]+)|\"link\":\"([^\"]*secret=[^\"]+)");

  /** What people order; what robots do meanwhile is in other columns and tables. */
  private static final List<String> STORED =
      List.of(
          "select id, name, email, password_hash, role, disabled from users",
          "select id, user_id, kind, name from sessions",
          "select user_id, secret_hash from reset_links",
          "select name, host, port, max_load, parking, fingerprint, out_of_service, held, removed"
              + " from robots",
          "select id, name, user_name, floor, load_kg, load_length, load_width, start_x, start_y,"
              + " start_station, goal_x, goal_y, goal_station, priority, deadline, held from tasks",
          "select id, name, user_name, floor, load_kg, priority, kind, first_at, every_s, weekdays,"
              + " time_of_day, zone, until_at, paused from schedules",
          "select id, name, floor, task_order, parameters, shared from task_templates",
          "select floor from floor_holds",
          "select id, name, url, robot, floor from cameras",
          "select id, name, kind, hardware_address, address from network_devices",
          "select floor, allocator from floor_allocators",
          "select id from fleet_pause");

  /** Of what attackers have more than people have. */
  private static final List<Setting> UNLIMITED =
      List.of(
          Setting.REQUESTS_AT_ONCE,
          Setting.CHECKS_PER_USER,
          Setting.STREAMS_PER_USER,
          Setting.STREAMS_PER_ADDRESS,
          Setting.SESSIONS_PER_USER);

  private final LogRecording log;
  private final WebServer web;
  private final SiteServers sites;
  private final FleetServer toqa;
  private final WebServer.RunningWebapp site;
  private final Connection database;
  private final Set<String> secrets = ConcurrentHashMap.newKeySet();
  private int addresses;

  private AttackedServer(Path data, Map<Setting, @Nullable String> more)
      throws IOException, ConfigurationException, SQLException {
    Map<Setting, @Nullable String> settings = new EnumMap<>(Setting.class);
    settings.put(Setting.PORT, "0");
    settings.put(Setting.DATA, data.toString());
    settings.put(Setting.MANAGER, MANAGER + ":" + WebTestServer.PASSWORD_HASH);
    settings.put(Setting.PROXY, "127.0.0.1");
    settings.put(Setting.REQUESTS_PER_SECOND, "0");
    settings.put(Setting.SIMULATE, "2");
    settings.put(Setting.SPEED, "10");
    settings.put(Setting.MQTT_BROKER, "embedded");
    settings.put(Setting.MQTT_PORT, "0");
    for (Setting limit : UNLIMITED) {
      settings.put(limit, "10000");
    }
    settings.putAll(more);
    Configuration configuration =
        Configuration.of(
            WebappFolder.shippedMap(WEBAPP), List.of(SettingSource.fromCommandLine(settings)));
    log = LogRecording.start();
    web = WebServer.bind(WEBAPP, configuration);
    sites = SiteServers.start(configuration, CheapPassword.hasher());
    toqa = sites.firstServer();
    site = web.open(sites);
    database = DriverManager.getConnection(configuration.database().url());
    secrets.add(WebTestServer.PASSWORD);
    secrets.add(WebTestServer.PASSWORD_HASH);
    secrets.add(PAIRING_CODE);
    secrets.add(PAIRING_CODE.replace("-", ""));
    addUser(CLERK);
  }

  /**
   * @param data an empty folder
   */
  static AttackedServer start(Path data) throws IOException, ConfigurationException, SQLException {
    return new AttackedServer(data, Map.of());
  }

  /**
   * @param data an empty folder
   * @param more settings beside those that it has itself, or other than those
   */
  static AttackedServer start(Path data, Map<Setting, @Nullable String> more)
      throws IOException, ConfigurationException, SQLException {
    return new AttackedServer(data, more);
  }

  URI root() {
    return site.uri();
  }

  /** The secret is used from now on. */
  void addSecret(String secret) {
    secrets.add(secret);
  }

  /** A clerk with the password of all. */
  void addUser(String name) {
    toqa.services().accounts().add(name, WebTestServer.PASSWORD_HASH, Role.CLERK, MANAGER);
  }

  long userId(String name) {
    return toqa.services().accounts().accountByName(name).orElseThrow().id();
  }

  /** Somebody at an address where nobody has failed yet. */
  TestClient stranger() {
    addresses++;
    return new TestClient(root(), "10.0.%d.%d".formatted(addresses / 250, addresses % 250 + 1));
  }

  /** The same, logged in. */
  TestClient signedIn(String name) {
    TestClient client = stranger();
    observed(client.signIn(name));
    observed(client.get("map"));
    return client;
  }

  /** Remembers the secrets of an answer. */
  HttpResponse<String> observed(HttpResponse<String> answer) {
    for (String cookie : answer.headers().allValues("Set-Cookie")) {
      String value = cookie.split(";", 2)[0].replaceFirst(".*?=", "");
      if (value.length() >= 20) { // not the language
        secrets.add(value);
      }
    }
    Matcher secret = SECRET_OF_A_PAGE.matcher(answer.body());
    while (secret.find()) {
      for (int group = 1; group <= secret.groupCount(); group++) {
        if (secret.group(group) != null) {
          secrets.add(secret.group(group).replaceFirst(".*secret=", ""));
        }
      }
    }
    return answer;
  }

  /** All that people have ordered, as it is stored now. */
  List<String> stored() throws SQLException {
    List<String> rows = new ArrayList<>();
    try (Statement statement = database.createStatement()) {
      for (String query : STORED) {
        try (ResultSet found = statement.executeQuery(query + " order by 1")) {
          String table = query.substring(query.indexOf(" from ") + " from ".length());
          int columns = found.getMetaData().getColumnCount();
          while (found.next()) {
            StringBuilder row = new StringBuilder(table);
            for (int i = 1; i <= columns; i++) {
              row.append(' ').append(found.getString(i));
            }
            rows.add(row.toString());
          }
        }
      }
    }
    return rows;
  }

  /** Lets all threads end, and then looks at what was logged. */
  @Override
  public void close() throws IOException, SQLException {
    try (log) {
      database.close();
      site.close();
      sites.close();
      web.close();
      assertTrue(log.lines().stream().anyMatch(line -> line.contains("The first manager is")));
      assertTrue(secrets.size() > 4, "few secrets were used");
      String text = log.text();
      for (String secret : secrets) {
        assertFalse(text.contains(secret), "The secret " + secret + " is in the log.");
      }
    }
  }
}
