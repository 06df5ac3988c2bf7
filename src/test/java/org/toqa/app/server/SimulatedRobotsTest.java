package org.toqa.app.server;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.time.Instant;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.app.config.Configuration;
import org.toqa.app.config.Setting;
import org.toqa.app.config.SettingSource;
import org.toqa.fleet.RobotRecord;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Disc;
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

  /** A hall of cells of 5 cm, and above it one that nothing leads to. */
  @Test
  void robotsOnAMapOfSmallCellsBeginApartWithRoomRoundThemWhereTheyCanDrive() throws Exception {
    OccupancyGrid hall = new OccupancyGrid(60, 60, 0.05, new Vec2(0, 0), walls(60, 15));
    FloorMap floor = new FloorMap("fine", hall, List.of(), List.of(), List.of());
    Disc body = new Disc(SimulatedFleet.FOOTPRINT / 2);
    try (Database database = MemoryDatabase.open("simulated-robots-apart")) {
      List<Vec2> starts = starts(floor, 8, new JdbiFleetStore(database.jdbi()));
      for (Vec2 start : starts) {
        assertTrue(body.isFreeAt(hall, start) && start.y() < 45 * 0.05, starts::toString);
        // itself
        assertEquals(1, starts.stream().filter(o -> o.distanceTo(start) < 0.5).count());
      }
    }
  }

  /** The edges of a square floor are walls, and one of its rows from side to side. */
  private static BitSet walls(int side, int row) {
    BitSet occupied = new BitSet();
    for (int i = 0; i < side; i++) {
      occupied.set(i);
      occupied.set(row * side + i);
      occupied.set((side - 1) * side + i);
      occupied.set(i * side);
      occupied.set(i * side + side - 1);
    }
    return occupied;
  }

  private static FloorMap floor(String name, Vec2 parking) {
    return new FloorMap(
        name,
        OccupancyGrid.parse("........", "........", "........"),
        List.of(),
        List.of(new Place("P1", parking)),
        List.of());
  }

  private Vec2 start(FloorMap floor, JdbiFleetStore store) throws Exception {
    return starts(floor, 1, store).getFirst();
  }

  /** Where the robots are then. */
  private List<Vec2> starts(FloorMap floor, int count, JdbiFleetStore store) throws Exception {
    Configuration configuration =
        Configuration.of(
            folder.resolve("lab.yaml"),
            List.of(
                SettingSource.fromCommandLine(
                    Map.of(Setting.SIMULATE, "" + count, Setting.DATA, folder.toString()))));
    try (VirtualClock clock = new VirtualClock(Instant.EPOCH, 1);
        SimulatedFleet robots =
            SimulatedRobots.start(configuration, List.of(floor), store, clock)) {
      return IntStream.rangeClosed(1, count)
          .mapToObj(i -> robots.truePose("r" + i).orElseThrow().position())
          .toList();
    }
  }
}
