package org.toqa.web.input;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;

/** Of what kind a parameter of a template is, which follows from the field that it fills. */
public enum ParameterKind {
  /** A station or coordinates. */
  PLACE {
    @Override
    @Nullable JsonNode value(Fields fields, String name) {
      return fields.hasPlace(name) ? TaskOrderJson.place(fields.place(name)) : null;
    }

    @Override
    JsonNode example() {
      return NODES.objectNode().put("x", 1).put("y", 1);
    }
  },
  NUMBER {
    @Override
    @Nullable JsonNode value(Fields fields, String name) {
      Double number = fields.number(name);
      return number == null ? null : NODES.numberNode(number);
    }

    @Override
    JsonNode example() {
      return NODES.numberNode(1);
    }
  },
  TEXT {
    @Override
    @Nullable JsonNode value(Fields fields, String name) {
      String text = fields.text(name);
      return text == null ? null : NODES.stringNode(text);
    }

    @Override
    JsonNode example() {
      return NODES.stringNode("x");
    }
  },
  /** A date and a time of day. */
  MOMENT {
    @Override
    @Nullable JsonNode value(Fields fields, String name) {
      Instant moment = fields.moment(name, "error.deadline");
      return moment == null ? null : NODES.stringNode(moment.toString());
    }

    @Override
    JsonNode example() {
      return NODES.stringNode("2100-01-01T00:00:00Z");
    }
  },
  /** Names of robots. */
  ROBOTS {
    @Override
    @Nullable JsonNode value(Fields fields, String name) {
      List<String> robots = fields.choices(name);
      ArrayNode list = NODES.arrayNode();
      robots.forEach(list::add);
      return robots.isEmpty() ? null : list;
    }

    @Override
    JsonNode example() {
      return NODES.arrayNode().add("r1");
    }
  };

  private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

  private static final Pattern STOP = Pattern.compile("stops\\.1?\\d");
  private static final Pattern NUMBER_OF_STOP =
      Pattern.compile("stops\\.1?\\d\\.(waitSeconds|charge\\.until)");
  private static final Pattern TEXT_OF_STOP = Pattern.compile("stops\\.1?\\d\\.charge\\.charger");
  private static final Set<String> NUMBERS =
      Set.of("load", "priority", "size.length", "size.width");

  /**
   * @param field of an order, named from the top
   * @return empty: no parameter can fill it
   */
  public static Optional<ParameterKind> of(String field) {
    if (field.equals("start") || field.equals("goal") || STOP.matcher(field).matches()) {
      return Optional.of(PLACE);
    }
    if (NUMBERS.contains(field) || NUMBER_OF_STOP.matcher(field).matches()) {
      return Optional.of(NUMBER);
    }
    if (field.equals("name") || TEXT_OF_STOP.matcher(field).matches()) {
      return Optional.of(TEXT);
    }
    return switch (field) {
      case "deadline" -> Optional.of(MOMENT);
      case "onlyRobots" -> Optional.of(ROBOTS);
      default -> Optional.empty();
    };
  }

  /**
   * What was entered into the field of that name, as JSON has it; a sentence is filed where that is
   * of another kind.
   *
   * @return null: nothing was
   */
  abstract @Nullable JsonNode value(Fields fields, String name);

  /** A value that every field of this kind takes. */
  abstract JsonNode example();
}
