package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URI;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.accounts.Role;
import org.toqa.app.config.Configuration;
import org.toqa.app.config.Setting;
import org.toqa.app.config.SettingSource;
import org.toqa.testbed.ApiClient;
import org.toqa.testbed.CheapPassword;
import org.toqa.testbed.Tally;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;
import org.toqa.web.route.Rights;
import tools.jackson.databind.JsonNode;

/** Several sites on one server: their people, what they see of each other, and how sites end. */
@Tag("full")
class SitesTest {
  private static final Path WEBAPP = Path.of("target/webapp").toAbsolutePath();
  private static final String PASSWORD = WebTestServer.PASSWORD;

  /** Of whatever the first site has: in no answer to somebody of another. */
  private static final String SECRET = "Zanzibar";

  @TempDir private Path folder;

  /** What a test does with a running server. */
  @FunctionalInterface
  private interface Use {
    void use(SiteServers sites, URI root) throws Exception;
  }

  @Test
  void siteHasPeopleFloorsAndWorkOfItsOwnAlsoAfterARestart() throws Exception {
    run(
        (sites, root) -> {
          addSite(root, "north");
          try (ApiClient north = new ApiClient(root, "Nora@North", PASSWORD)) {
            assertEquals(List.of("lab"), names(north.get("floors")));
            assertEquals("north", north.get("floors").get(0).get("site").asString());
            assertEquals(0, north.get("robots").size());
            assertEquals(List.of("Nora"), names(north.get("users")));
            north.post("users", Map.of("name", "Max", "password", PASSWORD, "role", "CLERK"));
            assertEquals(201, addRobot(north, "r1"), "the first site has another r1");
            assertEquals(422, addRobot(north, "R1"), "its name is taken there");
            assertEquals(422, north.replyTo("users", administrator()).status());
          }
          try (ApiClient max = new ApiClient(root, "Max", PASSWORD);
              ApiClient ofMain = new ApiClient(root, "Max@main", PASSWORD);
              ApiClient ofNorth = new ApiClient(root, "Max@north", PASSWORD)) {
            assertEquals("ADMINISTRATOR", max.get("users").get(0).get("role").asString());
            assertEquals(List.of("Max"), names(ofMain.get("users")));
            assertEquals("CLERK", ofNorth.get("users").get(0).get("role").asString());
          }
        });
    run(
        (sites, root) -> {
          try (ApiClient north = new ApiClient(root, "Max@north", PASSWORD);
              ApiClient max = new ApiClient(root, "Max", PASSWORD)) {
            assertEquals(List.of("r1"), names(north.get("robots")));
            JsonNode all = max.get("sites");
            assertEquals(List.of("main", "north"), names(all));
            assertEquals(1, all.get(1).get("robots").asInt());
            assertEquals(2, all.get(1).get("users").asInt());
            assertEquals(409, max.delete("sites/north").status(), "it has a robot");
            assertEquals(409, max.delete("sites/main").status());
          }
        });
  }

  @Test
  void nameWithAnAtOfTheFirstSiteStaysAsItIs() throws Exception {
    run(
        (sites, root) -> {
          sites.first().accounts().add("ann@north", WebTestServer.PASSWORD_HASH, Role.CLERK, "Max");
          addSite(root, "north");
          try (ApiClient ann = new ApiClient(root, "ann@north", PASSWORD);
              ApiClient nora = new ApiClient(root, "nora@north", PASSWORD)) {
            assertEquals("main", ann.get("floors").get(0).get("site").asString());
            assertEquals("north", nora.get("floors").get(0).get("site").asString());
          }
        });
  }

  @Test
  void nameOfASiteWhoseManagerCannotBeStoredIsFree() throws Exception {
    run(
        (sites, root) -> {
          String tooLong = "N".repeat(1000);
          CompletableFuture<?> failed =
              sites.add("north", tooLong, WebTestServer.PASSWORD_HASH, "Max").toCompletableFuture();
          assertThrows(ExecutionException.class, () -> failed.get(60, TimeUnit.SECONDS));
          addSite(root, "north");
        });
  }

  /** Every route, by everybody of another site, asking for what the first site has. */
  @Test
  void nobodyOfAnotherSiteLearnsOrChangesAnything() throws Exception {
    run(
        (sites, root) -> {
          addSite(root, "north");
          Map<String, String> wanted = fillFirstSite(root);
          try (ApiClient nora = new ApiClient(root, "Nora@north", PASSWORD)) {
            nora.post("users", Map.of("name", "Carl", "password", PASSWORD, "role", "CLERK"));
          }
          List<String> before = storedOfFirst(sites);
          int tried = 0;
          for (String user : List.of("Nora@north", "Carl@north")) {
            try (ApiClient session = new ApiClient(root, user, PASSWORD);
                TestClient client = new TestClient(root)) {
              for (Rights.Right right : Rights.all()) {
                if (right.endsSession()) {
                  continue;
                }
                for (@Nullable String site : new @Nullable String[] {null, "main", "MAIN"}) {
                  HttpResponse<String> answer =
                      client.send(request(client, right, wanted, session.token(), site));
                  String what = user + ", " + site + ": " + right + " " + answer.statusCode();
                  String told = withoutAsked(answer.body(), right, wanted);
                  assertFalse(told.contains(SECRET), what + "\n" + told);
                  boolean isOpen = right.ofAnonymous().equals(right.ofManager());
                  assertTrue(
                      site == null || isOpen || answer.statusCode() >= 300, what + " is answered");
                  tried++;
                }
              }
            }
          }
          assertEquals(before, storedOfFirst(sites));
          Tally.add("requests of people of another site", tried);
          assertTrue(tried > 900, "tried " + tried);
        });
  }

  @Test
  void liveEventsAndMetricsAreOfOnesOwnSite() throws Exception {
    run(
        (sites, root) -> {
          addSite(root, "north");
          fillFirstSite(root);
          try (ApiClient nora = new ApiClient(root, "Nora@north", PASSWORD);
              ApiClient max = new ApiClient(root, "Max", PASSWORD);
              TestClient client = new TestClient(root)) {
            max.awaitSnapshot(snapshot -> snapshot.toString().contains(SECRET));
            nora.awaitSnapshot(
                snapshot -> {
                  assertFalse(snapshot.toString().contains(SECRET), snapshot.toString());
                  return snapshot.get("robots").isEmpty();
                });
            String metrics = metrics(client, nora.token());
            assertTrue(metrics.contains("toqa_robots{state=\"idle\"} 0"), metrics);
            assertFalse(
                metrics.contains("jvm_memory"), "what the process does is the first site's");
            assertTrue(metrics(client, max.token()).contains("jvm_memory"));
          }
        });
  }

  @Test
  void administratorSeesAnotherSiteAndHelpsItsUsersOnly() throws Exception {
    run(
        (sites, root) -> {
          addSite(root, "north");
          try (TestClient client = new TestClient(root);
              ApiClient max = new ApiClient(root, "Max", PASSWORD);
              ApiClient nora = new ApiClient(root, "Nora@north", PASSWORD)) {
            for (Rights.Right right : Rights.all()) {
              if (!right.isApi() || right.endsSession()) {
                continue;
              }
              HttpResponse<String> answer =
                  client.send(request(client, right, Map.of(), max.token(), "north"));
              assertEquals(right.ofVisitor(), String.valueOf(answer.statusCode()), "" + right);
            }
            assertEquals(
                404, client.send(asking(client, "floors", max.token(), "nowhere")).statusCode());
            String floors = client.send(asking(client, "floors", max.token(), "North")).body();
            assertTrue(floors.contains("\"north\""), floors);
            String users = client.send(asking(client, "users", max.token(), "north")).body();
            assertTrue(users.contains("Nora") && !users.contains("Max"), users);
            assertEquals(403, nora.replyTo("sites", Map.of()).status());
          }
        });
  }

  @Test
  void siteThatCannotStartDisturbsNoOther() throws Exception {
    run((sites, root) -> addSite(root, "north"));
    run((sites, root) -> addSite(root, "south"));
    Path file = folder.resolve("toqa-site-2.mv.db");
    assertTrue(Files.exists(file));
    Files.writeString(file, "no database");
    run(
        (sites, root) -> {
          try (ApiClient max = new ApiClient(root, "Max", PASSWORD);
              ApiClient south = new ApiClient(root, "Nora@south", PASSWORD);
              TestClient stranger = new TestClient(root)) {
            assertEquals(1, south.get("floors").size());
            JsonNode north = max.get("sites").get(1);
            assertEquals("FAILED", north.get("state").asString());
            assertFalse(north.get("failure").asString().isBlank());
            assertEquals(200, stranger.get("api/v1/health").statusCode());
            String login = "{\"name\":\"Nora@north\",\"password\":\"" + PASSWORD + "\"}";
            assertEquals(401, stranger.postJson("api/v1/session", login).statusCode());
            assertTrue(max.delete("sites/north").isAccepted());
            assertEquals(List.of("main", "south"), names(max.get("sites")));
          }
        });
  }

  @Test
  void siteThatWasRemovedIsGoneWithItsNameFree() throws Exception {
    run(
        (sites, root) -> {
          addSite(root, "north");
          try (ApiClient max = new ApiClient(root, "Max", PASSWORD);
              ApiClient nora = new ApiClient(root, "Nora@north", PASSWORD);
              TestClient client = new TestClient(root)) {
            nora.post("users", Map.of("name", SECRET, "password", PASSWORD, "role", "CLERK"));
            assertEquals(
                422,
                max.replyTo("sites", Map.of("name", "NORTH", "manager", "X", "password", PASSWORD))
                    .status());
            assertTrue(max.delete("sites/north").isAccepted());
            assertEquals(
                401, client.send(asking(client, "floors", nora.token(), null)).statusCode());
            addSite(root, "north");
            assertEquals(
                401, client.send(asking(client, "floors", nora.token(), null)).statusCode());
          }
          try (ApiClient nora = new ApiClient(root, "Nora@north", PASSWORD)) {
            assertEquals(List.of("Nora"), names(nora.get("users")), "it begins anew");
          }
        });
  }

  private static Map<String, Object> administrator() {
    return Map.of("name", "Adam", "password", PASSWORD, "role", "ADMINISTRATOR");
  }

  private static void addSite(URI root, String name) throws Exception {
    try (ApiClient max = new ApiClient(root, "Max", PASSWORD)) {
      max.post("sites", Map.of("name", name, "manager", "Nora", "password", PASSWORD));
    }
  }

  private static int addRobot(ApiClient api, String name) throws Exception {
    return api.replyTo("robots", Map.of("name", name, "host", "127.0.0.1", "port", 9, "maxLoad", 5))
        .status();
  }

  /** What somebody else may ask for, by what stands in braces in the paths. */
  private static Map<String, String> fillFirstSite(URI root) throws Exception {
    Map<String, String> wanted = new LinkedHashMap<>();
    try (ApiClient max = new ApiClient(root, "Max", PASSWORD)) {
      String floor = SECRET + " attic";
      max.post("floors", Map.of("name", floor, "width", 6, "height", 6, "resolution", 0.3));
      addRobot(max, SECRET + "-robot");
      Map<String, Object> order =
          Map.of(
              "name",
              SECRET + " crate",
              "load",
              2,
              "start",
              Map.of("station", "Goods-in 1"),
              "goal",
              Map.of("station", "Goods-in 2"));
      long task = max.post("tasks", order).get("id").asLong();
      max.post("schedules", Map.of("task", order, "at", "2099-01-01T10:00:00Z"));
      max.post("users", Map.of("name", SECRET, "password", PASSWORD, "role", "CLERK"));
      max.awaitSnapshot(
          snapshot -> snapshot.get("tasks").size() == 1 && snapshot.get("robots").size() == 2);
      wanted.put("{id}", String.valueOf(task));
      wanted.put("{floor}", floor.replace(" ", "%20"));
      wanted.put("{name}", SECRET + "-robot");
      wanted.put("{reading}", "range");
      wanted.put("{topic}", "tasks");
      wanted.put("{box}", "1");
      wanted.put("{session}", "1");
      wanted.put("{site}", "main");
    }
    return wanted;
  }

  private static HttpRequest request(
      TestClient client,
      Rights.Right right,
      Map<String, String> wanted,
      String token,
      @Nullable String site) {
    String path = right.path().substring(1);
    for (Map.Entry<String, String> place : wanted.entrySet()) {
      path = path.replace(place.getKey(), place.getValue());
    }
    path =
        wanted.isEmpty() ? Rights.path(right) : path.replace("{language}", "en").replace("*", "");
    boolean isStream = right.path().equals("/api/v1/events");
    HttpRequest.Builder request =
        client
            .request(path)
            .header("Authorization", "Bearer " + token)
            .header("Content-Type", "application/json")
            .method(
                isStream ? "HEAD" : right.method(),
                right.method().equals("GET")
                    ? BodyPublishers.noBody()
                    : BodyPublishers.ofString("{}"));
    return (site == null ? request : request.header("Toqa-Site", site)).build();
  }

  /** An answer may say again what the question named. */
  private static String withoutAsked(
      String answer, Rights.Right right, Map<String, String> wanted) {
    String told = answer;
    for (Map.Entry<String, String> place : wanted.entrySet()) {
      if (right.path().contains(place.getKey())) {
        told = told.replace(place.getValue().replace("%20", " "), "");
      }
    }
    return told;
  }

  private static HttpRequest asking(
      TestClient client, String path, String token, @Nullable String site) {
    HttpRequest.Builder request =
        client.request("api/v1/" + path).header("Authorization", "Bearer " + token);
    return (site == null ? request : request.header("Toqa-Site", site)).build();
  }

  private static String metrics(TestClient client, String token) {
    return client.send(asking(client, "metrics", token, null)).body();
  }

  /** All that people have ordered there. */
  private static List<String> storedOfFirst(SiteServers sites) {
    List<String> stored = new ArrayList<>();
    stored.add(sites.first().accounts().accounts().toString());
    stored.add(sites.first().fleet().floors().stream().map(f -> f.name()).toList().toString());
    stored.add(sites.first().schedules().schedules().toString());
    sites.first().fleet().snapshots().latest().tasks().stream()
        .map(task -> task.id() + " " + task.task().name() + " " + task.held())
        .forEach(stored::add);
    sites.first().fleet().snapshots().latest().robots().stream()
        .map(robot -> robot.name() + " " + robot.work().held())
        .forEach(stored::add);
    return stored;
  }

  private void run(Use use) throws Exception {
    Map<Setting, @Nullable String> options = new EnumMap<>(Setting.class);
    options.put(Setting.PORT, "0");
    options.put(Setting.DATA, folder.toString());
    options.put(Setting.SIMULATE, "1");
    options.put(Setting.REQUESTS_PER_SECOND, "0");
    options.put(Setting.MANAGER, "Max:" + WebTestServer.PASSWORD_HASH);
    options.put(Setting.LOG_LEVEL, "ERROR");
    Configuration configuration =
        Configuration.of(
            WebappFolder.shippedMap(WEBAPP), List.of(SettingSource.fromCommandLine(options)));
    try (WebServer web = WebServer.bind(WEBAPP, configuration);
        SiteServers sites = SiteServers.start(configuration, CheapPassword.hasher());
        WebServer.RunningWebapp webapp = web.open(sites)) {
      use.use(sites, webapp.uri());
    }
  }

  private static List<String> names(JsonNode list) {
    return list.valueStream().map(node -> node.get("name").asString()).toList();
  }
}
