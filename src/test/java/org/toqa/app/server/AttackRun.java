package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.icegreen.greenmail.util.GreenMail;
import com.icegreen.greenmail.util.ServerSetup;
import java.io.IOException;
import java.net.URI;
import java.net.URLEncoder;
import java.net.http.HttpHeaders;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.sql.SQLException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.toqa.app.config.Setting;
import org.toqa.web.TestClient;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * A server with something of each kind on its pages, whose fleet carries one task after another,
 * each with an attack as its name; and what the attacks on it have shown.
 */
final class AttackRun implements AutoCloseable {
  private static final JsonMapper JSON = JsonMapper.shared();

  private static final String ORDER =
      "{\"name\":\"Held\",\"load\":2,\"start\":{\"station\":\"Store A\"},"
          + "\"goal\":{\"station\":\"Store B\"}}";

  /** Long enough on its way for somebody to see it there. */
  private static final String LONG_ORDER = ORDER.replace("Store B", "Goods-in 1");

  /** Whether each field is given all attacks; otherwise a sixth of them, which goes round. */
  private static final boolean IS_WHOLE = "whole".equals(System.getProperty("toqa.attacks"));

  private static final int SIXTHS = 6;

  /** Whose own account is changed, which ends what this user has logged in elsewhere. */
  static final String OWN = "Olga";

  private final GreenMail mail;
  private final Map<String, String> places = new LinkedHashMap<>();
  private final List<String> faults = new ArrayList<>();
  private final List<Long> heldTasks = new ArrayList<>();
  private final AttackedServer server;
  private final TestClient manager;
  private final String csrf;
  private final CarriedTasks tasks;
  private @Nullable TestClient own;
  private int ownUsed;
  private int tried;
  private int fields = Integer.getInteger("toqa.seed", 1);

  /**
   * @param data an empty folder
   */
  AttackRun(Path data) throws Exception {
    ServerSetup smtp = new ServerSetup(0, "127.0.0.1", ServerSetup.PROTOCOL_SMTP);
    smtp.setServerStartupTimeout(60_000);
    mail = new GreenMail(smtp);
    mail.start();
    Map<Setting, @Nullable String> settings = new EnumMap<>(Setting.class);
    settings.put(Setting.MAIL_HOST, "127.0.0.1");
    settings.put(Setting.MAIL_PORT, String.valueOf(mail.getSmtp().getPort()));
    settings.put(Setting.MAIL_SECURITY, "none");
    settings.put(Setting.MAIL_FROM, "toqa@example.org");
    settings.put(Setting.URL, "https://toqa.example.org");
    settings.put(Setting.GATEWAYS_TRUSTED, "dock=" + "0".repeat(64));
    settings.put(Setting.GATEWAYS_PORT, "0");
    server = AttackedServer.start(data, settings);
    manager = server.signedIn(AttackedServer.MANAGER);
    csrf = manager.csrf();
    addWaitingTask();
    addLeftLoad();
    tasks = new CarriedTasks(manager, Attack.SCRIPT.text());
    server.addUser(OWN);
    places.put("own", String.valueOf(server.userId(OWN)));
    places.put("self", String.valueOf(server.userId(AttackedServer.MANAGER)));
    places.put("clerk", String.valueOf(server.userId(AttackedServer.CLERK)));
    places.put("floor", "lab");
    places.put("site", "none");
    places.put("name", "Absent");
    String robot = "{\"name\":\"Absent\",\"host\":\"127.0.0.1\",\"port\":9,\"maxLoad\":50}";
    assertEquals(201, manager.postJson("api/v1/robots", robot).statusCode());
    String loft = "{\"name\":\"Loft\",\"width\":3,\"height\":3,\"resolution\":1}";
    assertEquals(201, manager.postJson("api/v1/floors", loft).statusCode());
    String schedule = "{\"task\":" + ORDER + ",\"at\":\"2099-01-01T10:00:00Z\"}";
    assertEquals(201, manager.postJson("api/v1/schedules", schedule).statusCode());
    String template =
        """
        {"name":"Usual","order":%s,
         "parameters":[{"name":"to","field":"goal"},{"name":"kg","field":"load"}]}
        """
            .formatted(ORDER);
    HttpResponse<String> stored = manager.postJson("api/v1/templates", template);
    assertEquals(201, stored.statusCode());
    places.put("template", stored.body().replaceFirst("(?s).*?\"id\":(\\d+).*", "$1"));
    String used =
        """
        {"task":{"template":"Usual","values":{"to":{"station":"Mill"},"kg":2}},
         "at":"2099-01-01T10:00:00Z"}
        """;
    assertEquals(201, manager.postJson("api/v1/schedules", used).statusCode());
  }

  /** But for the first one, so that none is called as the next attack. */
  void removeTemplates() {
    Matcher ids =
        Pattern.compile("\"id\":(\\d+),\"name\"").matcher(manager.get("api/v1/templates").body());
    while (ids.find()) {
      if (!ids.group(1).equals(places.get("template"))) {
        String path = "api/v1/templates/" + ids.group(1);
        expectStatus(204, manager.sendJson("DELETE", path, ""), "removing " + path);
      }
    }
  }

  AttackedServer server() {
    return server;
  }

  TestClient manager() {
    return manager;
  }

  CarriedTasks tasks() {
    return tasks;
  }

  /** One more attack, or the same without one, is tried. */
  void next() {
    tried++;
    places.put("n", String.valueOf(tried));
  }

  /** What the next field is given. */
  List<Attack> nextAttacks() {
    int field = fields++;
    return Arrays.stream(Attack.values())
        .filter(attack -> IS_WHOLE || (attack.ordinal() + field) % SIXTHS == 0)
        .toList();
  }

  int tried() {
    return tried;
  }

  /** Who changes his own account, logged in anew before he has failed too often. */
  TestClient own() {
    if (own == null || ownUsed++ % 3 == 0) {
      own = server.signedIn(OWN);
    }
    return own;
  }

  /** Somebody whom nobody else is, so that what fails for him hinders nobody. */
  void addGuest() {
    server.addUser("guest" + tried);
  }

  /** A task that no robot is ever given, since it was on hold before there was one. */
  private void addWaitingTask() {
    commandRobots("out-of-service");
    HttpResponse<String> answer = manager.postJson("api/v1/tasks", ORDER);
    assertEquals(201, answer.statusCode(), answer.body());
    String waiting = JSON.readTree(answer.body()).get("id").asString();
    assertEquals(200, manager.postJson("api/v1/tasks/" + waiting + "/hold", "").statusCode());
    commandRobots("in-service");
    places.put("waiting", waiting);
  }

  /** An ended task whose load lies on the floor. */
  private void addLeftLoad() throws InterruptedException {
    HttpResponse<String> answer = manager.postJson("api/v1/tasks", LONG_ORDER);
    assertEquals(201, answer.statusCode(), answer.body());
    String left = JSON.readTree(answer.body()).get("id").asString();
    awaitState(left, "CARRYING");
    String here = "{\"load\":\"here\"}";
    assertEquals(200, manager.postJson("api/v1/tasks/" + left + "/cancel", here).statusCode());
    awaitState(left, "CANCELLED");
    places.put("left", left);
    String aside = "{\"place\":{\"station\":\"Store B\"}}";
    String path = "api/v1/tasks/" + left + "/load-moved";
    assertEquals(200, manager.postJson(path, aside).statusCode());
  }

  private void awaitState(String task, String state) throws InterruptedException {
    long end = System.nanoTime() + Duration.ofMinutes(1).toNanos();
    while (!JSON.readTree(manager.get("api/v1/tasks/" + task).body())
        .path("state")
        .asString()
        .equals(state)) {
      assertTrue(System.nanoTime() < end, () -> task + " is never " + state);
      TimeUnit.MILLISECONDS.sleep(10);
    }
  }

  private void commandRobots(String command) {
    for (String robot : List.of("r1", "r2")) {
      String path = "api/v1/robots/" + robot + "/" + command;
      assertEquals(200, manager.postJson(path, "").statusCode(), path);
    }
  }

  /** A task that is held, and no other, as its page says. */
  void holdTask() throws InterruptedException {
    freeRobots();
    HttpResponse<String> answer = manager.postJson("api/v1/tasks", ORDER);
    assertEquals(201, answer.statusCode(), answer.body());
    String held = JSON.readTree(answer.body()).get("id").asString();
    assertEquals(200, manager.postJson("api/v1/tasks/" + held + "/hold", "").statusCode());
    long end = System.nanoTime() + Duration.ofMinutes(1).toNanos();
    while (!manager.get("tasks/" + held).body().contains("/tasks/" + held + "/resume")) {
      assertTrue(System.nanoTime() < end, "the page offers no resume");
      TimeUnit.MILLISECONDS.sleep(10);
    }
    places.put("held", held);
    heldTasks.add(Long.parseLong(held));
    holdOrder();
  }

  /** A task that was cancelled while it was held ends when its robot has heard of it. */
  void awaitEndOfHold() throws InterruptedException {
    String task = "api/v1/tasks/" + places.get("held");
    long end = System.nanoTime() + Duration.ofMinutes(1).toNanos();
    while (JSON.readTree(manager.get(task).body()).get("held").asBoolean()) {
      assertTrue(System.nanoTime() < end, "it is still held");
      TimeUnit.MILLISECONDS.sleep(10);
    }
  }

  /** What is held may have a robot already, which does nothing else then. */
  void freeRobots() {
    heldTasks.forEach(tasks::cancel);
    heldTasks.clear();
  }

  /** An order of which all is held, so that none of it is on board. */
  private void holdOrder() {
    HttpResponse<String> answer = manager.postJson("api/v1/orders", ORDER);
    assertEquals(201, answer.statusCode(), answer.body());
    JsonNode order = JSON.readTree(answer.body());
    for (JsonNode task : order.get("tasks")) {
      long held = task.get("id").asLong();
      assertEquals(200, manager.postJson("api/v1/tasks/" + held + "/hold", "").statusCode());
      heldTasks.add(held);
    }
    places.put("order", order.get("id").asString());
  }

  /** The secret of a link by which the clerk may choose a new password. */
  void createSecret() {
    HttpResponse<String> answer =
        manager.sendJson("POST", "api/v1/users/" + places.get("clerk") + "/reset-link", "", csrf);
    assertEquals(201, answer.statusCode(), answer.body());
    String link = JSON.readTree(server.observed(answer).body()).get("link").asString();
    places.put("secret", link.replaceFirst(".*secret=", ""));
  }

  /** A text with what is in braces put in. */
  String filled(String template) {
    String text = template.replace("{id}", String.valueOf(tasks.task()));
    for (Map.Entry<String, String> place : places.entrySet()) {
      text = text.replace("{" + place.getKey() + "}", place.getValue());
    }
    return text;
  }

  /** So that no floor is called as the next attack. */
  void removeFloor(String name) {
    String segment = URLEncoder.encode(name.strip(), StandardCharsets.UTF_8).replace("+", "%20");
    expectStatus(
        204, manager.sendJson("DELETE", "api/v1/floors/" + segment, ""), "removing " + name);
  }

  void removeSite(String name) {
    String segment = URLEncoder.encode(name.strip(), StandardCharsets.UTF_8);
    expectStatus(
        204, manager.sendJson("DELETE", "api/v1/sites/" + segment, ""), "removing " + name);
  }

  void addFault(String fault) {
    faults.add(fault);
  }

  void expect(boolean isSo, String fault) {
    if (!isSo) {
      faults.add(fault);
    }
  }

  /**
   * Files a fault where something was stored though it was refused.
   *
   * @param before what was stored before
   */
  void expectUnchanged(List<String> before, String where) throws SQLException {
    List<String> after = server.stored();
    expect(
        before.equals(after),
        where
            + " is refused and stored all the same: "
            + before.stream().filter(row -> !after.contains(row)).toList()
            + " is now "
            + after.stream().filter(row -> !before.contains(row)).toList());
  }

  /** Files a fault where an answer is another than the one that is right. */
  void expectStatus(int expected, HttpResponse<?> answer, String where) {
    expect(
        answer.statusCode() == expected,
        where + " answered " + answer.statusCode() + ", not " + expected);
  }

  /** Nothing of what somebody sent has become a part of the answer itself. */
  void check(String where, HttpResponse<String> answer) {
    server.observed(answer);
    HttpHeaders headers = answer.headers();
    String body = answer.body();
    String type = headers.firstValue("Content-Type").orElse("");
    boolean isPage = type.startsWith("text/html");
    boolean isUnreadable = body.startsWith("This request cannot be read");
    boolean isApi = answer.uri().getPath().startsWith("/api/");
    expect(answer.statusCode() < 500, where + " answered " + answer.statusCode());
    expect(!body.contains(Attack.EVALUATED), where + " evaluates what was sent");
    expect(!body.contains("Exception"), where + " shows a stack trace");
    expect(!body.contains("root:x:"), where + " shows a file");
    expect(headers.map().keySet().stream().noneMatch(name -> name.contains(Attack.MARK)), where);
    expect(
        headers.allValues("Set-Cookie").stream().noneMatch(c -> c.contains(Attack.MARK)),
        where + " sets a cookie of an attacker");
    expect(
        headers.firstValue("Content-Security-Policy").orElse("").startsWith("default-src 'self';"),
        where + " lets scripts of others run");
    expect(
        headers.firstValue("X-Content-Type-Options").orElse("").equals("nosniff"),
        where + " lets a browser guess what it is");
    String location = headers.firstValue("Location").orElse("/");
    expect(isHere(location), where + " leads to " + location);
    if (isPage) {
      Markup page = Markup.read(body);
      page.faults().forEach(fault -> addFault(where + fault));
      expect(answer.statusCode() < 400 || hasSentence(page), where + " says not why it is refused");
    } else if (isUnreadable) {
      expect(answer.statusCode() == 400, where + " cannot be read, and that is no error");
    } else if (!body.isEmpty() && isApi && !type.startsWith("text/csv")) {
      expect(type.contains("json"), where + " answers with " + type);
      JsonNode json = JSON.readTree(body);
      expect(
          answer.statusCode() < 400 || json.path("detail").asString("").length() > 10,
          where + " says not why it is refused: " + body);
    }
  }

  private boolean isHere(String location) {
    try {
      URI to = server.root().resolve(location);
      return to.getAuthority().equals(server.root().getAuthority());
    } catch (IllegalArgumentException e) {
      return false; // no address at all
    }
  }

  /** Where something is refused a page says so beside the field, above the form or by itself. */
  private static boolean hasSentence(Markup page) {
    return page.elements().stream()
        .anyMatch(
            element ->
                List.of("notice bad", "status", "wrong").contains(element.attribute("class"))
                    || element.attribute("aria-invalid").equals("true"));
  }

  /** None was found since the last time. */
  void assertNoFaults() {
    List<String> found = List.copyOf(faults);
    faults.clear();
    assertEquals("", String.join("\n", found), () -> found.size() + " faults");
  }

  @Override
  public void close() throws IOException, SQLException {
    try {
      server.close();
    } finally {
      mail.stop();
    }
  }
}
