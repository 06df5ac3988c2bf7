package org.toqa.web.input;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.toqa.fleet.FloorListener;
import org.toqa.fleet.MapProblem;
import org.toqa.fleet.TaskTemplate;
import org.toqa.fleet.TaskTemplateStore;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.Place;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * The templates of tasks that floors have: a floor is not removed before them, and a map without
 * what they name is told, since a parameter may name something else.
 */
public final class TemplatesOfFloors implements FloorListener.Objector {
  private static final JsonMapper MAPPER = JsonMapper.builder().build();

  private final TaskTemplateStore store;

  public TemplatesOfFloors(TaskTemplateStore store) {
    this.store = store;
  }

  private List<TaskTemplate> templates(String floor) {
    return store.templates().stream().filter(one -> one.floor().equals(floor)).toList();
  }

  @Override
  public Optional<Sentence> objectionToRemoval(String floor) {
    return Optional.of(templates(floor).size())
        .filter(count -> count > 0)
        .map(count -> Phrase.FLOOR_HAS_TEMPLATES.with(floor, count));
  }

  @Override
  public List<MapProblem> mapProblems(String floor, FloorDrawing drawing) {
    return templates(floor).stream()
        .flatMap(
            template -> {
              JsonNode order = MAPPER.readTree(template.order());
              return Stream.concat(
                  gone(order, "station", drawing.stations())
                      .map(name -> Phrase.TEMPLATE_STATION_GONE.with(template.name(), name)),
                  gone(order, "charger", drawing.charging())
                      .map(name -> Phrase.TEMPLATE_CHARGER_GONE.with(template.name(), name)));
            })
        .map(text -> new MapProblem(false, text, null))
        .toList();
  }

  /** Names that stand in a field, wherever it is, and that no place has. */
  private static Stream<String> gone(JsonNode order, String field, List<Place> places) {
    return order.findValues(field).stream()
        .filter(JsonNode::isString)
        .map(JsonNode::asString)
        .distinct()
        .filter(name -> places.stream().noneMatch(place -> place.name().equals(name)));
  }
}
