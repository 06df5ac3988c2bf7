package org.toqa.testbed;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.random.RandomGenerator;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * Makes lines of the robot link out of correct ones: left as they are, with fields that were
 * changed, removed or added, with bytes that were, or nothing but noise. The same seed, the same
 * lines.
 */
public final class LineFuzzer {

  private static final JsonMapper MAPPER = new JsonMapper();

  /** What represents it in the tree until it is text, for not all of them are JSON. */
  private static final String PLACEHOLDER = "<here>";

  private static final int LONGEST_NOISE = 300;
  private static final int TOO_LONG = 70_000;

  private static final List<String> VALUES =
      List.of(
          "null",
          "true",
          "0",
          "1",
          "-1",
          "0.5",
          "-0.0",
          "1e-320",
          "1e308",
          "1e999",
          "2147483647",
          "2147483648",
          "-2147483648",
          "9007199254740992",
          "9007199254740993",
          "9223372036854775808",
          "NaN",
          "\"NaN\"",
          "\"Infinity\"",
          "\"\"",
          "\"r1\"",
          "\"\\u0000\"",
          "\"\\ud800\"",
          "\"" + "long ".repeat(200) + "\"",
          "[]",
          "{}",
          "[null]",
          "[[0]]",
          "[".repeat(40) + "]".repeat(40));

  private final RandomGenerator random;

  public LineFuzzer(long seed) {
    random = new Random(seed);
  }

  /**
   * The next line, without its line feed.
   *
   * @param correct lines to make it of, without theirs
   */
  public byte[] next(List<byte[]> correct) {
    byte[] line = pick(correct);
    int dice = random.nextInt(10_000);
    if (dice < 2_500) {
      return line.clone();
    }
    if (dice < 7_000) {
      return withOtherFields(line, pick(correct));
    }
    if (dice < 9_500) {
      return withOtherBytes(line, pick(correct));
    }
    return dice < 9_995 ? noise(random.nextInt(LONGEST_NOISE)) : Arrays.copyOf(line, TOO_LONG);
  }

  /** One of the things, each as likely. */
  public <T> T pick(List<T> things) {
    return things.get(random.nextInt(things.size()));
  }

  private byte[] withOtherFields(byte[] line, byte[] other) {
    JsonNode tree = MAPPER.readTree(line);
    String value = PLACEHOLDER;
    for (int i = random.nextInt(3); i >= 0; i--) {
      List<JsonNode> containers = containers(tree);
      JsonNode container = pick(containers);
      switch (random.nextInt(5)) {
        case 0 -> removeFrom(container);
        case 1 -> putInto(container, pick(containers(MAPPER.readTree(other))).deepCopy());
        case 2 -> putInto(container, MAPPER.getNodeFactory().numberNode(number()));
        default -> {
          value = pick(VALUES);
          putInto(container, MAPPER.getNodeFactory().stringNode(PLACEHOLDER));
        }
      }
    }
    return utf8(MAPPER.writeValueAsString(tree).replace("\"" + PLACEHOLDER + "\"", value));
  }

  /** All objects and arrays that have something in them, the outermost first. */
  private static List<JsonNode> containers(JsonNode tree) {
    List<JsonNode> found = new ArrayList<>();
    if (tree.isObject() || !tree.isEmpty()) {
      found.add(tree);
    }
    tree.valueStream().filter(JsonNode::isContainer).forEach(n -> found.addAll(containers(n)));
    return found;
  }

  private void removeFrom(JsonNode container) {
    if (container instanceof ObjectNode object && !object.isEmpty()) {
      object.remove(pick(List.copyOf(object.propertyNames())));
    } else if (container instanceof ArrayNode array && !array.isEmpty()) {
      array.remove(random.nextInt(array.size()));
    }
  }

  private void putInto(JsonNode container, JsonNode value) {
    if (container instanceof ObjectNode object) {
      boolean isNew = object.isEmpty() || random.nextInt(10) == 0;
      object.set(isNew ? "new" : pick(List.copyOf(object.propertyNames())), value);
    } else if (container instanceof ArrayNode array && !array.isEmpty()) {
      array.set(random.nextInt(array.size()), value);
    }
  }

  /** Near to what is usual, or anything. */
  private double number() {
    return switch (random.nextInt(4)) {
      case 0 -> random.nextInt(-3, 12);
      case 1 -> random.nextGaussian();
      case 2 -> random.nextLong();
      default -> Double.longBitsToDouble(random.nextLong() & ~(1L << 62)); // finite
    };
  }

  private byte[] withOtherBytes(byte[] line, byte[] other) {
    byte[] bytes = line;
    for (int i = random.nextInt(4); i >= 0; i--) {
      int from = random.nextInt(bytes.length + 1);
      int to = Math.min(bytes.length, from + random.nextInt(12));
      bytes =
          switch (random.nextInt(5)) {
            case 0 -> Splice.of(bytes, from, new byte[0], to); // lost
            case 1 -> Splice.of(bytes, from, noise(to - from), to); // changed
            case 2 -> Splice.of(bytes, from, noise(random.nextInt(12)), from); // added
            case 3 -> Splice.of(bytes, to, Arrays.copyOfRange(bytes, from, to), to); // twice
            default -> Splice.of(bytes, from, other, bytes.length); // cut off, and another begun
          };
    }
    return bytes;
  }

  /** Has no line feed in it. */
  private byte[] noise(int length) {
    byte[] bytes = new byte[length];
    random.nextBytes(bytes);
    for (int i = 0; i < length; i++) {
      bytes[i] = bytes[i] == '\n' ? (byte) ' ' : bytes[i];
    }
    return bytes;
  }

  private static byte[] utf8(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }
}
