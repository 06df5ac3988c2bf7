package org.toqa.app.server;

import static java.util.Objects.requireNonNull;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.sql.Connection;
import java.sql.DriverManager;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import org.h2.engine.SessionLocal;
import org.h2.jdbc.JdbcConnection;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.app.command.StopSignal;
import org.toqa.app.config.Configuration;
import org.toqa.app.config.Setting;
import org.toqa.app.config.SettingSource;
import org.toqa.fleet.history.EventArchive;
import org.toqa.sim.VirtualClock;
import org.toqa.store.Database;
import org.toqa.store.JdbiEventArchive;

/** A server of which a part has failed. */
class FailedServerTest {
  private static final Path WEBAPP = Path.of("target/webapp").toAbsolutePath();
  private static final long GUARD_SECONDS = 60;

  @TempDir private Path folder;

  @Test
  void itsProcessEndsWhenItsClockHas() throws Exception {
    int code =
        run(
            (toqa, address, stop) -> {
              toqa.fleetClock()
                  .add(
                      nanos -> {
                        throw new OutOfMemoryError("said by the test");
                      },
                      VirtualClock.STEP);
              stop.await();
              return 0;
            });

    assertEquals(1, code);
  }

  /** As H2 does where the disk is full. */
  @Test
  void itsProcessEndsWhenItsDatabaseHasClosedItsFile() throws Exception {
    int code =
        run(
            (toqa, address, stop) -> {
              String file = Database.fileUrl(folder.resolve("toqa"));
              try (Connection connection = DriverManager.getConnection(file)) {
                ((SessionLocal) connection.unwrap(JdbcConnection.class).getSession())
                    .getDatabase()
                    .shutdownImmediately();
              }
              stop.await();
              return 0;
            });

    assertEquals(1, code);
    assertEquals(0, run((_, _, _) -> 0), "it starts again");
  }

  /** What a killed process leaves is what its files were. */
  @Test
  void aServerThatWasKilledIsInTheHistoryFromTheNextStart() throws Exception {
    Path left = folder.resolve("left");
    run(
        (toqa, address, stop) -> {
          Files.createDirectories(left);
          Files.copy(folder.resolve("toqa.mv.db"), left.resolve("toqa.mv.db"));
          return 0;
        });
    assertEquals(0, run((_, _, _) -> 0), "it was stopped");
    assertEquals(0, killsTold(folder));
    assertEquals(2, told(folder, "fleet.server-started"));
    assertEquals(2, told(folder, "fleet.server-stopped"));
    run((_, _, _) -> 0, Map.of(Setting.DATA, left.toString()));
    assertEquals(1, killsTold(left));
    run((_, _, _) -> 0, Map.of(Setting.DATA, left.toString()));
    assertEquals(1, killsTold(left), "told once");
  }

  private static int killsTold(Path data) {
    return told(data, "fleet.server-ended");
  }

  private static int told(Path data, String kind) {
    EventArchive.Filter ended = new EventArchive.Filter(null, null, null, kind, null, null, false);
    try (Database database = Database.open(Database.fileUrl(data.resolve("toqa")), "", "")) {
      return new JdbiEventArchive(database.jdbi()).events(ended, Long.MAX_VALUE, 10).size();
    }
  }

  @Test
  void itIsDownWhenAPartOfItsWorldIsLost() throws Exception {
    int code =
        run(
            (toqa, address, stop) -> {
              assertEquals(200, health(address).statusCode());
              toqa.fleetClock()
                  .add(
                      nanos -> {
                        throw new IllegalStateException("said by the test");
                      },
                      VirtualClock.STEP);
              HttpResponse<String> answer = health(address);
              long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(GUARD_SECONDS);
              while (answer.statusCode() == 200) {
                assertTrue(System.nanoTime() < end, "it does not come to be known");
                TimeUnit.MILLISECONDS.sleep(10);
                answer = health(address);
              }
              assertTrue(answer.body().contains("\"DOWN\""), answer.body());
              assertTrue(answer.body().contains("The clock that drives the fleet"), answer.body());
              return 0;
            });

    assertEquals(0, code);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "jdbc:mysql://127.0.0.1:1/toqa?user=toqa&password=tell-nobody",
        "jdbc:mysql://toqa:tell-nobody@127.0.0.1:1/toqa"
      })
  void whyItsDatabaseCannotBeUsedIsSaidWithoutItsPassword(String url) {
    Exception failure =
        assertThrows(
            ExecutionException.class,
            () -> run((toqa, address, stop) -> 0, Map.of(Setting.DATABASE_URL, url)));

    assertEquals(
        "The database jdbc:mysql://127.0.0.1:1/toqa cannot be used: Connection refused",
        requireNonNull(failure.getCause()).getMessage());
  }

  private int run(ServerOperation operation) throws Exception {
    return run(operation, Map.of());
  }

  private int run(ServerOperation operation, Map<Setting, String> more) throws Exception {
    Map<Setting, @Nullable String> options = new EnumMap<>(Setting.class);
    options.putAll(more);
    options.put(Setting.PORT, "0");
    options.putIfAbsent(Setting.DATA, folder.toString());
    options.put(Setting.MANAGER, "boss:boss-password");
    Configuration configuration =
        Configuration.of(
            WebappFolder.shippedMap(WEBAPP), List.of(SettingSource.fromCommandLine(options)));
    try (StopSignal stop = new StopSignal()) {
      CompletableFuture<Integer> code = new CompletableFuture<>();
      Thread thread =
          Thread.ofPlatform()
              .daemon()
              .start(
                  () -> {
                    try {
                      code.complete(operation.runWith(configuration, WEBAPP, stop));
                    } catch (Exception | AssertionError e) {
                      code.completeExceptionally(e);
                    }
                  });
      try {
        return code.get(GUARD_SECONDS, TimeUnit.SECONDS);
      } finally {
        thread.interrupt();
      }
    }
  }

  private static HttpResponse<String> health(URI address) throws Exception {
    try (HttpClient http = HttpClient.newHttpClient()) {
      return http.send(
          HttpRequest.newBuilder(address.resolve("api/v1/health")).build(),
          HttpResponse.BodyHandlers.ofString());
    }
  }
}
