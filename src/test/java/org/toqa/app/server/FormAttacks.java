package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URI;
import java.net.URLEncoder;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.web.TestClient;
import org.toqa.web.route.Routes;

/**
 * Every field of every form is given every attack, with all other fields filled in as they should
 * be, while the fleet carries tasks that bear an attack as their names.
 */
final class FormAttacks {
  /**
   * Forms of states that no page is in here. They have buttons only, but for the first six: the
   * second reads what /tasks/new reads, the fifth is attacked together with the pause that it ends,
   * the sixth as an order.
   */
  private static final Set<String> NOT_SHOWN =
      Set.of(
          "/first-start",
          "/templates/new",
          "/notices/seen",
          "/tasks/{id}/answer",
          "/tasks/{id}/load-removed",
          "/tasks/{id}/delete",
          "/tasks/{id}/unfollow",
          "/tasks/{id}/go-on",
          "/laboratory/runs/{id}/stop",
          "/laboratory/runs/{id}/delete",
          "/notices/webhooks/{id}/secret",
          "/notices/webhooks/{id}/test",
          "/notices/webhooks/{id}/delete",
          "/orders/{id}/hold",
          "/orders/{id}/resume",
          "/network/{id}/delete",
          "/cameras/{id}/delete",
          "/orders/{id}/retry",
          "/fleet/resume",
          "/robots/{name}/clear",
          "/schedules/{id}/resume",
          "/robots/{name}/in-service",
          "/robots/{name}/home",
          "/robots/{name}/resume",
          "/floors/{floor}/resume",
          "/floors/{floor}/seen/{id}/draw",
          "/floors/{floor}/seen/{id}/dismiss",
          "/floors/{floor}/delete",
          "/floors/{floor}/supervision/stop",
          "/floors/{floor}/supervision/look",
          "/floors/{floor}/supervision/boxes/{box}/leave-out",
          "/floors/{floor}/exploration/stop",
          "/floors/{floor}/exploration/draw",
          "/sites/{site}/visit",
          "/sites/{site}/delete");

  /** Attacked cell by cell, or without words: numbers that the page has. */
  private static final Set<String> ELSEWHERE = Set.of("/tasks/import", "/notices/seen");

  private final AttackRun run;
  private final AttackedServer server;
  private final TestClient manager;

  FormAttacks(AttackRun run) {
    this.run = run;
    this.server = run.server();
    this.manager = run.manager();
  }

  void attack() throws Exception {
    run.holdTask();
    for (List<FormCase> forms :
        List.of(FormCases.ofUsers(), FormCases.ofStrangers(), FormCases.ofQuestions())) {
      for (FormCase form : forms) {
        attack(form);
      }
    }
    attackTables();
  }

  /** Fields of forms that nobody attacks, and routes of forms that are nowhere. */
  List<String> left() throws InterruptedException {
    List<String> left = new ArrayList<>();
    Map<String, Set<String>> attacked = new TreeMap<>();
    Stream.of(FormCases.ofUsers(), FormCases.ofStrangers(), FormCases.ofQuestions())
        .flatMap(List::stream)
        .forEach(
            form ->
                attacked
                    .computeIfAbsent(form.route(), route -> new TreeSet<>())
                    .addAll(form.attacked().keySet()));
    run.holdTask();
    run.tasks().goOn();
    Set<String> reached = new TreeSet<>(NOT_SHOWN);
    for (String page : pages()) {
      try (TestClient reader = server.stranger()) {
        boolean isAnonymous = List.of("", "forgotten").contains(page);
        for (PageForm form :
            PageForm.in(Markup.read((isAnonymous ? reader : manager).get(page).body()))) {
          String route = route(form);
          reached.add(route);
          form.fields().keySet().stream()
              .filter(field -> !field.equals("_csrf") && !ELSEWHERE.contains(route))
              .filter(field -> !field.startsWith("parameter.")) // each read as the seed is
              .filter(field -> !attacked.getOrDefault(route, Set.of()).contains(field))
              .forEach(field -> left.add(field + " of " + route));
        }
      }
    }
    Routes.all().stream()
        .filter(route -> route.method().equals("POST") && !route.isApi())
        .map(route -> route.path())
        .filter(path -> !reached.contains(path) && !attacked.containsKey(path))
        .forEach(left::add);
    return left;
  }

  private void attack(FormCase form) throws Exception {
    for (String field : form.attacked().keySet()) {
      for (Attack attack : run.nextAttacks()) {
        send(form, field, attack);
      }
      run.tasks().goOn();
    }
    send(form, null, null);
  }

  private void send(FormCase form, @Nullable String field, @Nullable Attack attack)
      throws Exception {
    run.next();
    boolean isAnonymous = FormCases.ofStrangers().contains(form);
    boolean asksForPassword = form.page().equals("users/{own}");
    TestClient client = isAnonymous ? server.stranger() : asksForPassword ? run.own() : manager;
    if (form.page().isEmpty()) {
      run.addGuest();
    }
    if (form.page().contains("{secret}")) {
      run.createSecret();
    }
    String method = FormCases.ofQuestions().contains(form) ? "get" : "post";
    PageForm page = find(run.filled(form.page()), method, form.route(), client);
    Map<String, String> values = new LinkedHashMap<>();
    form.filled().forEach((name, value) -> values.put(name, run.filled(value)));
    String where = form.page() + " -> " + form.route() + " good";
    int expected = form.good();
    if (field != null && attack != null) {
      values.put(field, attack.text());
      where = form.page() + " -> " + form.route() + " " + field + " " + attack;
      boolean isAddress = page.method().equals("get");
      expected = isAddress && attack == Attack.VERY_LONG ? 400 : form.expected(field, attack);
    }
    List<String> before = server.stored();
    HttpResponse<String> answer = submit(client, page, values);
    run.expectStatus(expected, answer, where);
    check(where, answer);
    if (answer.statusCode() >= 400) {
      run.expectUnchanged(before, where);
    }
    if (answer.statusCode() == 303
        && form.route().equals("/tasks/new")
        && location(answer).matches(".*/tasks/\\d+")) {
      checkShownWhole(where, values, location(answer));
    }
    if (answer.statusCode() == 303 && form.route().equals("/tasks/{id}/edit")) {
      awaitShown(run.filled(form.page()), form.route(), values.getOrDefault("name", "").strip());
    }
    if (answer.statusCode() == 303 && form.route().equals("/tasks/{id}/cancel")) {
      run.awaitEndOfHold();
    }
    if (answer.statusCode() == 303 && form.route().equals("/floors")) {
      run.removeFloor(values.getOrDefault("name", ""));
    }
    if (answer.statusCode() == 303 && form.route().equals("/templates")) {
      run.removeTemplates();
    }
    if (answer.statusCode() == 303 && form.route().equals("/sites")) {
      run.removeSite(values.getOrDefault("name", ""));
    }
    if (form.route().equals("/fleet/pause")) {
      HttpResponse<String> resumed =
          submit(manager, find("map", "post", "/fleet/resume", manager), values);
      check("/fleet/resume back " + attack, resumed);
      run.expectStatus(303, resumed, "/fleet/resume back " + attack);
    }
    if (isAnonymous) {
      client.close();
    }
  }

  /** Every cell of a table, and the fields beside it. */
  private void attackTables() throws Exception {
    for (String place :
        List.of(
            "name",
            "load",
            "pieces",
            "start",
            "goal",
            "floor",
            "priority",
            "deadline",
            "zone",
            "key")) {
      for (Attack attack : run.nextAttacks()) {
        run.next();
        Map<String, String> row = new LinkedHashMap<>();
        row.putAll(Map.of("name", "Box", "load", "2", "start", "Mill", "goal", "Store A"));
        row.putAll(Map.of("floor", "lab", "priority", "1", "deadline", "2099-01-01T10:00"));
        Map<String, String> fields =
            new LinkedHashMap<>(find("tasks/import", "post", "/tasks/import", manager).fields());
        fields.remove("file");
        switch (place) {
          case "zone" -> fields.put("zone", attack.text());
          case "key" -> fields.put("idempotencyKey", attack.text());
          default -> row.put(place, attack.text());
        }
        boolean isTaken = place.equals("key") || (place.equals("name") && attack.isNameWithin(100));
        List<String> before = server.stored();
        HttpResponse<String> answer =
            manager.postFile("tasks/import", fields, "tasks.csv", table(row));
        String where = "a table's " + place + " " + attack;
        check(where, answer);
        run.expectStatus(isTaken ? 303 : 422, answer, where);
        if (answer.statusCode() >= 400) {
          run.expectUnchanged(before, where);
        } else {
          String newest = manager.get("api/v1/tasks?limit=1").body();
          String id = newest.replaceFirst("(?s).*?\"id\":(\\d+).*", "$1");
          checkShownWhole(where, row, "/tasks/" + id);
        }
      }
      run.tasks().goOn();
    }
  }

  private static byte[] table(Map<String, String> row) {
    String cells =
        row.values().stream()
            .map(cell -> '"' + cell.replace("\"", "\"\"") + '"')
            .collect(Collectors.joining(","));
    return (String.join(",", row.keySet()) + "\n" + cells + "\n").getBytes(StandardCharsets.UTF_8);
  }

  private void checkShownWhole(String where, Map<String, String> values, String task) {
    HttpResponse<String> shown = manager.get(task);
    check(where, shown);
    run.expect(
        Markup.read(shown.body()).text().contains(values.getOrDefault("name", "").strip()),
        where + " is not shown as it was typed");
    run.tasks().cancel(Long.parseLong(task.replaceFirst(".*/", "")));
  }

  /** The page may be a moment behind, and who edits from an older one is told so. */
  private void awaitShown(String page, String route, String name) throws InterruptedException {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(20);
    while (!name.equals(find(page, "post", route, manager).fields().get("name"))) {
      assertTrue(System.nanoTime() < end, page + " does not show " + name);
      TimeUnit.MILLISECONDS.sleep(5);
    }
  }

  /** All pages show what was typed as text. */
  void readPages() {
    int shown = 0;
    for (String page : pages()) {
      HttpResponse<String> answer = manager.get(page);
      check(page, answer);
      shown += Markup.read(answer.body()).text().contains(Attack.SCRIPT.text()) ? 1 : 0;
    }
    run.expect(shown >= 2, "Only " + shown + " pages show the name of the task.");
  }

  private void check(String where, HttpResponse<String> answer) {
    run.check(where, answer);
  }

  /** A page may be a moment behind what was done before. */
  private PageForm find(String page, String method, String route, TestClient client)
      throws InterruptedException {
    for (long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(20); ; ) {
      HttpResponse<String> answer = server.observed(client.get(page));
      if (page.contains("?secret=")) {
        answer = server.observed(client.get(location(answer).substring(1)));
      }
      Optional<PageForm> found =
          PageForm.in(Markup.read(answer.body())).stream()
              .filter(form -> form.method().equals(method) && route(form).equals(route))
              .findFirst();
      if (found.isPresent()) {
        return found.get();
      }
      assertTrue(System.nanoTime() < end, page + " has no form for " + route);
      TimeUnit.MILLISECONDS.sleep(20);
    }
  }

  private HttpResponse<String> submit(
      TestClient client, PageForm form, Map<String, String> values) {
    Map<String, String> all = new LinkedHashMap<>(form.fields());
    all.putAll(values);
    String path = form.action().substring(1);
    if (form.method().equals("post")) {
      all.values().removeIf(value -> value.isEmpty());
      return client.postWithoutToken(path, all);
    }
    return client.get(
        path
            + "?"
            + all.entrySet().stream()
                .map(
                    entry ->
                        entry.getKey()
                            + "="
                            + URLEncoder.encode(entry.getValue(), StandardCharsets.UTF_8))
                .collect(Collectors.joining("&")));
  }

  /** All pages that are read, each with something on it. */
  private List<String> pages() {
    List<String> pages =
        Stream.of(
                "users/{clerk}",
                "users/{self}",
                "tasks/{held}",
                "orders/{order}",
                "templates/new?order=%7B%22name%22:%22Box%22%7D",
                "templates/{template}",
                "templates/{template}/edit",
                "robots/r1",
                "robots/Absent")
            .map(run::filled)
            .collect(Collectors.toCollection(ArrayList::new));
    Routes.all().stream()
        .filter(route -> route.method().equals("GET") && !route.isApi())
        .map(route -> route.path())
        .filter(path -> !path.contains("*") && !path.contains("{language}"))
        .filter(path -> !path.equals("/first-start"))
        .map(path -> run.filled(path.replace("{topic}", "tasks")).substring(1))
        .forEach(pages::add);
    return pages;
  }

  /** The route that takes the form. */
  private static String route(PageForm form) {
    return Routes.find(URI.create(form.action()).getPath())
        .flatMap(match -> match.route(form.method().toUpperCase(Locale.ROOT)))
        .orElseThrow(() -> new AssertionError("No route takes " + form))
        .path();
  }

  private static String location(HttpResponse<String> answer) {
    return answer.headers().firstValue("Location").orElseThrow();
  }
}
