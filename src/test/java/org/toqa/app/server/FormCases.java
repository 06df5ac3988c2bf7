package org.toqa.app.server;

import static org.toqa.app.server.Verdict.CONFLICT;
import static org.toqa.app.server.Verdict.NAME_IN_ADDRESS;
import static org.toqa.app.server.Verdict.NAME_OF_100;
import static org.toqa.app.server.Verdict.NAME_OF_64;
import static org.toqa.app.server.Verdict.PASSWORD;
import static org.toqa.app.server.Verdict.REFUSED;
import static org.toqa.app.server.Verdict.TAKEN;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.toqa.notices.NoticeKind;
import org.toqa.web.WebTestServer;

/** All forms with something to fill in, by hand: that none is missing, their test looks after. */
final class FormCases {
  private static final String DAY = "2099-01-01T10:00";

  private static final String ORDER_JSON =
      """
      {"name":"Box","load":2,"start":{"station":"Goods-in 1"},"goal":{"station":"Mill"}}\
      """;

  private static final Map<String, String> ORDER =
      Map.of("name", "Box", "load", "2", "startStation", "Goods-in 1", "goalStation", "Mill");

  /** Those of users who are logged in. */
  static List<FormCase> ofUsers() {
    return List.of(
        FormCase.of(
            "tasks/new",
            "/tasks/new",
            and(ORDER, Map.of("length", "0.3", "width", "0.3", "deadline", DAY)),
            and(
                refused(
                    "load",
                    "floor",
                    "startStation",
                    "goalStation",
                    "priority",
                    "length",
                    "width",
                    "deadline",
                    "zone",
                    "when",
                    "pieces",
                    "kind",
                    "stopStation",
                    "onlyRobots"),
                Map.of("name", NAME_OF_100, "idempotencyKey", TAKEN))),
        FormCase.of(
            "tasks/new",
            "/tasks/new",
            and(ORDER, Map.of("startWait", "person", "stopStation", "Store A", "stopWait", "60")),
            and(refused("startWait", "goalWait", "stopWait"), Map.of("carriedBy", TAKEN))),
        FormCase.of(
            "tasks/new",
            "/tasks/new",
            Map.of(
                "name", "Box", "load", "2", "startX", "1.95", "startY", "4.65", "goalX", "3.45",
                "goalY", "9.45"),
            refused("startX", "startY", "goalX", "goalY")),
        FormCase.of(
            "tasks/new",
            "/tasks/new",
            and(ORDER, Map.of("when", "every", "first", DAY, "everyMinutes", "60", "until", DAY)),
            and(
                refused("first", "everyMinutes", "until"),
                Map.of("name", NAME_OF_100, "idempotencyKey", TAKEN))),
        FormCase.of(
            "tasks/new",
            "/tasks/new",
            and(ORDER, Map.of("when", "weekly", "weekday", "MONDAY", "time", "08:00")),
            refused("weekday", "time", "zone")),
        FormCase.of(
            "tasks/{waiting}/edit",
            "/tasks/{id}/edit",
            and(ORDER, Map.of("load", "6", "length", "0.3", "width", "0.3", "deadline", DAY)),
            and(
                refused(
                    "load",
                    "floor",
                    "startStation",
                    "goalStation",
                    "priority",
                    "length",
                    "width",
                    "deadline",
                    "zone",
                    "onlyRobots"),
                Map.of("name", NAME_OF_100, "version", CONFLICT))),
        FormCase.of(
            "tasks/{waiting}/edit",
            "/tasks/{id}/edit",
            and(
                Map.of("name", "Box", "load", "6", "startStation", "", "goalStation", ""),
                Map.of("startX", "1.95", "startY", "4.65", "goalX", "3.45", "goalY", "9.45")),
            refused("startX", "startY", "goalX", "goalY")),
        FormCase.of(
            "tasks/{held}",
            "/tasks/{id}/priority",
            Map.of("priority", "10"),
            Map.of("priority", REFUSED, "version", CONFLICT)),
        FormCase.of(
            "tasks/{held}", "/tasks/{id}/cancel", Map.of("load", "here"), Map.of("load", REFUSED)),
        FormCase.of(
            "tasks/{left}",
            "/tasks/{id}/load-moved",
            Map.of("placeX", "13.65", "placeY", "9.15"),
            refused("placeStation", "placeX", "placeY")),
        FormCase.of(
            "orders/{order}",
            "/orders/{id}/priority",
            Map.of("priority", "10"),
            Map.of("priority", REFUSED)),
        FormCase.of("orders/{order}", "/orders/{id}/cancel", Map.of(), Map.of("load", REFUSED)),
        FormCase.of("map", "/fleet/pause", Map.of(), Map.of("back", TAKEN)),
        FormCase.of(
            "map",
            "/floors/{floor}/allocator",
            Map.of("allocator", "zones"),
            Map.of("allocator", REFUSED)),
        FormCase.of(
            "floors",
            "/floors",
            Map.of("name", "Hall{n}", "width", "3", "height", "3", "resolution", "1"),
            Map.of("name", NAME_IN_ADDRESS)),
        FormCase.of(
                "floors",
                "/floors",
                Map.of("name", "{floor}", "width", "3", "height", "3", "resolution", "1"),
                and(refused("width", "height", "resolution"), Map.of("file", TAKEN)))
            .answeredWith(422), // that name is taken
        FormCase.of(
                "floors/{floor}/supervision",
                "/floors/{floor}/supervision",
                Map.of("supervisor", "r1", "boxes", "1: 1, 1"),
                refused("supervisor", "boxes", "sequential"))
            .answeredWith(422), // no robot has an arm
        FormCase.of(
            "settings", "/settings/log-level", Map.of("logLevel", "INFO"), refused("logLevel")),
        FormCase.of(
                "laboratory",
                "/laboratory",
                Map.of("runs", "0"),
                refused("experiment", "seed", "runs"))
            .answeredWith(422), // none is begun
        FormCase.of(
                "floors/{floor}/exploration",
                "/floors/{floor}/exploration",
                Map.of("robots", "0"),
                refused("ground", "robots", "seed", "startX", "startY", "targetX", "targetY"))
            .answeredWith(422), // none is begun
        FormCase.of("schedules", "/schedules/{id}/delete", Map.of(), Map.of("version", CONFLICT)),
        FormCase.of(
            "templates/new?order=%7B%22name%22:%22Box%22%7D",
            "/templates",
            Map.of("name", "Box", "order", ORDER_JSON, "ask.load", "always", "as.load", "kg"),
            and(
                refused("order", "as.load"),
                and(
                    and(refused(asked()), named("as.goal")),
                    Map.of("name", NAME_OF_100, "shared", TAKEN)))),
        FormCase.of(
            "templates/{template}/edit",
            "/templates/{id}/edit",
            Map.of("name", "Usual"),
            and(
                refused("order", "as.load", "as.goal"),
                and(
                    and(refused(asked()), named()),
                    Map.of("name", NAME_OF_100, "shared", TAKEN, "version", CONFLICT)))),
        FormCase.of(
            "templates/{template}",
            "/templates/{id}",
            Map.of("values.kg", "2", "values.toStation", "Mill"),
            and(refused("values.kg", "values.toStation", "when"), Map.of("idempotencyKey", TAKEN))),
        FormCase.of(
            "templates/{template}",
            "/templates/{id}",
            Map.of(
                "values.kg",
                "2",
                "values.toStation",
                "",
                "values.toX",
                "3.45",
                "values.toY",
                "9.45"),
            refused("values.toX", "values.toY")),
        FormCase.of(
            "templates/{template}",
            "/templates/{id}",
            and(
                Map.of("values.kg", "2", "values.toStation", "Mill"),
                Map.of("when", "every", "first", DAY, "everyMinutes", "60", "until", DAY)),
            refused("first", "everyMinutes", "until")),
        FormCase.of(
            "templates/{template}",
            "/templates/{id}",
            and(
                Map.of("values.kg", "2", "values.toStation", "Mill"),
                Map.of("when", "weekly", "weekday", "MONDAY", "time", "08:00")),
            refused("weekday", "time", "zone")),
        FormCase.of("templates", "/templates/{id}/delete", Map.of(), Map.of("version", CONFLICT))
            .answeredWith(409), // a schedule uses it
        FormCase.of(
            "robots",
            "/robots",
            Map.of("name", "Spare", "host", "127.0.0.1", "port", "9", "maxLoad", "5"),
            refused(
                "name", "host", "port", "maxLoad", "parking", "code", "gateway", "floor", "link")),
        FormCase.of(
                "robots",
                "/robots",
                Map.of(
                    "name",
                    "Absent",
                    "host",
                    "127.0.0.1",
                    "port",
                    "9",
                    "maxLoad",
                    "5",
                    "link",
                    "http",
                    "token",
                    "0123456789abcdef"),
                refused("token", "fingerprint"))
            .answeredWith(422), // that name is taken
        FormCase.of(
                "robots/Absent",
                "/robots/{name}/pair",
                Map.of("host", "127.0.0.3", "code", AttackedServer.PAIRING_CODE),
                and(refused("host", "port", "code"), Map.of("version", CONFLICT)))
            .answeredWith(422),
        FormCase.of(
                "robots/Absent",
                "/robots/{name}/move",
                Map.of("floor", "Loft", "x", "1", "y", "1", "heading", "0"),
                refused("floor", "x", "y", "heading"))
            .answeredWith(422),
        FormCase.of(
                "robots/Absent",
                "/robots/{name}/locate",
                Map.of("x", "1", "y", "1", "heading", "0"),
                refused("x", "y", "heading"))
            .answeredWith(422),
        FormCase.of(
            "robots/Absent",
            "/robots/{name}/change",
            Map.of("host", "127.0.0.4", "maxLoad", "57"),
            and(
                refused("host", "port", "maxLoad", "parking", "gateway"),
                Map.of("version", CONFLICT))),
        FormCase.of(
            "robots/Absent",
            "/robots/{name}/limits",
            Map.of("reading", "range", "low", "1"),
            refused("reading", "low", "high")),
        FormCase.of(
            "notices/settings",
            "/notices/settings",
            Map.of("quietFrom", "22:00", "quietUntil", "06:00"),
            and(
                and(
                    refused("quietFrom", "quietUntil", "zone"),
                    Map.of("ownTasksOnly", TAKEN, "ends", TAKEN)),
                refused(NoticeKind.ALL.stream().map(NoticeKind::word).toArray(String[]::new)))),
        FormCase.of(
            "notices/webhooks",
            "/notices/webhooks",
            Map.of("url", "https://8.8.8.8/", "kinds", "charger-faulty"),
            refused("url", "kinds")),
        FormCase.of(
            "notices/webhooks",
            "/notices/webhooks/{id}/change",
            Map.of("url", "https://8.8.8.8/", "kinds", "charger-faulty"),
            and(refused("url", "kinds"), Map.of("enabled", TAKEN))),
        FormCase.of(
            "cameras",
            "/cameras",
            Map.of("name", "Door{n}", "url", "http://127.0.0.1:9/", "robot", "", "floor", "lab"),
            refused("name", "url", "robot", "floor")),
        FormCase.of(
            "cameras?edit=1",
            "/cameras/{id}/change",
            Map.of("name", "Hatch", "url", "http://127.0.0.1:9/", "robot", "", "floor", "lab"),
            refused("name", "url", "robot", "floor")),
        FormCase.of(
            "network",
            "/network",
            Map.of("name", "Camera{n}", "kind", "camera", "hardwareAddress", "02:00:5e:10:00:0a"),
            refused("name", "kind", "hardwareAddress", "address")),
        FormCase.of(
            "network?edit=1",
            "/network/{id}/change",
            Map.of("name", "Gate", "kind", "camera", "address", "10.0.7.20"),
            refused("name", "kind", "hardwareAddress", "address")),
        FormCase.of(
            "sites",
            "/sites",
            Map.of("name", "north{n}", "manager", "Nora", "password", WebTestServer.PASSWORD),
            and(refused("name", "manager"), Map.of("password", PASSWORD))),
        FormCase.of(
            "users",
            "/users",
            Map.of("name", "New{n}", "password", WebTestServer.PASSWORD),
            and(refused("name", "email", "role"), Map.of("password", PASSWORD))),
        FormCase.of(
            "users/{clerk}",
            "/users/{id}/change",
            Map.of("role", "MANAGER"),
            Map.of("role", REFUSED, "disabled", TAKEN, "version", CONFLICT)),
        FormCase.of(
            "users/{clerk}",
            "/users/{id}/password",
            Map.of("password", WebTestServer.PASSWORD),
            Map.of("password", PASSWORD)),
        FormCase.of(
            "users/{clerk}",
            "/users/{id}/email",
            Map.of("email", "clara@example.org"),
            Map.of("email", REFUSED, "version", CONFLICT)),
        FormCase.of(
            "users/{own}",
            "/users/{id}/password",
            Map.of("old", WebTestServer.PASSWORD, "password", WebTestServer.PASSWORD),
            Map.of("old", REFUSED)),
        FormCase.of(
            "users/{own}",
            "/users/{id}/email",
            Map.of("email", "max@example.org", "password", WebTestServer.PASSWORD),
            Map.of("password", REFUSED)),
        FormCase.of(
            "users/{own}",
            "/users/{id}/tokens",
            Map.of(
                "tokenName", "for a program",
                "days", "30",
                "scopes", "read",
                "password", WebTestServer.PASSWORD),
            Map.of(
                "tokenName", NAME_OF_64,
                "days", REFUSED,
                "scopes", REFUSED,
                "password", REFUSED)),
        FormCase.of(
                "users/{clerk}",
                "/users/{id}/delete",
                Map.of("tasks", "none"),
                refused("tasks", "load", "schedules", "tokens", "to"))
            .answeredWith(422));
  }

  /** Those of people who are not logged in. */
  static List<FormCase> ofStrangers() {
    return List.of(
        FormCase.of(
            "",
            "/",
            Map.of("name", "guest{n}", "password", WebTestServer.PASSWORD),
            Map.of("name", REFUSED, "password", REFUSED, "next", TAKEN)),
        FormCase.of("forgotten", "/forgotten", Map.of("user", "nobody"), Map.of("user", TAKEN)),
        FormCase.of(
            "reset?secret={secret}",
            "/reset",
            Map.of("password", WebTestServer.PASSWORD),
            Map.of("password", PASSWORD, "username", TAKEN)));
  }

  /** Those that ask for something and change nothing. */
  static List<FormCase> ofQuestions() {
    return List.of(
        FormCase.of(
                "tasks",
                "/tasks",
                Map.of(),
                and(
                    refused("state", "from", "until", "sort", "followed"),
                    Map.of("robot", TAKEN, "floor", TAKEN, "text", TAKEN, "user", TAKEN)))
            .answeredWith(200),
        FormCase.of(
                "history",
                "/history",
                Map.of(),
                and(
                    refused("task", "from", "until", "kind"),
                    Map.of("robot", TAKEN, "floor", TAKEN, "user", TAKEN)))
            .answeredWith(200),
        FormCase.of("statistics", "/statistics", Map.of(), refused("from", "to", "zone", "floor"))
            .answeredWith(200),
        FormCase.of(
                "robots",
                "/robots",
                Map.of(),
                and(refused("floor", "state"), Map.of("text", TAKEN)))
            .answeredWith(200),
        FormCase.of("loads", "/loads", Map.of(), refused("floor")).answeredWith(200),
        FormCase.of(
                "schedules",
                "/schedules",
                Map.of(),
                and(refused("floor", "state"), Map.of("text", TAKEN)))
            .answeredWith(200),
        FormCase.of("users", "/users", Map.of(), Map.of("text", TAKEN)).answeredWith(200));
  }

  private FormCases() {}

  /** What a template may ask for. */
  private static String[] asked() {
    return Stream.of("name", "load", "start", "goal", "priority", "onlyRobots", "deadline")
        .map("ask."::concat)
        .toArray(String[]::new);
  }

  /** Names for what is not asked for count for nothing. */
  private static Map<String, Verdict> named(String... more) {
    return Stream.concat(
            Stream.of("as.name", "as.start", "as.priority", "as.onlyRobots", "as.deadline"),
            Stream.of(more))
        .collect(Collectors.toMap(field -> field, field -> TAKEN));
  }

  private static Map<String, Verdict> refused(String... fields) {
    return Arrays.stream(fields).collect(Collectors.toMap(field -> field, field -> REFUSED));
  }

  private static <T> Map<String, T> and(Map<String, T> first, Map<String, T> second) {
    return Stream.of(first, second).collect(HashMap::new, HashMap::putAll, HashMap::putAll);
  }
}
