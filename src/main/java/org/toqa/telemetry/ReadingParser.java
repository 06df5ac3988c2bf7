package org.toqa.telemetry;

import java.time.Instant;
import java.util.List;
import java.util.stream.StreamSupport;
import org.toqa.text.CleanText;
import tools.jackson.core.JacksonException;
import tools.jackson.core.StreamReadFeature;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Reads the body of a message, and believes only what a sensor can have measured. */
final class ReadingParser {
  static final int MAX_BYTES = 4096;
  static final int MAX_RANGES = 64;

  /** Metres; no range sensor of a robot sees farther. */
  static final double FARTHEST = 30;

  /** Of whatever is measured, in whatever unit. */
  private static final double LARGEST = 1e12;

  private static final int LONGEST_UNIT = 16;

  private static final JsonMapper JSON =
      JsonMapper.builder()
          .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
          .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
          .build();

  /** What a body is. */
  sealed interface Result {
    record Read(Reading reading) implements Result {}

    record Refused(Refusal why) implements Result {}
  }

  private ReadingParser() {}

  /**
   * @param name of the reading
   * @param now when it was heard
   */
  static Result parse(String name, byte[] body, Instant now) {
    if (body.length > MAX_BYTES) {
      return new Result.Refused(Refusal.TOO_LARGE);
    }
    JsonNode tree;
    try {
      tree = JSON.readTree(body);
    } catch (JacksonException e) {
      return new Result.Refused(Refusal.UNREADABLE);
    }
    if (!tree.isObject()) {
      return new Result.Refused(Refusal.UNREADABLE);
    }
    JsonNode stamp = tree.path("stamp");
    if (!stamp.isIntegralNumber() || !stamp.canConvertToLong() || stamp.longValue() < 0) {
      return new Result.Refused(Refusal.WRONG_FIELD);
    }
    return name.equals(Reading.RANGE)
        ? ranges(tree, stamp.longValue(), now)
        : value(name, tree, stamp.longValue(), now);
  }

  private static Result ranges(JsonNode tree, long stamp, Instant now) {
    JsonNode metres = tree.path("metres");
    JsonNode radians = tree.path("angles");
    if (!areNumbers(metres)
        || metres.isEmpty()
        || metres.size() > MAX_RANGES
        || !(radians.isMissingNode() || (areNumbers(radians) && radians.size() == metres.size()))) {
      return new Result.Refused(Refusal.WRONG_FIELD);
    }
    List<Double> ranges = numbers(metres);
    List<Double> angles = numbers(radians);
    if (!areWithin(ranges, 0, FARTHEST) || !areWithin(angles, -Math.TAU, Math.TAU)) {
      return new Result.Refused(Refusal.OUT_OF_BOUNDS);
    }
    return new Result.Read(new Reading(Reading.RANGE, stamp, now, ranges, "m", angles));
  }

  private static boolean areNumbers(JsonNode list) {
    return list.isArray()
        && StreamSupport.stream(list.spliterator(), false).allMatch(JsonNode::isNumber);
  }

  private static List<Double> numbers(JsonNode list) {
    return StreamSupport.stream(list.spliterator(), false).map(JsonNode::doubleValue).toList();
  }

  private static boolean areWithin(List<Double> numbers, double min, double max) {
    return numbers.stream().allMatch(number -> number >= min && number <= max); // not so for NaN
  }

  private static Result value(String name, JsonNode tree, long stamp, Instant now) {
    JsonNode value = tree.path("value");
    JsonNode unit = tree.path("unit");
    if (!value.isNumber() || !(unit.isMissingNode() || unit.isString())) {
      return new Result.Refused(Refusal.WRONG_FIELD);
    }
    if (!(Math.abs(value.doubleValue()) <= LARGEST)) { // so for NaN too
      return new Result.Refused(Refusal.OUT_OF_BOUNDS);
    }
    return new Result.Read(
        new Reading(
            name,
            stamp,
            now,
            List.of(value.doubleValue()),
            CleanText.of(unit.stringValue(""), LONGEST_UNIT).strip(),
            List.of()));
  }
}
