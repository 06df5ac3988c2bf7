package org.toqa.web.input;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.fleet.TaskView;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Tables of tasks: all of a table are added, or none, and every bad line is named. */
class ImportTest {
  private static final JsonMapper JSON = new JsonMapper();
  private static final Pattern KEY_FIELD =
      Pattern.compile("name=\"idempotencyKey\" value=\"([^\"]+)\"");
  private static final String HEADER = "name,load,start,goal\n";
  private static final String GOOD = HEADER + "bolts,2.5,Dock A,Shelf 3\nnuts,1,Shelf 3,Dock A\n";

  private static WebTestServer server;
  private static TestClient clerk;

  private long before;

  @BeforeAll
  static void start() throws Exception {
    server = WebTestServer.start();
    clerk = TestClient.signedIn(server.root(), WebTestServer.CLERK);
  }

  @AfterAll
  static void stop() throws Exception {
    clerk.close();
    server.close();
  }

  @BeforeEach
  void count() {
    before = server.fleet().count();
  }

  /** How many tasks this test has added. */
  private long added() {
    return server.fleet().count() - before;
  }

  @Test
  void everyColumnBecomesAFieldOfItsTask() {
    String table =
        """
        Priority, DEADLINE ,name,load,start,startX,startY,goal,goalX,goalY,floor,length,width
        7,2098-07-01 15:00,"Box, ""big\""\",2.5,Dock A,,,,10.35,1.05,hall,1.2,0.8
        ,2098-07-01T15:00:00Z,nuts,1,,1.05,5.25,Shelf 3,,,,,
        """;

    HttpResponse<String> answer = post("api/v1/tasks/import?zone=Europe/Paris", table);

    assertEquals(201, answer.statusCode(), answer.body());
    JsonNode first = JSON.readTree(answer.body()).get(0);
    assertEquals("Box, \"big\"", first.get("name").stringValue());
    assertEquals(7, first.get("priority").asInt());
    assertEquals("2098-07-01T13:00:00Z", first.get("deadline").stringValue());
    assertEquals("Dock A", first.get("start").get("station").stringValue());
    assertEquals(10.35, first.get("goal").get("x").asDouble());
    assertEquals(1.2, first.get("size").get("length").asDouble());
    assertEquals("Clara", first.get("user").stringValue());
    JsonNode second = JSON.readTree(answer.body()).get(1);
    assertEquals("2098-07-01T15:00:00Z", second.get("deadline").stringValue());
    assertEquals(1.05, second.get("start").get("x").asDouble());
    assertEquals(2, added());
  }

  @Test
  void aLineOfSeveralPiecesIsAnOrderOfItsOwn() {
    String header = "name,load,pieces,start,goal\n";
    String hundred = "bolts,1,100,Dock A,Shelf 3\n";
    HttpResponse<String> tooMany =
        post("api/v1/tasks/import", header + hundred.repeat(5) + "nuts,1,1,Dock A,Shelf 3\n");
    assertEquals(422, tooMany.statusCode());
    assertEquals(7, JSON.readTree(tooMany.body()).get("errors").get(0).get("line").asInt());
    assertEquals(0, added());

    HttpResponse<String> answer =
        post(
            "api/v1/tasks/import",
            header
                + "bolts,2.5,3,Dock A,Shelf 3\nnuts,1,,Shelf 3,Dock A\nnails,1,2,Dock A,Shelf 3\n");

    assertEquals(201, answer.statusCode(), answer.body());
    List<JsonNode> orders =
        JSON.readTree(answer.body()).values().stream().map(task -> task.get("order")).toList();
    assertEquals(6, added());
    assertEquals(
        List.of(3, 3, 3), orders.subList(0, 3).stream().map(o -> o.get("parts").asInt()).toList());
    assertTrue(orders.get(3).isNull());
    assertEquals(2, orders.get(5).get("part").asInt());
    assertFalse(orders.get(5).get("id").equals(orders.get(0).get("id")));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "name;load;start;goal\r\nbolts;2,5;Dock A;Shelf 3\r\n",
        "\uFEFFname;load;start;goal\r\nbolts;2.5;Dock A;Shelf 3\r\n;;;\r\n\r\n",
        "name\tload\tstart\tgoal\nbolts\t2.5\tDock A\tShelf 3",
        "goal,start,load,name\rShelf 3,Dock A,2.5,bolts\r",
        "name, load, start, goal\n\"bolts\", \"2.5\", \"Dock A\", \"Shelf 3\"\n"
      })
  void whatSpreadsheetsWriteIsRead(String table) {
    HttpResponse<String> answer = post("api/v1/tasks/import", table);

    assertEquals(201, answer.statusCode(), answer.body());
    assertEquals(1, added());
    TaskView task = server.fleet().task(before + 1).orElseThrow();
    assertEquals("bolts", task.task().name());
    assertEquals(2.5, task.task().load());
  }

  @Test
  void aLineMayHaveFurtherStopsAndWaits() {
    HttpResponse<String> answer =
        post(
            "api/v1/tasks/import",
            """
            name,load,start,goal,goalWait,stops,carriedBy
            tour,1,Dock A,Shelf 3,Person,2 1: 120 | Dock A,
            way,1,Dock A,Shelf 3,,Dock A,one
            legs,1,Dock A,Shelf 3,,Dock A,
            """);

    assertEquals(201, answer.statusCode(), answer.body());
    JsonNode tasks = JSON.readTree(answer.body());
    assertEquals(4, added());
    JsonNode stops = tasks.get(0).get("stops");
    assertEquals(4, stops.size());
    assertTrue(stops.get(1).get("waitForPerson").booleanValue());
    assertEquals(2, stops.get(2).get("x").asDouble());
    assertEquals(120, stops.get(2).get("waitSeconds").asInt());
    assertEquals("Dock A", stops.get(3).get("station").stringValue());
    assertTrue(tasks.get(0).get("order").isNull());
    assertEquals(3, tasks.get(1).get("stops").size());
    assertEquals(2, tasks.get(2).get("order").get("parts").asInt());
  }

  @Test
  void aTableMayHaveDrivesWithoutALoad() {
    HttpResponse<String> answer =
        post(
            "api/v1/tasks/import",
            """
            name,kind,load,start,goal,goalWait,stops
            look,Drive,,,Dock A,60,Shelf 3: person | Charge: 80%
            fill,drive,,,charge,300,
            box,,1,Dock A,Shelf 3,,
            """);

    assertEquals(201, answer.statusCode(), answer.body());
    JsonNode tasks = JSON.readTree(answer.body());
    assertEquals("DRIVE", tasks.get(0).get("kind").stringValue());
    assertEquals(60, tasks.get(0).get("stops").get(0).get("waitSeconds").asInt());
    assertTrue(tasks.get(0).get("stops").get(1).get("waitForPerson").booleanValue());
    assertEquals(0.8, tasks.get(0).get("stops").get(2).get("charge").get("until").asDouble());
    assertTrue(tasks.get(1).get("stops").get(0).get("charge").get("until").isNull());
    assertEquals(300, tasks.get(1).get("stops").get(0).get("waitSeconds").asInt());
    assertEquals("TRANSPORT", tasks.get(2).get("kind").stringValue());

    answer =
        post(
            "api/v1/tasks/import",
            """
            name,kind,load,start,goal,stops
            a,drive,1,Dock A,Dock A,
            b,drive,,,Moon,
            c,drive,,,Dock A,Moon
            d,,,Dock A,Shelf 3,
            e,drive,,,Dock A,charge@C9
            f,drive,,,Dock A,Shelf 3: 80%
            g,,1,Dock A,Shelf 3,charge
            """);
    assertEquals(422, answer.statusCode(), answer.body());
    assertEquals(
        List.of(
            "2 load", "2 start", "3 goal", "4 stops", "5 load", "6 stops", "7 stops", "8 stops"),
        JSON.readTree(answer.body()).get("errors").values().stream()
            .map(e -> e.get("line") + " " + e.get("field").stringValue())
            .sorted()
            .toList());
  }

  @Test
  void aStopThatIsWrongIsNamedByItsColumn() {
    HttpResponse<String> answer =
        post(
            "api/v1/tasks/import",
            """
            name,load,start,goal,startWait,goalWait,stops
            a,1,Dock A,Shelf 3,soon,0,Dock A: 1.5
            c,1,Dock A,Nowhere,,,Dock A
            d,1,Dock A,Shelf 3,,,Nowhere
            """);

    assertEquals(422, answer.statusCode(), answer.body());
    assertEquals(0, added());
    assertTrue(
        JSON.readTree(answer.body()).get("errors").values().stream()
            .map(e -> e.get("line") + " " + e.get("field").stringValue())
            .toList()
            .containsAll(List.of("2 startWait", "2 goalWait", "2 stops", "3 goal")),
        answer.body());
    answer =
        post(
            "api/v1/tasks/import",
            "name,load,start,goal,stops\nd,1,Dock A,Shelf 3,Dock A|Nowhere\n");
    assertTrue(answer.body().contains("Line 2, stops"), answer.body());
  }

  @Test
  void everyBadLineIsNamedAndNothingIsImported() {
    String table =
        HEADER
            + """
            bolts,2.5,Dock A,Shelf 3
            ,heavy,Dock A,Shelf 3
            "two
            lines",1,Nowhere,Shelf 3
            nuts,1,Dock A,Shelf 3,more

            nuts,1,Dock A,
            """;

    HttpResponse<String> answer = post("api/v1/tasks/import", table);

    assertEquals(422, answer.statusCode());
    JsonNode problem = JSON.readTree(answer.body());
    assertEquals(
        List.of("3 name", "3 load", "4 name", "4 start", "6 ", "8 goal"),
        problem.get("errors").values().stream()
            .map(e -> e.get("line") + " " + e.get("field").stringValue())
            .toList());
    assertTrue(
        problem.get("detail").stringValue().contains("Line 3, load: Enter a number, such as 2.5"));
    assertEquals(0, added());
  }

  @Test
  void whatTheFleetRefusesIsNamedWithTheRest() {
    HttpResponse<String> answer =
        post(
            "api/v1/tasks/import",
            HEADER + "a,1,Nowhere,Shelf 3\nb,x,Dock A,Shelf 3\nc,60,Dock A,Shelf 3\n");

    assertEquals(422, answer.statusCode());
    String detail = JSON.readTree(answer.body()).get("detail").stringValue();
    assertTrue(detail.contains("Line 2, start: The start is not a free place"), detail);
    assertTrue(detail.contains("Line 3, load: Enter a number, such as 2.5"), detail);
    assertTrue(detail.contains("Line 4, load: The robots cannot carry"), detail);
    answer = post("api/v1/tasks/import", GOOD + "c,60,Dock A,Shelf 3\n");
    assertTrue(answer.body().contains("Line 4, load"), answer.body());
    assertEquals(0, added());
  }

  @Test
  void aLineIsForRobotsThatCanDoSomething() {
    String header = "name,load,start,goal,onlyRobots\n";
    HttpResponse<String> answer =
        post("api/v1/tasks/import", header + "a,1,Dock A,Shelf 3,r1 with:arm; with:omni\n");

    assertEquals(201, answer.statusCode(), answer.body());
    assertEquals(
        "[\"r1\",\"with:arm\",\"with:omni\"]",
        JSON.readTree(answer.body()).get(0).get("onlyRobots").toString());
  }

  @Test
  void allFaultsOfALineAreToldAtOnce() {
    HttpResponse<String> answer =
        post(
            "api/v1/tasks/import",
            """
            name,load,start,goal,priority
            a,60,Nowhere,Nowhere else,1
            b,1,Dock A,Nowhere,high
            """);

    JsonNode problem = JSON.readTree(answer.body());
    assertEquals(
        List.of("2 load", "2 start", "2 goal", "3 priority", "3 goal"),
        problem.get("errors").values().stream()
            .map(e -> e.get("line") + " " + e.get("field").stringValue())
            .toList());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          name,load,start,goal,colour | Line 1, colour: Unknown column “colour”. Allowed: template,
          name,load,start,goal,Name   | The column “name” appears twice.
          name,load,start             | Line 1, goal: The column “goal” is missing, or goalX and goalY.
          name,start,goal,goalX       | Line 1, load: The column “load” is missing.
          name,load,start,goal        | There are no tasks in this file.
          """)
  void aWrongFirstLineIsToldBeforeAllOthers(String header, String sentence) {
    HttpResponse<String> answer = post("api/v1/tasks/import", header + "\n");

    assertEquals(422, answer.statusCode());
    assertTrue(answer.body().contains(sentence), answer.body());
  }

  @Test
  void aWrongFirstLineHidesNothingOfTheOthers() {
    assertEquals(
        List.of("1 colour", "2 load", "3 goal", "4 load"),
        faults(
            """
            name,load,start,goal,colour
            a,x,Dock A,Shelf 3,red
            b,1,Dock A,Nowhere,
            c,60,Dock A,Shelf 3,
            d,1,Dock A,Shelf 3,red
            """));
    assertEquals(
        List.of("1 load", "1 weight", "2 goal"),
        faults("name,weight,start,goal\na,1,Dock A,Nowhere\nb,1,Dock A,Shelf 3\n"));
    assertEquals(
        List.of("1 name", "2 goal"),
        faults("name,load,start,goal,name\na,1,Dock A,Nowhere,\nb,1,Dock A,Shelf 3,\n"));
    assertEquals(
        List.of("1 kind"), faults("name,kind,kind,goal\na,DRIVE,,Shelf 3\nb,DRIVE,,Nowhere\n"));
    assertEquals(List.of("1 template"), faults("template,name,template\nTour,a,\nNone,b,\n"));
    assertEquals(List.of("1 start", "2 goal"), faults("name,load,startX,goal\na,1,3,Nowhere\n"));
    assertEquals(
        List.of("1 goalX", "1 goalY"),
        faults("name,load,start,goalX,goalX,goalY,goalY\na,1,Dock A,3,3,1,1\n"));
    assertEquals( // no line of columns at all
        List.of(
            "1 2.5", "1 Dock A", "1 Shelf 3", "1 bolts", "1 goal", "1 load", "1 name", "1 start"),
        faults("bolts,2.5,Dock A,Shelf 3\n,x,Dock A,Shelf 3\n"));
    assertEquals(0, added());
  }

  /** Line and column of each fault, in order. */
  private List<String> faults(String table) {
    HttpResponse<String> answer = post("api/v1/tasks/import", table);
    assertEquals(422, answer.statusCode(), answer.body());
    return JSON.readTree(answer.body()).get("errors").values().stream()
        .map(e -> e.get("line") + " " + e.get("field").stringValue())
        .sorted()
        .toList();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          load     | -1               | The weight must be above 0
          load     | 1e999            | Enter a number, such as 2.5
          load     | 2,5              | Enter a number, such as 2.5
          load     | =1+1             | Enter a number, such as 2.5
          priority | 1.5              | The priority is a whole number
          priority | high             | The priority is a whole number
          deadline | soon             | Enter a date and time
          deadline | 2001-01-01 10:00 | This time has passed.
          length   | 1                | Enter both length and width
          goalX    | 3                | Enter either a station in goal or coordinates in goalX and goalY, not both.
          floor    | attic            | There is no floor attic.
          """)
  void aWrongCellIsToldAtItsColumn(String column, String value, String sentence) {
    Map<String, String> cells = new TreeMap<>(Map.of("name", "x", "load", "1"));
    cells.putAll(Map.of("start", "Dock A", "goal", "Shelf 3"));
    cells.put(column, "\"" + value + "\"");

    HttpResponse<String> answer =
        post(
            "api/v1/tasks/import",
            String.join(",", cells.keySet()) + "\n" + String.join(",", cells.values()));

    assertEquals(422, answer.statusCode(), answer.body());
    assertTrue(answer.body().contains(sentence), answer.body());
    assertTrue(answer.body().contains("\"line\":2"), answer.body());
  }

  @Test
  void whatIsNoTableIsRefusedAtItsLine() {
    byte[] latin = (GOOD + "Kühlschrank,1,Dock A,Shelf 3").getBytes(StandardCharsets.ISO_8859_1);
    byte[] noise = new byte[200_000];
    new Random(7).nextBytes(noise);
    Map<byte[], String> files =
        Map.of(
            latin,
            "Line 4: This character is not UTF-8.",
            noise,
            "not UTF-8",
            "PK\u0003\u0004\u0000".getBytes(StandardCharsets.UTF_8),
            "This is not a CSV file.",
            GOOD.getBytes(StandardCharsets.UTF_16),
            "not UTF-8",
            (GOOD + "\"open,1,Dock A,Shelf 3\nb,1,Dock A,Shelf 3").getBytes(StandardCharsets.UTF_8),
            "Line 4: In the text that begins here, a quotation mark is missing",
            (GOOD + "x,1,\"Dock\" A,Shelf 3\n").getBytes(StandardCharsets.UTF_8),
            "Line 4: In the text that begins here, a quotation mark",
            new byte[0],
            "There are no tasks in this file.",
            "<script>alert(1)</script>".getBytes(StandardCharsets.UTF_8),
            "Unknown column");
    files.forEach(
        (file, sentence) -> {
          HttpResponse<String> answer = post("api/v1/tasks/import", file, "text/csv");

          assertEquals(422, answer.statusCode(), sentence);
          assertTrue(answer.body().contains(sentence), answer.body());
        });
    assertEquals(0, added());
  }

  @Test
  void tooMuchIsRefused() {
    String line = "bolts,1,Dock A,Shelf 3\n";
    HttpResponse<String> answer = post("api/v1/tasks/import", HEADER + line.repeat(501));
    assertEquals(422, answer.statusCode());
    assertTrue(answer.body().contains("at most 500 tasks, this one has 501"), answer.body());

    answer = post("api/v1/tasks/import", HEADER + line.repeat(60_000)); // 1.4 MB
    assertEquals(413, answer.statusCode());
    answer = post("api/v1/tasks/import", HEADER + "x,x,,\n".repeat(30));
    assertEquals(50, JSON.readTree(answer.body()).get("errors").size());
    assertTrue(answer.body().contains("And 40 more."), answer.body()); // 3 x 30 - 50

    byte[] file = (HEADER + line.repeat(220_000)).getBytes(StandardCharsets.UTF_8); // 5 MB
    HttpResponse<String> page = clerk.postFile("tasks/import", Map.of(), "tasks.csv", file);
    assertEquals(422, page.statusCode());
    assertTrue(page.body().contains("The file is larger than 1,024 KiB. Split it."));
    assertEquals(0, added());
  }

  @Test
  void onlyTablesInUtf8AreTaken() {
    byte[] table = GOOD.getBytes(StandardCharsets.UTF_8);
    for (String type : List.of("application/json", "text/csv; charset=latin1", "text/csvx")) {
      assertEquals(415, post("api/v1/tasks/import", table, type).statusCode(), type);
    }
    assertEquals(422, post("api/v1/tasks/import?zone=Nowhere", GOOD).statusCode());
    assertEquals(
        201,
        post("api/v1/tasks/import", table, "text/csv; header=present; charset=UTF-8").statusCode());
  }

  @Test
  void aTableThatComesAgainWithItsKeyGetsItsTasks() {
    byte[] table = GOOD.getBytes(StandardCharsets.UTF_8);
    String[] key = {"Idempotency-Key", "monday"};
    String first = post("api/v1/tasks/import", table, "text/csv", key).body();

    assertEquals(first, post("api/v1/tasks/import", table, "text/csv", key).body());
    for (String other : List.of("x,1,Dock A,Shelf 3\n", "")) {
      byte[] changed =
          (GOOD.substring(0, HEADER.length() + 25) + other).getBytes(StandardCharsets.UTF_8);
      HttpResponse<String> answer = post("api/v1/tasks/import", changed, "text/csv", key);
      assertEquals(422, answer.statusCode(), "longer or shorter");
      assertTrue(answer.body().contains("was already used for another order"), answer.body());
    }
    assertEquals(2, added());
    assertNotEquals(first, post("api/v1/tasks/import", table, "text/csv").body(), "without a key");
  }

  @Test
  void theFormImportsATableOnce() {
    Matcher field = KEY_FIELD.matcher(clerk.get("tasks/import").body());
    assertTrue(field.find());
    Map<String, String> form = Map.of("idempotencyKey", field.group(1), "zone", "Europe/Paris");
    byte[] table =
        "name,load,start,goal,deadline\nbolts,1,Dock A,Shelf 3,2098-07-01 15:00\n"
            .getBytes(StandardCharsets.UTF_8);

    HttpResponse<String> answer = clerk.postFile("tasks/import", form, "tasks.csv", table);

    assertEquals(303, answer.statusCode(), answer.body());
    String list = answer.headers().firstValue("Location").orElseThrow();
    assertTrue(clerk.get(list).body().contains("One task was imported."));
    assertTrue(
        clerk.get("tasks/" + (before + 1)).body().contains("datetime=\"2098-07-01T13:00:00Z\""));
    assertEquals(303, clerk.postFile("tasks/import", form, "tasks.csv", table).statusCode());
    assertEquals(1, added());
    answer =
        clerk.postFile("tasks/import", form, "tasks.csv", GOOD.getBytes(StandardCharsets.UTF_8));
    assertEquals(422, answer.statusCode());
    assertTrue(answer.body().contains("This page was already used for another file."));
    assertEquals(1, added());
  }

  @Test
  void theFormNamesBadLinesAndShowsThemAsText() {
    byte[] table =
        (HEADER + "a,<script>alert(1)</script>,Dock A,Shelf 3\nb,1,<b>,Shelf 3\n")
            .getBytes(StandardCharsets.UTF_8);

    HttpResponse<String> answer =
        clerk.postFile("tasks/import", Map.of(), "../../../etc/passwd\u202e", table);

    assertEquals(422, answer.statusCode());
    assertTrue(answer.body().contains("Nothing was imported."), answer.body());
    assertTrue(answer.body().contains("Enter a number, such as 2.5"), answer.body());
    assertTrue(answer.body().contains("The start is not a free place"), answer.body());
    assertFalse(answer.body().contains("<script>alert"));
    byte[] unknown = (HEADER.strip() + ",<b>\n").getBytes(StandardCharsets.UTF_8);
    answer = clerk.postFile("tasks/import", Map.of(), "x.csv", unknown);
    assertTrue(answer.body().contains("&lt;b&gt;"), answer.body());
    assertFalse(answer.body().contains("<b>"));
    assertEquals(0, added());
  }

  @Test
  void aFormulaAndAScriptInANameStayText() {
    String table = HEADER + "\"=HYPERLINK(\"\"http://x\"\")<script>\",1,Dock A,Shelf 3\n";

    assertEquals(201, post("api/v1/tasks/import", table).statusCode());

    String page = clerk.get("tasks").body();
    assertTrue(page.contains("=HYPERLINK(&#034;http://x&#034;)&lt;script&gt;"), page);
  }

  @Test
  void aFormWithoutAFileOrATokenIsRefused() {
    HttpResponse<String> none = clerk.post("tasks/import", Map.of());
    assertEquals(422, none.statusCode());
    assertTrue(none.body().contains("Choose a CSV file."));
    byte[] table = GOOD.getBytes(StandardCharsets.UTF_8);
    assertEquals(422, clerk.postFile("tasks/import", Map.of(), "x.csv", new byte[0]).statusCode());
    assertEquals(
        422, clerk.postFile("tasks/import", Map.of("zone", "No/Where"), "x", table).statusCode());
    assertEquals(
        403, clerk.postFile("tasks/import", Map.of("_csrf", "guessed"), "x", table).statusCode());
    assertEquals(0, added());
  }

  @Test
  void theExampleCanBeImportedAsItIs() {
    HttpResponse<String> example = clerk.get("api/v1/tasks/import/example.csv");
    assertTrue(example.headers().firstValue("Content-Disposition").orElseThrow().contains(".csv"));

    assertEquals(201, post("api/v1/tasks/import", example.body()).statusCode());

    assertEquals(2, added());
  }

  @Test
  void whileTheDatabaseIsAwayNothingIsImported() throws Exception {
    try (WebTestServer away = WebTestServer.start();
        TestClient visitor = TestClient.signedIn(away.root(), WebTestServer.CLERK)) {
      away.fleet().stopAnswering();
      byte[] table = GOOD.getBytes(StandardCharsets.UTF_8);

      HttpResponse<String> page = visitor.postFile("tasks/import", Map.of(), "x.csv", table);

      assertEquals(503, page.statusCode());
      assertEquals("5", page.headers().firstValue("Retry-After").orElse(""));
      assertTrue(page.body().contains("The database does not answer"), page.body());
      assertEquals(0, away.fleet().count());
    }
  }

  private static HttpResponse<String> post(String path, String table) {
    return post(path, table.getBytes(StandardCharsets.UTF_8), "text/csv");
  }

  private static HttpResponse<String> post(
      String path, byte[] table, String type, String... headers) {
    HttpRequest.Builder request =
        clerk
            .request(path)
            .header("Content-Type", type)
            .header("X-CSRF-Token", clerk.csrf())
            .POST(HttpRequest.BodyPublishers.ofByteArray(table));
    return clerk.send((headers.length == 0 ? request : request.headers(headers)).build());
  }
}
