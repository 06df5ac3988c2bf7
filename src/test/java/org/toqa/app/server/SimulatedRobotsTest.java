package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.app.config.Configuration;
import org.toqa.app.config.Setting;
import org.toqa.app.config.SettingSource;
import org.toqa.fleet.RobotRecord;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.sim.SimulatedFleet;
import org.toqa.sim.VirtualClock;
import org.toqa.store.Database;
import org.toqa.store.JdbiFleetStore;
import org.toqa.store.MemoryDatabase;

/** The server's own robots, which it finds again, unless it has another map now. */
class SimulatedRobotsTest {
  private static final Vec2 PLACE = new Vec2(1.5, 1.5);
  private static final Vec2 ANOTHER = new Vec2(6.5, 0.5);

  @TempDir private Path folder;

  @Test
  void aRobotIsFoundAgainAndBeginsAnewOnAnotherMap() throws Exception {
    try (Database database = MemoryDatabase.open("simulated-robots")) {
      JdbiFleetStore store = new JdbiFleetStore(database.jdbi());

      assertEquals(PLACE, start(floor("hall", PLACE), store));
      assertEquals(PLACE, start(floor("hall", ANOTHER), store));
      assertEquals(ANOTHER, start(floor("yard", ANOTHER), store));

      assertEquals(List.of("yard"), store.robots().stream().map(RobotRecord::floor).toList());
    }
  }

  private static FloorMap floor(String name, Vec2 parking) {
    return new FloorMap(
        name,
        OccupancyGrid.parse("........", "........", "........"),
        List.of(),
        List.of(new Place("P1", parking)),
        List.of());
  }

  /** Where the robot is then. */
  private Vec2 start(FloorMap floor, JdbiFleetStore store) throws Exception {
    Configuration configuration =
        Configuration.of(
            folder.resolve("lab.yaml"),
            List.of(
                SettingSource.fromCommandLine(
                    Map.of(Setting.SIMULATE, "1", Setting.DATA, folder.toString()))));
    try (VirtualClock clock = new VirtualClock(Instant.EPOCH, 1);
        SimulatedFleet robots = SimulatedRobots.start(configuration, floor, store, clock)) {
      return robots.truePose("r1").orElseThrow().position();
    }
  }
}
