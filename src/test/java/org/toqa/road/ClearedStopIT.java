package org.toqa.road;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.http.HttpResponse;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.agent.firmware.SimulatorProbe;
import org.toqa.agent.firmware.SimulatorProbe.Truth;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.sim.Body;
import org.toqa.sim.SimulatedRobot;
import org.toqa.sim.VirtualClock;
import org.toqa.testbed.ApiClient;
import org.toqa.web.TestClient;
import tools.jackson.databind.JsonNode;

/**
 * The firmware stops the robot by itself, and only a person's word lets it go on: from the page to
 * the microcontroller, over the running server and the real daemon.
 */
@Tag("full")
@Timeout(600)
class ClearedStopIT {
  private static final Path FIRMWARE = Path.of("firmware", "build").toAbsolutePath();
  private static final String CODE = "STOP_SWITCH";
  private static final double RADIUS = 0.1275;
  private static final Pose START = new Pose(RoadWorld.PARKING.x(), RoadWorld.PARKING.y(), 0);

  /** Of the world's time: longer than any timer after which something goes on by itself. */
  private static final Duration LONG = Duration.ofSeconds(40);

  @TempDir private Path folder;

  @Test
  void robotThatStoppedItselfCarriesItsTaskToTheEndAfterAPersonsWord() throws Exception {
    SimulatedRobot robot = new SimulatedRobot(RoadWorld.ROBOT, START, 5, 1, FIRMWARE);
    RoadWorld.walk(
        folder,
        List.of(robot),
        road -> {
          Path socket = folder.resolve("robots").resolve(RoadWorld.ROBOT).resolve("spi.sock");
          try (SimulatorProbe world = new SimulatorProbe(socket)) {
            road.clock()
                .add(
                    nanos -> road.judge(Duration.ofNanos(nanos), List.of(body(world))),
                    VirtualClock.STEP.multipliedBy(5));
            ApiClient api = road.api();
            road.await("ready", () -> isInState(api, "IDLE"));
            long task = submit(api);
            road.await("carrying", () -> stateOf(api, task).equals("CARRYING"));
            road.await("on its way", () -> robot(api).get("state").asString().equals("DRIVING"));

            change(world, "switch pressed");
            road.await("stopped", () -> isStoppedBy(api, CODE));
            road.pass(Duration.ofSeconds(1));
            Vec2 stopped = place(world);
            change(world, "switch released");

            road.pass(LONG);
            assertTrue(isStoppedBy(api, CODE), () -> "it went on by itself");
            assertTrue(place(world).distanceTo(stopped) < 0.005, "it moved");
            assertEquals("CARRYING", stateOf(api, task));
            try (TestClient person = TestClient.signedIn(road.address(), RoadWorld.MANAGER)) {
              String page = person.get("robots/" + RoadWorld.ROBOT).body();
              assertTrue(page.contains("Somebody pressed the stop switch on the robot."), page);
              order(person, "hold");
              road.await("held", () -> robot(api).get("held").asBoolean());
              road.pass(Duration.ofSeconds(2));
              assertTrue(isStoppedBy(api, CODE), "a hold is not the word");
              order(person, "resume");
              road.await("let go on", () -> !robot(api).get("held").asBoolean());
              post(person, "fleet/pause", Map.of());
              road.pass(Duration.ofSeconds(2));
              post(person, "fleet/resume", Map.of());
              road.pass(Duration.ofSeconds(5));
              assertTrue(isStoppedBy(api, CODE), "no resume is the word");
              assertTrue(place(world).distanceTo(stopped) < 0.005, "it moved");
              post(person, "robots/" + RoadWorld.ROBOT + "/clear", Map.of("reasons", CODE));
            }

            road.await("cleared", () -> !isStoppedBy(api, CODE));
            road.await("done", () -> stateOf(api, task).equals("DONE"));
            assertTrue(place(world).distanceTo(stopped) > 0.1, "it drove");
            assertFalse(robot(api).get("held").asBoolean());
          }
        });
  }

  private static void order(TestClient person, String order) {
    post(person, "robots/" + RoadWorld.ROBOT + "/" + order, Map.of());
  }

  private static void post(TestClient person, String path, Map<String, String> form) {
    HttpResponse<String> answer = person.post(path, form);
    assertEquals(303, answer.statusCode(), answer.body());
  }

  private static long submit(ApiClient api) throws IOException, InterruptedException {
    return api.post(
            "tasks",
            Map.of(
                "name",
                "Box of bolts",
                "load",
                2,
                "priority",
                50,
                "start",
                Map.of("station", "Goods-out"),
                "goal",
                Map.of("station", "Packing 1")))
        .get("id")
        .asLong();
  }

  private static JsonNode robot(ApiClient api) throws IOException, InterruptedException {
    return api.get("robots/" + RoadWorld.ROBOT);
  }

  private static boolean isInState(ApiClient api, String state)
      throws IOException, InterruptedException {
    return robot(api).get("state").asString().equals(state);
  }

  private static String stateOf(ApiClient api, long task) throws IOException, InterruptedException {
    return api.get("tasks/" + task).get("state").asString();
  }

  private static boolean isStoppedBy(ApiClient api, String code)
      throws IOException, InterruptedException {
    return robot(api)
        .get("errors")
        .valueStream()
        .anyMatch(error -> error.get("code").asString().equals(code));
  }

  private static void change(SimulatorProbe world, String order) throws IOException {
    synchronized (world) {
      world.change(order);
    }
  }

  /** Where the wheels really took it. */
  private static Vec2 place(SimulatorProbe world) throws IOException {
    synchronized (world) {
      Truth truth = world.truth();
      return START.compose(new Pose(truth.decimal("x"), truth.decimal("y"), 0)).position();
    }
  }

  private static Body body(SimulatorProbe world) {
    try {
      return Body.disc(RoadWorld.ROBOT, place(world), RADIUS);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
