package org.toqa.notices;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.net.httpserver.HttpServer;
import java.io.File;
import java.lang.reflect.Proxy;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.persistence.StoreException;
import org.toqa.store.Database;
import org.toqa.store.JdbiNoticeStore;

/**
 * What was accepted by a process that was killed is told by the next one; what was told and not
 * noted is told again with the same id.
 */
@Tag("full")
class NoticesKilledTest {
  private static final Pattern UID = Pattern.compile("\"id\":\"([0-9a-f-]{36})\"");

  /** By the message's id, how often it came. */
  private final Map<String, Integer> messages = new ConcurrentHashMap<>();

  /** The notices of the messages. */
  private final Map<String, String> notices = new ConcurrentHashMap<>();

  @TempDir private Path folder;

  @Test
  @Timeout(120)
  void whatWasAcceptedIsToldAfterAKill() throws Exception {
    HttpServer receiver =
        HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    receiver.createContext(
        "/",
        exchange -> {
          String body =
              new String(exchange.getRequestBody().readAllBytes(), StandardCharsets.UTF_8);
          String id = exchange.getRequestHeaders().getFirst("webhook-id");
          var uid = UID.matcher(body);
          notices.put(id, uid.find() ? uid.group(1) : "");
          messages.merge(id, 1, Integer::sum);
          exchange.sendResponseHeaders(204, -1);
          exchange.close();
        });
    receiver.start();
    try {
      List<String> accepted =
          acceptedBy(process("http://127.0.0.1:" + receiver.getAddress().getPort() + "/"));
      assertEquals(AcceptingProcess.NOTICES, accepted.size());
      assertEquals(Map.of(), messages);

      try (Database database = AcceptingProcess.open(file())) {
        NoticeStore store = new JdbiNoticeStore(database.jdbi());
        // one that dies each time between what it tells and what it notes
        try (Outbox _ = outbox(withoutMemory(store))) {
          awaitMessages(2, 1);
        }
        assertTrue(messages.size() == 1, messages::toString);
        try (Outbox _ = outbox(store)) {
          awaitMessages(1, AcceptingProcess.NOTICES);
        }
      }
      assertEquals(new TreeSet<>(accepted), new TreeSet<>(notices.values()));
      assertEquals(AcceptingProcess.NOTICES, messages.size());
    } finally {
      receiver.stop(0);
    }
  }

  private void awaitMessages(int times, int ids) throws InterruptedException {
    while (messages.values().stream().filter(n -> n >= times).count() < ids) {
      Thread.sleep(5);
    }
  }

  private static NoticeStore withoutMemory(NoticeStore store) {
    return (NoticeStore)
        Proxy.newProxyInstance(
            NoticeStore.class.getClassLoader(),
            new Class<?>[] {NoticeStore.class},
            (_, method, arguments) -> {
              if (method.getName().equals("setSent")) {
                throw new StoreException(
                    StoreException.Kind.UNAVAILABLE, "it is gone", new IllegalStateException());
              }
              return method.invoke(store, arguments);
            });
  }

  private static Outbox outbox(NoticeStore store) {
    InstantSource clock = InstantSource.system();
    WebhookAddresses loopback =
        new WebhookAddresses(List.of(WebhookAddresses.Network.parse("127.0.0.1").orElseThrow()));
    return new Outbox(
        store, null, new WebhookPoster("main", loopback, clock), clock, Duration.ofMillis(5));
  }

  private static List<String> acceptedBy(Process process) throws Exception {
    List<String> lines = process.inputReader().lines().toList();
    process.waitFor(1, TimeUnit.MINUTES);
    assertEquals(137, process.exitValue());
    return lines;
  }

  private Process process(String url) throws Exception {
    return new ProcessBuilder(
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-XX:TieredStopAtLevel=1",
            "-XX:+UseSerialGC",
            "--sun-misc-unsafe-memory-access=allow",
            "-cp",
            System.getProperty("surefire.test.class.path", System.getProperty("java.class.path")),
            AcceptingProcess.class.getName(),
            file().toString(),
            url)
        .redirectError(new File(folder.toFile(), "errors"))
        .start();
  }

  private Path file() {
    return folder.resolve("toqa");
  }
}
