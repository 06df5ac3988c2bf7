package org.toqa.app.demo;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.grid.FloorMap;
import org.toqa.grid.FloorReader;
import org.toqa.grid.Place;

/** What the demo wants of the shipped floors. */
class DemoTasksTest {

  @Test
  void everyRobotHasAParkingPointAndEveryTaskItsStations() throws Exception {
    assertEquals(
        FloorReader.read(Path.of("maps", "lab.yaml")).parking().size(), DemoTasks.MAX_ROBOTS);
    for (TaskOrder order : DemoTasks.orders(DemoTasks.MAX_ROBOTS)) {
      String name = order.floor() == null ? "lab" : order.floor();
      FloorMap floor = FloorReader.read(Path.of("maps", name + ".yaml"));
      List<String> stations = floor.stations().stream().map(Place::name).toList();
      for (Where place : List.of(order.start(), order.goal())) {
        assertTrue(
            place instanceof Where.Station(String station) && stations.contains(station),
            order::toString);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 3, DemoTasks.MAX_ROBOTS})
  void thereIsMoreToDoThanRobots(int robots) {
    assertTrue(DemoTasks.orders(robots).size() > robots);
  }
}
