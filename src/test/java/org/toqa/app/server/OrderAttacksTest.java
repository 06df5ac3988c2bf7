package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.app.config.Setting;
import org.toqa.app.server.OrderCases.OrderCase;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;
import org.toqa.web.route.Routes;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * Every word of every order of the API is given every attack, with all else as it should be, while
 * the fleet carries tasks.
 */
class OrderAttacksTest {
  private static final JsonMapper JSON = JsonMapper.shared();

  /** Whose own account is changed, which ends what this user has logged in elsewhere. */
  private static final String OWN = "Olga";

  @TempDir private Path data;

  private final Map<String, String> places = new LinkedHashMap<>();
  private final List<String> faults = new ArrayList<>();
  private AttackedServer server;
  private TestClient manager;
  private CarriedTasks tasks;
  private int sent;

  @BeforeEach
  void start() throws Exception {
    Map<Setting, @Nullable String> settings = new EnumMap<>(Setting.class);
    settings.put(Setting.MAIL_HOST, "127.0.0.1");
    settings.put(Setting.MAIL_FROM, "toqa@example.org");
    settings.put(Setting.SITE, "https://toqa.example.org");
    server = AttackedServer.start(data, settings);
    manager = server.signedIn(AttackedServer.MANAGER);
    tasks = new CarriedTasks(manager, Attack.FORMULA.text());
    server.addUser(OWN);
    places.put("own", String.valueOf(server.userId(OWN)));
    places.put("clerk", String.valueOf(server.userId(AttackedServer.CLERK)));
    places.put("name", "Absent");
    String robot = "{\"name\":\"Absent\",\"host\":\"127.0.0.1\",\"port\":9,\"maxLoad\":5}";
    assertEquals(201, manager.postJson("api/v1/robots", robot).statusCode());
    String held =
        """
        {"name":"Held","load":2,"start":{"station":"Store A"},"goal":{"station":"Store B"}}
        """;
    String task = manager.postJson("api/v1/tasks", held).body();
    places.put("held", JSON.readTree(task).get("id").asString());
    assertEquals(200, manager.send(hold()).statusCode());
  }

  private HttpRequest hold() {
    return manager
        .request("api/v1/tasks/" + places.get("held") + "/hold")
        .header("X-CSRF-Token", manager.csrf())
        .POST(BodyPublishers.noBody())
        .build();
  }

  @AfterEach
  void stop() throws Exception {
    server.close();
  }

  @Test
  void whatIsSaidIsTextInEveryWordOfEveryOrder() throws Exception {
    String token = logIn(server.stranger(), AttackedServer.MANAGER);
    for (OrderCase order : OrderCases.all()) {
      for (String word : order.attacked().keySet()) {
        for (Attack attack : Attack.values()) {
          send(order, word, attack, token);
        }
        tasks.goOn();
      }
      send(order, null, null, token);
    }
    assertEquals("", String.join("\n", faults));
    assertTrue(sent > 800, "only " + sent + " attacks");
    tasks.awaitDone();
    for (String list : List.of("tasks", "schedules", "robots", "users", "history")) {
      assertEquals(200, manager.get("api/v1/" + list).statusCode(), list);
    }
  }

  private String logIn(TestClient client, String name) {
    String body = JSON.writeValueAsString(Map.of("name", name, "password", WebTestServer.PASSWORD));
    HttpResponse<String> answer = client.send(request(client, "POST", "session", body).build());
    assertEquals(200, answer.statusCode());
    return JSON.readTree(server.observed(answer).body()).get("token").asString();
  }

  private static HttpRequest.Builder request(
      TestClient client, String method, String path, String body) {
    return client
        .request("api/v1/" + path)
        .header("Content-Type", "application/json")
        .method(method, BodyPublishers.ofString(body));
  }

  private void send(
      OrderCase order, @Nullable String word, @Nullable Attack attack, String managerToken)
      throws Exception {
    sent++;
    places.put("n", String.valueOf(sent));
    boolean asksForPassword = order.path().startsWith("users/{own}/");
    boolean isAnonymous =
        List.of("session", "forgotten-password", "reset-password").contains(order.path());
    if (order.path().equals("session")) {
      server.addUser("guest" + sent);
    }
    if (order.body().contains("{secret}")) {
      places.put("secret", newSecret());
    }
    JsonNode body = JSON.readTree(filled(order.body()));
    String where = order.method() + " " + order.path() + " good";
    int expected = order.good();
    if (word != null && attack != null) {
      put(body, word, attack.text());
      where = order.method() + " " + order.path() + " " + word + " " + attack;
      expected = order.attacked().getOrDefault(word, Verdict.REFUSED).status(attack, expected);
    }
    try (TestClient client = server.stranger()) {
      String token = asksForPassword ? logIn(client, OWN) : managerToken;
      HttpRequest.Builder request =
          request(client, order.method(), filled(order.path()), JSON.writeValueAsString(body));
      if (!isAnonymous) {
        request.header("Authorization", "Bearer " + token);
      }
      String before = server.stored();
      HttpResponse<String> answer = server.observed(client.send(request.build()));
      if (answer.statusCode() != expected) {
        faults.add(where + " answered " + answer.statusCode() + ", not " + expected);
      }
      assertHarmless(where, answer);
      if (expected >= 400) {
        assertEquals(before, server.stored(), where + " is refused and stored all the same");
      } else if (order.path().equals("tasks")) {
        JsonNode task = JSON.readTree(answer.body());
        assertEquals(body.get("name").asString().strip(), task.get("name").asString(), where);
        tasks.cancel(task.get("id").asLong());
      }
    }
  }

  private static void assertHarmless(String where, HttpResponse<String> answer) {
    assertTrue(answer.statusCode() < 500, where + " answered " + answer.statusCode());
    String type = answer.headers().firstValue("Content-Type").orElse("application/json");
    assertTrue(type.contains("json"), where + " answers with " + type);
    assertTrue(
        answer.headers().allValues("Set-Cookie").stream().noneMatch(c -> c.contains(Attack.MARK)),
        where);
    assertTrue(!answer.body().contains(Attack.EVALUATED), where + " evaluates what was said");
    assertTrue(!answer.body().contains("Exception"), where + " shows a stack trace");
    if (!answer.body().isEmpty()) {
      JSON.readTree(answer.body());
    }
  }

  private String newSecret() {
    HttpResponse<String> answer =
        manager.postJson("api/v1/users/" + places.get("clerk") + "/reset-link", "");
    return server.observed(answer).body().replaceFirst("(?s).*secret=([^\"]+)\".*", "$1");
  }

  /** Puts a word there, also where the order had none. */
  private static void put(JsonNode body, String pointer, String word) {
    int slash = pointer.lastIndexOf('/');
    JsonNode parent = body.at(pointer.substring(0, slash));
    String name = pointer.substring(slash + 1);
    if (parent instanceof ArrayNode list) {
      list.set(Integer.parseInt(name), word);
    } else {
      ((ObjectNode) parent).put(name, word);
    }
  }

  private String filled(String template) {
    String text = template;
    for (Map.Entry<String, String> place : places.entrySet()) {
      text = text.replace("{" + place.getKey() + "}", place.getValue());
    }
    return text;
  }

  @Test
  void everyWordOfEveryOrderIsAttacked() {
    Map<String, Set<String>> attacked = new TreeMap<>();
    for (OrderCase order : OrderCases.all()) {
      String path =
          Routes.find("/api/v1/" + order.path())
              .flatMap(match -> match.route(order.method()))
              .orElseThrow()
              .path();
      attacked
          .computeIfAbsent(order.method() + " " + path, route -> new TreeSet<>())
          .addAll(order.attacked().keySet());
    }
    Map<String, Set<String>> described = new TreeMap<>();
    JsonNode document = JSON.readTree(manager.get("api/v1/openapi.json").body());
    document
        .get("paths")
        .properties()
        .forEach(
            path ->
                path.getValue()
                    .properties()
                    .forEach(
                        operation -> {
                          JsonNode schema =
                              operation
                                  .getValue()
                                  .at("/requestBody/content/application~1json/schema");
                          Set<String> words = new TreeSet<>();
                          addWords(document, schema, "", words);
                          if (!words.isEmpty()) {
                            described.put(
                                operation.getKey().toUpperCase(Locale.ROOT) + " " + path.getKey(),
                                words);
                          }
                        }));
    assertEquals(described, attacked);
  }

  /** Adds the pointers of all words that the schema describes. */
  private static void addWords(
      JsonNode document, JsonNode schema, String pointer, Set<String> words) {
    if (schema.has("$ref")) {
      addWords(document, document.at(schema.get("$ref").asString().substring(1)), pointer, words);
    }
    schema.path("oneOf").forEach(one -> addWords(document, one, pointer, words));
    schema
        .path("properties")
        .properties()
        .forEach(
            property ->
                addWords(document, property.getValue(), pointer + "/" + property.getKey(), words));
    if (schema.has("items")) {
      addWords(document, schema.get("items"), pointer + "/0", words);
    }
    if (schema.path("type").toString().contains("\"string\"")) {
      words.add(pointer);
    }
  }
}
