package org.toqa.web.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.RobotView.Readings;
import org.toqa.fleet.RobotView.Telemetry;
import org.toqa.fleet.history.BatteryLevel;
import org.toqa.geometry.Pose;
import org.toqa.link.message.AgentMessage.NetworkRoute;
import org.toqa.testbed.Hall;
import org.toqa.web.WebServerTest;
import org.toqa.web.WebTestServer;
import org.toqa.wording.Phrase;

class PagesTest extends WebServerTest {
  private static final Map<String, String> GOOD_TASK =
      Map.of(
          "name", "Box of bolts",
          "load", "2.5",
          "startStation", "Dock A",
          "goalX", "10.35",
          "goalY", "1.05");

  @BeforeAll
  void addRobot() {
    server
        .fleet()
        .setRobots(Hall.robot("r1", RobotState.IDLE, new Pose(1.05, 0.75, 0), "127.0.0.1", 7275));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"map", "tasks", "tasks/new", "robots", "robots/r1", "users", "statistics"})
  void everyPageIsShownWithTheNavigation(String path) {
    HttpResponse<String> page = clerk.get(path);

    assertEquals(200, page.statusCode());
    for (String entry : new String[] {"Tasks", "Robots", "Map", "Users", "Statistics", "Log out"}) {
      assertTrue(page.body().contains("<span>" + entry + "</span>"), entry);
    }
    assertTrue(page.body().strip().endsWith("</html>"), "The page is whole.");
    assertFalse(page.body().contains("???"), "Every text is in the bundle.");
  }

  @Test
  void theFormsTaskIsStoredAndShown() {
    HttpResponse<String> answer = clerk.post("tasks/new", GOOD_TASK);

    assertEquals(303, answer.statusCode());
    String task = answer.headers().firstValue("Location").orElseThrow();
    assertTrue(task.matches("/tasks/[0-9]+"), task);
    String page = clerk.get(task).body();
    assertTrue(page.contains("Box of bolts"));
    assertTrue(page.contains("Dock A"));
    assertTrue(page.contains("10.35, 1.05 m"));
    assertTrue(page.contains("Looking for a robot."));
    assertTrue(page.contains("Created by " + WebTestServer.CLERK));
    assertTrue(clerk.get("tasks").body().contains("Box of bolts"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          name  |                 | Enter a task name.
          load  | heavy           | Enter a number, such as 2.5
          load  | NaN             | Enter a number, such as 2.5
          load  | 0x10            | Enter a number, such as 2.5
          load  | 1,500           | Enter a number, such as 2.5
          load  | -1              | The weight must be above 0
          load  | 1e3             | Enter a number, such as 2.5
          load  | 99999999999     | The weight must be above 0
          load  | 60              | The robots cannot carry 60 kg
          goalX | east            | Enter a number, such as 2.5
          goalX | 99999999999     | Coordinates must lie within
          goalX | 0.1             | The goal is not a free place
          goalX | 500             | The goal is not a free place
          goalY |                 | Choose a station, or enter x and y
          startStation | Nowhere  | The start is not a free place
          deadline | tomorrow     | Enter a date and time
          deadline | 2099-02-30T10:00 | Enter a date and time
          deadline | 2001-01-01T10:00 | This time has passed.
          deadline | 9999-12-31T10:00 | year must be from 2000 to 9998.
          deadline | +999999999-12-31T10:00 | year must be from 2000 to 9998.
          """)
  void aBadValueIsShownAgainWithASentence(String field, String value, String sentence) {
    long before = server.fleet().count();
    Map<String, String> fields = new TreeMap<>(GOOD_TASK);
    fields.put(field, value == null ? "" : value);

    HttpResponse<String> answer = clerk.post("tasks/new", fields);

    assertEquals(422, answer.statusCode());
    assertTrue(answer.body().contains(sentence), answer.body());
    assertTrue(answer.body().contains("value=\"10.35\"") || field.equals("goalX"));
    assertEquals(before, server.fleet().count());
  }

  @Test
  void theDeadlineIsReadInTheZoneOfItsReader() {
    Map<String, String> fields = new TreeMap<>(GOOD_TASK);
    fields.put("deadline", "2098-07-01T15:00");
    fields.put("zone", "Europe/Paris"); // two hours ahead of UTC in summer

    String task = clerk.post("tasks/new", fields).headers().firstValue("Location").orElseThrow();

    assertTrue(clerk.get(task).body().contains("datetime=\"2098-07-01T13:00:00Z\""));
    fields.put("zone", "");
    task = clerk.post("tasks/new", fields).headers().firstValue("Location").orElseThrow();
    assertTrue(clerk.get(task).body().contains("datetime=\"2098-07-01T15:00:00Z\""));
    fields.put("zone", "Nowhere/Land");
    assertEquals(422, clerk.post("tasks/new", fields).statusCode());
  }

  @Test
  void aTaskThatWillBeLateSaysSo() {
    Map<String, String> fields = new TreeMap<>(GOOD_TASK);
    fields.put("deadline", "2098-07-01T15:00");
    String task = clerk.post("tasks/new", fields).headers().firstValue("Location").orElseThrow();
    assertFalse(clerk.get(task).body().contains("The deadline cannot be met"));

    server
        .fleet()
        .changeView(
            Long.parseLong(task.replaceAll("\\D", "")),
            view ->
                view.withLateness(Phrase.CANNOT_BE_IN_TIME.with("r1", Phrase.SECONDS.with(30))));

    assertTrue(clerk.get(task).body().contains("r1 would deliver at least 30 s late"));
  }

  @Test
  void aNameOfTenThousandCharactersIsRefused() {
    Map<String, String> fields = new TreeMap<>(GOOD_TASK);
    fields.put("name", "x".repeat(10_000));

    HttpResponse<String> answer = clerk.post("tasks/new", fields);

    assertEquals(422, answer.statusCode());
    assertTrue(answer.body().contains("at most 100 characters, this one has 10,000"));
  }

  @Test
  void scriptInAStoredNameIsText() {
    Map<String, String> fields = new TreeMap<>(GOOD_TASK);
    fields.put("name", "<script>alert(1)</script>\"'&");

    String task = clerk.post("tasks/new", fields).headers().firstValue("Location").orElseThrow();

    for (String path : new String[] {task, "tasks"}) {
      String page = clerk.get(path).body();
      assertFalse(page.contains("<script>alert"), path);
      assertTrue(page.contains("&lt;script&gt;alert(1)&lt;/script&gt;"), path);
    }
  }

  @Test
  void scriptInARefusedFormIsText() {
    Map<String, String> fields = new TreeMap<>(GOOD_TASK);
    fields.put("load", "\"><script>alert(1)</script>");

    HttpResponse<String> answer = clerk.post("tasks/new", fields);

    assertEquals(422, answer.statusCode());
    assertFalse(answer.body().contains("<script>alert"));
  }

  @Test
  void aTaskIsPutInAgainFromItsPage() {
    String task = clerk.post("tasks/new", GOOD_TASK).headers().firstValue("Location").orElseThrow();
    Matcher again =
        Pattern.compile("href=\"/(tasks/new\\?[^\"]+)\"").matcher(clerk.get(task).body());
    assertTrue(again.find());

    String form = clerk.get(again.group(1).replace("&amp;", "&")).body();

    assertTrue(form.contains("value=\"Box of bolts\""), form);
    assertTrue(form.contains("value=\"2.5\""), form);
    assertTrue(form.contains("<option value=\"Dock A\" dir=\"auto\" selected>"), form);
    assertTrue(
        form.contains(
            "name=\"goalX\" inputmode=\"decimal\" dir=\"ltr\" autocomplete=\"off\" value=\"10.35\""),
        form);
  }

  @Test
  void tasksAreFilteredAndSorted() {
    Map<String, String> fields = new TreeMap<>(GOOD_TASK);
    for (int i = 0; i < 26; i++) {
      fields.put("name", "Pallet");
      clerk.post("tasks/new", fields);
    }

    String page = clerk.get("tasks?state=open&text=Pallet&sort=-load").body();

    assertTrue(page.contains("26 tasks"), page);
    assertFalse(page.contains(">Box of bolts<"), page);
    assertTrue(page.contains("aria-sort=\"descending\""), page);
    assertTrue(
        page.contains("href=\"/tasks?page=2&amp;state=open&amp;text=Pallet&amp;sort=-load\""),
        page);
    assertTrue(page.contains("href=\"/tasks?state=open&amp;text=Pallet&amp;sort=load\""), page);
    assertTrue(clerk.get("tasks?text=Elephant").body().contains("No matching tasks."));
    for (String wrong : new String[] {"state=NEW", "sort=colour", "from=yesterday"}) {
      HttpResponse<String> refused = clerk.get("tasks?" + wrong);
      assertEquals(422, refused.statusCode(), wrong);
      assertTrue(refused.body().strip().endsWith("</html>"), wrong);
    }
  }

  @Test
  void tasksComePageByPage() {
    for (int i = 0; i < 26; i++) {
      assertEquals(303, clerk.post("tasks/new", GOOD_TASK).statusCode());
    }

    assertTrue(clerk.get("tasks").body().contains("href=\"/tasks?page=2\""));
    HttpResponse<String> last = clerk.get("tasks?page=9999999");
    assertEquals(200, last.statusCode());
    assertTrue(last.body().contains(">Box of bolts<"));
  }

  @Test
  void aManagerAddsARobot() {
    Map<String, String> fields =
        Map.of("name", "r7", "host", "localhost", "port", "7275", "maxLoad", "5");

    HttpResponse<String> answer = manager.post("robots", fields);

    assertEquals("/robots/r7", answer.headers().firstValue("Location").orElseThrow());
    assertTrue(manager.get("robots/r7").body().contains("localhost:7275"));
    HttpResponse<String> again = manager.post("robots", fields);
    assertEquals(422, again.statusCode());
    assertTrue(again.body().contains("There is already a robot of that name."));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          name    | ../etc      | A robot’s name has
          host    | a b         | Enter the robot’s host name
          port    | 70000       | The port is a whole number from 1 to 65535.
          port    | 1.5         | The port is a whole number from 1 to 65535.
          maxLoad | 0           | The weight must be above 0
          code    | ABC         | A pairing code has 26 letters
          """)
  void aBadRobotIsShownAgainWithASentence(String field, String value, String sentence) {
    Map<String, String> fields =
        new TreeMap<>(Map.of("name", "r8", "host", "localhost", "port", "7275", "maxLoad", "5"));
    fields.put(field, value);

    HttpResponse<String> answer = manager.post("robots", fields);

    assertEquals(422, answer.statusCode());
    assertTrue(answer.body().contains(sentence), answer.body());
  }

  @Test
  void aManagerSaysWhereARobotIs() {
    HttpResponse<String> answer =
        manager.post("robots/r1/locate", Map.of("x", "2.25", "y", "0.75", "heading", "90"));

    assertEquals(303, answer.statusCode());
    assertTrue(manager.get("robots/r1").body().contains("2.25, 0.75 m, 90°"));

    HttpResponse<String> inWall =
        manager.post("robots/r1/locate", Map.of("x", "0.1", "y", "0.1", "heading", "0"));
    assertEquals(422, inWall.statusCode());
    assertTrue(inWall.body().contains("There is a wall."));
  }

  @Test
  void whatARobotReportsIsShown() {
    RobotView lost = Hall.robot("r8", RobotState.LOST, new Pose(1, 1, 0), "10.0.0.7", 7277);
    Telemetry said = lost.telemetry();
    RobotView robot =
        lost.withTelemetry(
                new Telemetry(
                    said.pose(),
                    said.battery(),
                    new Readings(
                        0.23,
                        0.0,
                        List.of(0.45, 0.8, 0.1),
                        0.03,
                        4.2,
                        null,
                        null,
                        new NetworkRoute("10.0.0.9", 768, 0.94),
                        0.0),
                    List.of(),
                    said.lastSeen()))
            .withUnreachable(Phrase.NOBODY_LISTENS.with("r8", "10.0.0.7:7277"));
    server
        .fleet()
        .changeRobots(robots -> Stream.concat(robots.stream(), Stream.of(robot)).toList());
    server.store().saveRobot(robot.record());
    Instant at = server.fleet().latest().at();
    server
        .tracks()
        .addBatteryLevels(
            List.of(
                new BatteryLevel("r8", at.minusSeconds(7200), 0.84),
                new BatteryLevel("r8", at.minusSeconds(60), 0.8)));

    String list = clerk.get("robots").body();
    String page = clerk.get("robots/r8").body();

    for (String text : List.of("0.23 m/s", "10.0.0.7:7277", "data-last-seen=\"r8\"")) {
      assertTrue(list.contains(text), text);
      assertTrue(page.contains(text), text);
    }
    assertTrue(page.contains("No program accepts connections at 10.0.0.7:7277. Check that"));
    assertTrue(page.contains("0.03 m"), "off its place");
    assertTrue(page.contains("4.2 kg"), "what it bears");
    assertTrue(page.contains("0.45, 0.80, 0.10"), "the ranges");
    for (String text : List.of("No robot forwards", "hears its next hop 94%")) {
      assertTrue(list.contains(text), text);
      assertTrue(page.contains(text), text);
    }
    assertTrue(page.contains("10.0.0.9</bdi>") && page.contains("768</bdi>"), "its route");
    assertTrue(page.contains("has never been connected"));
    assertTrue(page.contains("<polyline points=\"200.0,16.0 398.3,20.0 400.0,20.0\""));
    server
        .fleet()
        .changeRobots(robots -> robots.stream().filter(r -> !r.name().equals("r8")).toList());
  }

  @Test
  void aManagerTakesARobotOutOfServiceAndPutsItBack() {
    String before = manager.get("robots/r1").body();
    assertTrue(before.contains("action=\"/robots/r1/out-of-service\""));
    assertTrue(before.contains("make sure that the robot is not there any more"));
    assertFalse(before.contains("action=\"/robots/r1/in-service\""));
    assertFalse(clerk.get("robots/r1").body().contains("out-of-service"));

    HttpResponse<String> out = manager.post("robots/r1/out-of-service", Map.of());

    assertEquals(303, out.statusCode());
    assertEquals("/robots/r1", out.headers().firstValue("Location").orElseThrow());
    String after = manager.get("robots/r1").body();
    assertTrue(after.contains("Out of service"));
    assertTrue(after.contains("action=\"/robots/r1/in-service\""));
    assertFalse(after.contains("action=\"/robots/r1/out-of-service\""));

    assertEquals(303, manager.post("robots/r1/in-service", Map.of()).statusCode());
    assertFalse(manager.get("robots/r1").body().contains("Out of service"));
  }

  @Test
  void thePlaceOfARobotThatIsNotHeardOfIsFreedOnItsPage() {
    Map<String, String> fields =
        Map.of("name", "r6", "host", "localhost", "port", "7275", "maxLoad", "5");
    manager.post("robots", fields);
    manager.post("robots/r6/out-of-service", Map.of());
    assertFalse(manager.get("robots/r6").body().contains("Confirm release"));

    server.fleet().changeFloor(Hall.crowdedFloor());

    assertTrue(manager.get("robots/r6").body().contains("Confirm release"));
  }

  @Test
  void usersAreAddedAndDeletedByAManager() {
    assertEquals(
        303,
        manager
            .post("users", Map.of("name", "Omar", "password", "another long one", "role", "CLERK"))
            .statusCode());
    HttpResponse<String> taken =
        manager.post("users", Map.of("name", "OMAR", "password", "another long one"));
    assertEquals(422, taken.statusCode());
    assertTrue(taken.body().contains("This name is already in use."));

    long omar = server.accounts().accountByName("omar").orElseThrow().id();
    assertEquals(303, manager.post("users/" + omar + "/delete", Map.of()).statusCode());
    assertTrue(server.accounts().accountByName("omar").isEmpty());
  }

  @Test
  void theLastManagerIsNotDeleted() {
    long max = server.accounts().accountByName(WebTestServer.MANAGER).orElseThrow().id();

    HttpResponse<String> answer = manager.post("users/" + max + "/delete", Map.of());

    assertEquals(422, answer.statusCode());
    assertTrue(answer.body().contains("This is the last manager."));
  }

  @Test
  void aClerkSeesOnlyHisOwnAccount() {
    String page = clerk.get("users").body();

    assertTrue(page.contains(WebTestServer.CLERK));
    assertFalse(page.contains("<strong>" + WebTestServer.MANAGER));
  }

  @ParameterizedTest
  @CsvSource({"tasks/999999, 404", "tasks/x, 404", "robots/none, 404", "nothing, 404"})
  void whatIsNotThereIsAPageOfTheSameStyle(String path, int status) {
    HttpResponse<String> answer = clerk.get(path);

    assertEquals(status, answer.statusCode());
    assertTrue(answer.body().contains("css/base.css"));
    assertTrue(answer.body().contains("Page not found"));
    assertTrue(answer.body().contains("<span>Log out</span>"), "The way back stays.");
  }

  @Test
  void theWrongMethodNamesTheRightOnes() {
    HttpResponse<String> answer = clerk.send("DELETE", "tasks");

    assertEquals(405, answer.statusCode());
    assertEquals("GET, HEAD", answer.headers().firstValue("Allow").orElseThrow());
    assertTrue(answer.body().contains("css/base.css"));
  }

  /** Each link beside a form leads to a section that is there, and so do those within the help. */
  @Test
  void theHelpHasWhatPagesLeadTo() throws IOException {
    Set<String> links = new TreeSet<>();
    try (Stream<Path> views = Files.walk(Path.of("src/main/webapp/WEB-INF/views"))) {
      for (Path view : views.filter(Files::isRegularFile).toList()) {
        Pattern.compile("<t:help topic=\"([^\"]*)\"(?: section=\"([^\"]*)\")?/>")
            .matcher(Files.readString(view))
            .results()
            .forEach(
                link ->
                    links.add(link.group(1) + (link.group(2) == null ? "" : "#" + link.group(2))));
      }
    }
    assertTrue(links.size() > 8, links::toString);
    clerk
        .get("help")
        .body()
        .lines()
        .flatMap(line -> Pattern.compile("/help/([a-z-]+)").matcher(line).results())
        .forEach(topic -> links.add(topic.group(1)));

    for (String link : List.copyOf(links)) {
      String document = clerk.get("help/" + link.replaceFirst("#.*", "")).body();
      Pattern.compile("href=\"/help/([^\"]*)\"")
          .matcher(document)
          .results()
          .forEach(further -> links.add(further.group(1)));
    }
    for (String link : links) {
      String[] part = link.split("#", -1);
      HttpResponse<String> answer = clerk.get("help/" + part[0]);
      assertEquals(200, answer.statusCode(), link);
      assertTrue(
          part.length == 1 || answer.body().contains("id=\"" + part[1] + "\""),
          () -> link + " leads to no heading");
    }
  }

  @Test
  void managersReadTheConfigurationWithoutItsSecretsAndClerksDoNot() {
    String page = manager.get("settings").body();

    assertTrue(page.contains("lostAfter in /etc/toqa.yaml"));
    assertTrue(
        Pattern.compile("database\\.password</code></th>\\s*<td[^>]*><em>Set; not shown</em>")
            .matcher(page)
            .find());
    assertTrue(page.contains("Change on the map"));
    assertEquals(403, clerk.get("settings").statusCode());
    assertFalse(clerk.get("map").body().contains("/settings\""));
  }
}
