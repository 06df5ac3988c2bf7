package org.toqa.web.access;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.web.WebServerTest;

/** The names by which the server is asked. */
class HostsTest extends WebServerTest {

  @ParameterizedTest
  @CsvSource({
    "127.0.0.1, /, 200",
    "127.0.0.1:8080, /, 200",
    "localhost:8080, /, 200",
    "LOCALHOST, /, 200",
    "[::1]:8080, /, 200",
    "192.168.7.9, /, 200",
    "toqa.example.org, /, 200",
    "Toqa.Example.org.:8443, /, 200",
    "toqa.example.org.evil.test, /, 421",
    "evil.test, /, 421",
    "evil.test:8080, /first-start, 421",
    "evil.test, /api/v1/health, 421",
    "evil.test, /api/v1/tasks, 421",
    "127.0.0.1.evil.test, /, 421",
    "evil.test, /assets/css/base.css, 200"
  })
  void onlyKnownNamesAreAnswered(String host, String path, int status) throws IOException {
    String answer = ask(host, path);

    assertTrue(answer.startsWith("HTTP/1.1 " + status), answer);
    if (status == 421) {
      assertTrue(answer.contains("not known by the name"), answer);
      assertEquals(path.startsWith("/api/"), answer.contains("application/problem+json"));
      assertTrue(answer.contains("Content-Security-Policy"), answer);
    }
  }

  private String ask(String host, String path) throws IOException {
    try (Socket socket = new Socket(InetAddress.getLoopbackAddress(), server.root().getPort())) {
      socket.setSoTimeout(60_000);
      socket
          .getOutputStream()
          .write(
              "GET %s HTTP/1.1\r\nHost: %s\r\nConnection: close\r\n\r\n"
                  .formatted(path, host)
                  .getBytes(StandardCharsets.US_ASCII));
      return new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    }
  }
}
