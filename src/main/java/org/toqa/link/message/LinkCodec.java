package org.toqa.link.message;

import com.fasterxml.jackson.annotation.JsonSetter;
import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.Nulls;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.toqa.motion.DriveKind;
import org.toqa.motion.FreeZone;
import org.toqa.text.CleanText;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.StreamReadConstraints;
import tools.jackson.core.StreamReadFeature;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.databind.DeserializationContext;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.MapperFeature;
import tools.jackson.databind.cfg.EnumFeature;
import tools.jackson.databind.deser.std.StdScalarDeserializer;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.module.SimpleModule;
import tools.jackson.databind.node.ObjectNode;

/**
 * Messages of the robot link as lines: one JSON object, UTF-8, ended by a line feed, at most {@link
 * #MAX_LINE_BYTES} long. Reading never throws: whatever a peer sends becomes a message that is
 * complete, well typed, finite in every number and clean in every text ({@link CleanText}), or a
 * sentence about what is wrong with it. Fields that are not known are ignored; a field of the
 * record that is not sent is an error.
 */
public final class LinkCodec {

  /** Of a line with its line feed. */
  public static final int MAX_LINE_BYTES = 65_536;

  /** So many segments fit into one line, whatever their numbers; the rest follows by extend. */
  public static final int SEGMENTS_A_LINE = 500;

  /** 2^53: up to here every whole number is exact in any language's JSON. */
  private static final double LARGEST_NUMBER = 0x1p53;

  /** Radians a second; what a daemon that does not tell it refuses, if its file says nothing. */
  private static final double MAX_TURN_RATE_NOT_SENT = 3.5;

  /** Metres; what a daemon that does not tell it sees: {@code avoidance.RangeSensors}. */
  private static final double SENSOR_RANGE_NOT_SENT = 0.8;

  private static final int LONGEST_ECHO = 40;

  private static final JsonMapper MAPPER =
      JsonMapper.builder(
              JsonFactory.builder()
                  .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
                  .streamReadConstraints(
                      StreamReadConstraints.builder()
                          .maxNestingDepth(16)
                          .maxNumberLength(64)
                          .build())
                  .build())
          .disable(DeserializationFeature.FAIL_ON_UNKNOWN_PROPERTIES)
          .enable(DeserializationFeature.FAIL_ON_MISSING_CREATOR_PROPERTIES)
          .enable(DeserializationFeature.FAIL_ON_NULL_FOR_PRIMITIVES)
          .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS)
          .disable(DeserializationFeature.ACCEPT_FLOAT_AS_INT)
          .disable(MapperFeature.ALLOW_COERCION_OF_SCALARS)
          .enable(EnumFeature.FAIL_ON_NUMBERS_FOR_ENUMS)
          .changeDefaultNullHandling(
              nulls -> nulls.withValueNulls(Nulls.FAIL).withContentNulls(Nulls.FAIL))
          .withConfigOverride(
              FreeZone.class,
              zone -> zone.setNullHandling(JsonSetter.Value.forValueNulls(Nulls.SET)))
          .addModule(
              new SimpleModule()
                  .addDeserializer(double.class, new PlainNumber())
                  .addDeserializer(Double.class, new PlainNumber())
                  .addDeserializer(String.class, new PlainText()))
          .build();

  /**
   * Takes at once what is complete, sane and known in every field, and nothing else: as nearly all
   * lines are.
   */
  private static final JsonMapper STRICT_MAPPER =
      MAPPER
          .rebuild()
          .enable(DeserializationFeature.FAIL_ON_UNKNOWN_PROPERTIES)
          .addModule(
              new SimpleModule("sane numbers")
                  .addDeserializer(double.class, new SaneNumber())
                  .addDeserializer(Double.class, new SaneNumber())
                  .addDeserializer(long.class, new SaneWholeNumber())
                  .addDeserializer(Long.class, new SaneWholeNumber()))
          .build();

  private LinkCodec() {}

  /**
   * The message as a line with its line feed.
   *
   * @return bytes of UTF-8, at most {@link #MAX_LINE_BYTES}
   * @throws IllegalArgumentException if it would be longer than a line may be
   */
  public static byte[] encode(ServerMessage message) {
    return encode((Object) message);
  }

  /**
   * The message as a line with its line feed.
   *
   * @return bytes of UTF-8, at most {@link #MAX_LINE_BYTES}
   * @throws IllegalArgumentException if it would be longer than a line may be
   */
  public static byte[] encode(AgentMessage message) {
    return encode((Object) message);
  }

  /**
   * The message as a line with its line feed.
   *
   * @return bytes of UTF-8, at most {@link #MAX_LINE_BYTES}
   * @throws IllegalArgumentException if it would be longer than a line may be
   */
  public static byte[] encode(PairingMessage message) {
    return encode((Object) message);
  }

  /**
   * The message as a line with its line feed.
   *
   * @return bytes of UTF-8, at most {@link #MAX_LINE_BYTES}
   */
  public static byte[] encode(GatewayMessage message) {
    return encode((Object) message);
  }

  /** The message, or the refusal that says what is wrong with the line; never throws. */
  public static DecodeResult<ServerMessage> decodeServerMessage(LineReader.Line line) {
    return decode(line, ServerMessage.class);
  }

  /** As {@link #decodeServerMessage}. */
  public static DecodeResult<AgentMessage> decodeAgentMessage(LineReader.Line line) {
    return decode(line, AgentMessage.class);
  }

  /** As {@link #decodeServerMessage}. */
  public static DecodeResult<PairingMessage> decodePairingMessage(LineReader.Line line) {
    return decode(line, PairingMessage.class);
  }

  /** As {@link #decodeServerMessage}. */
  public static DecodeResult<GatewayMessage> decodeGatewayMessage(LineReader.Line line) {
    return decode(line, GatewayMessage.class);
  }

  private static String tooLong(long bytes) {
    return "The line has "
        + bytes
        + " bytes; a line has at most "
        + MAX_LINE_BYTES
        + ". Send a longer path by extend.";
  }

  private static byte[] encode(Object message) {
    byte[] json = MAPPER.writeValueAsBytes(message);
    if (json.length >= MAX_LINE_BYTES) {
      throw new IllegalArgumentException(tooLong(json.length + 1L));
    }
    byte[] line = Arrays.copyOf(json, json.length + 1);
    line[json.length] = '\n';
    return line;
  }

  private static <M> DecodeResult<M> decode(LineReader.Line line, Class<M> messages) {
    return switch (line) {
      case LineReader.Text(byte[] utf8) -> decode(utf8, messages);
      case LineReader.TooLong(long bytes) -> new DecodeResult.Invalid<>(0, tooLong(bytes));
    };
  }

  private static <M> DecodeResult<M> decode(byte[] line, Class<M> messages) {
    if (line.length > 0 && line[0] == '{') { // the library would take a list for an object
      try {
        return new DecodeResult.Decoded<>(STRICT_MAPPER.readValue(line, messages));
      } catch (JacksonException e) {
        return decodeAsTree(line, messages);
      }
    }
    return decodeAsTree(line, messages);
  }

  /** Says what is wrong, and takes what a peer of another release sends. */
  static <M> DecodeResult<M> decodeAsTree(byte[] line, Class<M> messages) {
    JsonNode tree;
    try {
      tree = MAPPER.readTree(line);
    } catch (JacksonException e) {
      return new DecodeResult.Invalid<>(0, "The line is not one JSON object in UTF-8.");
    }
    if (!tree.isObject()) {
      return new DecodeResult.Invalid<>(0, "The line is not one JSON object in UTF-8.");
    }
    addMissingFields(tree);
    long seq = seqOf(tree);
    String fault = faultOf(tree, messages);
    if (fault != null) {
      return new DecodeResult.Invalid<>(seq, fault);
    }
    try {
      return new DecodeResult.Decoded<>(MAPPER.treeToValue(tree, messages));
    } catch (JacksonException e) {
      return new DecodeResult.Invalid<>(seq, sentence(tree.path("type").stringValue(), e));
    }
  }

  /** What can be said back in an answer; else 0. */
  private static long seqOf(JsonNode message) {
    JsonNode seq = message.path("seq");
    return seq.isIntegralNumber() && isSane(seq) ? seq.asLong(0) : 0;
  }

  /** Fields that a peer of an earlier release does not send. */
  private static void addMissingFields(JsonNode message) {
    switch (message.path("type").asString("")) {
      case "drive" -> {
        addIfMissing(message, "load", 0);
        addShiftIfMissing(message);
      }
      case "extend" -> addShiftIfMissing(message);
      case "pose" -> addIfMissing(message.path("twist"), "u", 0);
      case "room" -> addNullIfMissing(message, "zone");
      case "lead", "follow" -> addNullIfMissing(message, "carries");
      case "pair" -> addNullIfMissing(message, "robot");
      case "hello" -> {
        addIfMissing(message, "maxTurnRate", MAX_TURN_RATE_NOT_SENT);
        addIfMissing(message, "sensorRange", SENSOR_RANGE_NOT_SENT);
        addKindIfMissing(message);
        addNullIfMissing(message, "arm");
        addNullIfMissing(message, "act");
        addNullIfMissing(message, "acted");
        addIfMissing(message, "track", 0);
        addNullIfMissing(message, "room");
        addNullIfMissing(message.path("room"), "zone");
        addIfMissing(message, "freeZones");
        addIfMissing(message, "shifts");
      }
      case "state" -> {
        addIfMissing(message.path("twist"), "u", 0);
        addNullIfMissing(message, "placeError");
        addNullIfMissing(message, "measuredLoad");
        addNullIfMissing(message, "arm");
        addNullIfMissing(message, "camera");
        addNullIfMissing(message, "networkRoute");
        addRoomUseIfMissing(message);
        message.path("errors").valueStream().forEach(error -> addIfMissing(error, "clearable"));
      }
      default -> {}
    }
  }

  private static void addIfMissing(JsonNode node, String field, double value) {
    if (node instanceof ObjectNode object && !object.has(field)) {
      object.put(field, value);
    }
  }

  /** Segments go sideways only where that is said. */
  private static void addShiftIfMissing(JsonNode drive) {
    drive.path("segments").valueStream().forEach(segment -> addIfMissing(segment, "u", 0));
  }

  /** A daemon that does not tell its kind drives on three omni wheels. */
  private static void addKindIfMissing(JsonNode hello) {
    if (hello instanceof ObjectNode object && !object.has("kind")) {
      object.put("kind", DriveKind.OMNI.word());
    }
  }

  /** A daemon that does not tell it asks for no room. */
  private static void addRoomUseIfMissing(JsonNode state) {
    if (state instanceof ObjectNode object && !object.has("room")) {
      object.put("room", AgentMessage.RoomUse.NONE.name());
    }
  }

  private static void addNullIfMissing(JsonNode node, String field) {
    if (node instanceof ObjectNode object && !object.has(field)) {
      object.putNull(field);
    }
  }

  private static void addIfMissing(JsonNode node, String flag) {
    if (node instanceof ObjectNode object && !object.has(flag)) {
      object.put(flag, false);
    }
  }

  private static @Nullable String faultOf(JsonNode tree, Class<?> messages) {
    JsonNode type = tree.path("type");
    if (!type.isString()) {
      return "The message has no type.";
    }
    List<String> known = types(messages);
    if (!known.contains(type.stringValue())) {
      return "The type \"%s\" is not known; known are %s."
          .formatted(shortened(type.stringValue()), String.join(", ", known));
    }
    return hasSaneNumbers(tree)
        ? null
        : "A number of the %s is not finite or absurdly large.".formatted(type.stringValue());
  }

  private static List<String> types(Class<?> messages) {
    return Arrays.stream(messages.getAnnotation(JsonSubTypes.class).value())
        .map(JsonSubTypes.Type::name)
        .toList();
  }

  private static boolean hasSaneNumbers(JsonNode node) {
    return node.isNumber() ? isSane(node) : node.valueStream().allMatch(LinkCodec::hasSaneNumbers);
  }

  private static boolean isSane(JsonNode number) {
    return isSane(number.doubleValue());
  }

  private static boolean isSane(double number) {
    return Math.abs(number) <= LARGEST_NUMBER;
  }

  private static String sentence(String type, JacksonException e) {
    String field =
        e.getPath().stream()
            .map(r -> r.getPropertyName() == null ? "[" + r.getIndex() + "]" : r.getPropertyName())
            .collect(Collectors.joining("."))
            .replace(".[", "[");
    return field.isEmpty()
        ? "The %s lacks a field or has one of the wrong kind.".formatted(type)
        : "The field \"%s\" of the %s is missing or of the wrong kind."
            .formatted(shortened(field), type);
  }

  private static String shortened(String text) {
    return CleanText.of(text, LONGEST_ECHO);
  }

  /** Takes numbers only, where the library would also take the text "NaN". */
  private static final class PlainNumber extends StdScalarDeserializer<Double> {
    PlainNumber() {
      super(double.class);
    }

    @Override
    public Double deserialize(JsonParser parser, DeserializationContext context) {
      return parser.currentToken().isNumeric()
          ? parser.getDoubleValue()
          : (Double) context.handleUnexpectedToken(context.constructType(Double.class), parser);
    }
  }

  /** Takes numbers only that are finite and not absurdly large. */
  private static final class SaneNumber extends StdScalarDeserializer<Double> {
    SaneNumber() {
      super(double.class);
    }

    @Override
    public Double deserialize(JsonParser parser, DeserializationContext context) {
      return parser.currentToken().isNumeric() && isSane(parser.getDoubleValue())
          ? parser.getDoubleValue()
          : (Double) context.handleUnexpectedToken(context.constructType(Double.class), parser);
    }
  }

  /** Takes whole numbers only that any language can tell. */
  private static final class SaneWholeNumber extends StdScalarDeserializer<Long> {
    SaneWholeNumber() {
      super(long.class);
    }

    @Override
    public Long deserialize(JsonParser parser, DeserializationContext context) {
      return parser.currentToken() == JsonToken.VALUE_NUMBER_INT
              && isSane((double) parser.getLongValue())
          ? parser.getLongValue()
          : (Long) context.handleUnexpectedToken(context.constructType(Long.class), parser);
    }
  }

  /** Takes texts only, and makes them fit for logs and pages. */
  private static final class PlainText extends StdScalarDeserializer<String> {
    PlainText() {
      super(String.class);
    }

    @Override
    public String deserialize(JsonParser parser, DeserializationContext context) {
      return parser.currentToken() == JsonToken.VALUE_STRING
          ? CleanText.of(parser.getString())
          : (String) context.handleUnexpectedToken(context.constructType(String.class), parser);
    }
  }
}
