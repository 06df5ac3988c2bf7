package org.toqa.fleet.manager;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.MapProblem;
import org.toqa.fleet.Orderer;
import org.toqa.fleet.Recurrence;
import org.toqa.fleet.Schedule;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.StopOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Area;
import org.toqa.grid.Direction;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.OneWay;
import org.toqa.grid.Place;
import org.toqa.mission.Stop;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TransportTask;

/** Two halls of cells of 1 m, joined by two corridors that are one cell high. */
class MapCheckTest {
  private static final OccupancyGrid WALLS =
      OccupancyGrid.parse(
          "...........", //
          "...@@@@@...",
          "...........");
  private static final Place WEST = place("West", 1.5, 1.5);
  private static final Place WEST_2 = place("West 2", 1.5, 2.5);
  private static final Place EAST = place("East", 9.5, 1.5);
  private static final OneWay NORTH_EAST = corridor(2, Direction.EAST);
  private static final OneWay SOUTH_EAST = corridor(0, Direction.EAST);
  private static final OneWay SOUTH_WEST = corridor(0, Direction.WEST);

  @Test
  void oneWayCorridorsThatMakeARoundAreNoHindrance() {
    assertEquals(List.of(), blocking(List.of(NORTH_EAST, SOUTH_WEST), null));
  }

  @Test
  void placeThatNobodyCanLeaveIsNamed() {
    assertEquals(
        List.of(
            "One-way areas and directions of approach let nobody drive from East to the other"
                + " places: who comes there stays. Turn one of them, leave a way beside them, or move the place."),
        blocking(List.of(NORTH_EAST, SOUTH_EAST), null));
  }

  @Test
  void placeThatNobodyCanReachIsNamed() {
    assertEquals(
        List.of(
            "One-way areas and directions of approach let nobody drive from the other places to"
                + " East. Turn one of them, leave a way beside them, or move the place."),
        blocking(List.of(corridor(2, Direction.WEST), SOUTH_WEST), null));
  }

  @Test
  void placeThatIsEnteredFromTheBorderOnlyIsNamed() {
    OccupancyGrid corner =
        OccupancyGrid.parse(
            ".....", //
            ".....", ".....");
    Place blind = new Place("Blind", new Vec2(0.5, 0.5), null, Direction.EAST);
    FloorDrawing drawing = drawing(corner, List.of(place("Middle", 2.5, 1.5), blind), List.of());
    assertEquals(
        List.of(
            "One-way areas and directions of approach let nobody drive from the other places to"
                + " Blind. Turn one of them, leave a way beside them, or move the place."),
        blocking(drawing, Map.of()));
  }

  @Test
  void stationThatAnotherFloorHasIsNamed() {
    assertEquals(
        List.of(
            "The floor cellar has a station East already, and names of stations are unique in a"
                + " site. Choose another name."),
        blocking(List.of(), "cellar"));
  }

  @Test
  void aChargerThatTasksAndSchedulesNameIsNotTakenAway() {
    Instant at = Instant.parse("2026-11-28T10:00:00Z");
    TaskPlace there = new TaskPlace(new Vec2(3.5, 2.5), null);
    TransportTask task =
        new TransportTask(7, "Tea", 1, there, there, "hall", 0, null, null, "Ann", at)
            .withStops(
                List.of(
                    new Stop(there, false, null),
                    new Stop(there, false, null, new Stop.Charge("C1", 0.8)),
                    new Stop(there, false, null, new Stop.Charge(null, 0.8)),
                    new Stop(there, false, null, new Stop.Charge("C2", null))));
    TaskOrder order =
        new TaskOrder(
                "Round", 0, new Where.Charger("C1"), new Where.Charger("C1"), null, 0, null, null)
            .along(List.of(new StopOrder(new Where.Charger("C1"), false, null, 1.0)));
    Schedule schedule =
        Schedule.of(order, new Recurrence.Once(at.plusSeconds(60)), null, Orderer.named("Ann"), at);
    FloorDrawing drawing =
        new FloorDrawing(
            WALLS,
            List.of(WEST, WEST_2, EAST),
            List.of(),
            List.of(place("C2", 9.5, 2.5)),
            List.of(),
            List.of(),
            List.of());

    assertEquals(
        List.of(
            "Task 7 charges at C1. Keep the charger, or finish or cancel the task first.",
            "The schedule Round charges at C1. Keep the charger, or delete the schedule first."),
        new MapCheck(WALLS, Map.of(), List.of(), List.of(task), List.of(), List.of(schedule))
            .problems(drawing).stream()
                .filter(MapProblem::isBlocking)
                .map(problem -> problem.text().english())
                .toList());
  }

  private static List<String> blocking(List<OneWay> oneWay, @Nullable String floorWithEast) {
    return blocking(
        drawing(WALLS, List.of(WEST, WEST_2, EAST), oneWay),
        floorWithEast == null ? Map.of() : Map.of("East", floorWithEast));
  }

  private static List<String> blocking(FloorDrawing drawing, Map<String, String> elsewhere) {
    return new MapCheck(WALLS, elsewhere, List.of(), List.of(), List.of(), List.of())
        .problems(drawing).stream()
            .filter(MapProblem::isBlocking)
            .map(problem -> problem.text().english())
            .toList();
  }

  private static FloorDrawing drawing(
      OccupancyGrid walls, List<Place> stations, List<OneWay> oneWay) {
    return new FloorDrawing(walls, stations, List.of(), List.of(), List.of(), List.of(), oneWay);
  }

  private static Place place(String name, double x, double y) {
    return new Place(name, new Vec2(x, y));
  }

  /** Its three middle cells. */
  private static OneWay corridor(double bottom, Direction direction) {
    return new OneWay(new Area(new Vec2(4, bottom), 3, 1), direction);
  }
}
