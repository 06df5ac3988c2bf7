package org.toqa.app.server;

import static org.toqa.app.server.Verdict.NOT_FOUND;
import static org.toqa.app.server.Verdict.REDIRECTED;
import static org.toqa.app.server.Verdict.REFUSED;
import static org.toqa.app.server.Verdict.TAKEN;
import static org.toqa.app.server.Verdict.UNREADABLE;

import java.net.URLEncoder;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.toqa.web.TestClient;
import org.toqa.web.route.Route;
import org.toqa.web.route.Routes;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * What is asked for in addresses, by hand. What the forms of pages ask for besides is in {@link
 * FormCases#ofQuestions}.
 */
final class QueryAttacks {
  private static final JsonMapper JSON = JsonMapper.shared();

  private static final Map<String, Verdict> PERIOD =
      Map.of("period", REFUSED, "from", REFUSED, "to", REFUSED, "zone", REFUSED, "floor", REFUSED);

  private static final Map<String, Map<String, Verdict>> PAGES =
      Map.of(
          "/", Map.of("next", TAKEN, "done", TAKEN),
          "/reset", Map.of("secret", REDIRECTED),
          "/tasks", Map.of("page", TAKEN, "imported", TAKEN),
          "/notices", Map.of("show", REFUSED, "before", REFUSED),
          "/users", Map.of("done", TAKEN),
          "/history", Map.of("before", REFUSED, "zone", TAKEN),
          "/statistics", Map.of("period", REFUSED));

  private static final Map<String, Map<String, Verdict>> API =
      Map.of(
          "/api/v1/map",
          Map.of("floor", NOT_FOUND, "at", REFUSED),
          "/api/v1/path",
          Map.of("floor", NOT_FOUND, "start", REFUSED, "goal", REFUSED),
          "/api/v1/events",
          Map.of("changes", UNREADABLE, "notices", UNREADABLE, "floor", REFUSED),
          "/api/v1/tasks",
          Map.of(
              "state",
              REFUSED,
              "robot",
              TAKEN,
              "user",
              TAKEN,
              "text",
              TAKEN,
              "from",
              REFUSED,
              "until",
              REFUSED,
              "sort",
              REFUSED,
              "followed",
              REFUSED,
              "floor",
              TAKEN),
          "/api/v1/tracks",
          Map.of("floor", NOT_FOUND, "from", REFUSED, "until", REFUSED),
          "/api/v1/statistics",
          PERIOD,
          "/api/v1/floors/lab/export",
          Map.of("format", REFUSED),
          "/api/v1/statistics/series.csv",
          PERIOD,
          "/api/v1/statistics/robots.csv",
          PERIOD,
          "/api/v1/history",
          Map.of(
              "robot", TAKEN, "user", TAKEN, "kind", REFUSED, "from", REFUSED, "until", REFUSED,
              "floor", TAKEN));

  /** Lists of one floor or of all, and of notices. */
  private static final Map<String, Map<String, Verdict>> LISTS =
      Map.of(
          "/api/v1/robots", Map.of("floor", REFUSED),
          "/api/v1/loads", Map.of("floor", REFUSED),
          "/api/v1/notices", Map.of("show", REFUSED),
          "/api/v1/schedules", Map.of("floor", REFUSED),
          "/api/v1/templates", Map.of("floor", REFUSED));

  /** Those that are numbers, which the document of the API does not call words. */
  private static final Map<String, Map<String, Verdict>> NUMBERS =
      Map.of(
          "/api/v1/tasks", Map.of("offset", UNREADABLE, "limit", UNREADABLE),
          "/api/v1/orders", Map.of("offset", UNREADABLE, "limit", UNREADABLE),
          "/api/v1/tracks/r1", Map.of("hours", UNREADABLE),
          "/api/v1/robots/r1/battery", Map.of("hours", UNREADABLE),
          "/api/v1/notices", Map.of("before", REFUSED, "limit", UNREADABLE),
          "/api/v1/history", Map.of("task", REFUSED, "before", REFUSED, "limit", UNREADABLE));

  private final AttackRun run;

  QueryAttacks(AttackRun run) {
    this.run = run;
  }

  void attack() {
    try (TestClient stranger = run.server().stranger()) {
      for (Map<String, Map<String, Verdict>> queries : List.of(PAGES, API, LISTS, NUMBERS)) {
        queries.forEach(
            (path, parameters) ->
                parameters.forEach(
                    (parameter, verdict) -> {
                      for (Attack attack : run.nextAttacks()) {
                        TestClient client =
                            List.of("/", "/reset").contains(path) ? stranger : run.manager();
                        send(client, path, parameter, attack, expected(verdict, attack));
                      }
                    }));
        run.tasks().goOn();
      }
    }
  }

  /** An address is not longer than a request's first line may be. */
  private static int expected(Verdict verdict, Attack attack) {
    return attack == Attack.VERY_LONG ? 400 : verdict.status(attack, 200);
  }

  private void send(TestClient client, String path, String parameter, Attack attack, int expected) {
    run.next();
    String where = path + "?" + parameter + " " + attack;
    HttpResponse<String> answer =
        client.get(
            path
                + "?"
                + parameter
                + "="
                + URLEncoder.encode(attack.text(), StandardCharsets.UTF_8));
    run.expectStatus(expected, answer, where);
    run.check(where, answer);
  }

  /** The words in addresses of the API that are attacked, by route. */
  static Map<String, Set<String>> attacked() {
    Map<String, Set<String>> attacked = new TreeMap<>();
    Stream.of(API, LISTS)
        .flatMap(queries -> queries.entrySet().stream())
        .forEach(
            query ->
                attacked.put(
                    Routes.find(query.getKey()).orElseThrow().routes().getFirst().path(),
                    query.getValue().keySet()));
    return attacked;
  }

  /** All words in addresses of the API, by path, as its document says. */
  static Map<String, Set<String>> described(AttackRun run) {
    Map<String, Set<String>> described = new TreeMap<>();
    JsonNode document = JSON.readTree(run.manager().get("api/v1/openapi.json").body());
    for (Route route : Routes.all()) {
      if (route.isApi() && route.method().equals("GET")) {
        Set<String> words = new TreeSet<>();
        for (JsonNode given :
            document.path("paths").path(route.path()).path("get").path("parameters")) {
          JsonNode parameter =
              given.has("$ref") ? document.at(given.get("$ref").asString().substring(1)) : given;
          if (parameter.path("in").asString().equals("query")
              && parameter.path("schema").path("type").asString().matches("string|boolean")) {
            words.add(parameter.get("name").asString());
          }
        }
        if (!words.isEmpty()) {
          described.put(route.path(), words);
        }
      }
    }
    return described;
  }
}
