package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.stream.StreamSupport;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.accounts.AccountStore;
import org.toqa.accounts.Role;
import org.toqa.app.command.StopSignal;
import org.toqa.app.config.Configuration;
import org.toqa.app.config.Setting;
import org.toqa.app.config.SettingSource;
import org.toqa.fleet.history.SeenPlaces;
import org.toqa.fleet.history.SeenPlaces.Sighting;
import org.toqa.fleet.supervision.SupervisedBox;
import org.toqa.fleet.supervision.Supervision;
import org.toqa.geometry.Vec2;
import org.toqa.store.Database;
import org.toqa.store.JdbiSightingStore;
import org.toqa.store.JdbiSupervisionStore;
import org.toqa.testbed.ApiClient;
import org.toqa.testbed.ApiClient.Reply;
import org.toqa.web.WebTestServer;
import tools.jackson.databind.JsonNode;

/** Several floors on one server, as programs use them. */
@Tag("full")
class FloorsOfServerTest {
  private static final Path WEBAPP = Path.of("target/webapp").toAbsolutePath();
  private static final Path MAPS = Path.of("maps").toAbsolutePath();
  private static final Map<String, Object> POST_ROOM = Map.of("station", "Post room");
  private static final Map<String, Object> ARCHIVE = Map.of("station", "Archive");

  /** Of orders, at once. */
  private static final int SENDERS = 4;

  @TempDir private Path folder;

  /** What a test does with a running server. */
  @FunctionalInterface
  private interface Use {
    void use(FleetServer toqa, ApiClient api) throws Exception;
  }

  @Test
  void tasksOfTwoFloorsAreCarriedBesideEachOtherAndListedApart() throws Exception {
    run(
        (toqa, api) -> {
          assertEquals(List.of("lab", "offices"), names(api.get("floors")));
          assertEquals(List.of("r1"), names(api.get("robots?floor=lab")));
          assertEquals(List.of("r2"), names(api.get("robots?floor=offices")));
          long steel =
              order(api, Map.of("start", station("Goods-in 1"), "goal", station("Goods-in 2")));
          long post = order(api, Map.of("start", POST_ROOM, "goal", ARCHIVE)); // by its stations
          assertEquals("offices", api.get("tasks/" + post).get("floor").asString());

          await(api, steel, "DONE");
          await(api, post, "DONE");
          assertEquals("r1", robotOf(api, steel));
          assertEquals("r2", robotOf(api, post));
          assertEquals(1, api.get("tasks?floor=offices").size());
          assertEquals(2, api.get("tasks").size());
          assertEquals(1, api.get("statistics?period=today&floor=lab").at("/total/done").asInt());
          for (JsonNode event : api.get("history?floor=offices").get("events")) {
            assertEquals("offices", event.get("floor").asString());
          }
          api.post("fleet/pause", Map.of());
          assertTrue(api.get("fleet").has("pause"));
          whoIsDeletedWhileHeOrdersLeavesNothingOpen(toqa, api);
          api.post("fleet/resume", Map.of());
        });
  }

  /** One after the other, and tables, by connections that go on until they are refused. */
  private static void whoIsDeletedWhileHeOrdersLeavesNothingOpen(FleetServer toqa, ApiClient api)
      throws Exception {
    AccountStore accounts = toqa.services().accounts();
    for (String choice : List.of("cancel", "handOver", "cancel")) {
      long clerk =
          accounts.add("Clara", WebTestServer.PASSWORD_HASH, Role.CLERK, "Max").orElseThrow().id();
      long heir =
          accounts.add("Omar", WebTestServer.PASSWORD_HASH, Role.CLERK, "Max").orElseThrow().id();
      try (ApiClient clara = api.as("Clara", WebTestServer.PASSWORD);
          ExecutorService senders = Executors.newVirtualThreadPerTaskExecutor()) {
        CountDownLatch some = new CountDownLatch(SENDERS);
        List<Future<Integer>> refusals = new ArrayList<>();
        for (int i = 0; i < SENDERS; i++) {
          refusals.add(senders.submit(() -> orderUntilRefused(clara, some)));
        }
        some.await();
        Reply deleted =
            api.delete(
                "users/"
                    + clerk
                    + "?tasks="
                    + choice
                    + "&schedules=remove&tokens=remove&to="
                    + heir);

        assertEquals(204, deleted.status(), () -> deleted.body().toString());
        for (Future<Integer> refusal : refusals) {
          assertEquals(401, refusal.get(1, TimeUnit.MINUTES), "as if not logged in");
        }
      }
      assertEquals(0, api.get("tasks?state=open&user=Clara").size(), choice);
      assertEquals(0, api.get("schedules").size());
      for (JsonNode task : api.get("tasks?state=open&user=Omar&limit=200")) {
        assertTrue(
            api.replyTo("tasks/" + task.get("id").asLong() + "/cancel", Map.of()).isAccepted());
      }
      api.delete("users/" + heir + "?tasks=cancel");
    }
  }

  private static int orderUntilRefused(ApiClient clara, CountDownLatch some) throws Exception {
    Map<String, Object> order =
        Map.of(
            "name",
            "Box",
            "load",
            2,
            "start",
            station("Goods-in 1"),
            "goal",
            station("Goods-in 2"));
    int status = 201;
    while (status == 201 || status == 429) {
      status = clara.replyTo("tasks", order).status();
      some.countDown();
    }
    return status;
  }

  @Test
  void floorIsAddedDrawnPublishedAndRemovedAndARobotIsCarriedToAnotherOne() throws Exception {
    run(
        (toqa, api) -> {
          api.post("floors", Map.of("name", "attic", "width", 6, "height", 6, "resolution", 0.3));
          Reply twice =
              api.replyTo(
                  "floors", Map.of("name", "Attic", "width", 6, "height", 6, "resolution", 0.3));
          assertEquals(422, twice.status());
          JsonNode draft = api.get("floors/attic/draft");
          Map<String, Object> drawing =
              Map.of(
                  "width", 20,
                  "height", 20,
                  "resolution", 0.3,
                  "origin", Map.of("x", 0, "y", 0),
                  "occupied", List.of(),
                  "stations", List.of(place("Hatch", 0.75), place("Window", 5.25)),
                  "parking", List.of(),
                  "charging", List.of(),
                  "moves", "smooth");
          Map<String, Object> change =
              Map.of("revision", draft.get("revision").asLong(), "drawing", drawing);
          JsonNode saved = api.put("floors/attic/draft", change).body();
          assertEquals(412, api.put("floors/attic/draft", change).status(), "it has changed");
          api.post(
              "floors/attic/draft/publish", Map.of("revision", saved.get("revision").asLong()));
          assertEquals(2, api.get("map?floor=attic").get("stations").size());

          long task = order(api, Map.of("start", station("Hatch"), "goal", station("Window")));
          assertEquals(409, api.delete("floors/attic").status(), "it has a task");
          api.post("tasks/" + task + "/cancel", Map.of());
          await(api, task, "CANCELLED");

          Map<String, Object> order =
              Map.of(
                  "name", "Box", "load", 2, "start", station("Hatch"), "goal", station("Window"));
          long schedule =
              api.post("schedules", Map.of("task", order, "at", "2099-01-01T10:00:00Z"))
                  .get("id")
                  .asLong();
          assertEquals(1, api.get("schedules?floor=attic").size(), "its stations are there");
          assertEquals(0, api.get("schedules?floor=lab").size());
          assertEquals(409, api.delete("floors/attic").status(), "it has a schedule");
          assertTrue(api.delete("schedules/" + schedule).isAccepted());
          carryToOffices(toqa, api);
        });
    storeWorkOfAttic();
    run(
        (toqa, api) -> {
          assertEquals(List.of("lab", "offices", "attic"), names(api.get("floors")));
          assertEquals(2, api.get("map?floor=attic").get("stations").size());
          assertEquals("smooth", api.get("floors/attic").at("/drawing/moves").asString());
          atticIsRemovedWithAllThatIsKeptOfIt(api);
          carryBackToLab(toqa, api);
          assertEquals(409, api.delete("floors/lab").status(), "it has a robot");
        });
    // as a server leaves it that was killed after the move was stored, before the body was carried
    Files.writeString(folder.resolve("robots/r1/floor"), "offices");
    run(
        (toqa, api) -> {
          assertEquals(List.of("lab", "offices"), names(api.get("floors")));
          api.awaitSnapshot(
              snapshot -> isAt(snapshot, "r1", 1.95, 4.65) && isTrulyAt(toqa, "r1", 1.95, 4.65));
          addEmptyAttic(api);
          assertAtticIsNew(api);
        });
  }

  /** What robots saw there, and a supervision that has ended. */
  private void storeWorkOfAttic() {
    try (Database database = Database.open(Database.fileUrl(folder.resolve("toqa")), "", "")) {
      Instant now = Instant.now();
      Sighting seen = new Sighting(now.minusSeconds(7200), now, Set.of("r1", "r2"), false);
      new JdbiSightingStore(database.jdbi())
          .replace(Map.of(new SeenPlaces.Spot("attic", 3150, 3150), seen));
      SupervisedBox box =
          new SupervisedBox(1, new Vec2(2, 2), new Vec2(3, 3), null, null, 1, false);
      new JdbiSupervisionStore(database.jdbi())
          .save(
              new Supervision(
                  "attic",
                  "run",
                  "r1",
                  List.of("r2"),
                  true,
                  "Max",
                  Supervision.State.STOPPED,
                  now,
                  now,
                  0,
                  Map.of(1, box),
                  ""),
              List.of());
    }
  }

  private static void atticIsRemovedWithAllThatIsKeptOfIt(ApiClient api) throws Exception {
    assertEquals(1, api.get("floors/attic/seen").size());
    assertEquals("STOPPED", api.get("floors/attic/supervision").get("state").asString());
    Map<String, Object> order =
        Map.of(
            "ground", "floor:offices",
            "start", Map.of("x", 13.35, "y", 6.45),
            "target", Map.of("x", 0.75, "y", 4.05));
    api.post("floors/attic/exploration", order);
    assertRefused("explored", api.delete("floors/attic"));
    api.post("floors/attic/exploration/stop", Map.of());
    Map<String, Object> watching =
        Map.of("name", "Hatch", "url", "http://127.0.0.1:1/", "floor", "attic");
    long camera = api.post("cameras", watching).get("id").asLong();
    assertRefused("Cameras watch", api.delete("floors/attic"));
    assertTrue(api.delete("cameras/" + camera).isAccepted());
    Map<String, Object> task =
        Map.of("floor", "attic", "load", 2, "start", station("Hatch"), "goal", station("Window"));
    long template = api.post("templates", Map.of("name", "Post", "order", task)).get("id").asLong();
    assertRefused("Templates of tasks", api.delete("floors/attic"));
    assertTrue(api.delete("templates/" + template).isAccepted());

    assertTrue(api.delete("floors/attic").isAccepted());
    addEmptyAttic(api);
    assertAtticIsNew(api);
    assertTrue(api.get("history?floor=attic").toString().contains("exploration.began"), "it stays");
    assertTrue(api.delete("floors/attic").isAccepted());
  }

  private static void assertRefused(String why, Reply reply) {
    assertEquals(409, reply.status());
    assertTrue(reply.body().get("detail").asString().contains(why), reply.body()::toString);
  }

  private static void addEmptyAttic(ApiClient api) throws Exception {
    api.post("floors", Map.of("name", "attic", "width", 6, "height", 6, "resolution", 0.3));
  }

  private static void assertAtticIsNew(ApiClient api) throws Exception {
    assertEquals(0, api.get("floors/attic/seen").size());
    for (String last : List.of("supervision", "exploration")) {
      assertEquals(404, api.replyTo("floors/attic/" + last).status(), last);
    }
  }

  /** Out of service, it is put where another one stands, and then where it can stand. */
  private static void carryToOffices(FleetServer toqa, ApiClient api) throws Exception {
    assertEquals(
        409, api.replyTo("robots/r1/move", move("offices", 0.75, 4.05)).status(), "in service");
    api.post("robots/r1/out-of-service", Map.of());
    assertEquals(
        422, api.replyTo("robots/r1/move", move("offices", 0.75, 4.65)).status(), "r2 is there");
    assertEquals(List.of("r1"), names(api.get("robots?floor=lab")));

    JsonNode moved = api.post("robots/r1/move", move("offices", 13.35, 6.45));
    assertEquals("offices", moved.get("floor").asString());
    assertEquals(List.of(), names(api.get("robots?floor=lab")));
    api.post("robots/r1/in-service", Map.of());
    api.awaitSnapshot(
        snapshot -> isAt(snapshot, "r1", 13.35, 6.45) && isTrulyAt(toqa, "r1", 13.35, 6.45));
    api.post("robots/r2/out-of-service", Map.of());
    long post = order(api, Map.of("start", POST_ROOM, "goal", ARCHIVE));
    await(api, post, "DONE");
    assertEquals("r1", robotOf(api, post));
    api.post("robots/r1/out-of-service", Map.of());
  }

  private static void carryBackToLab(FleetServer toqa, ApiClient api) throws Exception {
    assertEquals(List.of("r1", "r2"), names(api.get("robots?floor=offices")));
    api.awaitSnapshot(
        snapshot -> isAt(snapshot, "r1", 5.85, 2.25) && isTrulyAt(toqa, "r1", 5.85, 2.25));
    api.post("robots/r1/move", move("lab", 1.95, 4.65));
    api.awaitSnapshot(snapshot -> isTrulyAt(toqa, "r1", 1.95, 4.65));
  }

  private static Map<String, Object> move(String floor, double x, double y) {
    return Map.of("floor", floor, "x", x, "y", y, "theta", 0);
  }

  private static boolean isAt(JsonNode snapshot, String robot, double x, double y) {
    return StreamSupport.stream(snapshot.get("robots").spliterator(), false)
        .anyMatch(
            r ->
                r.get("name").asString().equals(robot)
                    && Math.hypot(r.at("/pose/x").asDouble() - x, r.at("/pose/y").asDouble() - y)
                        < 0.2);
  }

  private static boolean isTrulyAt(FleetServer toqa, String robot, double x, double y) {
    return toqa.truePose(robot)
        .filter(truth -> truth.position().distanceTo(new Vec2(x, y)) < 0.2)
        .isPresent();
  }

  private void run(Use use) throws Exception {
    Map<Setting, @Nullable String> options = new EnumMap<>(Setting.class);
    options.put(Setting.PORT, "0");
    options.put(Setting.DATA, folder.toString());
    options.put(
        Setting.MAP, MAPS.resolve("lab.yaml") + File.pathSeparator + MAPS.resolve("offices.yaml"));
    options.put(Setting.SIMULATE, "1,1");
    options.put(Setting.SPEED, "40");
    options.put(Setting.MANAGER, "Max:" + WebTestServer.PASSWORD_HASH);
    options.put(Setting.LOG_LEVEL, "ERROR");
    Configuration configuration =
        Configuration.of(MAPS.resolve("lab.yaml"), List.of(SettingSource.fromCommandLine(options)));
    ServerOperation operation =
        (FleetServer toqa, URI address, StopSignal _) -> {
          try (ApiClient api = new ApiClient(address, "Max", WebTestServer.PASSWORD)) {
            use.use(toqa, api);
          }
          return 0;
        };
    try (StopSignal stop = new StopSignal()) {
      assertEquals(0, operation.runWith(configuration, WEBAPP, stop));
    }
  }

  private static Map<String, Object> station(String name) {
    return Map.of("station", name);
  }

  private static Map<String, Object> place(String name, double at) {
    return Map.of("name", name, "x", at, "y", at);
  }

  private static long order(ApiClient api, Map<String, Object> places) throws Exception {
    return api.post(
            "tasks",
            Map.of(
                "name", "Box", "load", 2, "start", places.get("start"), "goal", places.get("goal")))
        .get("id")
        .asLong();
  }

  private static void await(ApiClient api, long task, String state) throws Exception {
    api.awaitSnapshot(
        snapshot ->
            StreamSupport.stream(snapshot.get("tasks").spliterator(), false)
                .anyMatch(
                    t -> t.get("id").asLong() == task && t.get("state").asString().equals(state)));
  }

  private static String robotOf(ApiClient api, long task) throws Exception {
    return api.get("tasks/" + task).get("robots").get(0).asString();
  }

  private static List<String> names(JsonNode list) {
    return StreamSupport.stream(list.spliterator(), false)
        .map(one -> one.get("name").asString())
        .toList();
  }
}
