package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.FloorReader;
import org.toqa.link.gateway.GatewayRig;
import org.toqa.link.gateway.Gateways;
import org.toqa.mission.TaskState;
import org.toqa.sim.SimulatedFleet;
import org.toqa.sim.SimulatedFloor;

/** A fleet whose robot, a real daemon over a simulated body, is reached through a gateway. */
class GatewayFleetTest {
  private static final double SPEED = 200;

  @TempDir private Path folder;
  private @Nullable GatewayRig rig;
  private @Nullable LiveFloor opened;

  @BeforeEach
  void open() throws Exception {
    FloorMap lab = FloorReader.read(Path.of("maps", "lab.yaml"));
    FloorMap floor =
        new FloorMap(
            lab.name(), lab.grid(), lab.stations(), lab.parking().subList(0, 1), lab.charging());
    opened = new LiveFloor(folder, floor, SimulatedFloor.of(floor), SPEED, "dock", this::gateways);
    live().start();
  }

  @AfterEach
  void close() throws Exception {
    live().close();
    rig().close();
  }

  private Gateways gateways(SimulatedFleet robots) {
    try {
      rig = new GatewayRig(folder, List.of("127.0.0.1:" + robots.port("r1")));
      return rig.port();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private LiveFloor live() {
    return Objects.requireNonNull(opened);
  }

  private GatewayRig rig() {
    return Objects.requireNonNull(rig);
  }

  @Test
  @Timeout(120)
  void aTaskIsDoneAlthoughTheLineIsCutInTheMiddle() throws Exception {
    long task = live().submit(2, "Goods-in 1", "Goods-in 2");
    FleetSnapshot driving =
        live()
            .await(
                view ->
                    LiveFloor.isInState(view, task, TaskState.TO_OBJECT)
                        && robot(view).releasedPoints() > 1
                        && robot(view).releasedPoints() < robot(view).pathPoints().size());
    Vec2 releasedEnd = robot(driving).pathPoints().get(robot(driving).releasedPoints() - 1);
    assertTrue(place().distanceTo(releasedEnd) > 0.1, "it is on its way");

    rig().cable().cut();
    passes(Duration.ofSeconds(15));
    Vec2 held = place();
    passes(Duration.ofSeconds(5));

    assertEquals(0, held.distanceTo(place()), 1e-6, "it stands");
    assertTrue(
        held.distanceTo(releasedEnd) < 0.05, () -> held + " is not the end of what was released");
    // the line's end is found out in real time, while the world goes on 200 times as fast
    FleetSnapshot lost =
        live()
            .await(
                view ->
                    String.valueOf(robot(view).alert())
                        .contains("its gateway dock is not connected"));
    assertEquals(RobotState.LOST, robot(lost).state());
    assertFalse(rig().port().states().getFirst().isConnected());

    rig().cable().mend();
    FleetSnapshot done = live().await(view -> LiveFloor.isInState(view, task, TaskState.DONE));
    assertEquals(null, robot(done).alert());
  }

  private void passes(Duration time) throws InterruptedException {
    long end = live().clock.nanos() + time.toNanos();
    live().await(_ -> live().clock.nanos() >= end);
  }

  private Vec2 place() {
    Pose pose = live().robots.truePose("r1").orElseThrow();
    return new Vec2(pose.x(), pose.y());
  }

  private static RobotView robot(FleetSnapshot view) {
    return view.robots().getFirst();
  }
}
