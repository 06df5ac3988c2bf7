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
import org.toqa.fleet.RobotUse;
import org.toqa.fleet.UseRecord;
import org.toqa.geometry.Vec2;
import org.toqa.mission.Mission;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.store.JdbiFleetStore;
import org.toqa.store.JdbiUseStore;
import org.toqa.wording.Sentence;

/** Puts into a server's store what a fleet has done. */
final class PastWork {
  private static final Duration HALF_HOUR = Duration.ofMinutes(30);

  private final JdbiFleetStore store;
  private final JdbiUseStore uses;

  private PastWork(JdbiFleetStore store, JdbiUseStore uses) {
    this.store = store;
    this.uses = uses;
  }

  static PastWork in(WebTestServer server) {
    return new PastWork(server.store(), server.uses());
  }

  /** Four tasks, a failure, and half an hour of two robots with names that no door lets in. */
  void anHour(Instant at) {
    task(at, 10, 60, 120);
    task(at, 30, 160, 300);
    change(ordered(at), TaskState.CANCELLED, at.plusSeconds(1));
    ordered(at);
    failure(at, "task.robot-failed");
    robot("=r1");
    robot("r2, \"old\"");
    uses.save(
        List.of(
            use("=r1", at, Map.of(RobotUse.WORKING, 1200, RobotUse.IDLE, 600), 120, 0.02),
            use(
                "r2, \"old\"",
                at,
                Map.of(RobotUse.CHARGING, 1200, RobotUse.TRAVELLING, 600),
                30,
                0.005)));
  }

  /** Busy days of six robots, the same with every call. */
  void days(Instant end, int days) {
    Random random = new Random(days);
    for (int robot = 1; robot <= 6; robot++) {
      robot("r" + robot);
    }
    for (Instant at = end.minus(Duration.ofDays(days)); at.isBefore(end); at = at.plus(HALF_HOUR)) {
      for (int tasks = random.nextInt(3); tasks > 0; tasks--) {
        int assigned = 5 + random.nextInt(90);
        int delivered = assigned + 60 + random.nextInt(400);
        if (random.nextInt(12) == 0) {
          change(ordered(at), TaskState.CANCELLED, at.plusSeconds(assigned));
        } else {
          task(at.plusSeconds(random.nextInt(1800)), assigned, delivered, delivered + 60);
        }
      }
      if (random.nextInt(9) == 0) {
        failure(
            at,
            List.of("task.robot-lost", "task.late", "traffic.standstill").get(random.nextInt(3)));
      }
      for (int robot = 1; robot <= 6; robot++) {
        uses.save(
            List.of(use("r" + robot, at, shares(robot, random), 40 + random.nextInt(300), 0.03)));
      }
    }
  }

  private static Map<RobotUse, Integer> shares(int robot, Random random) {
    int left = (int) HALF_HOUR.toSeconds();
    Map<RobotUse, Integer> seconds = new EnumMap<>(RobotUse.class);
    for (RobotUse use : RobotUse.values()) {
      int some = use == RobotUse.WORKING ? left / 2 : random.nextInt(left / (robot + 2) + 1);
      seconds.put(use, some);
      left -= some;
    }
    seconds.merge(RobotUse.IDLE, left, Integer::sum);
    return seconds;
  }

  /** Seconds from the order. */
  private void task(Instant at, int assigned, int delivered, int ended) {
    TransportTask task = ordered(at);
    change(task, TaskState.ASSIGNED, at.plusSeconds(assigned));
    change(task, TaskState.RETURNING, at.plusSeconds(delivered));
    change(task, TaskState.DONE, at.plusSeconds(ended));
  }

  TransportTask ordered(Instant at) {
    TaskPlace here = new TaskPlace(new Vec2(1, 1), null);
    TransportTask task =
        new TransportTask(0, "box", 1, here, here, "hall", 0, null, null, "Ann", at);
    return store.addTasks(List.of(new Submission(task, UUID.randomUUID()))).getFirst();
  }

  private void change(TransportTask task, TaskState state, Instant at) {
    store.saveMission(new Mission(task, state, List.of(), false, null, null, null), at, List.of());
  }

  private void failure(Instant at, String kind) {
    store.addEvents(
        List.of(
            new EventRecord(
                at, kind, null, null, EventRecord.SYSTEM, Sentence.verbatim("Something failed"))));
  }

  private void robot(String name) {
    store.saveRobot(new RobotRecord(name, "hall", "127.0.0.1", 7275, 5, null, true, null));
  }

  private static UseRecord use(
      String robot, Instant at, Map<RobotUse, Integer> seconds, double metres, double battery) {
    Map<RobotUse, Duration> time = new EnumMap<>(RobotUse.class);
    seconds.forEach((use, s) -> time.put(use, Duration.ofSeconds(s)));
    return new UseRecord(robot, at, time, metres, battery);
  }
}
