package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.icegreen.greenmail.util.GreenMail;
import com.icegreen.greenmail.util.ServerSetup;
import java.net.URI;
import java.net.URLEncoder;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.app.config.Setting;
import org.toqa.web.TestClient;
import org.toqa.web.route.Routes;

/**
 * Every field of every form is given every attack, with all other fields filled in as they should
 * be, while the fleet carries tasks that bear an attack as their names.
 */
class FormAttacksTest {
  private static final Pattern LINK = Pattern.compile("reset\\?secret=([^<\"\\s]+)");

  /**
   * Forms of states that no page is in here. They have buttons only, but for the first three: the
   * third is attacked together with the pause that it ends.
   */
  private static final Set<String> NOT_SHOWN =
      Set.of(
          "/first-start",
          "/tasks/{id}/answer",
          "/fleet/resume",
          "/tasks/{id}/resume",
          "/schedules/{id}/resume",
          "/robots/{name}/in-service",
          "/robots/{name}/resume",
          "/floors/{floor}/resume");

  /** Attacked cell by cell, and as an order of the API. */
  private static final Set<String> ELSEWHERE = Set.of("/tasks/import", "/tasks/{id}/cancel");

  /** Whose own account is changed, which ends what this user has logged in elsewhere. */
  private static final String OWN = "Olga";

  @TempDir private Path data;

  private final GreenMail mail =
      new GreenMail(new ServerSetup(0, "127.0.0.1", ServerSetup.PROTOCOL_SMTP));
  private final Map<String, String> places = new LinkedHashMap<>();
  private final List<String> faults = new ArrayList<>();
  private AttackedServer server;
  private TestClient manager;
  private CarriedTasks tasks;
  private int sent;

  @BeforeEach
  void start() throws Exception {
    mail.start();
    Map<Setting, @Nullable String> settings = new EnumMap<>(Setting.class);
    settings.put(Setting.MAIL_HOST, "127.0.0.1");
    settings.put(Setting.MAIL_PORT, String.valueOf(mail.getSmtp().getPort()));
    settings.put(Setting.MAIL_SECURITY, "none");
    settings.put(Setting.MAIL_FROM, "toqa@example.org");
    settings.put(Setting.SITE, "https://toqa.example.org");
    server = AttackedServer.start(data, settings);
    manager = server.signedIn(AttackedServer.MANAGER);
    tasks = new CarriedTasks(manager, Attack.SCRIPT.text());
    server.addUser(OWN);
    places.put("own", String.valueOf(server.userId(OWN)));
    places.put("self", String.valueOf(server.userId(AttackedServer.MANAGER)));
    places.put("clerk", String.valueOf(server.userId(AttackedServer.CLERK)));
    places.put("floor", "lab");
    places.put("name", "Absent");
    places.put("id", String.valueOf(tasks.task()));
    String robot = "{\"name\":\"Absent\",\"host\":\"127.0.0.1\",\"port\":9,\"maxLoad\":5}";
    assertEquals(201, manager.postJson("api/v1/robots", robot).statusCode());
    HttpResponse<String> held = submit(manager, find("tasks/new", "/tasks/new", manager), ORDER);
    places.put("heldTask", location(held).replaceFirst(".*/", ""));
    String hold = "api/v1/tasks/" + places.get("heldTask") + "/hold";
    assertEquals(200, manager.postJson(hold, "").statusCode());
    Map<String, String> schedule = new LinkedHashMap<>(ORDER);
    schedule.putAll(Map.of("when", "once", "first", "2099-01-01T10:00"));
    assertEquals(
        303, submit(manager, find("tasks/new", "/tasks/new", manager), schedule).statusCode());
  }

  private static final Map<String, String> ORDER =
      Map.of("name", "Held", "load", "2", "startStation", "Store A", "goalStation", "Store B");

  @AfterEach
  void stop() throws Exception {
    server.close();
    mail.stop();
  }

  @Test
  void whatIsTypedIsTextInEveryFieldOfEveryForm() throws Exception {
    for (FormCase form : FormCases.ofUsers()) {
      attack(form);
    }
    for (FormCase form : FormCases.ofStrangers()) {
      attack(form);
    }
    for (FormCase question : FormCases.ofQuestions()) {
      attack(question);
    }
    attackTables();
    assertEquals("", String.join("\n", faults));
    assertTrue(sent > 1000, "only " + sent + " attacks");
    tasks.awaitDone();
    assertPagesAreHarmless();
  }

  @Test
  void everyFieldOfEveryFormIsAttacked() {
    Map<String, Set<String>> attacked =
        Stream.of(FormCases.ofUsers(), FormCases.ofStrangers(), FormCases.ofQuestions())
            .flatMap(List::stream)
            .collect(
                Collectors.toMap(
                    FormCase::route,
                    form -> form.attacked().keySet(),
                    (a, b) -> {
                      Set<String> both = new TreeSet<>(a);
                      both.addAll(b);
                      return both;
                    }));
    Set<String> reached = new TreeSet<>(NOT_SHOWN);
    for (String page : pages()) {
      TestClient reader = List.of("", "forgotten").contains(page) ? server.stranger() : manager;
      for (PageForm form : PageForm.in(Markup.read(reader.get(page).body()))) {
        String route = route(form);
        reached.add(route);
        for (String field : form.fields().keySet()) {
          if (!field.equals("_csrf") && !ELSEWHERE.contains(route)) {
            if (!attacked.getOrDefault(route, Set.of()).contains(field)) {
              faults.add("Nobody attacks " + field + " of " + route);
            }
          }
        }
      }
    }
    assertEquals("", String.join("\n", faults));
    List<String> missing =
        Routes.all().stream()
            .filter(route -> route.method().equals("POST") && !route.isApi())
            .map(route -> route.path())
            .filter(path -> !reached.contains(path) && !attacked.containsKey(path))
            .toList();
    assertEquals(List.of(), missing);
  }

  private void attack(FormCase form) throws Exception {
    for (String field : form.attacked().keySet()) {
      for (Attack attack : Attack.values()) {
        send(form, field, attack);
      }
      tasks.goOn();
    }
    send(form, null, null);
  }

  private void send(FormCase form, @Nullable String field, @Nullable Attack attack)
      throws Exception {
    sent++;
    boolean isAnonymous = FormCases.ofStrangers().contains(form);
    boolean asksForPassword = form.page().equals("users/{own}");
    TestClient client =
        isAnonymous ? server.stranger() : asksForPassword ? server.signedIn(OWN) : manager;
    places.put("n", String.valueOf(sent));
    if (form.page().isEmpty()) {
      server.addUser("guest" + sent);
    }
    if (form.page().contains("{secret}")) {
      places.put("secret", newSecret());
    }
    PageForm page = find(filled(form.page()), form.route(), client);
    Map<String, String> values = new LinkedHashMap<>();
    form.filled().forEach((name, value) -> values.put(name, filled(value)));
    String where = form + " good";
    int expected = form.good();
    if (field != null && attack != null) {
      values.put(field, attack.text());
      where = form.page() + " -> " + form.route() + " " + field + " " + attack;
      expected = form.expected(field, attack);
    }
    String before = server.stored();
    HttpResponse<String> answer = submit(client, page, values);
    if (answer.statusCode() != expected) {
      faults.add(where + " answered " + answer.statusCode() + ", not " + expected);
    }
    assertHarmless(where, answer);
    if (expected >= 400) {
      assertEquals(before, server.stored(), where + " is refused and stored all the same");
    } else if (answer.statusCode() == 303 && location(answer).matches(".*/tasks/\\d+")) {
      assertShownWhole(where, values, client, location(answer));
    }
    if (form.route().equals("/fleet/pause")) {
      HttpResponse<String> resumed = submit(manager, find("map", "/fleet/resume", manager), values);
      assertHarmless("/fleet/resume " + attack, resumed);
      assertEquals(303, resumed.statusCode());
    }
    if (client != manager) {
      client.close();
    }
  }

  /** Every cell of a table, and the fields beside it. */
  private void attackTables() throws Exception {
    for (Attack attack : Attack.values()) {
      for (String place :
          List.of(
              "name", "load", "start", "goal", "floor", "priority", "deadline", "zone", "key")) {
        sent++;
        Map<String, String> row = new LinkedHashMap<>();
        row.putAll(Map.of("name", "Box", "load", "2", "start", "Mill", "goal", "Store A"));
        row.putAll(Map.of("floor", "lab", "priority", "1", "deadline", "2099-01-01T10:00"));
        Map<String, String> fields =
            new LinkedHashMap<>(find("tasks/import", "/tasks/import", manager).fields());
        fields.remove("file");
        switch (place) {
          case "zone" -> fields.put("zone", attack.text());
          case "key" -> fields.put("idempotencyKey", attack.text());
          default -> row.put(place, attack.text());
        }
        boolean isTaken = place.equals("key") || place.equals("name") && attack.isNameWithin(100);
        String before = server.stored();
        HttpResponse<String> answer =
            manager.postFile("tasks/import", fields, "tasks.csv", table(row));
        String where = "a table's " + place + " " + attack;
        assertHarmless(where, answer);
        if (answer.statusCode() != (isTaken ? 303 : 422)) {
          faults.add(where + " answered " + answer.statusCode());
        } else if (!isTaken) {
          assertEquals(before, server.stored(), where);
        } else {
          String newest = manager.get("api/v1/tasks?limit=1").body();
          String id = newest.replaceFirst("(?s).*?\"id\":(\\d+).*", "$1");
          assertShownWhole(where, row, manager, "/tasks/" + id);
        }
      }
      tasks.goOn();
    }
  }

  private static byte[] table(Map<String, String> row) {
    String cells =
        row.values().stream()
            .map(cell -> '"' + cell.replace("\"", "\"\"") + '"')
            .collect(Collectors.joining(","));
    return (String.join(",", row.keySet()) + "\n" + cells + "\n").getBytes(StandardCharsets.UTF_8);
  }

  private void assertShownWhole(
      String where, Map<String, String> values, TestClient client, String task) {
    HttpResponse<String> shown = client.get(task);
    assertHarmless(where, shown);
    assertTrue(
        Markup.read(shown.body()).text().contains(values.getOrDefault("name", "").strip()),
        where + " is not shown as it was typed");
    tasks.cancel(Long.parseLong(task.replaceFirst(".*/", "")));
  }

  private String newSecret() throws InterruptedException {
    String page = filled("users/{clerk}");
    HttpResponse<String> answer =
        submit(manager, find(page, "/users/{id}/reset-link", manager), Map.of());
    Matcher link = LINK.matcher(answer.body());
    assertTrue(link.find(), answer.body());
    return link.group(1);
  }

  private void assertPagesAreHarmless() {
    int shown = 0;
    for (String page : pages()) {
      HttpResponse<String> answer = manager.get(page);
      assertHarmless(page, answer);
      shown += Markup.read(answer.body()).text().contains(Attack.SCRIPT.text()) ? 1 : 0;
    }
    assertTrue(shown >= 2, "Only " + shown + " pages show the name of the task.");
  }

  private void assertHarmless(String where, HttpResponse<String> answer) {
    server.observed(answer);
    assertTrue(answer.statusCode() < 500, where + " answered " + answer.statusCode());
    assertTrue(
        answer.headers().allValues("Set-Cookie").stream().noneMatch(c -> c.contains(Attack.MARK)),
        where + " sets a cookie of an attacker");
    answer
        .headers()
        .firstValue("Location")
        .ifPresent(
            to ->
                assertEquals(
                    server.root().getAuthority(), server.root().resolve(to).getAuthority(), where));
    if (answer.headers().firstValue("Content-Type").orElse("").startsWith("text/html")) {
      Markup.read(answer.body()).assertHarmless(where);
    }
  }

  /** A page may be a moment behind what was done before. */
  private PageForm find(String page, String route, TestClient client) throws InterruptedException {
    for (long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(20); ; ) {
      HttpResponse<String> answer = server.observed(client.get(page));
      Optional<PageForm> found =
          PageForm.in(Markup.read(answer.body())).stream()
              .filter(form -> route(form).equals(route))
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
    List<String> pages = new ArrayList<>(List.of(filled("users/{clerk}"), filled("users/{self}")));
    Routes.all().stream()
        .filter(route -> route.method().equals("GET") && !route.isApi())
        .map(route -> route.path())
        .filter(path -> !path.contains("*") && !path.contains("{language}"))
        .filter(path -> !path.equals("/first-start"))
        .map(path -> filled(path).substring(1))
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

  private String filled(String template) {
    String text = template;
    for (Map.Entry<String, String> place : places.entrySet()) {
      text = text.replace("{" + place.getKey() + "}", place.getValue());
    }
    return text;
  }

  private static String location(HttpResponse<String> answer) {
    return answer.headers().firstValue("Location").orElseThrow();
  }
}
