package org.toqa.web.page;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskTemplate;
import org.toqa.fleet.TaskTemplate.Parameter;
import org.toqa.grid.FloorMap;
import org.toqa.grid.Place;
import org.toqa.mission.Stop;
import org.toqa.mission.TaskKind;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.OpenFields;
import org.toqa.web.input.TemplateAccess;
import org.toqa.web.input.TemplateFiller;
import org.toqa.web.input.Version;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * A template of tasks as pages show it.
 *
 * @param places its way
 * @param gone stations of its order that its floor has not any more
 */
public record TemplateView(
    TaskTemplate template,
    Version version,
    boolean mayChange,
    boolean isDrive,
    List<PlaceView> places,
    List<String> gone) {

  /**
   * @param parameter whether that is what is asked for, and no place yet
   */
  public record PlaceView(String text, boolean parameter) {}

  /**
   * @param floors those that there are
   */
  static TemplateView of(TaskTemplate template, Caller caller, List<FloorMap> floors, Texts texts) {
    ObjectNode order = TemplateFiller.order(template);
    List<String> stations =
        floors.stream()
            .filter(floor -> floor.name().equals(template.floor()))
            .flatMap(floor -> floor.stations().stream())
            .map(Place::name)
            .toList();
    List<PlaceView> places = new ArrayList<>();
    List<String> gone = new ArrayList<>();
    for (String field : fields(order)) {
      JsonNode value = OpenFields.value(order, field);
      String station = value == null ? "" : value.path("station").asString("");
      if (!station.isEmpty() && !stations.contains(station)) {
        gone.add(station);
      }
      places.add(place(template, order, field, texts));
    }
    return new TemplateView(
        template,
        Version.of(template),
        TemplateAccess.canChange(caller, template),
        TaskKind.DRIVE.name().equals(order.path("kind").asString("")),
        places,
        gone);
  }

  private static List<String> fields(ObjectNode order) {
    if (order.path("stops").isArray()) {
      List<String> stops = new ArrayList<>();
      for (int i = 0; i < order.path("stops").size(); i++) {
        stops.add("stops." + i);
      }
      return stops;
    }
    return TaskKind.DRIVE.name().equals(order.path("kind").asString(""))
        ? List.of("goal")
        : List.of("start", "goal");
  }

  private static PlaceView place(
      TaskTemplate template, ObjectNode order, String field, Texts texts) {
    Optional<Parameter> open =
        template.parameters().stream().filter(one -> one.field().equals(field)).findFirst();
    if (open.isPresent()) {
      return new PlaceView(open.get().name(), true);
    }
    JsonNode charge = field.startsWith("stops.") ? charge(order, field) : null;
    if (charge != null) {
      String charger = charge.path("charger").asString("");
      return new PlaceView(
          texts.text(new Stop.Charge(charger.isEmpty() ? null : charger, null).sentence()), false);
    }
    return new PlaceView(text(OpenFields.value(order, field)), false);
  }

  private static @Nullable JsonNode charge(ObjectNode order, String field) {
    return OpenFields.value(order, field + ".charge");
  }

  /** A value as a line of text. */
  static String text(@Nullable JsonNode value) {
    if (value == null) {
      return "";
    }
    if (value.has("station")) {
      return value.path("station").asString("");
    }
    if (value.has("x")) {
      return "(" + number(value.path("x")) + ", " + number(value.path("y")) + ")";
    }
    if (value.isArray()) {
      List<String> names = new ArrayList<>();
      value.values().forEach(name -> names.add(name.asString("")));
      return String.join(", ", names);
    }
    return value.isNumber() ? number(value) : value.asString("");
  }

  static String number(JsonNode value) {
    return BigDecimal.valueOf(value.asDouble(0)).stripTrailingZeros().toPlainString();
  }
}
