package org.toqa.link.http;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.toqa.link.http.HttpRobotException.Reason;
import org.toqa.motion.DifferentialLimits;
import org.toqa.motion.WheelCommand;

class HttpRobotCodecTest {
  private static final String REPORT =
      "{\"seq\":1,\"boot\":7,\"stamp\":30,\"left\":1,\"right\":2,\"battery\":0.5}";

  static List<String> goldenLines() throws IOException {
    try (InputStream golden =
        Objects.requireNonNull(HttpRobotCodecTest.class.getResourceAsStream("http-robot.golden"))) {
      return new String(golden.readAllBytes(), StandardCharsets.UTF_8)
          .lines()
          .filter(line -> !line.startsWith("#"))
          .toList();
    }
  }

  @ParameterizedTest
  @MethodSource("goldenLines")
  void goldenMessageIsReadAndWrittenAsItStands(String line) throws Exception {
    String kind = line.substring(0, line.indexOf(' '));
    String json = line.substring(line.indexOf(' ') + 1);
    byte[] read = json.getBytes(StandardCharsets.UTF_8);
    byte[] written =
        switch (kind) {
          case "description" -> HttpRobotCodec.encode(HttpRobotCodec.decodeDescription(read));
          case "order" -> HttpRobotCodec.encode(HttpRobotCodec.decodeOrder(read));
          case "report" -> HttpRobotCodec.encode(HttpRobotCodec.decodeReport(read));
          default -> throw new AssertionError(kind);
        };
    assertEquals(json, new String(written, StandardCharsets.UTF_8));
  }

  @Test
  void orderHasTheQuantitiesOfThePaper() {
    DifferentialLimits limits = new DifferentialLimits(0.52, 0.2, 0.5, 0.8, 4);

    // vR = v + w L / 2 = 0.13 + 1.3 * 0.1 = 0.26, vL = 0
    WheelOrder order = WheelOrder.of(5, WheelCommand.of(0, 0.13, 1.3, limits));

    assertEquals(0, order.left().speed(), 1e-12);
    assertEquals(0.26, order.right().speed(), 1e-12);
    assertEquals(128, order.right().amplitude()); // 255 * 0.26 / 0.52 = 127.5
    assertEquals(128 * 33.0 / 255, order.right().pulse(), 1e-12);
    assertTrue(order.right().forward());
  }

  @ParameterizedTest
  @CsvSource({"1000,false", "600,false", "599,true", "1001,true"})
  void orderIsStaleBeyondItsAge(long after, boolean isStale) {
    WheelCommand stop = WheelCommand.of(0, 0, 0, DifferentialLimits.DEFAULT);

    assertEquals(isStale, WheelOrder.of(1, after, stop).isStale(1000));
    assertFalse(WheelOrder.of(1, stop).isStale(1000));
  }

  @Test
  void ageThatIsNoneIsRefused() {
    byte[] body =
        new String(
                HttpRobotCodec.encode(
                    WheelOrder.of(1, 30L, WheelCommand.of(0, 0, 0, DifferentialLimits.DEFAULT))),
                StandardCharsets.UTF_8)
            .replace("\"after\":30", "\"after\":\"soon\"")
            .getBytes(StandardCharsets.UTF_8);

    HttpRobotException refused =
        assertThrows(HttpRobotException.class, () -> HttpRobotCodec.decodeOrder(body));

    assertTrue(String.valueOf(refused.getMessage()).startsWith("after must be a whole number"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "\"seq\":1 | \"seq\":1.5 | seq must be a whole number",
        "\"seq\":1 | \"seq\":-1 | seq must be a whole number",
        "\"boot\":7 | \"boot\":null | boot must be a whole number",
        "\"left\":1 | \"left\":\"1\" | left must be a whole number",
        "\"left\":1 | \"left\":1e300 | left must be a whole number",
        "\"battery\":0.5 | \"battery\":1.5 | battery must be a number from 0.0 to 1.0",
        "\"battery\":0.5 | \"ranges\":[0.5,-3,0.5] | ranges must be up to 16 numbers",
        "\"battery\":0.5 | \"ranges\":[1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1] | ranges must be up to 16 numbers",
        "\"battery\":0.5 | \"ranges\":0.5 | ranges must be up to 16 numbers",
        "\"battery\":0.5 | \"errors\":[{\"code\":\"a b\",\"text\":\"\"}] | errors must be a list",
        "\"battery\":0.5 | \"errors\":[7] | errors must be a list",
        "{ | [ | it is not JSON",
        "} | }x | it is not JSON",
        "\"boot\":7 | \"boot\":7,\"boot\":7 | it is not JSON"
      })
  void reportThatMakesNoSenseIsRefusedWithItsField(String usual, String wrong, String sentence) {
    byte[] body = REPORT.replace(usual, wrong).getBytes(StandardCharsets.UTF_8);

    HttpRobotException refused =
        assertThrows(HttpRobotException.class, () -> HttpRobotCodec.decodeReport(body));

    assertEquals(Reason.NONSENSE, refused.reason());
    assertTrue(String.valueOf(refused.getMessage()).startsWith(sentence), refused.getMessage());
  }

  @Test
  void emptyListOfRangesIsThatOfARobotWithoutSensors() throws Exception {
    byte[] body =
        REPORT.replace("\"battery\":0.5", "\"ranges\":[]").getBytes(StandardCharsets.UTF_8);

    assertNull(HttpRobotCodec.decodeReport(body).ranges());
  }

  @Test
  void errorsOfARobotAreFitForLogs() throws Exception {
    byte[] body =
        REPORT
            .replace(
                "\"battery\":0.5", "\"errors\":[{\"code\":\"STALL\",\"text\":\"a\\nb\\u001b[2J\"}]")
            .getBytes(StandardCharsets.UTF_8);

    assertEquals("a b", HttpRobotCodec.decodeReport(body).errors().getFirst().text().strip());
  }

  static Stream<String> wrongDescriptions() throws IOException {
    String right = goldenLines().getFirst().substring("description ".length());
    return Stream.of(
        right.replace("\"version\":1", "\"version\":2"),
        right.replace("\"seq\":0", "\"seq\":4503599627370497"),
        right.replace("\"seq\":0", "\"seq\":0,\"rangeAngles\":[]"),
        right.replace("\"seq\":0", "\"seq\":0,\"rangeAngles\":[0.3,-0.3]"),
        right.replace("\"seq\":0", "\"seq\":0,\"rangeAngles\":[-4]"),
        right.replace("\"seq\":0", "\"seq\":0,\"sonar\":true"),
        right.replace("\"seq\":0", "\"seq\":0,\"sonar\":{\"farthest\":4}"),
        right.replace("\"seq\":0", "\"seq\":0,\"sonar\":{\"farthest\":4,\"deviation\":0}"),
        right.replace("\"track\":0.2", "\"track\":0"),
        right.replace("\"maxSpeed\":0.52", "\"maxSpeed\":100"),
        right.replace("\"countsPerTurn\":2808", "\"countsPerTurn\":2808.5"),
        right.replace("\"countsPerTurn\":2808", "\"countsPerTurn\":100"));
  }

  @ParameterizedTest
  @MethodSource("wrongDescriptions")
  void bodyThatCannotBeDrivenIsRefused(String json) {
    byte[] body = json.getBytes(StandardCharsets.UTF_8);
    assertThrows(HttpRobotException.class, () -> HttpRobotCodec.decodeDescription(body));
  }

  @Test
  void tokenIsNeitherShownNorGuessed() {
    RobotToken token = new RobotToken("0123456789abcdef");

    assertFalse(token.toString().contains("0123"));
    assertTrue(token.isIn("Bearer 0123456789abcdef"));
    assertFalse(token.isIn("Bearer 0123456789abcdeX"));
    assertFalse(token.isIn("0123456789abcdef"));
    assertTrue(RobotToken.parse("short").isEmpty());
  }
}
