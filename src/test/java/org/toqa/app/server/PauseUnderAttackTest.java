package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.random.RandomGenerator;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.app.config.Setting;
import org.toqa.fleet.RobotState;
import org.toqa.web.TestClient;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * Robots are stopped while connections are held open, streams are read to their limit and previews
 * are asked for as fast as they are answered, all at once.
 */
@Tag("full")
class PauseUnderAttackTest {
  private static final JsonMapper JSON = JsonMapper.shared();

  /** More than the server has; of each address fewer than one may have. */
  private static final int SLOW = 1000;

  private static final int ADDRESSES = 5;
  private static final int CONNECTIONS = 600;

  /** Of those that everybody else has. */
  private static final int RESERVED = 150;

  private static final int STREAMS_PER_USER = 30;
  private static final int CHECKS_PER_USER = 8;
  private static final int PREVIEWERS = 3 * CHECKS_PER_USER;

  /** A guard for a loaded machine; alone it takes about a second. */
  private static final long GUARD_SECONDS = 60;

  @TempDir private Path data;

  private final AtomicBoolean isOver = new AtomicBoolean();
  private final AtomicInteger slowCount = new AtomicInteger();
  private final List<AutoCloseable> streams = new ArrayList<>();
  private AttackedServer server;
  private TestClient manager;
  private TestClient attacker;

  @BeforeEach
  void start() throws Exception {
    server =
        AttackedServer.start(
            data,
            Map.of(
                Setting.PROXY, "",
                Setting.CONNECTIONS, "" + CONNECTIONS,
                Setting.STREAMS_PER_USER, "" + STREAMS_PER_USER,
                Setting.CHECKS_PER_USER, "" + CHECKS_PER_USER));
    manager = server.signedIn(AttackedServer.MANAGER);
    attacker = server.signedIn(AttackedServer.CLERK);
  }

  @AfterEach
  void stop() throws Exception {
    isOver.set(true);
    for (AutoCloseable stream : streams) {
      stream.close();
    }
    server.close();
  }

  @Test
  void everyRobotStandsWhenSomebodyPausesAll() throws Exception {
    CarriedTasks tasks = new CarriedTasks(manager, "Carried until the pause");
    await("a robot drives", () -> states().contains(RobotState.DRIVING.name()));
    try (ExecutorService threads = Executors.newVirtualThreadPerTaskExecutor();
        AutoCloseable _ = () -> isOver.set(true)) {
      AtomicInteger previewed = new AtomicInteger();
      AtomicInteger refused = new AtomicInteger();
      String attackersCsrf = attacker.csrf();
      for (int i = 0; i < PREVIEWERS; i++) {
        threads.execute(() -> preview(attackersCsrf, previewed, refused));
      }
      openStreams();
      for (int i = 0; i < ADDRESSES; i++) {
        int host = 2 + i;
        threads.execute(() -> holdOpen(host));
      }
      await("the server is full", () -> slowCount.get() >= CONNECTIONS - RESERVED);
      await("previews are made and refused", () -> previewed.get() > 0 && refused.get() > 0);

      tasks.goOn();
      long begun = System.nanoTime();
      TestClient newcomer = server.signedIn(AttackedServer.MANAGER);
      String csrf = newcomer.csrf();
      HttpResponse<String> byApi = newcomer.sendJson("POST", "api/v1/fleet/pause", "{}", csrf);
      HttpResponse<String> byPage = newcomer.postWithoutToken("fleet/pause", Map.of("_csrf", csrf));
      String hold = "api/v1/robots/" + robots().get(0).get("name").asString() + "/hold";
      HttpResponse<String> ofOne = newcomer.sendJson("POST", hold, "{}", csrf);
      long seconds = TimeUnit.NANOSECONDS.toSeconds(System.nanoTime() - begun);

      assertEquals(200, byApi.statusCode(), byApi.body());
      assertEquals(303, byPage.statusCode(), byPage.body());
      assertEquals(200, ofOne.statusCode(), ofOne.body());
      assertTrue(seconds < GUARD_SECONDS, () -> "after " + seconds + " s");
      assertEquals(200, server.stranger().get("api/v1/health").statusCode());
      await("no robot drives", () -> !states().contains(RobotState.DRIVING.name()));
    }
  }

  private void preview(String csrf, AtomicInteger previewed, AtomicInteger refused) {
    RandomGenerator random = RandomGenerator.getDefault();
    while (!isOver.get()) {
      String order =
          """
          {"name": "x", "load": %s, "start": {"station": "Goods-in 1"},
           "goal": {"station": "Mill"}, "size": {"length": %s, "width": 0.4}}
          """
              .formatted(6 + random.nextInt(4), 0.4 + random.nextInt(1000) / 4000.0);
      try {
        int status = attacker.sendJson("POST", "api/v1/tasks/preview", order, csrf).statusCode();
        (status == 429 ? refused : previewed).incrementAndGet();
      } catch (RuntimeException e) {
        // his connection was given to somebody else
      }
    }
  }

  private void openStreams() {
    int open = 0;
    HttpRequest request = attacker.request("api/v1/events").build();
    var stream = attacker.send(request, BodyHandlers.ofInputStream());
    while (stream.statusCode() == 200) {
      streams.add(stream.body());
      open++;
      assertTrue(open <= STREAMS_PER_USER, "more than one user may have");
      stream = attacker.send(request, BodyHandlers.ofInputStream());
    }
    assertEquals(429, stream.statusCode());
    assertEquals(STREAMS_PER_USER, open);
  }

  /** One address keeps its connections: a letter now and then, and who is cut comes again. */
  private void holdOpen(int host) {
    List<Socket> sockets = new ArrayList<>();
    while (!isOver.get()) {
      sockets.removeIf(this::isCut);
      while (sockets.size() < SLOW / ADDRESSES && !isOver.get()) {
        try {
          sockets.add(connect(host));
          slowCount.incrementAndGet();
        } catch (IOException full) {
          break;
        }
      }
      LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(500));
    }
    sockets.forEach(PauseUnderAttackTest::close);
  }

  private boolean isCut(Socket socket) {
    try {
      socket.getOutputStream().write('n');
      return false;
    } catch (IOException cut) {
      slowCount.decrementAndGet();
      close(socket);
      return true;
    }
  }

  private Socket connect(int host) throws IOException {
    Socket socket = new Socket();
    try {
      socket.bind(new InetSocketAddress(InetAddress.ofLiteral("127.0.0." + host), 0));
      socket.connect(new InetSocketAddress(server.root().getHost(), server.root().getPort()), 1000);
      socket
          .getOutputStream()
          .write("POST / HTTP/1.1\r\nHost: localhost\r\nConte".getBytes(StandardCharsets.US_ASCII));
      return socket;
    } catch (IOException full) {
      close(socket);
      throw full;
    }
  }

  private static void close(Socket socket) {
    try {
      socket.close();
    } catch (IOException gone) {
      // so it is closed
    }
  }

  private JsonNode robots() {
    return JSON.readTree(manager.get("api/v1/robots").body());
  }

  private List<String> states() {
    List<String> states = new ArrayList<>();
    robots().forEach(robot -> states.add(robot.get("state").asString()));
    return states;
  }

  private interface Condition {
    boolean holds();
  }

  private static void await(String what, Condition condition) throws InterruptedException {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(120);
    while (!condition.holds()) {
      assertTrue(System.nanoTime() < end, what);
      TimeUnit.MILLISECONDS.sleep(20);
    }
  }
}
