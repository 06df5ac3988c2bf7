package org.toqa.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicReference;
import org.toqa.agent.chassis.SimulatedBodyFile.Reading;
import org.toqa.mission.TaskState;
import tools.jackson.databind.JsonNode;

/** That people hold a task, a robot, a floor or the fleet; what must stand still stands still. */
final class ActiveHold {
  private static final double STILL = 0.03; // metres, also for a daemon that starts anew

  private final CrashTestbed site;
  private final Work.Kind kind;

  /** Of the API, such as {@code robots/r1}. */
  private final String path;

  /** Where the robots stand that must not move. */
  private final Map<String, Reading> places;

  /** That of the task that is held, or of none. */
  private final TaskState state;

  private ActiveHold(
      CrashTestbed site,
      Work.Kind kind,
      String path,
      Map<String, Reading> places,
      TaskState state) {
    this.site = site;
    this.kind = kind;
    this.path = path;
    this.places = places;
    this.state = state;
  }

  /** Holds the task, which has not ended, and waits until its robots stand. */
  static ActiveHold ofTask(CrashTestbed site, long id) throws Exception {
    String path = "tasks/" + id;
    assertAccepted(site, path + "/hold");
    List<String> moving = robotsAtWork(site.server.await(path, task -> true));
    awaitHeld(site, moving);
    site.truth().awaitStandstill(moving);
    JsonNode task = site.server.await(path, t -> true);
    awaitHeld(site, robotsAtWork(task));
    Map<String, Reading> places = site.truth().awaitStandstill(robotsAtWork(task));
    return new ActiveHold(site, Work.Kind.TASK_HOLD, path, places, state(task));
  }

  /** Holds the robot, all of the floor or all robots. */
  static ActiveHold of(CrashTestbed site, Work work) throws Exception {
    String robot = site.robots().get(work.number() % site.robots().size());
    String path =
        switch (work.kind()) {
          case ROBOT_HOLD -> "robots/" + robot;
          case FLOOR_HOLD -> "floors/" + CrashTestbed.FLOOR;
          default -> "fleet";
        };
    assertAccepted(site, path + (work.kind() == Work.Kind.PAUSE ? "/pause" : "/hold"));
    List<String> still = work.kind() == Work.Kind.ROBOT_HOLD ? List.of(robot) : site.robots();
    awaitHeld(site, still);
    Map<String, Reading> places = site.truth().awaitStandstill(still);
    return new ActiveHold(site, work.kind(), path, places, TaskState.DONE);
  }

  /** One that only stands may have been told to drive just before, and runs faster than we do. */
  private static void awaitHeld(CrashTestbed site, List<String> robots) throws Exception {
    for (String robot : robots) {
      site.server.await("robots/" + robot, r -> r.get("state").asString().equals("HOLDING"));
    }
  }

  private static void assertAccepted(CrashTestbed site, String path) throws Exception {
    site.server.awaitAccepted(path, Map.of());
  }

  /** Whether people may have cancelled the task that is held: then it need not stay so. */
  boolean isCancelled(WorkLedger ledger) {
    return ledger.cancels().stream().anyMatch(task -> path.equals("tasks/" + task));
  }

  /** Whether nothing has moved, and it is still told. */
  void check() throws Exception {
    List<String> mustStand = new ArrayList<>(places.keySet());
    if (kind == Work.Kind.TASK_HOLD) {
      JsonNode task = site.server.await(path, t -> true);
      assertTrue(task.get("held").asBoolean(), () -> "not on hold any more: " + task);
      assertTrue(
          state(task).compareTo(state) <= 0,
          () -> "went on from " + state + ", though held: " + task);
      mustStand.retainAll(robotsAtWork(task)); // one that was silent may have been replaced
    } else {
      assertTrue(isTold(), () -> path + " is not on hold any more");
    }
    for (String robot : mustStand) {
      assertEquals(
          0,
          site.truth().metresFrom(robot, places.get(robot)),
          STILL,
          robot + " moved, though held");
    }
  }

  private boolean isTold() throws Exception {
    return switch (kind) {
      case ROBOT_HOLD -> site.server.await(path, r -> true).get("held").asBoolean();
      case FLOOR_HOLD -> !snapshot().get("floors").get(0).get("hold").isNull();
      default -> !snapshot().get("pause").isNull();
    };
  }

  private JsonNode snapshot() throws Exception {
    AtomicReference<JsonNode> first = new AtomicReference<>();
    site.server
        .api()
        .awaitSnapshot(
            snapshot -> {
              first.set(snapshot);
              return true;
            });
    return first.get();
  }

  /** Unless what was held is over. */
  void resume() throws Exception {
    if (kind != Work.Kind.TASK_HOLD
        || site.server.await(path, task -> true).get("held").asBoolean()) {
      site.server.awaitAccepted(path + "/resume", Map.of());
    }
  }

  private static TaskState state(JsonNode task) {
    return TaskState.valueOf(task.get("state").asString());
  }

  /** Those that fetch its load or carry it. */
  private static List<String> robotsAtWork(JsonNode task) {
    List<String> robots = new ArrayList<>();
    if (!state(task).isDelivered()) {
      task.get("robots").forEach(robot -> robots.add(robot.asString()));
    }
    return robots;
  }
}
