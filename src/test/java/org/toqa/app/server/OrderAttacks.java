package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.toqa.app.server.OrderCases.OrderCase;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;
import org.toqa.web.route.Route;
import org.toqa.web.route.Routes;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * Every word of every order of the API is given every attack, with all else as it should be, while
 * the fleet carries tasks.
 */
final class OrderAttacks {
  private static final JsonMapper JSON = JsonMapper.shared();

  private final AttackRun run;
  private final AttackedServer server;

  /** What has a token of a user, and no cookies. */
  private final TestClient program;

  /** The same for the one who changes his own account; a new one before he has failed too often. */
  private TestClient own;

  private String ownToken = "";

  private int ownUsed;

  OrderAttacks(AttackRun run) {
    this.run = run;
    this.server = run.server();
    this.program = server.stranger();
    this.own = program;
  }

  void attack() throws Exception {
    run.holdTask();
    String token = logIn(program, AttackedServer.MANAGER);
    for (OrderCase order : OrderCases.all()) {
      for (String word : order.attacked().keySet()) {
        for (Attack attack : run.nextAttacks()) {
          send(order, word, attack, token);
        }
        run.tasks().goOn();
      }
      send(order, null, null, token);
    }
    for (String list : List.of("tasks", "schedules", "templates", "robots", "users", "history")) {
      HttpResponse<String> answer = run.manager().get("api/v1/" + list);
      run.expectStatus(200, answer, list);
      run.check(list, answer);
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
    run.next();
    boolean asksForPassword = order.path().startsWith("users/{own}/");
    boolean isAnonymous =
        List.of("session", "forgotten-password", "reset-password").contains(order.path());
    if (order.path().equals("session")) {
      run.addGuest();
    }
    if (order.body().contains("{secret}")) {
      run.createSecret();
    }
    JsonNode body = JSON.readTree(run.filled(order.body()));
    String where = order.method() + " " + order.path() + " good";
    int expected = order.good();
    if (word != null && attack != null) {
      put(body, word, attack.text());
      where = order.method() + " " + order.path() + " " + word + " " + attack;
      expected = order.attacked().getOrDefault(word, Verdict.REFUSED).status(attack, expected);
    }
    if (asksForPassword && ownUsed++ % 3 == 0) {
      own = server.stranger();
      ownToken = logIn(own, AttackRun.OWN);
    }
    TestClient client = isAnonymous ? server.stranger() : asksForPassword ? own : program;
    try {
      String token = asksForPassword ? ownToken : managerToken;
      HttpRequest.Builder request =
          request(client, order.method(), run.filled(order.path()), JSON.writeValueAsString(body));
      if (!isAnonymous) {
        request.header("Authorization", "Bearer " + token);
      }
      List<String> before = server.stored();
      HttpResponse<String> answer = client.send(request.build());
      run.expectStatus(expected, answer, where);
      run.check(where, answer);
      if (asksForPassword && answer.statusCode() < 400) {
        ownUsed = 0; // a new password ends what was logged in by the old one
      }
      if (answer.statusCode() >= 400) {
        run.expectUnchanged(before, where);
      } else if (order.path().equals("tasks") && body.has("name")) {
        JsonNode task = JSON.readTree(answer.body());
        assertEquals(body.get("name").asString().strip(), task.get("name").asString(), where);
        run.tasks().cancel(task.get("id").asLong());
      } else if (order.path().equals("floors")) {
        run.removeFloor(body.get("name").asString());
      } else if (order.path().equals("templates")) {
        run.removeTemplates();
      } else if (order.path().equals("sites")) {
        run.removeSite(body.get("name").asString());
      } else if (order.path().equals("orders")) {
        JSON.readTree(answer.body())
            .get("tasks")
            .forEach(task -> run.tasks().cancel(task.get("id").asLong()));
      }
    } finally {
      if (isAnonymous) {
        client.close();
      }
    }
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

  /** The words that are attacked, by route. */
  static Map<String, Set<String>> attacked() {
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
    attacked.values().forEach(words -> words.removeIf(OrderAttacks::isOpen));
    return attacked;
  }

  /** Whether the document leaves open what stands there: it depends on the template. */
  private static boolean isOpen(String word) {
    return word.startsWith("/values/")
        || word.startsWith("/task/values/")
        || word.startsWith("/order/");
  }

  /** The words of all orders, by route, as the document of the API says. */
  static Map<String, Set<String>> described(AttackRun run) {
    Map<String, Set<String>> described = new TreeMap<>();
    JsonNode document = JSON.readTree(run.manager().get("api/v1/openapi.json").body());
    for (Route route : Routes.all()) {
      Set<String> words = new TreeSet<>();
      JsonNode operation =
          document.path("paths").path(route.path()).path(route.method().toLowerCase(Locale.ROOT));
      JsonNode schema = operation.at("/requestBody/content/application~1json/schema");
      addWords(document, schema, "", words);
      if (route.isApi() && !words.isEmpty()) {
        described.put(route.method() + " " + route.path(), words);
      }
    }
    return described;
  }

  /** Adds the pointers of all words that the schema describes. */
  private static void addWords(
      JsonNode document, JsonNode schema, String pointer, Set<String> words) {
    if (schema.has("$ref")) {
      addWords(document, document.at(schema.get("$ref").asString().substring(1)), pointer, words);
    }
    for (String choice : List.of("oneOf", "anyOf")) {
      schema.path(choice).forEach(one -> addWords(document, one, pointer, words));
    }
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
