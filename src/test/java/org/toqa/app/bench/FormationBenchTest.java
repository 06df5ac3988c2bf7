package org.toqa.app.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class FormationBenchTest {
  private final StringWriter out = new StringWriter();
  private final StringWriter err = new StringWriter();

  @ParameterizedTest
  @CsvSource({"1", "2", "3"})
  void omniRobotsKeepTheirPlacesAsWellAsTheyShall(int seed) {
    JsonNode report = measured("--seed", String.valueOf(seed));
    JsonNode soon = report.path("formations").path(0);
    JsonNode late = report.path("formations").path(1);

    assertEquals(20, soon.path("delayMs").intValue());
    assertTrue(soon.path("error").path("rmsMetres").doubleValue() < 0.01, soon.toString());
    assertTrue(soon.path("error").path("maxMetres").doubleValue() < 0.03, soon.toString());
    assertEquals(100, late.path("delayMs").intValue());
    assertTrue(late.path("error").path("maxMetres").doubleValue() < 0.05, late.toString());
    for (JsonNode formation : report.path("formations")) {
      assertTrue(formation.path("error").path("arrived").booleanValue(), formation.toString());
      assertTrue(formation.path("error").path("free").booleanValue(), formation.toString());
    }
  }

  @Test
  void robotAloneEndsItsWayWithinACentimetreByOdometry() {
    JsonNode tracking = measured("--seed", "4").path("tracking");

    assertEquals(20, tracking.path("metres").doubleValue(), 0.1);
    assertTrue(tracking.path("endMetres").doubleValue() < 0.01, tracking.toString());
    assertTrue(
        tracking.path("trueEndMetres").doubleValue() > tracking.path("endMetres").doubleValue(),
        "odometry does not see slip");
  }

  @Test
  void trueErrorOfWheelsThatNeitherSlipNorDifferIsOdometrys() {
    JsonNode report = measured("--slip", "0", "--wheel-size-error", "0");
    JsonNode error = report.path("formations").path(0).path("error");

    // what the encoders round off
    assertEquals(
        error.path("rmsMetres").doubleValue(), error.path("trueRmsMetres").doubleValue(), 0.01);
  }

  @Test
  void numberOutOfItsRangeIsRefused() {
    assertEquals(2, run("--slip", "11"));
    assertTrue(err.toString().contains("--slip 11.0: it must be from 0 to 10"), err.toString());
  }

  private JsonNode measured(String... arguments) {
    assertEquals(0, run(arguments), () -> out + " " + err);
    return JsonMapper.shared().readTree(out.toString());
  }

  private int run(String... arguments) {
    return new CommandLine(new FormationBench(() -> Path.of("maps", "lab.yaml")))
        .setOut(new PrintWriter(out, true))
        .setErr(new PrintWriter(err, true))
        .execute(arguments);
  }
}
