package org.toqa.road;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpResponse;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.agent.config.ArmConfig;
import org.toqa.arm.Arm;
import org.toqa.arm.JointAngles;
import org.toqa.arm.JointLimits;
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

  /** With the phase of each. */
  private static final List<String> ARM_STEPS =
      List.of("1 REACH", "1 GRASP", "1 WEIGH", "1 FOLD", "2 REACH", "2 RELEASE", "2 FOLD");

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

  /** The load lies beside the start and shall lie beside the goal; the robot's arm handles it. */
  @Test
  void aTaskOfTheFormIsPickedUpAndPutDownByTheArm() throws Exception {
    Pose start = new Pose(RoadWorld.PARKING.x(), RoadWorld.PARKING.y(), 0);
    Vec2 pick = new Vec2(RoadWorld.GOODS_OUT.x(), RoadWorld.GOODS_OUT.y() + 0.4);
    Vec2 place = new Vec2(GOAL.x() + 0.3, GOAL.y() + 0.2);
    RoadWorld.walk(
        folder,
        List.of(
            new SimulatedRobot(RoadWorld.ROBOT, start, 5, 1).withArm(new ArmConfig(ARM, 1.5)),
            new SimulatedRobot("r2", new Pose(14.25, 1.05, 0), 5, 1)),
        road -> {
          road.api().awaitSnapshot(FormToWheelsTest::areIdle);
          try (TestClient manager = TestClient.signedIn(road.address(), RoadWorld.MANAGER)) {
            HttpResponse<String> refused =
                manager.post("tasks/new", armForm(pick, new Vec2(GOAL.x() + 2, GOAL.y())));
            assertEquals(422, refused.statusCode());
            assertTrue(refused.body().contains("it is 1.95 m from the shoulder"), refused::body);
            HttpResponse<String> answer = manager.post("tasks/new", armForm(pick, place));
            assertEquals(303, answer.statusCode(), answer.body());
          }
          Set<String> steps = new LinkedHashSet<>();
          road.await(
              "delivered",
              () -> {
                JsonNode robot = road.api().get("robots/" + RoadWorld.ROBOT);
                JsonNode arm = robot.get("arm");
                if (!arm.get("step").isNull()) {
                  steps.add(robot.get("phase").asInt() + " " + arm.get("step").asString());
                  assertTrue(
                      Math.min(road.distanceTo(RoadWorld.GOODS_OUT), road.distanceTo(GOAL)) < AT,
                      "it stands while its arm acts");
                }
                String state = road.api().get("tasks/1").get("state").asString();
                return state.equals("RETURNING") || state.equals("DONE");
              });
          List<String> inTurn = new ArrayList<>(ARM_STEPS);
          inTurn.retainAll(steps); // a busy machine does not see all of them
          assertEquals(inTurn, List.copyOf(steps));
          for (String phase : List.of("1", "2")) {
            assertTrue(steps.stream().anyMatch(step -> step.startsWith(phase)), steps::toString);
          }
          JsonNode task = road.api().get("tasks/1");
          assertEquals(RoadWorld.ROBOT, task.get("robots").get(0).asString());
          assertTrue(
              task.get("history").toString().contains("r1 weighed the load: 1.5 kg, and 2 kg"),
              task::toString);
        });
  }

  private static final Arm ARM =
      new Arm(
          0.3,
          0.25,
          new Pose(0.05, 0, 0),
          new JointLimits(-2.5, 2.5, 1.5, 4),
          new JointLimits(-2.8, 2.8, 2, 5),
          3,
          new JointAngles(2.2, -2.7));

  private static Map<String, String> armForm(Vec2 pick, Vec2 place) {
    return Map.of(
        "name", "Box of bolts",
        "load", "2",
        "startStation", "Goods-out",
        "goalX", String.valueOf(GOAL.x()),
        "goalY", String.valueOf(GOAL.y()),
        "pickX", String.valueOf(pick.x()),
        "pickY", String.valueOf(pick.y()),
        "placeX", String.valueOf(place.x()),
        "placeY", String.valueOf(place.y()));
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
