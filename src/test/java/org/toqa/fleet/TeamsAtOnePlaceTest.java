package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.grid.FloorMap;
import org.toqa.grid.FloorReader;
import org.toqa.mission.TaskState;
import org.toqa.sim.SimulatedFloor;

/** One team comes for its load to where another is about to leave with its own. */
@Tag("full")
class TeamsAtOnePlaceTest {
  private static final double SPEED = 200;

  @TempDir private Path folder;

  @Test
  @Timeout(400)
  void whoComesMakesRoomForWhoLeaves() throws Exception {
    FloorMap lab = FloorReader.read(Path.of("maps", "lab.yaml"));
    FloorMap floor =
        new FloorMap(
            lab.name(), lab.grid(), lab.stations(), lab.parking().subList(0, 4), lab.charging());
    LiveFloor live = new LiveFloor(folder, floor, SimulatedFloor.of(floor), SPEED);
    try {
      live.start();
      long first = live.submit(8, "Packing 1", "Goods-in 2");
      long second = live.submit(8, "Packing 1", "Packing 2");
      live.await(view -> LiveFloor.isInState(view, first, TaskState.DONE));
      live.await(view -> LiveFloor.isInState(view, second, TaskState.DONE));
      assertTrue(live.hasSeenCarriedLoad());
    } finally {
      live.close();
    }
  }
}
