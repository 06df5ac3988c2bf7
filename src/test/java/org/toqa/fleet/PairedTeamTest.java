package org.toqa.fleet;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.toqa.fleet.TaskOrder.Where.Station;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.grid.OccupancyGrid;
import org.toqa.grid.Place;
import org.toqa.link.message.ServerMessage.Command;
import org.toqa.link.message.ServerMessage.Follow;
import org.toqa.link.message.ServerMessage.Lead;
import org.toqa.link.trust.Fingerprint;

/** Robots that carry together are told whom to trust on the link between them. */
@Timeout(120)
class PairedTeamTest {
  private static final Fingerprint NEAR = new Fingerprint("a".repeat(64));
  private static final Fingerprint FAR = new Fingerprint("b".repeat(64));
  private static final Vec2 NEAR_HOME = new Vec2(2.5, 0.5);
  private static final Vec2 FAR_HOME = new Vec2(13.5, 0.5);
  private static final double HEAVY = 8;

  private final FleetStage stage =
      new FleetStage(
          new FloorMap(
              "hall",
              OccupancyGrid.parse(".".repeat(16), ".".repeat(16), ".".repeat(16), ".".repeat(16)),
              List.of(new Place("A", new Vec2(3.5, 2.5)), new Place("B", new Vec2(12.5, 2.5))),
              List.of(new Place("P1", NEAR_HOME), new Place("P2", FAR_HOME)),
              List.of()));

  @AfterEach
  void stop() {
    stage.close();
  }

  @Test
  void leaderAndFollowerAreToldEachOthersCertificate() throws Exception {
    ScriptedRobot near = stage.add("near", NEAR_HOME, "P1", NEAR);
    ScriptedRobot far = stage.add("far", FAR_HOME, "P2", FAR);
    stage.restart();
    stage.await(view -> view.robots().stream().allMatch(r -> r.state() == RobotState.IDLE));

    TaskOrder order =
        new TaskOrder("gearbox", HEAVY, new Station("A"), new Station("B"), null, 0, null, null);
    assertInstanceOf(
        Answer.Accepted.class, stage.fleet.submit(order, "Clara").toCompletableFuture().get());
    stage.await(view -> !all(near, Lead.class).isEmpty() && !all(far, Follow.class).isEmpty());

    assertEquals(FAR.hex(), all(near, Lead.class).getFirst().followers().getFirst().fingerprint());
    assertEquals(NEAR.hex(), all(far, Follow.class).getFirst().fingerprint());
  }

  private static <T extends Command> List<T> all(ScriptedRobot robot, Class<T> kind) {
    return robot.obeyed().stream().filter(kind::isInstance).map(kind::cast).toList();
  }
}
