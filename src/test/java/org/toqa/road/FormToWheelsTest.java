package org.toqa.road;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpResponse;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.sim.SimulatedRobot;
import org.toqa.web.TestClient;
import tools.jackson.databind.JsonNode;

/** The way of a command: from the form of a task to the wheels of the robot that carries it. */
@Timeout(600)
class FormToWheelsTest {
  private static final double AT = 0.06;
  private static final Vec2 GOAL = new Vec2(12.15, 1.65);

  @TempDir private Path folder;

  @Test
  void aTaskOfTheFormIsDrivenByTheWheelsToItsStartAndThenToItsGoal() throws Exception {
    Pose start = new Pose(RoadWorld.PARKING.x(), RoadWorld.PARKING.y(), 0);
    Pose beside = new Pose(14.25, 1.05, 0); // P2
    RoadWorld.walk(
        folder,
        List.of(
            new SimulatedRobot(RoadWorld.ROBOT, start, 5, 1),
            new SimulatedRobot("r2", beside, 1, 1)),
        road -> {
          road.api().awaitSnapshot(FormToWheelsTest::areIdle);
          assertTrue(
              road.track().stream().allMatch(p -> p.distanceTo(start) < 0.001),
              "nobody asked it to drive");

          submitForm(road);

          road.await("at the start", () -> road.distanceTo(RoadWorld.GOODS_OUT) < AT);
          road.await("at the goal", () -> road.distanceTo(GOAL) < AT);
          assertNoJump(road.track());
        });
  }

  private static boolean areIdle(JsonNode snapshot) {
    return snapshot.get("robots").size() == 2
        && snapshot
            .get("robots")
            .valueStream()
            .allMatch(robot -> robot.get("state").asString().equals("IDLE"));
  }

  private static void submitForm(RoadWorld road) {
    try (TestClient manager = TestClient.signedIn(road.address(), RoadWorld.MANAGER)) {
      HttpResponse<String> answer =
          manager.post(
              "tasks/new",
              Map.of(
                  "name", "Box of bolts",
                  "load", "2",
                  "startStation", "Goods-out",
                  "goalX", String.valueOf(GOAL.x()),
                  "goalY", String.valueOf(GOAL.y())));
      assertEquals(303, answer.statusCode(), answer.body());
    }
  }

  /** It was driven there: in 0.1 s it gets on by no more than wheels do at 0.5 m/s. */
  private static void assertNoJump(List<Pose> track) {
    for (int i = 1; i < track.size(); i++) {
      double step = track.get(i).distanceTo(track.get(i - 1));
      assertTrue(step < 0.06, "a jump to " + track.get(i));
    }
  }
}
