package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.io.InputStream;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Place;
import org.toqa.web.Services;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ObjectNode;

/** The API's own description, whose examples are of this server: they can be sent as they stand. */
public final class OpenApiResource extends ApiHandler {
  private static final String EXAMPLE = "example";

  /** Of the shipped map, as the examples name them. */
  private static final String FLOOR = "lab";

  private static final String START = "Goods-in 1";
  private static final String GOAL = "Mill";

  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    response.setContentType("application/json");
    try (InputStream document =
        Objects.requireNonNull(OpenApiResource.class.getResourceAsStream("openapi.json"))) {
      JsonNode described = Json.MAPPER.readTree(document);
      List<FloorMap> floors = Services.of(request).fleet().floors();
      if (!floors.isEmpty() && floors.getFirst().stations().size() > 1) {
        useFloor(described, floors.getFirst());
      }
      Json.MAPPER.writeValue(response.getOutputStream(), described);
    }
  }

  private static void useFloor(JsonNode described, FloorMap floor) {
    Place start = floor.stations().getFirst();
    Map<String, String> names =
        Map.of(FLOOR, floor.name(), START, start.name(), GOAL, floor.stations().get(1).name());
    for (JsonNode parent : described.get("paths").findParents(EXAMPLE)) {
      if (parent.get(EXAMPLE).isString()) {
        String table = parent.get(EXAMPLE).stringValue();
        ((ObjectNode) parent)
            .put(EXAMPLE, table.replace(START, start.name()).replace(GOAL, names.get(GOAL)));
      } else {
        useNames(parent.get(EXAMPLE), names, start);
      }
    }
  }

  private static void useNames(JsonNode example, Map<String, String> names, Place start) {
    if (example instanceof ObjectNode object) {
      object.properties().stream()
          .filter(field -> field.getValue().isString())
          .filter(field -> names.containsKey(field.getValue().stringValue()))
          .toList()
          .forEach(field -> object.put(field.getKey(), names.get(field.getValue().stringValue())));
      if (object.has("theta")) {
        object.put("x", start.position().x()).put("y", start.position().y());
      }
    }
    example.forEach(part -> useNames(part, names, start));
  }
}
