package org.toqa.web.input;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.toqa.mission.TaskKind;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ObjectNode;

/** Which fields of an order a parameter could fill. */
public final class TemplateFields {
  private TemplateFields() {}

  /** Their names from the top, in the order of a form. */
  public static List<String> of(ObjectNode order) {
    List<String> fields = new ArrayList<>(List.of("name"));
    boolean isDrive = TaskKind.DRIVE.name().equals(order.path("kind").asString(""));
    if (!isDrive) {
      fields.add("load");
    }
    JsonNode stops = order.path("stops");
    if (stops.isArray()) {
      for (int i = 0; i < stops.size(); i++) {
        fields.addAll(ofStop(stops.get(i), "stops." + i));
      }
    } else {
      fields.addAll(isDrive ? List.of("goal") : List.of("start", "goal"));
    }
    fields.addAll(List.of("priority", "onlyRobots"));
    if (order.has("size")) {
      fields.addAll(List.of("size.length", "size.width"));
    }
    fields.add("deadline");
    return fields;
  }

  private static List<String> ofStop(JsonNode stop, String at) {
    Stream<String> place =
        stop.has("charge")
            ? Stream.of("charger", "until")
                .filter(stop.get("charge")::has)
                .map(field -> at + ".charge." + field)
            : Stream.of(at);
    Stream<String> wait = stop.has("waitSeconds") ? Stream.of(at + ".waitSeconds") : Stream.empty();
    return Stream.concat(place, wait).toList();
  }
}
