package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.net.SocketTimeoutException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.app.config.Configuration;
import org.toqa.app.config.Setting;
import org.toqa.app.config.SettingSource;

/** Connections that are held open, by clients at several addresses of the loopback network. */
class ConnectionLimitsTest {
  private static final Path WEBAPP = Path.of("target/webapp").toAbsolutePath();
  private static final String HALF_A_HEADER = "POST / HTTP/1.1\r\nHost: localhost\r\nConte";
  private static final String HALF_A_BODY =
      "POST / HTTP/1.1\r\nHost: localhost\r\n"
          + "Content-Type: application/x-www-form-urlencoded\r\nContent-Length: 5000\r\n\r\nname=a";

  /** Of a body that nobody reads: the page is not there. */
  private static final String HALF_A_BODY_FOR_NOBODY =
      "POST /nowhere HTTP/1.1\r\nHost: localhost\r\nContent-Length: 5000\r\n\r\nx";

  /** Far longer than any limit here, far shorter than Tomcat's own patience with one who drips. */
  private static final long GUARD_SECONDS = 30;

  private static final int PER_ADDRESS = 20;
  private static final int TOTAL = 40;

  @TempDir private Path folder;

  private final List<Socket> sockets = new ArrayList<>();

  @AfterEach
  void close() throws IOException {
    for (Socket socket : sockets) {
      socket.close();
    }
  }

  @Test
  void aHeaderThatDripsInIsCut() throws Exception {
    try (Server server = start(Map.of(Setting.REQUEST_SECONDS, "1"))) {
      assertTrue(isCutWhileItDrips(server.connect(1, HALF_A_HEADER)));
      assertTrue(isCutWhileItDrips(server.connect(1, "\r\n"), '\n'), "empty lines before it");
      assertEquals(200, server.status(1));
    }
  }

  @Test
  void aBodyThatDripsInIsCutWhetherItIsReadOrNot() throws Exception {
    try (Server server = start(Map.of(Setting.REQUEST_SECONDS, "1"))) {
      assertTrue(isCutWhileItDrips(server.connect(1, HALF_A_BODY)), "a form");
      assertTrue(isCutWhileItDrips(server.connect(1, HALF_A_BODY_FOR_NOBODY)), "read by nobody");
      assertEquals(200, server.status(1));
    }
  }

  @Test
  void aConnectionThatIsUsedAgainAndAgainIsNotCut() throws Exception {
    try (Server server = start(Map.of(Setting.REQUEST_SECONDS, "1"))) {
      Socket socket = server.connect(1, "");
      long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(3);
      while (System.nanoTime() < end) {
        assertEquals(200, status(socket));
        TimeUnit.MILLISECONDS.sleep(100); // Tomcat ends one after 100 requests
      }
    }
  }

  @Test
  void ofOneAddressTheNewestTakesThePlaceOfTheSlowest() throws Exception {
    try (Server server = start(Map.of(Setting.CONNECTIONS_PER_ADDRESS, "" + PER_ADDRESS))) {
      Socket other = server.connect(2, HALF_A_HEADER);
      for (int i = 0; i < 3 * PER_ADDRESS; i++) {
        server.connect(1, HALF_A_HEADER);
      }
      awaitOpen(PER_ADDRESS, sockets.subList(1, sockets.size()));

      assertEquals(200, server.status(1), "of the same address, with a whole request");
      assertTrue(isOpen(other), "of another address");
    }
  }

  @Test
  void ofAllAddressesTheFullestGivesAPlace() throws Exception {
    try (Server server =
        start(
            Map.of(
                Setting.CONNECTIONS, "" + TOTAL,
                Setting.CONNECTIONS_PER_ADDRESS, "" + PER_ADDRESS))) {
      Socket alone = server.connect(50, HALF_A_HEADER);
      for (int i = 0; i < 2 * TOTAL; i++) {
        server.connect(1 + i % 4, HALF_A_HEADER);
      }
      awaitOpen(TOTAL - 1, sockets.subList(1, sockets.size()));

      assertEquals(200, server.status(51));
      assertTrue(isOpen(alone), "of an address that has one");
    }
  }

  @Test
  void theProxyHasNoLimitByAddress() throws Exception {
    try (Server server =
        start(
            Map.of(
                Setting.CONNECTIONS_PER_ADDRESS, "" + PER_ADDRESS, Setting.PROXY, "127.0.0.1"))) {
      for (int i = 0; i < 2 * PER_ADDRESS; i++) {
        server.connect(1, HALF_A_HEADER);
      }
      for (int i = 0; i < 2 * PER_ADDRESS; i++) {
        server.connect(2, HALF_A_HEADER);
      }

      awaitOpen(PER_ADDRESS, sockets.subList(2 * PER_ADDRESS, sockets.size()));
      assertTrue(
          sockets.subList(0, 2 * PER_ADDRESS).stream().allMatch(ConnectionLimitsTest::isOpen));
    }
  }

  private static boolean isCutWhileItDrips(Socket socket) throws IOException {
    return isCutWhileItDrips(socket, 'x');
  }

  private static boolean isCutWhileItDrips(Socket socket, char drop) throws IOException {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(GUARD_SECONDS);
    socket.setSoTimeout(50);
    while (System.nanoTime() < end) {
      try {
        socket.getOutputStream().write(drop);
        if (socket.getInputStream().read() < 0) {
          return true;
        }
      } catch (SocketTimeoutException e) {
        // still open
      } catch (IOException reset) {
        return true;
      }
    }
    return false;
  }

  private static void awaitOpen(int expected, List<Socket> among) {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(GUARD_SECONDS);
    while (openCount(among) > expected && System.nanoTime() < end) {
      Thread.onSpinWait();
    }
    assertEquals(expected, openCount(among));
  }

  private static long openCount(List<Socket> among) {
    return among.stream().filter(ConnectionLimitsTest::isOpen).count();
  }

  /** Whether the server has not ended it. */
  private static boolean isOpen(Socket socket) {
    try {
      socket.setSoTimeout(1);
      return socket.getInputStream().read() >= 0;
    } catch (SocketTimeoutException e) {
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  /** Asks for a page and takes the answer. */
  private static int status(Socket socket) throws IOException {
    socket.setSoTimeout((int) TimeUnit.SECONDS.toMillis(GUARD_SECONDS));
    socket
        .getOutputStream()
        .write(
            "GET /api/v1/health HTTP/1.1\r\nHost: localhost\r\n\r\n"
                .getBytes(StandardCharsets.US_ASCII));
    StringBuilder head = new StringBuilder();
    while (head.indexOf("\r\n\r\n") < 0) {
      int next = socket.getInputStream().read();
      if (next < 0) {
        throw new IOException("The server has ended it after: " + head);
      }
      head.append((char) next);
    }
    int length =
        Integer.parseInt(head.toString().replaceFirst("(?s).*(?i)content-length: (\\d+).*", "$1"));
    socket.getInputStream().skipNBytes(length);
    return Integer.parseInt(head.substring(9, 12));
  }

  private Server start(Map<Setting, String> more) throws Exception {
    Map<Setting, @Nullable String> settings = new EnumMap<>(Setting.class);
    settings.putAll(more);
    settings.put(Setting.PORT, "0");
    settings.put(Setting.DATA, folder.toString());
    settings.put(Setting.MANAGER, "boss:boss-password");
    settings.put(Setting.REQUESTS_PER_SECOND, "0");
    Configuration configuration =
        Configuration.of(
            WebappFolder.shippedMap(WEBAPP), List.of(SettingSource.fromCommandLine(settings)));
    WebServer web = WebServer.bind(WEBAPP, configuration);
    SiteServers toqa = SiteServers.start(configuration);
    return new Server(web, toqa, web.open(toqa));
  }

  private final class Server implements AutoCloseable {
    private final WebServer web;
    private final SiteServers toqa;
    private final WebServer.RunningWebapp site;

    Server(WebServer web, SiteServers toqa, WebServer.RunningWebapp site) {
      this.web = web;
      this.toqa = toqa;
      this.site = site;
    }

    /** From the address 127.0.0.{@code host}. */
    Socket connect(int host, String beginning) throws IOException {
      Socket socket =
          new Socket(
              InetAddress.ofLiteral("127.0.0.1"),
              site.uri().getPort(),
              InetAddress.ofLiteral("127.0.0." + host),
              0);
      sockets.add(socket);
      socket.setTcpNoDelay(true);
      socket.getOutputStream().write(beginning.getBytes(StandardCharsets.US_ASCII));
      return socket;
    }

    int status(int host) throws IOException {
      return ConnectionLimitsTest.status(connect(host, ""));
    }

    @Override
    public void close() throws IOException {
      site.close();
      toqa.close();
      web.close();
    }
  }
}
