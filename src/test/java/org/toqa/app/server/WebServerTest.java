package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.ConnectException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.app.config.Configuration;
import org.toqa.app.config.ConfigurationException;
import org.toqa.app.config.Setting;
import org.toqa.app.config.SettingSource;
import org.toqa.testbed.TestCertificate;

class WebServerTest {
  private static final Path WEBAPP = Path.of("target/webapp").toAbsolutePath();

  @TempDir private Path folder;

  @Test
  void theApplicationIsServedUntilTheSiteIsClosed() throws Exception {
    Configuration configuration = onPort(0);
    URI address;
    try (WebServer web = WebServer.bind(WEBAPP, configuration);
        SiteServers toqa = SiteServers.start(configuration)) {
      try (WebServer.RunningWebapp site = web.open(toqa)) {
        address = site.uri();
        assertEquals(200, get(address).statusCode());
        assertEquals(200, get(address.resolve("assets/pico/pico.blue.min.css")).statusCode());
      }
    }

    assertThrows(ConnectException.class, () -> get(address));
  }

  @Test
  void theLauncherAndTheClassesAreNoPages() throws Exception {
    Configuration configuration = onPort(0);
    try (WebServer web = WebServer.bind(WEBAPP, configuration);
        SiteServers toqa = SiteServers.start(configuration);
        WebServer.RunningWebapp site = web.open(toqa)) {
      for (String path :
          List.of("org/toqa/launch/Launcher.class", "META-INF/MANIFEST.MF", "WEB-INF/web.xml")) {
        int status = get(site.uri().resolve(path)).statusCode();
        assertTrue(status == 403 || status == 404 || status == 303, path + " " + status);
      }
    }
  }

  @Test
  void aPortThatIsTakenIsNamedBeforeAnythingElseStarts() throws Exception {
    try (ServerSocket other = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      Configuration configuration = onPort(other.getLocalPort());

      IOException refusal =
          assertThrows(IOException.class, () -> WebServer.bind(WEBAPP, configuration).close());

      String sentence = String.valueOf(refusal.getMessage());
      assertTrue(sentence.startsWith("Port " + other.getLocalPort() + " on 127.0.0.1"), sentence);
      assertTrue(sentence.endsWith("choose another one by --port."), sentence);
    }
  }

  @Test
  void withACertificateThePagesAreEncrypted() throws Exception {
    TestCertificate certificate = TestCertificate.in(folder, "toqa");
    Configuration configuration = with(certificate.file(), certificate.key());
    try (WebServer web = WebServer.bind(WEBAPP, configuration);
        SiteServers toqa = SiteServers.start(configuration);
        WebServer.RunningWebapp site = web.open(toqa);
        HttpClient client =
            HttpClient.newBuilder().sslContext(certificate.trustingNoOther()).build()) {
      assertEquals("https", site.uri().getScheme());
      HttpResponse<String> answer =
          client.send(
              HttpRequest.newBuilder(site.uri()).build(), HttpResponse.BodyHandlers.ofString());

      assertEquals(200, answer.statusCode());
      assertTrue(
          answer.headers().firstValue("Set-Cookie").orElseThrow().contains("Secure"), "cookie");
      assertTrue(answer.headers().firstValue("Strict-Transport-Security").isPresent());
      URI plain = URI.create(site.uri().toString().replace("https", "http"));
      assertNotEquals(200, get(plain).statusCode(), "nothing is served without encryption");
    }
  }

  @Test
  void aKeyOfAnotherCertificateIsRefusedInASentence() throws Exception {
    Configuration configuration =
        with(TestCertificate.in(folder, "one").file(), TestCertificate.in(folder, "two").key());

    IOException refusal =
        assertThrows(IOException.class, () -> WebServer.bind(WEBAPP, configuration).close());

    assertTrue(String.valueOf(refusal.getMessage()).startsWith("tls.certificate "), "" + refusal);
    assertTrue(String.valueOf(refusal.getMessage()).endsWith("both as PEM."), "" + refusal);
  }

  @Test
  void theSameHoldsForMqtt() throws Exception {
    Map<Setting, @Nullable String> options = options(0);
    options.put(Setting.MQTT_BROKER, "embedded");
    options.put(Setting.MQTT_PORT, "0");
    options.put(Setting.MQTT_CERTIFICATE, TestCertificate.in(folder, "one").file().toString());
    options.put(Setting.MQTT_KEY, TestCertificate.in(folder, "two").key().toString());
    Configuration configuration =
        Configuration.of(
            WebappFolder.shippedMap(WEBAPP), List.of(SettingSource.fromCommandLine(options)));

    IOException refusal =
        assertThrows(IOException.class, () -> SiteServers.start(configuration).close());

    assertTrue(String.valueOf(refusal.getMessage()).startsWith("mqtt.certificate "), "" + refusal);
  }

  @Test
  void onlyTheProxyIsBelievedForWhomItAsks() throws Exception {
    for (String proxy : new String[] {"127.0.0.1", "127.0.0.2"}) {
      Map<Setting, @Nullable String> options = options(0);
      options.put(Setting.PROXY, proxy);
      options.put(Setting.DATA, folder.resolve(proxy).toString());
      Configuration configuration =
          Configuration.of(
              WebappFolder.shippedMap(WEBAPP), List.of(SettingSource.fromCommandLine(options)));
      try (WebServer web = WebServer.bind(WEBAPP, configuration);
          SiteServers toqa = SiteServers.start(configuration);
          WebServer.RunningWebapp site = web.open(toqa);
          HttpClient client = HttpClient.newHttpClient()) {
        HttpResponse<String> answer =
            client.send(
                HttpRequest.newBuilder(site.uri())
                    .header("X-Forwarded-For", "192.0.2.7")
                    .header("X-Forwarded-Proto", "https")
                    .build(),
                HttpResponse.BodyHandlers.ofString());

        boolean isSecure =
            answer.headers().firstValue("Set-Cookie").orElseThrow().contains("Secure");
        assertEquals(proxy.equals("127.0.0.1"), isSecure, proxy);
      }
    }
  }

  private Configuration with(Path certificate, Path key) throws ConfigurationException {
    Map<Setting, @Nullable String> options = options(0);
    options.put(Setting.TLS_CERTIFICATE, certificate.toString());
    options.put(Setting.TLS_KEY, key.toString());
    return Configuration.of(
        WebappFolder.shippedMap(WEBAPP), List.of(SettingSource.fromCommandLine(options)));
  }

  private Configuration onPort(int port) throws ConfigurationException {
    return Configuration.of(
        WebappFolder.shippedMap(WEBAPP), List.of(SettingSource.fromCommandLine(options(port))));
  }

  private Map<Setting, @Nullable String> options(int port) {
    Map<Setting, @Nullable String> options = new EnumMap<>(Setting.class);
    options.put(Setting.PORT, String.valueOf(port));
    options.put(Setting.DATA, folder.toString());
    options.put(Setting.MANAGER, "boss:boss-password");
    return options;
  }

  private static HttpResponse<String> get(URI uri) throws IOException, InterruptedException {
    try (HttpClient client = HttpClient.newHttpClient()) {
      return client.send(HttpRequest.newBuilder(uri).build(), HttpResponse.BodyHandlers.ofString());
    }
  }
}
