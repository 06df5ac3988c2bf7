package org.toqa.link.http;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.toqa.link.http.HttpRobotException.Reason;
import org.toqa.link.http.WheelReport.RobotError;
import org.toqa.text.CleanText;
import tools.jackson.core.JacksonException;
import tools.jackson.core.StreamReadConstraints;
import tools.jackson.core.StreamReadFeature;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * The messages as JSON in UTF-8. What is read is complete, finite and within its limits, or refused
 * with a sentence that names the field; fields that are not known are ignored.
 */
public final class HttpRobotCodec {
  /** Of a message, either way. */
  public static final int MOST_BYTES = 16_384;

  /** 2^53: up to here every whole number is exact in any language's JSON. */
  private static final long LARGEST_NUMBER = 1L << 53;

  /** Of a robot: as many numbers are left for the orders to come. */
  private static final long LARGEST_SEQ = 1L << 52;

  /** Of range sensors; a robot that does not say where its own look has three. */
  private static final int MOST_RANGES = 16;

  private static final double FARTHEST_RANGE = 100;
  private static final String RANGES = "up to " + MOST_RANGES + " numbers from 0 to 100";
  private static final String ANGLES =
      "1 to " + MOST_RANGES + " rising numbers from -3.1416 to 3.1416";
  private static final double LARGEST_ANGLE = 3.1416;
  private static final int MOST_ERRORS = 16;
  private static final int MOST_AMPLITUDE = 255;
  private static final double LONGEST_PULSE = 33;
  private static final double FASTEST_WHEEL = 5;

  /** Metres; a robot is taken to within a millimetre of where it shall stand. */
  private static final double COARSEST_COUNT = 0.0002;

  private static final double DECIMALS = 1e6;
  private static final Pattern CODE = Pattern.compile("[A-Z][A-Z0-9_]{0,31}");

  private static final JsonMapper MAPPER =
      JsonMapper.builder(
              JsonFactory.builder()
                  .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
                  .streamReadConstraints(
                      StreamReadConstraints.builder()
                          .maxNestingDepth(8)
                          .maxNumberLength(64)
                          .build())
                  .build())
          .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
          .build();

  private HttpRobotCodec() {}

  public static byte[] encode(WheelOrder order) {
    ObjectNode json = MAPPER.createObjectNode().put("seq", order.seq());
    if (order.after() != null) {
      json.put("after", order.after());
    }
    json.set("left", wheel(order.left()));
    json.set("right", wheel(order.right()));
    return bytes(json);
  }

  private static ObjectNode wheel(WheelOrder.Wheel wheel) {
    return MAPPER
        .createObjectNode()
        .put("speed", rounded(wheel.speed()))
        .put("amplitude", wheel.amplitude())
        .put("pulse", rounded(wheel.pulse()))
        .put("forward", wheel.forward());
  }

  public static byte[] encode(WheelReport report) {
    ObjectNode json =
        MAPPER
            .createObjectNode()
            .put("seq", report.seq())
            .put("boot", report.boot())
            .put("stamp", report.stamp())
            .put("left", report.left())
            .put("right", report.right());
    if (report.battery() != null) {
      json.put("battery", rounded(report.battery()));
    }
    if (report.ranges() != null) {
      ArrayNode ranges = json.putArray("ranges");
      report.ranges().forEach(range -> ranges.add(rounded(range)));
    }
    if (!report.errors().isEmpty()) {
      ArrayNode errors = json.putArray("errors");
      report.errors().forEach(e -> errors.addObject().put("code", e.code()).put("text", e.text()));
    }
    return bytes(json);
  }

  public static byte[] encode(RobotDescription robot) {
    ObjectNode json =
        MAPPER
            .createObjectNode()
            .put("version", RobotDescription.VERSION)
            .put("track", robot.track())
            .put("wheelRadius", robot.wheelRadius())
            .put("countsPerTurn", robot.countsPerTurn())
            .put("maxSpeed", robot.maxSpeed())
            .put("maxLoad", robot.maxLoad())
            .put("footprint", robot.footprint())
            .put("rangeSensors", robot.hasRangeSensors())
            .put("boot", robot.boot())
            .put("seq", robot.seq());
    if (!robot.rangeAngles().isEmpty()) {
      ArrayNode angles = json.putArray("rangeAngles");
      robot.rangeAngles().forEach(angle -> angles.add(rounded(angle)));
    }
    RobotDescription.Sonar sonar = robot.sonar();
    if (sonar != null) {
      json.putObject("sonar")
          .put("farthest", rounded(sonar.farthest()))
          .put("deviation", rounded(sonar.deviation()));
    }
    return bytes(json);
  }

  private static double rounded(double number) {
    return Math.round(number * DECIMALS) / DECIMALS;
  }

  private static byte[] bytes(JsonNode json) {
    return MAPPER.writeValueAsBytes(json);
  }

  /**
   * @throws HttpRobotException {@link Reason#NONSENSE}, with the field and what it must be
   */
  public static WheelOrder decodeOrder(byte[] body) throws HttpRobotException {
    JsonNode json = read(body);
    return new WheelOrder(
        whole(json, "seq", 1, LARGEST_NUMBER),
        isSent(json, "after") ? whole(json, "after", -LARGEST_NUMBER, LARGEST_NUMBER) : null,
        wheel(json, "left"),
        wheel(json, "right"));
  }

  private static WheelOrder.Wheel wheel(JsonNode json, String name) throws HttpRobotException {
    JsonNode wheel = json.path(name);
    if (!wheel.isObject()) {
      throw nonsense(name, "an object");
    }
    return new WheelOrder.Wheel(
        number(wheel, "speed", -FASTEST_WHEEL, FASTEST_WHEEL),
        (int) whole(wheel, "amplitude", 0, MOST_AMPLITUDE),
        number(wheel, "pulse", 0, LONGEST_PULSE),
        flag(wheel, "forward"));
  }

  /**
   * @throws HttpRobotException {@link Reason#NONSENSE}, with the field and what it must be
   */
  public static WheelReport decodeReport(byte[] body) throws HttpRobotException {
    JsonNode json = read(body);
    return new WheelReport(
        whole(json, "seq", 0, LARGEST_SEQ),
        whole(json, "boot", 1, LARGEST_NUMBER),
        whole(json, "stamp", -LARGEST_NUMBER, LARGEST_NUMBER),
        whole(json, "left", -LARGEST_NUMBER, LARGEST_NUMBER),
        whole(json, "right", -LARGEST_NUMBER, LARGEST_NUMBER),
        isSent(json, "battery") ? number(json, "battery", 0, 1) : null,
        ranges(json),
        errors(json));
  }

  private static @Nullable List<Double> ranges(JsonNode json) throws HttpRobotException {
    if (!isSent(json, "ranges")) {
      return null;
    }
    JsonNode list = json.path("ranges");
    List<Double> ranges = new ArrayList<>();
    for (JsonNode range : list) {
      if (!range.isNumber() || !(range.asDouble() >= 0 && range.asDouble() <= FARTHEST_RANGE)) {
        throw nonsense("ranges", RANGES);
      }
      ranges.add(range.asDouble());
    }
    if (!list.isArray() || ranges.size() > MOST_RANGES) {
      throw nonsense("ranges", RANGES);
    }
    return ranges.isEmpty() ? null : ranges;
  }

  private static List<RobotError> errors(JsonNode json) throws HttpRobotException {
    if (!isSent(json, "errors")) {
      return List.of();
    }
    JsonNode list = json.path("errors");
    List<RobotError> errors = new ArrayList<>();
    for (JsonNode error : list) {
      JsonNode code = error.path("code");
      JsonNode text = error.path("text");
      if (!code.isString() || !CODE.matcher(code.asString()).matches() || !text.isString()) {
        throw nonsense("errors", "a list of objects with a code like STALL and a text");
      }
      errors.add(new RobotError(code.asString(), CleanText.of(text.asString())));
    }
    if (!list.isArray() || errors.size() > MOST_ERRORS) {
      throw nonsense("errors", "a list of " + MOST_ERRORS + " objects at most");
    }
    return errors;
  }

  /**
   * @throws HttpRobotException {@link Reason#NONSENSE}, with the field and what it must be
   */
  public static RobotDescription decodeDescription(byte[] body) throws HttpRobotException {
    JsonNode json = read(body);
    var _ = whole(json, "version", RobotDescription.VERSION, RobotDescription.VERSION);
    RobotDescription robot = description(json);
    if (robot.metresPerCount() > COARSEST_COUNT) {
      throw nonsense("countsPerTurn", "so many that a count is 0.2 mm at most");
    }
    return robot;
  }

  private static RobotDescription description(JsonNode json) throws HttpRobotException {
    return new RobotDescription(
        number(json, "track", 0.02, 5),
        number(json, "wheelRadius", 0.005, 1),
        (int) whole(json, "countsPerTurn", 1, 10_000_000),
        number(json, "maxSpeed", 0.01, FASTEST_WHEEL),
        number(json, "maxLoad", 0, 10_000),
        number(json, "footprint", 0.05, 5),
        isSent(json, "rangeSensors") && flag(json, "rangeSensors"),
        isSent(json, "rangeAngles") ? rangeAngles(json.path("rangeAngles")) : List.of(),
        isSent(json, "sonar") ? sonar(json.path("sonar")) : null,
        whole(json, "boot", 1, LARGEST_NUMBER),
        whole(json, "seq", 0, LARGEST_SEQ));
  }

  private static List<Double> rangeAngles(JsonNode list) throws HttpRobotException {
    List<Double> angles = new ArrayList<>();
    double last = -LARGEST_ANGLE;
    for (JsonNode angle : list) {
      if (!angle.isNumber() || !(angle.asDouble() >= last && angle.asDouble() <= LARGEST_ANGLE)) {
        throw nonsense("rangeAngles", ANGLES);
      }
      last = angle.asDouble();
      angles.add(last);
    }
    if (!list.isArray() || angles.isEmpty() || angles.size() > MOST_RANGES) {
      throw nonsense("rangeAngles", ANGLES);
    }
    return angles;
  }

  private static RobotDescription.Sonar sonar(JsonNode sonar) throws HttpRobotException {
    if (!sonar.isObject()) {
      throw nonsense("sonar", "an object");
    }
    return new RobotDescription.Sonar(
        number(sonar, "farthest", 0.1, 30), number(sonar, "deviation", 0.001, 0.5));
  }

  private static JsonNode read(byte[] body) throws HttpRobotException {
    if (body.length > MOST_BYTES) {
      throw new HttpRobotException(Reason.NONSENSE, "it is longer than " + MOST_BYTES + " bytes");
    }
    try {
      JsonNode json = MAPPER.readTree(body);
      if (json != null && json.isObject()) {
        return json;
      }
      throw new HttpRobotException(Reason.NONSENSE, "it is not a JSON object");
    } catch (JacksonException e) {
      throw new HttpRobotException(Reason.NONSENSE, "it is not JSON", e);
    }
  }

  private static boolean isSent(JsonNode json, String name) {
    return json.hasNonNull(name);
  }

  private static long whole(JsonNode json, String name, long least, long most)
      throws HttpRobotException {
    JsonNode value = json.path(name);
    if (!value.isIntegralNumber() || !value.canConvertToLong()) {
      throw nonsense(name, wholeNumber(least, most));
    }
    long number = value.asLong();
    if (number < least || number > most) {
      throw nonsense(name, wholeNumber(least, most));
    }
    return number;
  }

  private static String wholeNumber(long least, long most) {
    return least == most ? "the number " + least : "a whole number from " + least + " to " + most;
  }

  private static double number(JsonNode json, String name, double least, double most)
      throws HttpRobotException {
    JsonNode value = json.path(name);
    if (!value.isNumber() || !(value.asDouble() >= least && value.asDouble() <= most)) {
      throw nonsense(name, "a number from " + least + " to " + most);
    }
    return value.asDouble();
  }

  private static boolean flag(JsonNode json, String name) throws HttpRobotException {
    JsonNode value = json.path(name);
    if (!value.isBoolean()) {
      throw nonsense(name, "true or false");
    }
    return value.asBoolean();
  }

  private static HttpRobotException nonsense(String field, String allowed) {
    return new HttpRobotException(Reason.NONSENSE, field + " must be " + allowed);
  }
}
