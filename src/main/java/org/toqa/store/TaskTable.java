package org.toqa.store;

import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import java.util.function.BiFunction;
import org.jdbi.v3.core.Handle;
import org.jdbi.v3.core.statement.Update;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetStore.ExpectedDelivery;
import org.toqa.fleet.FleetStore.Submission;
import org.toqa.mission.ArmHandling;
import org.toqa.mission.AssignedRobot;
import org.toqa.mission.LoadRecord;
import org.toqa.mission.Mission;
import org.toqa.mission.OrderPart;
import org.toqa.mission.Phase;
import org.toqa.mission.StopProgress;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TransportTask;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.mission.Trouble;

/** The tables of tasks and of who executes them, within a transaction of somebody else. */
final class TaskTable {
  /** Of whose robots are asked for at a time; a statement takes only so many values. */
  private static final int MAX_IDS = 1000;

  private TaskTable() {}

  /**
   * @param owner the id of the task's user; null: there is no such user
   */
  static TransportTask add(Handle h, Submission submission, @Nullable Long owner) {
    TransportTask task = submission.task();
    OrderPart part = task.part();
    long id =
        bindOrder(
                h.createUpdate(
                    """
                      insert into tasks (name, user_id, user_name, floor, load_kg, load_length, load_width,
                        start_x, start_y, start_station, goal_x, goal_y, goal_station, priority, deadline,
                        state, created_at, changed_at, submission, order_id, order_part, awaits_previous, only_robots, stops,
                        arm_pick_x, arm_pick_y, arm_place_x, arm_place_y)
                      values (:name, :owner, :user, :floor, :load,
                        :length, :width, :startX, :startY, :startStation, :goalX, :goalY, :goalStation,
                        :priority, :deadline, 'QUEUED', :at, :at, :submission, :order, :part, :awaits, :onlyRobots, :stops,
                        :armPickX, :armPickY, :armPlaceX, :armPlaceY)
                      """),
                task,
                StopProgress.START)
            .bind("owner", owner)
            .bind("user", task.user())
            .bind("at", task.createdAt())
            .bind("submission", submission.idempotencyKey())
            .bind("order", part == null ? null : part.order())
            .bind("part", part == null ? null : part.position())
            .bind("awaits", part != null && part.awaitsPrevious())
            .executeAndReturnGeneratedKeys("id")
            .mapTo(Long.class)
            .one();
    return task.withId(id).withOwner(task.user(), owner);
  }

  /** What is ordered of the task, and beside its stops how far it is. */
  private static Update bindOrder(Update statement, TransportTask task, StopProgress progress) {
    LoadSize size = task.size();
    ArmHandling arm = task.arm();
    return statement
        .bind("name", task.name())
        .bind("floor", task.floor())
        .bind("load", task.load())
        .bind("length", size == null ? null : size.length())
        .bind("width", size == null ? null : size.width())
        .bind("startX", task.start().position().x())
        .bind("startY", task.start().position().y())
        .bind("startStation", task.start().station())
        .bind("goalX", task.goal().position().x())
        .bind("goalY", task.goal().position().y())
        .bind("goalStation", task.goal().station())
        .bind("armPickX", arm == null ? null : arm.pick().x())
        .bind("armPickY", arm == null ? null : arm.pick().y())
        .bind("armPlaceX", arm == null ? null : arm.place().x())
        .bind("armPlaceY", arm == null ? null : arm.place().y())
        .bind("priority", task.priority())
        .bind("deadline", task.deadline())
        .bind("onlyRobots", RobotNames.write(task.onlyRobots()))
        .bind("stops", StopsJson.write(task.stops(), progress.fetchedBefore()));
  }

  /**
   * Deletes an ended task whose load does not lie on the floor.
   *
   * @return false: it is no such task
   */
  static boolean delete(Handle h, long task) {
    Optional<Long> order = OrderTable.orderOf(h, "id", task);
    boolean isDeleted =
        h.createUpdate(
                    """
                    delete from tasks where id = :id
                      and (state = 'DONE' or state in ('FAILED', 'CANCELLED') and set_down_x is null)
                    """)
                .bind("id", task)
                .execute()
            == 1;
    order.ifPresent(id -> OrderTable.deleteIfEmpty(h, id));
    return isDeleted;
  }

  static void withdraw(Handle h, UUID key) {
    Optional<Long> order = OrderTable.orderOf(h, "submission", key);
    String of = " (select id from tasks where submission = :submission)";
    h.createUpdate("delete from events where task_id in" + of).bind("submission", key).execute();
    h.createUpdate("delete from tasks where submission = :submission")
        .bind("submission", key)
        .execute();
    order.ifPresent(id -> OrderTable.deleteIfEmpty(h, id));
  }

  static void saveState(Handle h, Mission mission, Instant at) {
    TaskPlace setDown = mission.setDownPlace();
    Trouble trouble = mission.trouble();
    OrderPart part = mission.task().part();
    TaskPlace place = trouble == null ? null : trouble.place();
    LoadRecord load = mission.load();
    bindOrder(
            h.createUpdate(
                """
            update tasks set user_id = (select id from users where id = :owner), user_name = :user,
              name = :name, floor = :floor, load_kg = :load, load_length = :length, load_width = :width,
              start_x = :startX, start_y = :startY, start_station = :startStation,
              goal_x = :goalX, goal_y = :goalY, goal_station = :goalStation, deadline = :deadline, only_robots = :onlyRobots, stops = :stops,
              state = :state, changed_at = :at, priority = :priority, held = :held, ending = :ending,
              assigned_at = coalesce(assigned_at, :assigned), delivered_at = coalesce(delivered_at, :delivered),
              set_down_x = :setDownX, set_down_y = :setDownY, trouble_robot = :troubleRobot,
              trouble_why = :troubleWhy, trouble_said = :troubleSaid, trouble_x = :troubleX,
              trouble_y = :troubleY, trouble_waits = :troubleWaits, trouble_arm = :troubleArm,
              arm_pick_x = :armPickX, arm_pick_y = :armPickY, arm_place_x = :armPlaceX, arm_place_y = :armPlaceY,
              awaits_previous = :awaits, load_id = :loadId, load_since = :loadSince,
              stop = :stop, waiting_since = :waitingSince
            where id = :id
            """),
            mission.task(),
            mission.progress())
        .bind("owner", mission.task().owner())
        .bind("user", mission.task().user())
        .bind("state", mission.state().name())
        .bind("at", at)
        .bind("assigned", mission.state().isAssigned() ? at : null)
        .bind("delivered", mission.state().isDelivered() ? at : null)
        .bind("held", mission.held())
        .bind("ending", mission.ending())
        .bind("setDownX", setDown == null ? null : setDown.position().x())
        .bind("setDownY", setDown == null ? null : setDown.position().y())
        .bind("troubleRobot", trouble == null ? null : trouble.robot())
        .bind("troubleWhy", trouble == null ? null : trouble.why().english())
        .bind("troubleSaid", trouble == null ? null : SentenceJson.write(trouble.why()))
        .bind("troubleX", place == null ? null : place.position().x())
        .bind("troubleY", place == null ? null : place.position().y())
        .bind("troubleWaits", trouble != null && trouble.isAwaited())
        .bind("troubleArm", trouble != null && trouble.isOfArm())
        .bind("awaits", part != null && part.awaitsPrevious())
        .bind("loadId", load == null ? null : load.id())
        .bind("loadSince", load == null ? null : load.since())
        .bind("stop", mission.progress().stop())
        .bind("waitingSince", mission.progress().waitingSince())
        .bind("id", mission.id())
        .execute();
  }

  static void saveExpectation(Handle h, ExpectedDelivery expectation) {
    String column = expectation.hasRobots() ? "expected_at_start" : "expected_at_order";
    h.createUpdate(
            "update tasks set %1$s = coalesce(%1$s, :delivery) where id = :id".formatted(column))
        .bind("delivery", expectation.delivery())
        .bind("id", expectation.task())
        .execute();
  }

  /** Whether a user has tasks that are neither delivered nor cancelled. */
  static boolean isAnyLeftTo(Handle h, long owner) {
    return h.createQuery(
                """
                select count(*) from tasks where user_id = :owner
                  and state in ('QUEUED', 'ASSIGNED', 'TO_OBJECT', 'CARRYING') and ending is null
                """)
            .bind("owner", owner)
            .mapTo(Integer.class)
            .one()
        > 0;
  }

  static List<Long> robotsOf(Handle h, long task) {
    return h.createQuery("select robot_id from task_robots where task_id = :task")
        .bind("task", task)
        .mapTo(Long.class)
        .list();
  }

  static void saveAssignedRobots(Handle h, Mission mission) {
    h.createUpdate("delete from task_robots where task_id = :id")
        .bind("id", mission.id())
        .execute();
    for (int place = 0; place < mission.assignedRobots().size(); place++) {
      saveAssignedRobot(h, mission.id(), place, mission.assignedRobots().get(place));
    }
  }

  private static void saveAssignedRobot(Handle h, long task, int place, AssignedRobot assigned) {
    long robot = RobotTable.id(h, assigned.robot());
    h.createUpdate(
            """
            insert into task_robots (task_id, robot_id, place, phase, arrived, released)
            values (:task, :robot, :place, :phase, :arrived, :released)
            """)
        .bind("task", task)
        .bind("robot", robot)
        .bind("place", place)
        .bind("phase", assigned.phase())
        .bind("arrived", assigned.arrived())
        .bind("released", assigned.unassigned())
        .execute();
  }

  /** From what the robot is in now: a task, the drive home from one, or neither. */
  static void saveAvailability(Handle h, long robot) {
    // availability 1: can be given a task; phase 0: parked   (Tanta, "Database")
    h.createUpdate(
            """
            update robots set
              availability = case when exists (select 1 from task_robots t
                where t.robot_id = :robot and not t.released and t.phase < 3) then 0 else 1 end,
              phase = coalesce((select min(t.phase) from task_robots t
                where t.robot_id = :robot and not t.released), 0)
            where id = :robot
            """)
        .bind("robot", robot)
        .execute();
  }

  /**
   * The rows, each with the robots that execute it.
   *
   * @param made of a row and its robots, in the order they were chosen
   */
  static <T> List<T> withRobots(
      Handle h, List<TaskRow> rows, BiFunction<TaskRow, List<AssignedRobot>, T> made) {
    Map<Long, List<AssignedRobot>> robots = new HashMap<>();
    for (int i = 0; i < rows.size(); i += MAX_IDS) {
      List<TaskRow> part = rows.subList(i, Math.min(rows.size(), i + MAX_IDS));
      for (AssignedRobotRow row : assignedRobots(h, part.stream().map(TaskRow::id).toList())) {
        robots.computeIfAbsent(row.task(), task -> new ArrayList<>()).add(row.toAssignedRobot());
      }
    }
    return rows.stream()
        .map(row -> made.apply(row, robots.getOrDefault(row.id(), List.of())))
        .toList();
  }

  /** A robot's part in a task. */
  record AssignedRobotRow(long task, String robot, Phase phase, boolean arrived, boolean released) {
    AssignedRobot toAssignedRobot() {
      return new AssignedRobot(robot, phase, arrived, released);
    }
  }

  /**
   * @param tasks at least one id
   */
  private static List<AssignedRobotRow> assignedRobots(Handle h, List<Long> tasks) {
    return h.createQuery(
            """
            select t.task_id as task, r.name as robot, t.phase, t.arrived, t.released
            from task_robots t join robots r on r.id = t.robot_id
            where t.task_id in (<tasks>) order by t.task_id, t.place
            """)
        .bindList("tasks", tasks)
        .mapTo(AssignedRobotRow.class)
        .list();
  }
}
