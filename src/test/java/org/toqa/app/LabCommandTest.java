package org.toqa.app;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.lab.Experiments;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

@Tag("full")
class LabCommandTest {
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  @Test
  void withoutANameExperimentsAreListedOneALineAndIndented() {
    assertEquals(0, run());

    List<String> lines = out.toString().lines().toList();
    assertEquals(Experiments.all().size(), lines.size());
    for (int i = 0; i < lines.size(); i++) {
      String name = Experiments.all().get(i).name();
      assertTrue(lines.get(i).startsWith("  " + name + " "), lines.get(i));
    }
    assertEquals("", err.toString());
  }

  @Test
  void anExperimentIsDoneAndPrintedAsJson() {
    assertEquals(0, run("csm-static", "--seed", "7", "--json"));

    JsonNode json = JsonMapper.shared().readTree(out.toString());
    assertEquals("csm-static", json.path("experiment").stringValue());
    assertEquals(7, json.path("seed").intValue());
    assertEquals(1, json.path("runs").intValue());
    assertFalse(json.path("figures").isEmpty());
    for (JsonNode figure : json.path("figures")) {
      String verdict = figure.path("verdict").stringValue();
      assertTrue(Set.of("reproduced", "refuted", "not comparable").contains(verdict), verdict);
      assertFalse(figure.path("name").stringValue().isEmpty());
      assertTrue(figure.has("published") && figure.has("measured"));
      assertTrue(
          !verdict.equals("not comparable") || !figure.path("reason").stringValue().isEmpty(),
          () -> "without a reason: " + figure);
    }
    assertTrue(err.toString().contains("csm-static: 0 %"), "progress goes to standard error");
  }

  @Test
  void theSameSeedGivesTheSameReport() {
    assertEquals(0, run("csm-static", "--seed", "3", "--json"));
    String first = out.toString();
    out.getBuffer().setLength(0);
    assertEquals(0, run("csm-static", "--seed", "3", "--json"));
    assertEquals(first, out.toString());

    out.getBuffer().setLength(0);
    assertEquals(0, run("csm-static", "--seed", "4", "--json"));
    JsonNode other = JsonMapper.shared().readTree(out.toString());
    JsonNode same = JsonMapper.shared().readTree(first);
    assertFalse(
        same.path("tables").equals(other.path("tables")), "another seed gives another slip");
  }

  @Test
  void theTableTellsEveryFigureWithItsVerdict() {
    assertEquals(0, run("csm-static"));

    String figure =
        out.toString()
            .lines()
            .filter(line -> line.contains("end of equation 14"))
            .findFirst()
            .orElseThrow();
    // 0.0034 * 210^2 - 0.64 * 210 + 157.53 = 173.07
    assertTrue(figure.matches(".*200 cm +173\\.07 cm +- +refuted"), figure);
  }

  @Test
  void reportsAreWrittenAsFilesIntoAFolderThatIsMade(@TempDir Path folder) throws Exception {
    Path made = folder.resolve("a/b");
    assertEquals(0, run("csm-static", "--out", made.toString()));

    JsonNode json = JsonMapper.shared().readTree(Files.readString(made.resolve("csm-static.json")));
    List<String> rows = Files.readAllLines(made.resolve("csm-static-figures.csv"));
    assertEquals("name,published,measured,bound,verdict,reason", rows.getFirst());
    assertEquals(json.path("figures").size() + 1, rows.size());
    List<Path> drawings;
    try (Stream<Path> files = Files.list(made)) {
      drawings = files.filter(file -> file.toString().endsWith(".svg")).toList();
    }
    assertEquals(8, drawings.size(), "three floors, three costs, errors, wheel speeds");
    for (Path drawing : drawings) {
      assertEquals(
          "svg",
          DocumentBuilderFactory.newInstance()
              .newDocumentBuilder()
              .parse(drawing.toFile())
              .getDocumentElement()
              .getTagName());
    }
  }

  @Test
  void aParameterIsSet() {
    assertEquals(0, run("csm-static", "--set", "lag=0.2", "--json"));

    JsonNode json = JsonMapper.shared().readTree(out.toString());
    assertEquals(0.2, json.path("parameters").path("lag").doubleValue());
    // four times the lag that the tracker reckons with
    assertTrue(verdicts(json, "position error").contains("refuted"));
  }

  private static List<String> verdicts(JsonNode json, String name) {
    return json.path("figures")
        .valueStream()
        .filter(figure -> figure.path("name").stringValue().contains(name))
        .map(figure -> figure.path("verdict").stringValue())
        .toList();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          csm-statik                     | is no experiment; the nearest is csm-static
          nope                           | is no experiment; there are: cmct-
          csm-static --set x             | Value for option '--set'
          csm-static --runs 0            | --runs 0: it must be from 1 to 10000
          csm-static --seed x            | "x" is not a whole number
          csm-static --set leg=1         | is no parameter; the nearest is lag
          csm-static --set lag=9         | --set lag=9.0: it must be from 0.0 to 0.5
          csm-static csm-dynamic         | is not known
          csm-static --out /proc/nowhere | this folder cannot be made
          --out somewhere                | need the NAME of an experiment
          """)
  void aWrongArgumentGetsOneLineAndExitCodeTwo(String arguments, String expected) {
    assertEquals(2, run(arguments.split(" ")));

    assertEquals("", out.toString());
    assertEquals(1, err.toString().lines().count(), err::toString);
    assertTrue(err.toString().contains(expected), err::toString);
  }

  private int run(String... arguments) {
    return Main.commandLine()
        .setOut(new PrintWriter(out, true))
        .setErr(new PrintWriter(err, true))
        .execute(Stream.concat(Stream.of("lab"), Stream.of(arguments)).toArray(String[]::new));
  }
}
