package org.toqa.web.api;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.fleet.FloorView.SeenObstacle;
import org.toqa.fleet.RobotState;
import org.toqa.grid.Cell;
import org.toqa.grid.CellRuns;
import org.toqa.grid.FloorMap;
import org.toqa.grid.MapArchive;
import org.toqa.testbed.Hall;
import org.toqa.testbed.Views;
import org.toqa.web.RequestPath;
import org.toqa.web.WebServerTest;
import org.toqa.web.WebTestServer;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Floors, their drafts and their files, in the API. */
class ApiFloorsTest extends WebServerTest {
  private static final JsonMapper JSON = JsonMapper.shared();

  /** 4 x 3 cells; the middle of the top row is wall. */
  private static final String DRAWING =
      """
      {"width":4,"height":3,"resolution":0.5,"origin":{"x":-1,"y":0},"occupied":[1,2],
       "stations":[{"name":"Dock \\"A\\"","x":-0.75,"y":0.25,"headingDegrees":90,"approach":"north"}],
       "parking":[{"name":"P1","x":0.25,"y":0.25}],"charging":[],
       "keepOut":[{"x":0.5,"y":0,"width":0.5,"height":0.5}],
       "speedLimits":[{"x":-1,"y":0,"width":1,"height":0.5,"speed":0.2}],
       "oneWay":[{"x":-1,"y":0.5,"width":2,"height":0.5,"direction":"west"}],
       "freeZones":[{"x":-1,"y":0,"width":1.5,"height":1}],
       "moves":"smooth"}\
      """;

  @BeforeEach
  void forget() {
    server.forgetWork();
  }

  @Test
  void aFloorIsAddedListedShownAndDeleted() {
    JsonNode added = post("floors", "{\"name\":\"Ümit 2/%\",\"drawing\":" + DRAWING + "}", 422);
    assertEquals("name", added.at("/errors/0/field").asString());
    added = post("floors", "{\"name\":\"Ümit 2%\",\"drawing\":" + DRAWING + "}", 201);
    assertEquals("READY", added.get("state").asString());
    JsonNode twice = post("floors", "{\"name\":\"Ümit 2%\",\"drawing\":" + DRAWING + "}", 422);
    assertEquals("name", twice.at("/errors/0/field").asString());

    JsonNode empty =
        post("floors", "{\"name\":\"Empty\",\"width\":12,\"height\":6,\"resolution\":0.3}", 201);
    assertEquals("main", empty.get("site").asString());
    JsonNode drawing = get("floors/Empty", 200).get("drawing");
    assertEquals(40, drawing.get("width").asInt());
    assertEquals(20, drawing.get("height").asInt());
    assertEquals(0, drawing.get("occupied").size());

    List<String> names =
        get("floors", 200).valueStream().map(floor -> floor.get("name").asString()).toList();
    assertEquals(List.of("hall", "Ümit 2%", "Empty"), names);

    JsonNode shown = get("floors/%C3%9Cmit%202%25", 200).get("drawing");
    assertSame(JSON.readTree(DRAWING), shown);

    assertEquals(204, manager.sendJson("DELETE", "api/v1/floors/Empty", "").statusCode());
    get("floors/Empty", 404);
  }

  @Test
  void aFloorOnHoldSaysSo() {
    server.fleet().changeRobots(none -> List.of(Hall.robot("r1", RobotState.IDLE, null, "h", 1)));
    server.fleet().holdFloor("hall", "Max");

    JsonNode hall = get("floors", 200).get(0);
    assertEquals("HELD", hall.get("state").asString());
    assertEquals(1, hall.get("robots").asInt());
    assertEquals(409, manager.sendJson("DELETE", "api/v1/floors/hall", "").statusCode());
    server.fleet().resumeFloor("hall", "Max");
  }

  @Test
  void twoWhoEditOneDraftAreToldOfEachOther() {
    assertEquals(0, get("floors/hall/draft", 200).get("revision").asLong());
    JsonNode saved = put(0, 200);
    long revision = saved.get("revision").asLong();
    assertTrue(revision > 0);
    assertEquals("Max", saved.get("user").asString());

    JsonNode late = put(0, 412);
    assertTrue(late.get("detail").asString().startsWith("Max has changed the draft"));
    assertEquals(revision, get("floors/hall/draft", 200).get("revision").asLong());

    String draft = "api/v1/floors/hall/draft?revision=";
    assertEquals(412, manager.sendJson("DELETE", draft + (revision - 1), "").statusCode());
    assertEquals(422, manager.sendJson("DELETE", draft + "x", "").statusCode());
    assertEquals(revision, get("floors/hall/draft", 200).get("revision").asLong());
    assertEquals(204, manager.sendJson("DELETE", draft + revision, "").statusCode());
    JsonNode gone = put(revision, 412);
    assertTrue(gone.get("detail").asString().contains("published or discarded"));
  }

  @Test
  void aDraftIsCheckedAndPublished() {
    String path = "floors/hall/draft";
    String good = "{\"drawing\":" + DRAWING + "}";
    assertEquals(0, post(path + "/check", good, 200).size());
    String bad = good.replace("\"x\":0.25,\"y\":0.25", "\"x\":-0.25,\"y\":1.25");
    JsonNode problem = post(path + "/check", bad, 200).get(0);
    assertTrue(problem.get("blocking").asBoolean());
    assertTrue(problem.get("text").asString().startsWith("P1 lies in a wall"));
    assertEquals(-0.25, problem.at("/where/x").asDouble());

    long revision = save(bad, 0, 200).get("revision").asLong();
    JsonNode refused = post(path + "/publish", "{\"revision\":" + revision + "}", 409);
    assertTrue(refused.at("/problems/0/text").asString().startsWith("P1 lies in a wall"));

    long next = save(good, revision, 200).get("revision").asLong();
    post(path + "/publish", "{\"revision\":" + revision + "}", 412);
    post(path + "/publish", "{\"revision\":" + next + "}", 200);
    assertEquals(4, get("map", 200).get("width").asInt());
    assertEquals("smooth", get("floors/hall", 200).at("/drawing/moves").asString());
    assertTrue(get(path, 200).get("user").isNull());
    get("map?at=2026-01-01T00:00:00Z", 404);
    get("map?at=yesterday", 422);
  }

  @Test
  void itIsSaidWhichPlaceNeedsAnotherName() {
    String drawing = DRAWING.replace("\"name\":\"P1\"", "\"name\":\"P1\u200f\"");

    JsonNode answer = post("floors/hall/draft/check", "{\"drawing\":" + drawing + "}", 422);

    assertEquals(
        "The place at 0.25, 0.25 m needs a name of 1 to 64 letters on one line, all of which can"
            + " be shown.",
        answer.get("detail").asString());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "\"width\":4 | \"width\":0 | width",
        "\"width\":4 | \"width\":1.5 | width",
        "\"width\":4 | \"width\":16777217 | width",
        "\"height\":3 | \"height\":9000000 | width",
        "\"resolution\":0.5 | \"resolution\":1e999 | resolution",
        "\"resolution\":0.5 | \"resolution\":0 | resolution",
        "\"x\":-1,\"y\":0} | \"x\":-1e9,\"y\":0} | origin.x",
        "[1,2] | [1] | occupied",
        "[1,2] | [1,0] | occupied",
        "[1,2] | [4,2,1,2] | occupied",
        "[1,2] | [1,4,3,2] | occupied",
        "[1,2] | [11,2] | occupied",
        "[1,2] | [-1,2] | occupied",
        "[1,2] | [1,2.5] | occupied",
        "[1,2] | \"x\" | occupied",
        "\"name\":\"P1\" | \"name\":\" \" | parking.0.name",
        "\"name\":\"P1\" | \"name\":\"\\u200b\\u00a0\" | parking.0.name",
        "\"name\":\"P1\" | \"name\":\"\\ud800\" | parking.0.name",
        "\"name\":\"P1\" | \"name\":\"a\\tb\" | parking.0.name",
        "\"name\":\"P1\" | \"name\":\"a\\u202eb\" | parking.0.name",
        "\"name\":\"P1\" | \"name\":\"Dock \\\"A\\\"\" | parking.0.name",
        "\"headingDegrees\":90 | \"headingDegrees\":361 | stations.0.headingDegrees",
        "\"approach\":\"north\" | \"approach\":\"up\" | stations.0.approach",
        "\"approach\":\"north\" | \"colour\":\"red\" | stations.0.colour",
        "\"parking\":[{ | \"parking\":[7,{ | parking",
        "\"charging\":[] | \"doors\":[] | doors",
        "\"width\":0.5,\"height\":0.5} | \"width\":0,\"height\":0.5} | keepOut.0.width",
        "\"speed\":0.2 | \"speed\":0 | speedLimits.0.speed",
        "\"height\":1} | \"height\":-1} | freeZones.0.height",
        "\"moves\":\"smooth\" | \"moves\":\"curvy\" | moves",
        "\"moves\":\"smooth\" | \"moves\":7 | moves",
        "\"direction\":\"west\" | \"direction\":\"WEST\" | oneWay.0.direction",
      })
  void everyFaultOfADrawingIsNamed(String right, String wrong, String field) {
    assertTrue(DRAWING.contains(right), right);
    String drawing = DRAWING.replace(right, wrong);

    JsonNode answer = post("floors/hall/draft/check", "{\"drawing\":" + drawing + "}", 422);
    List<String> fields =
        answer.get("errors").valueStream().map(e -> e.get("field").asString()).toList();
    assertTrue(fields.contains("drawing." + field), answer::toString);
  }

  @Test
  void aDrawingMayBeLargeAndOtherBodiesMayNot() {
    String large = " ".repeat(300_000);
    post("floors/hall/draft/check", "{\"drawing\":" + DRAWING + large + "}", 200);
    post("floors/hall/draft/publish", "{\"revision\":1" + large + "}", 413);
    post("tasks", "{\"name\":\"x\"" + large + "}", 413);
  }

  @Test
  void whatIsExportedIsReadAgain() throws Exception {
    post("floors", "{\"name\":\"Ümit\",\"drawing\":" + DRAWING + "}", 201);
    HttpResponse<byte[]> zip = bytes("floors/%C3%9Cmit/export?format=ros");
    assertEquals(200, zip.statusCode());
    assertTrue(
        zip.headers()
            .firstValue("Content-Disposition")
            .orElseThrow()
            .contains("filename*=UTF-8''%C3%9Cmit.zip"));
    assertSame(JSON.readTree(DRAWING), read("application/zip", "", zip.body(), 200));

    HttpResponse<byte[]> map = bytes("floors/%C3%9Cmit/export?format=movingai");
    JsonNode walls = read("text/plain", "", map.body(), 200);
    assertEquals("[1,2,11,1]", walls.get("occupied").toString(), "with what is kept out");
    get("floors/%C3%9Cmit/export?format=svg", 422);
  }

  @Test
  void aPlanBecomesADrawing() throws Exception {
    byte[] png = png(new int[][] {{0xFFFFFF, 0x000000}, {0x808080, 0x303030}});
    JsonNode drawing = read("image/png", "?resolution=0.2&threshold=0.4", png, 200);
    assertEquals("[1,1,3,1]", drawing.get("occupied").toString());
    assertEquals(0.2, drawing.get("resolution").asDouble());
    assertEquals("[1,3]", read("image/png", "?threshold=0.6", png, 200).get("occupied").toString());
    read("image/png", "?threshold=2", png, 422);
    read("image/png", "?resolution=NaN", png, 422);
  }

  @Test
  void aWrongFileGetsASentence() throws Exception {
    String map = "type octile\nheight 100000\nwidth 100000\nmap\n";
    assertFault("floor.map: the map is 100000 x 100000 cells", "text/plain", text(map));
    assertTrue(
        read("text/plain", "?file=" + RequestPath.segment("my hall.MAP"), text(map), 422)
            .get("detail")
            .asString()
            .startsWith("my hall.MAP: "));
    assertTrue(
        read("image/png", "?file=e.png", new byte[9], 422)
            .get("detail")
            .asString()
            .startsWith("e.png is not a readable"));
    assertFault("0 x 4", "text/plain", text("type octile\nheight 4\nwidth 0\nmap\n"));
    assertFault("row has 0 cells", "text/plain", text("type octile\nheight 4\nwidth 3\nmap\n"));
    byte[] png = png(new int[][] {{0}});
    assertFault("picture.png is not a readable", "image/png", Arrays.copyOf(png, 40));
    assertFault("It is no ZIP file", "application/zip", png);
    byte[] noPicture =
        MapArchive.of(
                Map.of(
                    "a.yaml",
                    text(
                        "image: a.pgm\nresolution: 0.1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.6\nfree_thresh: 0.2\n")))
            .pack();
    assertFault("no file a.pgm", "application/zip", noPicture);
    byte[] bomb = MapArchive.of(Map.of("a.pgm", new byte[70 << 20])).pack();
    assertTrue(bomb.length < 1 << 20);
    assertFault("unpacks to more than", "application/zip", bomb);
    assertEquals(415, send("text/html", "", png).statusCode());
  }

  /** The same, with 0 or 0.0 for nothing. */
  private static void assertSame(JsonNode wanted, JsonNode came) {
    assertTrue(
        wanted.equals(
            (one, other) ->
                one.isNumber() && other.isNumber()
                    ? Double.compare(one.asDouble(), other.asDouble())
                    : one.equals(other) ? 0 : 1,
            came),
        () -> wanted + " and " + came);
  }

  @Test
  void aFloorIsAddedByAFileOnThePage() throws Exception {
    byte[] plan = png(new int[][] {{0xFFFFFF, 0x000000}});
    Map<String, String> fields =
        new TreeMap<>(Map.of("_csrf", manager.csrf(), "name", "Plan", "resolution", "0.5"));
    assertEquals(303, manager.postFile("floors", fields, "plan.png", plan).statusCode());
    assertEquals("[1,1]", get("floors/Plan", 200).at("/drawing/occupied").toString());

    fields.put("name", "Torn");
    HttpResponse<String> torn =
        manager.postFile("floors", fields, "plan.png", Arrays.copyOf(plan, 30));
    assertEquals(422, torn.statusCode());
    assertTrue(torn.body().contains("is not a readable PNG picture"), torn.body());
    get("floors/Torn", 404);

    assertEquals(303, manager.post("floors/Plan/delete", Map.of()).statusCode());
    get("floors/Plan", 404);
  }

  private static byte[] text(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  private static byte[] png(int[][] rows) throws IOException {
    BufferedImage image =
        new BufferedImage(rows[0].length, rows.length, BufferedImage.TYPE_INT_RGB);
    for (int y = 0; y < rows.length; y++) {
      for (int x = 0; x < rows[0].length; x++) {
        image.setRGB(x, y, rows[y][x]);
      }
    }
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ImageIO.write(image, "png", out);
    return out.toByteArray();
  }

  private void assertFault(String part, String type, byte[] file) throws Exception {
    JsonNode answer = read(type, "", file, 422);
    assertTrue(answer.get("detail").asString().contains(part), answer::toString);
  }

  private JsonNode read(String type, String query, byte[] file, int status) throws Exception {
    HttpResponse<String> answer = send(type, query, file);
    assertEquals(status, answer.statusCode(), answer.body());
    return JSON.readTree(answer.body());
  }

  private HttpResponse<String> send(String type, String query, byte[] file) {
    return manager.send(
        manager
            .request("api/v1/floors/read" + query)
            .header("Content-Type", type)
            .header("X-CSRF-Token", manager.csrf())
            .POST(BodyPublishers.ofByteArray(file))
            .build());
  }

  private HttpResponse<byte[]> bytes(String path) {
    return manager.send(manager.request("api/v1/" + path).build(), BodyHandlers.ofByteArray());
  }

  private JsonNode put(long seen, int status) {
    return save("{\"drawing\":" + DRAWING + "}", seen, status);
  }

  private JsonNode save(String drawing, long seen, int status) {
    String body = "{\"revision\":" + seen + "," + drawing.substring(1);
    return answer(manager.sendJson("PUT", "api/v1/floors/hall/draft", body), status);
  }

  private JsonNode post(String path, String body, int status) {
    return answer(manager.postJson("api/v1/" + path, body), status);
  }

  private JsonNode get(String path, int status) {
    return answer(manager.get("api/v1/" + path), status);
  }

  private static JsonNode answer(HttpResponse<String> answer, int status) {
    assertEquals(status, answer.statusCode(), answer.body());
    return JSON.readTree(answer.body());
  }

  @Test
  void whatRobotsSawIsDrawnIntoTheDraftOrDismissed() {
    FloorMap hall = Hall.floor();
    Cell cell = new Cell(15, 9);
    Instant now = Instant.now();
    seen(hall, cell, now.minus(Duration.ofHours(2)), "r1");
    seen(hall, cell, now, "r2");
    JsonNode offer = get("floors/hall/seen", 200).get(0);
    assertEquals(hall.grid().centre(cell).x(), offer.at("/cells/0/x").asDouble(), 1e-9);
    assertTrue(manager.get("floors").body().contains("r1, r2"), "on the page");
    assertFalse(clerk.get("floors").body().contains("/seen/"), "it is the manager's");
    String path = "floors/hall/seen/" + offer.get("id").asString();

    JsonNode drawn = post(path + "/draw", "", 200);
    JsonNode draft = get("floors/hall/draft", 200);
    assertEquals(drawn.get("revision"), draft.get("revision"));
    assertTrue(
        draft.at("/drawing/occupied").toString().contains(String.valueOf(hall.grid().index(cell))),
        draft::toString);
    assertEquals(204, manager.sendJson("DELETE", "api/v1/floors/hall/draft", "").statusCode());

    assertEquals(204, manager.postJson("api/v1/" + path + "/dismiss", "").statusCode());
    assertEquals(0, get("floors/hall/seen", 200).size());
    post(path + "/dismiss", "", 404);
    post(path + "/draw", "", 404);
  }

  private void seen(FloorMap floor, Cell cell, Instant at, String robot) {
    BitSet cells = new BitSet();
    cells.set(floor.grid().index(cell));
    SeenObstacle obstacle = new SeenObstacle(CellRuns.of(cells), List.of(robot), at, at, false);
    server
        .seenPlaces()
        .observe(floor, Views.floorWith(floor.name(), List.of(obstacle)), List.of(), at);
  }

  @Test
  void whatASwarmExploredBecomesTheDraft() {
    post("floors", "{\"name\":\"New\",\"width\":3,\"height\":3,\"resolution\":0.3}", 201);
    String path = "floors/New/exploration";
    get("floors/none/exploration", 404);
    get(path, 404);
    assertEquals(403, clerk.get("api/v1/" + path).statusCode());
    server.setExplorationSpeed(Double.POSITIVE_INFINITY);

    JsonNode begun = post(path, order("scene:office", 1, 2, 22), 201);
    assertEquals("NONE_YET", begun.get("draft").asString());
    JsonNode end = explored(path);
    assertEquals("REACHED", end.get("state").asString());
    assertEquals("SAVED", end.get("draft").asString());
    assertEquals(1, end.get("share").asDouble());
    assertTrue(end.get("area").asDouble() > 100, () -> "seen: " + end.get("area"));

    JsonNode draft = get("floors/New/draft", 200);
    assertEquals(0.1, draft.at("/drawing/resolution").asDouble());
    assertEquals(WebTestServer.MANAGER, draft.get("user").asString());
    FloorMap published =
        server.fleet().floors().stream()
            .filter(f -> f.name().equals("New"))
            .findFirst()
            .orElseThrow();
    assertEquals(0.3, published.grid().resolution(), "in force is what was");
    assertEquals(409, status(path, order("scene:office", 1, 2, 22)), "a draft is there");
    post("floors/New/draft/publish", "{\"revision\":" + draft.get("revision") + "}", 200);

    server.setExplorationSpeed(1);
    assertEquals("RUNNING", post(path, order("floor:New", 2, 2, 3), 201).get("state").asString());
    assertEquals(409, status("floors/hall/exploration", order("scene:store", 1, 2, 28)));
    assertEquals(409, status(path + "/draw", ""));
    JsonNode now = get("floors/New/draft", 200);
    String theirs = "{\"revision\":" + now.get("revision") + ",\"drawing\":" + DRAWING + "}";
    answer(manager.sendJson("PUT", "api/v1/floors/New/draft", theirs), 200);
    JsonNode stopped = post(path + "/stop", "", 200);
    assertEquals("STOPPED", stopped.get("state").asString());
    assertEquals("NOT_SAVED", stopped.get("draft").asString());
    assertEquals(409, status(path + "/stop", ""));
    assertEquals("SAVED", post(path + "/draw", "", 200).get("draft").asString());
    JsonNode drawn = get("floors/New/draft", 200).get("drawing");
    assertEquals(0.1, drawn.get("resolution").asDouble());
    assertEquals("Dock \"A\"", drawn.at("/stations/0/name").asString(), "places are kept");
    assertEquals(
        List.of(
            WebTestServer.MANAGER + " stopped the exploration of New",
            WebTestServer.MANAGER + " let 2 robots explore New in simulation, with seed 1",
            "The exploration of New reached its target",
            WebTestServer.MANAGER + " let a robot explore New in simulation, with seed 1"),
        get("history?kind=exploration&floor=New", 200)
            .get("events")
            .valueStream()
            .map(event -> event.get("text").asString())
            .toList());
  }

  @Test
  void wrongOrdersToExploreAreToldWhatIsWrong() {
    String path = "floors/hall/exploration";
    for (String[] wrong :
        new String[][] {
          {order("scene:moon", 1, 2, 22), "ground"},
          {order("floor:none", 1, 2, 22), "ground"},
          {order("scene:office", 0, 2, 22), "robots"},
          {order("scene:office", 10, 2, 22), "robots"},
          {order("scene:office", 1, 6.1, 22), "start"}, // a wall
          {order("scene:office", 1, -2, 22), "start"},
          {order("scene:office", 1, 2, 25), "target"},
          {"{\"ground\":\"scene:office\",\"start\":{\"x\":2},\"target\":5,\"sed\":1}", "start.y"},
        }) {
      JsonNode problem = post(path, wrong[0], 422);
      assertEquals(wrong[1], problem.at("/errors/0/field").asString(), problem::toString);
      assertFalse(problem.at("/errors/0/detail").asString().isBlank(), problem::toString);
    }
    get(path, 404);
  }

  private static String order(String ground, int robots, double x, double toX) {
    return """
        {"ground":"%s","robots":%d,"start":{"x":%s,"y":2},"target":{"x":%s,"y":14}}\
        """
        .formatted(ground, robots, x, toX);
  }

  private int status(String path, String body) {
    return manager.postJson("api/v1/" + path, body).statusCode();
  }

  /** When it has ended. */
  private JsonNode explored(String path) {
    Instant limit = Instant.now().plusSeconds(60);
    JsonNode exploration = get(path, 200);
    while (exploration.get("state").asString().equals("RUNNING")) {
      assertTrue(Instant.now().isBefore(limit), "it does not end");
      exploration = get(path, 200);
    }
    return exploration;
  }
}
