package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.lang.management.ManagementFactory;
import java.net.Socket;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import javax.management.MBeanServer;
import javax.management.ObjectName;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.app.config.Setting;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Very many connections at once, while the fleet carries tasks. */
@Tag("full")
class CrowdTest {
  private static final JsonMapper JSON = JsonMapper.shared();
  private static final int STREAMS = 1000;

  /** Of so many streams one is read as a browser does, the others are only taken. */
  private static final int STREAMS_A_BROWSER = 20;

  /** Connections that are left to everybody else, with those that the container has in reserve. */
  private static final int LEFT = 150;

  @TempDir private Path data;

  private AttackedServer server;
  private TestClient manager;
  private CarriedTasks tasks;

  @BeforeEach
  void start() throws Exception {
    server =
        AttackedServer.start(
            data,
            Map.of(Setting.REQUEST_SECONDS, "600")); // of slow ones there are as many as can be
    manager = server.signedIn(AttackedServer.MANAGER);
    tasks = new CarriedTasks(manager, "Carried through the crowd");
  }

  @AfterEach
  void stop() throws Exception {
    server.close();
  }

  @Test
  void halfRequestsUpToTheServersLimitKeepNobodyWaiting() throws Exception {
    int limit = connections("maxConnections") - LEFT;
    assertTrue(limit > 1000, "a limit of " + limit);
    List<Socket> slow = new CopyOnWriteArrayList<>();
    Thread trickle = Thread.ofVirtual().start(() -> trickle(slow));
    try {
      for (int i = 0; i < limit; i++) {
        slow.add(send("POST / HTTP/1.1\r\nHost: localhost\r\nConte"));
      }
      awaitConnections(limit);

      for (String page : List.of("map", "tasks", "robots", "api/v1/robots")) {
        assertEquals(200, manager.get(page).statusCode(), page);
      }
      tasks.awaitDone();

      trickle.interrupt();
      slow.getFirst().setSoTimeout(60_000); // the server's own patience is 20 s
      assertTrue(slow.getFirst().getInputStream().readAllBytes().length < 1000);
    } finally {
      trickle.interrupt();
      close(slow);
    }
  }

  /** Sockets are open before the server has taken them. */
  private void awaitConnections(int least) throws Exception {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
    while (connections("connectionCount") < least) {
      assertTrue(System.nanoTime() < end, "the server has not taken all, or has dropped some");
      TimeUnit.MILLISECONDS.sleep(20);
    }
  }

  /** A letter from each now and then, so that the server does not lose its patience. */
  private static void trickle(List<Socket> slow) {
    while (!Thread.interrupted()) {
      for (Socket socket : slow) {
        try {
          socket.getOutputStream().write('n');
        } catch (IOException e) {
          // the server's count of connections shows it
        }
      }
      LockSupport.parkNanos(TimeUnit.SECONDS.toNanos(1));
    }
  }

  @Test
  void aThousandLiveStreamsSeeATaskToItsEnd() throws Exception {
    long task = tasks.task();
    String token = token();
    CountDownLatch open = new CountDownLatch(STREAMS);
    CountDownLatch done = new CountDownLatch(STREAMS / STREAMS_A_BROWSER);
    AtomicInteger ended = new AtomicInteger();
    List<Socket> streams = new ArrayList<>();
    try {
      for (int i = 0; i < STREAMS; i++) {
        Socket stream =
            send(
                "GET /api/v1/events HTTP/1.1\r\nHost: localhost\r\nAuthorization: Bearer %s\r\n\r\n"
                    .formatted(token));
        streams.add(stream);
        boolean isBrowser = i % STREAMS_A_BROWSER == 0;
        Thread.ofVirtual()
            .start(
                () -> {
                  try {
                    read(stream, isBrowser ? task : -1, open, done);
                  } catch (IOException e) {
                    // it is counted
                  }
                  ended.incrementAndGet();
                });
      }
      assertTrue(open.await(60, TimeUnit.SECONDS), () -> open.getCount() + " streams are not open");
      tasks.awaitDone();
      assertTrue(done.await(60, TimeUnit.SECONDS), () -> done.getCount() + " saw no end of it");
      assertEquals(0, ended.get(), "streams that the server has ended");
      assertEquals(200, manager.get("map").statusCode());
    } finally {
      close(streams);
    }
  }

  /**
   * Takes all that comes.
   *
   * @param task whose end is looked for; -1: none
   */
  private static void read(Socket stream, long task, CountDownLatch open, CountDownLatch done)
      throws IOException {
    BufferedReader lines =
        new BufferedReader(new InputStreamReader(stream.getInputStream(), StandardCharsets.UTF_8));
    if ("HTTP/1.1 200 ".equals(lines.readLine())) {
      open.countDown();
    }
    boolean isDone = task < 0;
    for (String line = lines.readLine(); line != null; line = lines.readLine()) {
      if (!isDone && line.startsWith("data: ") && line.contains("\"DONE\"")) {
        for (JsonNode shown : JSON.readTree(line.substring("data: ".length())).path("tasks")) {
          isDone |=
              shown.path("id").asLong() == task && shown.path("state").asString().equals("DONE");
        }
        if (isDone) {
          done.countDown();
        }
      }
    }
  }

  private String token() {
    String body =
        JSON.writeValueAsString(
            Map.of("name", AttackedServer.CLERK, "password", WebTestServer.PASSWORD));
    HttpResponse<String> answer =
        manager.send(
            manager
                .request("api/v1/session")
                .header("Content-Type", "application/json")
                .POST(BodyPublishers.ofString(body))
                .build());
    return JSON.readTree(server.observed(answer).body()).get("token").asString();
  }

  private Socket send(String request) throws IOException {
    Socket socket = new Socket(server.root().getHost(), server.root().getPort());
    socket.getOutputStream().write(request.getBytes(StandardCharsets.US_ASCII));
    return socket;
  }

  private static void close(List<Socket> sockets) throws IOException {
    for (Socket socket : sockets) {
      socket.close();
    }
  }

  /** What the container says of the connections to its port. */
  private int connections(String attribute) throws Exception {
    MBeanServer beans = ManagementFactory.getPlatformMBeanServer();
    for (ObjectName name : beans.queryNames(new ObjectName("*:type=ThreadPool,name=*"), null)) {
      if (beans.getAttribute(name, "localPort").equals(server.root().getPort())) {
        return Integer.parseInt(String.valueOf(beans.getAttribute(name, attribute)));
      }
    }
    throw new AssertionError("The container says nothing of its connections.");
  }
}
