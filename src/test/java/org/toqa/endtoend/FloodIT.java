package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Anonymous clients ask as fast as they can while robots carry. */
@Tag("full")
class FloodIT {
  private static final int CLIENTS = 4;

  @TempDir private Path folder;

  @Test
  void theFleetDrivesOnAndItsManagerIsAnswered() throws Exception {
    Path config = Files.writeString(folder.resolve("server.yaml"), "requestsPerSecond: 50\n");
    AtomicBoolean isOver = new AtomicBoolean();
    try (RunningServer server =
            new RunningServer(
                folder, "--config", config.toString(), "--simulate", "3", "--speed", "30");
        ExecutorService clients = Executors.newFixedThreadPool(CLIENTS)) {
      List<Future<Long>> refused = new ArrayList<>();
      for (int i = 0; i < CLIENTS; i++) {
        refused.add(clients.submit(() -> flood(server.root(), isOver)));
      }
      try {
        long task = server.addTask("crate", "Workbench 1", "Packing 1");
        server.awaitState(task, "DONE");

        assertEquals(1, server.eventCount(task, "Delivered"));
        assertEquals("UP", server.api().get("health").get("status").asString());
      } finally {
        isOver.set(true);
      }
      for (Future<Long> one : refused) {
        assertTrue(one.get() > 0, "a client was never told to wait");
      }
    }
  }

  /** How many of the requests were told to wait. */
  private static long flood(URI root, AtomicBoolean isOver) throws Exception {
    HttpRequest request = HttpRequest.newBuilder(root).build();
    long refused = 0;
    try (HttpClient http = HttpClient.newHttpClient()) {
      while (!isOver.get()) {
        refused += http.send(request, BodyHandlers.discarding()).statusCode() == 429 ? 1 : 0;
      }
    }
    return refused;
  }
}
