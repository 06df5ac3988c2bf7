package org.toqa.app.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringReader;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.InputSource;
import picocli.CommandLine;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class PlanCommandTest {
  /** The lower aisle is wide enough for arcs from its west end; the upper one bends sharply. */
  private static final String MAP =
      """
      type octile
      height 3
      width 5
      map
      ...@@
      @@...
      ....@
      """;

  @TempDir private Path folder;
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  @BeforeEach
  void writeMap() throws IOException {
    Files.writeString(folder.resolve("small.map"), MAP);
  }

  @Test
  void theTableTellsTheWayAndItsSegments() {
    assertEquals(0, run("--from 0.5,0.5 --to 4.5,1.5"));

    // an arc of 45 degrees: R = 0.5 / tan 22.5 = 1.207 m, 0.948 m long, w = 0.25 / R = 0.207
    assertEquals(
        """
        from    0.500, 0.500 m, cell (0,2)
        to      4.500, 1.500 m, cell (4,1)
        cost    4.414 cells
        length  4.310 m driven
        time    17.2 s
        turns   0 on the spot
        cells   (0,2) (1,2) (2,2) (3,1) (4,1)

         segment  v (m/s)  w (rad/s)    t (s)  then at x (m)    y (m)  degrees
               1    0.250      0.000    6.000          2.000    0.500        0
               2    0.250      0.207    3.792          2.854    0.854       45
               3    0.250      0.000    1.657          3.146    1.146       45
               4    0.250     -0.207    3.792          4.000    1.500        0
               5    0.250      0.000    2.000          4.500    1.500        0
        """,
        out.toString());
    assertEquals("", err.toString());
  }

  @Test
  void jsonHasTheCellsAndTheSegments() throws IOException {
    assertEquals(0, run("--from 0.9,2.1,90 --to 4.5,1.5 --format json"));

    JsonNode json = JsonMapper.shared().readTree(out.toString());
    assertTrue(json.path("found").booleanValue());
    assertTrue(json.path("reason").isNull());
    assertEquals(7, json.path("cost").doubleValue(), 1e-9); // 5 cells, 2 turns of 90 degrees
    assertEquals(5, json.path("length").doubleValue(), 1e-9);
    // 5 m at 0.25 m/s, 3 turns of 90 degrees at 1.5 rad/s
    assertEquals(20 + Math.PI, json.path("seconds").doubleValue(), 1e-9);
    assertEquals(2, json.path("turnsOnSpot").intValue());
    assertEquals(0.5, json.path("start").path("x").doubleValue(), 1e-9);
    assertEquals(Math.PI / 2, json.path("start").path("theta").doubleValue(), 1e-9);
    assertEquals("[[0,0],[1,0],[2,0],[2,1],[3,1],[4,1]]", json.path("cells").toString());
    JsonNode first = json.path("segments").path(0);
    assertEquals(0, first.path("v").doubleValue());
    assertEquals(-1.5, first.path("w").doubleValue()); // from north to east: to the right
    assertEquals(Math.PI / 2, -first.path("w").doubleValue() * first.path("t").doubleValue(), 1e-9);
  }

  @Test
  void octileMovesBendAsTheyLike() throws IOException {
    assertEquals(0, run("--from 0.5,2.5 --to 4.5,1.5 --moves octile --format json"));

    JsonNode json = JsonMapper.shared().readTree(out.toString());
    assertEquals(5, json.path("cost").doubleValue(), 1e-9);
    assertEquals(0, json.path("turnsOnSpot").intValue());
  }

  @Test
  void smoothMovesAreACurveWithSegmentsAndWheels() throws IOException {
    assertEquals(
        0, run("--from 0.5,0.5,90 --to 4.5,1.5 --moves smooth --margin 0.4 --format json"));

    JsonNode json = JsonMapper.shared().readTree(out.toString());
    assertTrue(json.path("found").booleanValue());
    assertEquals(0.5, json.path("path").path(0).path(0).doubleValue(), 1e-9);
    // 2.5 m to below the corner, up to the upper aisle, and on: longer than straight
    assertTrue(json.path("length").doubleValue() > Math.hypot(4, 1));
    assertTrue(json.path("length").doubleValue() < 4.5);
    assertFalse(json.path("segments").isEmpty());
    assertTrue(json.path("polynomial").isNull(), "it would touch the corner");
    for (JsonNode sample : json.path("wheels")) {
      assertTrue(Math.abs(sample.path("left").path("speed").doubleValue()) <= 0.52);
      assertTrue(sample.path("right").path("amplitude").intValue() <= 255);
    }
  }

  /** The same floor, a thousand times smaller. */
  @Test
  void smoothMovesKeepOffWallsOfMillimetres() throws IOException {
    String map = "map.yaml";
    Files.writeString(
        folder.resolve(map),
        """
        image: map.pgm
        resolution: 0.001
        origin: [0, 0, 0]
        negate: 0
        occupied_thresh: 0.65
        free_thresh: 0.196
        """);
    Files.writeString(
        folder.resolve("map.pgm"),
        """
        P2 5 3 255
        255 255 255 0 0
        0 0 255 255 255
        255 255 255 255 0
        """);
    List<Vec2> walls =
        List.of(cell(3, 2), cell(4, 2), cell(0, 1), cell(1, 1), cell(4, 0)); // row 0 below

    assertEquals(
        0,
        run(
            map,
            "--from 0.0005,0.0005,90 --to 0.0045,0.0015 --moves smooth --margin 0.4 --format json"));

    JsonNode json = JsonMapper.shared().readTree(out.toString());
    JsonNode start = json.path("start");
    Pose pose =
        new Pose(
            start.path("x").doubleValue(),
            start.path("y").doubleValue(),
            start.path("theta").doubleValue());
    for (JsonNode segment : json.path("segments")) {
      Twist twist = new Twist(segment.path("v").doubleValue(), 0, segment.path("w").doubleValue());
      double part = segment.path("t").doubleValue() / 50;
      for (int i = 0; i < 50; i++) {
        pose = pose.advanced(twist, part);
        Vec2 there = pose.position();
        double nearest =
            walls.stream().mapToDouble(wall -> distance(there, wall)).min().orElseThrow();
        assertTrue(nearest > 0.000379, () -> there + " is too near to a wall"); // 0.4 of a cell
      }
    }
    assertEquals(0, pose.position().distanceTo(new Vec2(0.0045, 0.0015)), 0.00003);
  }

  /** Its lower left corner, metres. */
  private static Vec2 cell(int column, int rowFromBelow) {
    return new Vec2(0.001 * column, 0.001 * rowFromBelow);
  }

  private static double distance(Vec2 point, Vec2 corner) {
    double x = Math.clamp(point.x(), corner.x(), corner.x() + 0.001);
    double y = Math.clamp(point.y(), corner.y(), corner.y() + 0.001);
    return point.distanceTo(new Vec2(x, y));
  }

  @Test
  void aPolynomialThatTouchesNothingIsTold() throws IOException {
    assertEquals(0, run("--from 0.5,0.5 --to 2,0.5 --moves smooth --margin 0.4 --format json"));
    JsonNode polynomial = JsonMapper.shared().readTree(out.toString()).path("polynomial");
    assertEquals(2, polynomial.path("to").path("x").doubleValue());
    assertEquals(1, polynomial.path("bulge").size());
  }

  @ParameterizedTest
  @CsvSource({"table, turns   0 on the spot", "table, no polynomial is free", "svg, right wheel"})
  void smoothMovesAreShownToPeople(String format, String words) {
    assertEquals(
        0, run("--from 0.5,0.5 --to 4.5,1.5 --moves smooth --margin 0.4 --format " + format));
    assertTrue(out.toString().contains(words), out::toString);
  }

  @ParameterizedTest
  @CsvSource({
    "'--from 4.5,2.5 --to 0.5,0.5', START_BLOCKED",
    "'--from 1.5,2.5 --to 9,0.5', GOAL_BLOCKED"
  })
  void whyThereIsNoSmoothWayIsNamed(String arguments, String reason) throws IOException {
    assertEquals(1, run(arguments + " --moves smooth --margin 0.4 --format json"));
    assertEquals(reason, JsonMapper.shared().readTree(out.toString()).path("reason").stringValue());
    assertTrue(err.toString().contains("(" + reason + "): "), err::toString);
  }

  @Test
  void startThatIsTheGoalIsAWayWithoutSegments() throws IOException {
    assertEquals(0, run("--from 0.5,2.5,30 --to 0.6,2.4 --format json"));

    JsonNode json = JsonMapper.shared().readTree(out.toString());
    assertEquals(0, json.path("cost").doubleValue());
    assertEquals("[[0,0]]", json.path("cells").toString());
    assertEquals("[]", json.path("segments").toString());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          --from 4.5,2.5 --to 0.5,0.5               | START_BLOCKED | the start at (4.5, 2.5) m lies in an obstacle
          --from -0.5,2.5 --to 0.5,0.5              | START_BLOCKED | the start at (-0.5, 2.5) m lies off the map
          --from 1.5,2.5 --to 9e5,0.5               | GOAL_BLOCKED  | the goal at (900000.0, 0.5) m lies off the map
          --from 2.5,2.5 --to 2.5,0.5 --margin 0.51 | START_BLOCKED | is nearer to an obstacle than the margin
          --from 0.5,2.5 --to 0.5,4.5               | NO_PATH       | obstacles part the goal from the start
          """)
  void whyThereIsNoWayIsNamed(String arguments, String reason, String words) throws IOException {
    Files.writeString(
        folder.resolve("small.map"),
        MAP.replace("height 3", "height 5").replace("map\n", "map\n.....\n@@@@@\n"));

    assertEquals(1, run(arguments + " --format json"));

    JsonNode json = JsonMapper.shared().readTree(out.toString());
    assertFalse(json.path("found").booleanValue());
    assertEquals(reason, json.path("reason").stringValue());
    assertEquals("[]", json.path("cells").toString());
    assertTrue(err.toString().contains("(" + reason + "): "), err::toString);
    assertTrue(err.toString().contains(words), err::toString);
  }

  @Test
  void withoutAWayOnlyJsonIsPrinted() {
    assertEquals(1, run("--from 0.5,2.5 --to 0.5,1.5 --format svg"));
    assertEquals("", out.toString());
  }

  @Test
  void thePictureShowsTheMapTheWayAndTheDrive() throws Exception {
    Files.writeString(
        folder.resolve("small.floor.yaml"), "stations:\n  - {name: A<B & C, x: 1.5, y: 0.5}\n");

    assertEquals(0, run("--from 0.5,0.5 --to 4.5,1.5 --format svg"));

    Document svg =
        DocumentBuilderFactory.newInstance()
            .newDocumentBuilder()
            .parse(new InputSource(new StringReader(out.toString())));
    assertTrue(texts(svg).anyMatch("A<B & C"::equals));
    assertTrue(
        texts(svg).anyMatch(text -> text.startsWith("small: cost 4.41 cells, 4.31 m driven")));
    // walls, row by row, neighbours as one
    assertTrue(paths(svg).anyMatch("M3 0h2v1h-2zM0 1h2v1h-2zM4 2h1v1h-1z"::equals));
    assertTrue(paths(svg).anyMatch("M0.5 2.5L1.5 2.5L2.5 2.5L3.5 1.5L4.5 1.5"::equals));
    // to the left, which is against the clock, then to the right
    String drive =
        "M0.5 2.5L2 2.5A1.207 1.207 0 0 0 2.854 2.146"
            + "L3.146 1.854A1.207 1.207 0 0 1 4 1.5L4.5 1.5";
    assertTrue(paths(svg).anyMatch(drive::equals), out::toString);
  }

  @Test
  void keepOutZonesOfTheFloorAreKept() throws IOException {
    Files.writeString(
        folder.resolve("small.floor.yaml"), "keepOut:\n  - {x: 2, y: 1, width: 1, height: 1}\n");

    assertEquals(1, run("--from 0.5,2.5 --to 4.5,1.5"));
    assertTrue(err.toString().contains("NO_PATH"), err::toString);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          --from 0.5 --to 1,1                     | expected X,Y in metres or X,Y,DEG
          --from 1,1,0,0 --to 1,1                 | expected X,Y in metres or X,Y,DEG
          --from 1,1 --to 1,1,90                  | expected X,Y in metres, such as
          --from 1,one --to 1,1                   | "one" is not a number
          --from 1,NaN --to 1,1                   | "NaN" is not a number
          --from 1,1e7 --to 1,1                   | "1e7" is not a number from -1000000 to 1000000
          --from 1,1,361 --to 1,1                 | "361" is not a number from -360 to 360
          --from 1,1 --to 1,1 --margin -1         | --margin -1.0: it must be from 0 to 1000
          --from 1,1 --to 1,1 --margin NaN        | --margin NaN: it must be from 0 to 1000
          --from 1,1 --to 1,1 --margin wide       | 'wide'
          --from 1,1 --to 1,1 --moves knight      | it is octile, heading or smooth, not knight
          --from 1,1 --to 1,1 --moves smooth      | --moves smooth needs a --margin above 0
          --from 1,1 --to 1,1 --format png        | it is table, json or svg, not png
          --from 1,1                              | --to
          """)
  void aWrongArgumentIsOneSentenceAndExitTwo(String arguments, String words) {
    assertEquals(2, run(arguments));

    assertEquals("", out.toString());
    assertTrue(err.toString().contains(words), err::toString);
  }

  @Test
  void aMissingMapIsAWrongArgument() throws IOException {
    Files.delete(folder.resolve("small.map"));

    assertEquals(2, run("--from 1,1 --to 1,1"));
    assertTrue(err.toString().contains("There is no file"), err::toString);
  }

  private static Stream<String> texts(Document svg) {
    return elements(svg, "text").map(Element::getTextContent);
  }

  private static Stream<String> paths(Document svg) {
    return elements(svg, "path").map(path -> path.getAttribute("d"));
  }

  private static Stream<Element> elements(Document svg, String name) {
    NodeList nodes = svg.getElementsByTagName(name);
    return IntStream.range(0, nodes.getLength()).mapToObj(i -> (Element) nodes.item(i));
  }

  private int run(String arguments) {
    return run("small.map", arguments);
  }

  private int run(String map, String arguments) {
    String[] words = ("--map " + folder.resolve(map) + " " + arguments).split(" +");
    return new CommandLine(new PlanCommand())
        .setOut(new PrintWriter(out, true))
        .setErr(new PrintWriter(err, true))
        .execute(words);
  }
}
