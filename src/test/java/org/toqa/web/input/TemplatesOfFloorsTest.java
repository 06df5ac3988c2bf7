package org.toqa.web.input;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.lang.reflect.Proxy;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.FloorListener;
import org.toqa.fleet.MapProblem;
import org.toqa.fleet.TaskTemplate;
import org.toqa.fleet.TaskTemplateStore;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;

class TemplatesOfFloorsTest {
  private static final FloorDrawing DRAWING =
      new FloorDrawing(
          OccupancyGrid.parse("...."),
          List.of(new Place("Mill", new Vec2(0.5, 0.5))),
          List.of(),
          List.of(new Place("C1", new Vec2(3.5, 0.5))),
          List.of(),
          List.of(),
          List.of());

  @Test
  void whatAMapTakesAwayFromTemplatesIsNamed() {
    FloorListener templates =
        of(
            template(
                "Tea",
                "hall",
                "{\"load\":1,\"start\":{\"station\":\"Mill\"},\"goal\":{\"station\":\"Store\"}}"),
            template(
                "Round",
                "hall",
                "{\"stops\":[{\"station\":\"Mill\"},{\"charge\":{\"charger\":\"C1\"}},"
                    + "{\"charge\":{\"charger\":\"C2\"}},{\"x\":1,\"y\":1}]}"),
            template("Other", "cellar", "{\"start\":{\"station\":\"Shelf\"}}"));

    List<MapProblem> problems = templates.mapProblems("hall", DRAWING);

    assertEquals(
        List.of(
            "The template Tea names the station Store, which this map does not have. Tasks by it"
                + " are refused until it names another one.",
            "The template Round charges at C2, which this map does not have. Tasks by it are"
                + " refused until it names another charger."),
        problems.stream().map(problem -> problem.text().english()).toList());
    assertEquals(0, problems.stream().filter(MapProblem::isBlocking).count());
  }

  @Test
  void aFloorThatHasOneIsNotRemoved() {
    FloorListener templates = of(template("Tea", "hall", "{}"));

    assertEquals(
        "Templates of tasks belong to the floor hall (1). Delete them first.",
        templates.objectionToRemoval("hall").orElseThrow().english());
    assertEquals(Optional.empty(), templates.objectionToRemoval("cellar"));
  }

  private static FloorListener of(TaskTemplate... templates) {
    return new TemplatesOfFloors(
        (TaskTemplateStore)
            Proxy.newProxyInstance(
                TaskTemplateStore.class.getClassLoader(),
                new Class<?>[] {TaskTemplateStore.class},
                (_, _, _) -> List.of(templates)));
  }

  private static TaskTemplate template(String name, String floor, String order) {
    return new TaskTemplate(1, name, floor, order, List.of(), true, "Max", null, Instant.EPOCH);
  }
}
