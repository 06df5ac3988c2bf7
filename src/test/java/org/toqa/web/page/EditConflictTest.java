package org.toqa.web.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpResponse;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.toqa.accounts.Account;
import org.toqa.accounts.Role;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.geometry.Pose;
import org.toqa.testbed.Hall;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;

/** Two managers have the same form open: the second one replaces nothing that he has not seen. */
class EditConflictTest {
  private static final String NOTHING_WAS_STORED =
      "Someone changed this after you opened the page, so nothing was saved.";

  private WebTestServer server;
  private TestClient first;
  private TestClient second;

  @BeforeEach
  void start() throws Exception {
    server = WebTestServer.start();
    first = TestClient.signedIn(server.root(), WebTestServer.MANAGER);
    second = TestClient.signedIn(server.root(), WebTestServer.MANAGER);
    server
        .fleet()
        .changeRobots(
            none -> List.of(Hall.robot("r1", RobotState.IDLE, new Pose(1, 1, 0), "r1.lan", 7275)));
  }

  @AfterEach
  void stop() throws Exception {
    first.close();
    second.close();
    server.close();
  }

  @Test
  void aRobotIsNotChangedBackUnseen() {
    Map<String, String> mine =
        Map.of("host", "r1.lan", "port", "7275", "maxLoad", "8", "parking", "P2");
    String seen = version(second, "robots/r1", "/robots/r1/change");
    Map<String, String> others =
        Map.of("host", "r1.lan", "port", "7300", "maxLoad", "6.0", "parking", "");
    assertEquals(303, send(first, "robots/r1/change", others, seen).statusCode());

    HttpResponse<String> refused = send(second, "robots/r1/change", mine, seen);

    assertEquals(409, refused.statusCode());
    String page = refused.body();
    assertTrue(page.contains(NOTHING_WAS_STORED), page);
    assertTrue(page.contains("Current value: 7300<"), page);
    assertTrue(page.contains("Current value: 6 kg<"), page);
    assertTrue(page.contains("Current value: None: stays where its task ends<"), page);
    assertFalse(page.contains("Current value: r1.lan"), "the address is the same");
    assertTrue(page.contains("value=\"8\""), "what was entered stays");
    assertEquals(7300, robot().record().port());
    assertEquals(6, robot().maxLoad());
    assertNull(robot().record().parking());

    String now = version(page, "/robots/r1/change");
    assertEquals(303, send(second, "robots/r1/change", mine, now).statusCode());
    assertEquals(7275, robot().record().port());
    assertEquals(8, robot().maxLoad());
    assertEquals("P2", robot().record().parking());
  }

  @Test
  void aRobotIsNotPairedAtAnAddressThatItHasNoMore() {
    String seen = version(second, "robots/r1", "/robots/r1/pair");
    Map<String, String> others = Map.of("host", "other.lan", "port", "7275", "maxLoad", "5");
    assertEquals(303, send(first, "robots/r1/change", others, seen).statusCode());

    Map<String, String> mine = Map.of("host", "r1.lan", "port", "7275", "code", "A".repeat(26));
    HttpResponse<String> refused = send(second, "robots/r1/pair", mine, seen);

    assertEquals(409, refused.statusCode());
    assertTrue(refused.body().contains("Current value: other.lan<"), refused.body());
    assertNull(robot().record().fingerprint());
  }

  @Test
  void anOrderIsNotEditedBackUnseen() {
    Map<String, String> box =
        Map.of(
            "name",
            "Box",
            "load",
            "2",
            "startStation",
            "Dock A",
            "startX",
            "",
            "startY",
            "",
            "goalStation",
            "Shelf 3",
            "goalX",
            "",
            "goalY",
            "");
    assertEquals(303, first.post("tasks/new", box).statusCode());
    String seen = version(second, "tasks/1/edit", "/tasks/1/edit");
    Map<String, String> heavier = new HashMap<>(box);
    heavier.put("load", "3");
    assertEquals(303, send(first, "tasks/1/edit", heavier, seen).statusCode());

    Map<String, String> mine = new HashMap<>(box);
    mine.put("load", "1");
    HttpResponse<String> refused = send(second, "tasks/1/edit", mine, seen);

    assertEquals(409, refused.statusCode());
    assertTrue(refused.body().contains(NOTHING_WAS_STORED), refused.body());
    assertTrue(refused.body().contains("Current value: 3"), refused.body());
    String now = version(refused.body(), "/tasks/1/edit");
    assertEquals(303, send(second, "tasks/1/edit", mine, now).statusCode());
    assertEquals(1, server.fleet().task(1).orElseThrow().task().load());
  }

  @Test
  void aUserIsNotChangedBackUnseen() {
    long id =
        server.accounts().add("Etta", "none", Role.CLERK, EventRecord.SYSTEM).orElseThrow().id();
    String form = "users/" + id + "/change";
    String seen = version(second, "users/" + id, "/" + form);
    Map<String, String> manager = Map.of("role", "MANAGER");
    assertEquals(303, send(first, form, manager, seen).statusCode());

    Map<String, String> disabled = Map.of("role", "CLERK", "disabled", "on");
    HttpResponse<String> refused = send(second, form, disabled, seen);

    assertEquals(409, refused.statusCode());
    String page = refused.body();
    assertTrue(page.contains(NOTHING_WAS_STORED), page);
    assertTrue(page.contains("Current value: Manager<"), page);
    assertTrue(page.contains("Current value: enabled<"), page);
    assertTrue(page.contains("<option value=\"MANAGER\" >"), "what was chosen stays");
    assertTrue(page.contains("name=\"disabled\" checked"), "what was checked stays");
    assertEquals(Role.MANAGER, user(id).role());
    assertFalse(user(id).disabled());

    assertEquals(303, send(second, form, disabled, version(page, "/" + form)).statusCode());
    assertEquals(Role.CLERK, user(id).role());
    assertTrue(user(id).disabled());
  }

  @Test
  void anEmailAddressIsNotChangedBackUnseen() {
    long id = server.accounts().accountByName(WebTestServer.CLERK).orElseThrow().id();
    String form = "users/" + id + "/email";
    String seen = version(second, "users/" + id, "/" + form);
    Map<String, String> others = Map.of("email", "clara@example.org");
    assertEquals(303, send(first, form, others, seen).statusCode());

    Map<String, String> mine = Map.of("email", "clara@example.com");
    HttpResponse<String> refused = send(second, form, mine, seen);

    assertEquals(409, refused.statusCode());
    assertTrue(refused.body().contains("Current value: clara@example.org<"), refused.body());
    assertTrue(refused.body().contains("value=\"clara@example.com\""), refused.body());
    assertEquals("clara@example.org", user(id).email());

    String now = version(refused.body(), "/" + form);
    assertEquals(303, send(second, form, mine, now).statusCode());
    assertEquals("clara@example.com", user(id).email());
  }

  @Test
  void aPriorityIsNotChangedBackUnseen() {
    addTask();
    String form = "tasks/1/priority";
    String seen = version(second, "tasks/1", "/" + form);
    assertEquals(303, send(first, form, Map.of("priority", "10"), seen).statusCode());

    HttpResponse<String> refused = send(second, form, Map.of("priority", "-10"), seen);

    assertEquals(409, refused.statusCode());
    assertTrue(refused.body().contains("Current value: High<"), refused.body());
    assertTrue(refused.body().contains("<option value=\"-10\" selected>"), refused.body());
    assertEquals(10, priority());

    String now = version(refused.body(), "/" + form);
    assertEquals(303, send(second, form, Map.of("priority", "-10"), now).statusCode());
    assertEquals(-10, priority());
  }

  @Test
  void aScheduleThatSomebodyHasPausedIsNotDeletedUnseen() {
    String order =
        "{\"name\":\"tour\",\"load\":1,\"start\":{\"station\":\"Dock A\"},\"goal\":{\"station\":\"Shelf 3\"}}";
    assertEquals(
        201,
        first
            .postJson(
                "api/v1/schedules",
                "{\"task\":%s,\"at\":\"2098-07-01T15:00:00Z\"}".formatted(order))
            .statusCode());
    String seen = version(second, "schedules", "/schedules/1/delete");
    assertEquals(303, first.post("schedules/1/pause", Map.of()).statusCode());

    HttpResponse<String> refused = send(second, "schedules/1/delete", Map.of(), seen);

    assertEquals(409, refused.statusCode());
    assertTrue(refused.body().contains("Someone paused or resumed schedule 1"), refused.body());
    assertEquals(200, second.get("api/v1/schedules/1").statusCode());
    String now = version(refused.body(), "/schedules/1/delete");
    assertEquals(303, send(second, "schedules/1/delete", Map.of(), now).statusCode());
    assertEquals(404, second.get("api/v1/schedules/1").statusCode());
  }

  @Test
  void aDoubleClickIsNoConflict() {
    addTask();
    String seen = version(first, "tasks/1", "/tasks/1/priority");

    assertEquals(303, send(first, "tasks/1/priority", Map.of("priority", "10"), seen).statusCode());
    assertEquals(303, send(first, "tasks/1/priority", Map.of("priority", "10"), seen).statusCode());
    assertEquals(10, priority());
  }

  @Test
  void whatAProgramDoesMeanwhileCountsAsWell() {
    String seen = version(second, "robots/r1", "/robots/r1/change");
    String read = first.get("api/v1/robots/r1").headers().firstValue("ETag").orElseThrow();
    assertEquals('"' + seen + '"', read, "one version for pages and programs");
    String change = "{\"host\":\"r1.lan\",\"port\":7400,\"maxLoad\":5,\"parking\":null}";
    assertEquals(200, first.sendJson("PUT", "api/v1/robots/r1", change).statusCode());

    Map<String, String> mine = Map.of("host", "r1.lan", "port", "7500", "maxLoad", "5");

    assertEquals(409, send(second, "robots/r1/change", mine, seen).statusCode());
    assertEquals(7400, robot().record().port());
  }

  private void addTask() {
    first.post(
        "tasks/new",
        Map.of("name", "x", "load", "1", "startStation", "Dock A", "goalStation", "Shelf 3"));
  }

  private RobotView robot() {
    return server.fleet().latest().robots().getFirst();
  }

  private Account user(long id) {
    return server.accounts().account(id).orElseThrow();
  }

  private int priority() {
    return server.fleet().latest().tasks().getFirst().task().priority();
  }

  private static HttpResponse<String> send(
      TestClient visitor, String form, Map<String, String> entries, String version) {
    Map<String, String> fields = new TreeMap<>(entries);
    fields.put("version", version);
    return visitor.post(form, fields);
  }

  private static String version(TestClient visitor, String page, String form) {
    return version(visitor.get(page).body(), form);
  }

  /** What the form on the page says it was filled from. */
  private static String version(String page, String form) {
    Matcher version =
        Pattern.compile(
                "action=\"" + form + "\"[^>]*>((?!</form>).)*name=\"version\" value=\"([^\"]+)\"",
                Pattern.DOTALL)
            .matcher(page);
    assertTrue(version.find(), page);
    return version.group(2);
  }
}
