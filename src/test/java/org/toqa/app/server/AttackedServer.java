package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpResponse;
import java.nio.file.Path;
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
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;

/**
 * The whole server with simulated robots. At its end all that was logged is searched for all
 * secrets that were used.
 */
final class AttackedServer implements AutoCloseable {
  static final String MANAGER = WebTestServer.MANAGER;

  static final String CLERK = WebTestServer.CLERK;

  private static final Path WEBAPP = Path.of("target/webapp").toAbsolutePath();

  private static final Pattern SECRET_OF_A_PAGE =
      Pattern.compile(
          "name=\"_csrf\" value=\"([^\"]+)|class=\"secret\"[^>]*>([^<]*)"
              + "|\"(?:token|secret|link)\":\"([^\"]+)");

  private final LogRecording log;
  private final WebServer web;
  private final FleetServer toqa;
  private final WebServer.RunningWebapp site;
  private final Set<String> secrets = ConcurrentHashMap.newKeySet();

  private AttackedServer(Path data) throws IOException, ConfigurationException {
    Map<Setting, @Nullable String> settings = new EnumMap<>(Setting.class);
    settings.put(Setting.PORT, "0");
    settings.put(Setting.DATA, data.toString());
    settings.put(Setting.MANAGER, MANAGER + ":" + WebTestServer.PASSWORD);
    settings.put(Setting.REQUESTS_PER_SECOND, "0");
    settings.put(Setting.SIMULATE, "2");
    settings.put(Setting.SPEED, "10");
    Configuration configuration =
        Configuration.of(
            WebappFolder.shippedMap(WEBAPP), List.of(SettingSource.fromCommandLine(settings)));
    log = LogRecording.start();
    web = WebServer.bind(WEBAPP, configuration);
    toqa = FleetServer.start(configuration);
    site = web.open(toqa);
    secrets.add(WebTestServer.PASSWORD);
    String hash = toqa.services().passwordHasher().hash(WebTestServer.PASSWORD);
    toqa.services().accounts().add(CLERK, hash, Role.CLERK, MANAGER);
  }

  /**
   * @param data an empty folder
   */
  static AttackedServer start(Path data) throws IOException, ConfigurationException {
    return new AttackedServer(data);
  }

  URI root() {
    return site.uri();
  }

  /** Somebody who has logged in. */
  TestClient signedIn(String name) {
    TestClient client = new TestClient(root());
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

  /** Lets all threads end, and then looks at what was logged. */
  @Override
  public void close() throws IOException {
    try (log) {
      site.close();
      toqa.close();
      web.close();
      assertTrue(log.lines().stream().anyMatch(line -> line.contains("The first manager is")));
      assertTrue(secrets.size() > 2, "a password, a session, a form's token");
      String text = log.text();
      for (String secret : secrets) {
        assertFalse(text.contains(secret), "The secret " + secret + " is in the log.");
      }
    }
  }
}
