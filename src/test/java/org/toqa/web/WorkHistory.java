package org.toqa.web;

import java.time.Duration;
import java.time.Instant;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.UUID;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.FleetStore.Submission;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.history.RobotActivity;
import org.toqa.fleet.history.UtilisationRecord;
import org.toqa.geometry.Vec2;
import org.toqa.mission.Mission;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.store.JdbiFleetStore;
import org.toqa.store.JdbiUtilisationStore;
import org.toqa.wording.Sentence;

/** Puts into a server's store what a fleet has done. */
public final class WorkHistory {
  private static final Duration HALF_HOUR = Duration.ofMinutes(30);

  private final JdbiFleetStore store;
  private final JdbiUtilisationStore uses;

  private WorkHistory(JdbiFleetStore store, JdbiUtilisationStore uses) {
    this.store = store;
    this.uses = uses;
  }

  public static WorkHistory in(WebTestServer server) {
    return new WorkHistory(server.store(), server.uses());
  }

  /** Four tasks, a failure, and half an hour of two robots with names that no door lets in. */
  public void addHour(Instant at) {
    addEndedTask(at, 10, 60, 120);
    addEndedTask(at, 30, 160, 300);
    saveState(addTask(at), TaskState.CANCELLED, at.plusSeconds(1));
    addTask(at);
    addFailure(at, "task.robot-failed");
    addFailure(at, "task.robot-withdrawn");
    addRobot("=r1");
    addRobot("r2, \"old\"");
    uses.save(
        List.of(
            useRecord(
                "=r1", at, Map.of(RobotActivity.WORKING, 1200, RobotActivity.IDLE, 600), 120, 0.02),
            useRecord(
                "r2, \"old\"",
                at,
                Map.of(RobotActivity.CHARGING, 1200, RobotActivity.TRAVELLING, 600),
                30,
                0.005)));
  }

  /** Busy days of six robots, the same with every call. */
  public void addDays(Instant end, int days) {
    Random random = new Random(days);
    for (int robot = 1; robot <= 6; robot++) {
      addRobot("r" + robot);
    }
    for (Instant at = end.minus(Duration.ofDays(days)); at.isBefore(end); at = at.plus(HALF_HOUR)) {
      for (int tasks = random.nextInt(3); tasks > 0; tasks--) {
        int assigned = 5 + random.nextInt(90);
        int delivered = assigned + 60 + random.nextInt(400);
        if (random.nextInt(12) == 0) {
          saveState(addTask(at), TaskState.CANCELLED, at.plusSeconds(assigned));
        } else {
          addEndedTask(at.plusSeconds(random.nextInt(1800)), assigned, delivered, delivered + 60);
        }
      }
      if (random.nextInt(9) == 0) {
        addFailure(
            at,
            List.of("task.robot-lost", "task.late", "traffic.standstill").get(random.nextInt(3)));
      }
      for (int robot = 1; robot <= 6; robot++) {
        uses.save(
            List.of(
                useRecord("r" + robot, at, shares(robot, random), 40 + random.nextInt(300), 0.03)));
      }
    }
  }

  private static Map<RobotActivity, Integer> shares(int robot, Random random) {
    int left = (int) HALF_HOUR.toSeconds();
    Map<RobotActivity, Integer> seconds = new EnumMap<>(RobotActivity.class);
    for (RobotActivity use : RobotActivity.values()) {
      int some = use == RobotActivity.WORKING ? left / 2 : random.nextInt(left / (robot + 2) + 1);
      seconds.put(use, some);
      left -= some;
    }
    seconds.merge(RobotActivity.IDLE, left, Integer::sum);
    return seconds;
  }

  /** Seconds from the order. */
  private void addEndedTask(Instant at, int assigned, int delivered, int ended) {
    TransportTask task = addTask(at);
    saveState(task, TaskState.ASSIGNED, at.plusSeconds(assigned));
    saveState(task, TaskState.RETURNING, at.plusSeconds(delivered));
    saveState(task, TaskState.DONE, at.plusSeconds(ended));
  }

  public TransportTask addTask(Instant at) {
    TaskPlace here = new TaskPlace(new Vec2(1, 1), null);
    TransportTask task =
        new TransportTask(0, "box", 1, here, here, "hall", 0, null, null, "Ann", at);
    return store.addTasks(List.of(new Submission(task, UUID.randomUUID()))).getFirst();
  }

  private void saveState(TransportTask task, TaskState state, Instant at) {
    store.saveMission(new Mission(task, state, List.of(), false, null, null, null), at, List.of());
  }

  private void addFailure(Instant at, String kind) {
    store.addEvents(
        List.of(
            new EventRecord(
                at, kind, null, null, EventRecord.SYSTEM, Sentence.verbatim("Something failed"))));
  }

  private void addRobot(String name) {
    store.saveRobot(RobotRecord.direct(name, "hall", "127.0.0.1", 7275, 5, null, true, null));
  }

  private static UtilisationRecord useRecord(
      String robot,
      Instant at,
      Map<RobotActivity, Integer> seconds,
      double metres,
      double battery) {
    Map<RobotActivity, Duration> time = new EnumMap<>(RobotActivity.class);
    seconds.forEach((use, s) -> time.put(use, Duration.ofSeconds(s)));
    return new UtilisationRecord(robot, at, time, metres, battery);
  }
}
