package org.toqa.store;

import java.time.Instant;
import java.util.List;
import org.jdbi.v3.core.mapper.Nested;
import org.jdbi.v3.core.mapper.PropagateNull;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FleetStore.OpenTask;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Vec2;
import org.toqa.mission.ArmHandling;
import org.toqa.mission.AssignedRobot;
import org.toqa.mission.LoadChoice;
import org.toqa.mission.LoadRecord;
import org.toqa.mission.Mission;
import org.toqa.mission.OrderPart;
import org.toqa.mission.StopProgress;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.mission.Trouble;

/** A row of the table of tasks: a mission without its robots. */
record TaskRow(
    long id,
    String name,
    String userName,
    @Nullable Long userId,
    String floor,
    double loadKg,
    @Nullable Double loadLength,
    @Nullable Double loadWidth,
    @Nested("start") PlaceColumns start,
    @Nested("goal") PlaceColumns goal,
    int priority,
    @Nullable Instant deadline,
    TaskState state,
    Instant createdAt,
    Instant changedAt,
    boolean held,
    @Nullable LoadChoice ending,
    @Nullable Double setDownX,
    @Nullable Double setDownY,
    @Nullable Long loadId,
    @Nullable Instant loadSince,
    @Nullable Double armPickX,
    @Nullable Double armPickY,
    @Nullable Double armPlaceX,
    @Nullable Double armPlaceY,
    @Nested("trouble") @Nullable TroubleColumns trouble,
    @Nested("order") @Nullable OrderColumns order,
    @Nullable String onlyRobots,
    @Nullable String stops,
    int stop,
    @Nullable Instant waitingSince) {

  static final String COLUMNS =
      """
      id, name, user_name, user_id, floor, load_kg, load_length, load_width, start_x, start_y, start_station,
      goal_x, goal_y, goal_station, priority, deadline, state, created_at, changed_at, held, ending,
      set_down_x, set_down_y, load_id, load_since, trouble_robot, trouble_why, trouble_said, trouble_x, trouble_y, trouble_waits, trouble_arm,
      arm_pick_x, arm_pick_y, arm_place_x, arm_place_y,
      only_robots, stops, stop, waiting_since, order_id, order_part, awaits_previous as order_awaits,
      (select o.name from orders o where o.id = tasks.order_id) as order_name,
      (select o.kind from orders o where o.id = tasks.order_id) as order_kind,
      (select o.parts from orders o where o.id = tasks.order_id) as order_parts
      """;

  /** What keeps a robot from going on; all null where nothing does. */
  record TroubleColumns(
      @PropagateNull String robot,
      String why,
      @Nullable String said,
      @Nullable Double x,
      @Nullable Double y,
      boolean waits,
      boolean arm) {
    Trouble toTrouble() {
      return new Trouble(robot, SentenceJson.read(said, why), place(x, y), waits, arm);
    }
  }

  /** Which part of an order it is; all null where it is none. */
  record OrderColumns(
      @PropagateNull Long id,
      int part,
      boolean awaits,
      String name,
      OrderPart.Kind kind,
      int parts) {
    OrderPart toOrderPart() {
      return new OrderPart(id, name, kind, part, parts, awaits);
    }
  }

  OpenTask toOpenTask(List<AssignedRobot> robots) {
    return new OpenTask(toMission(robots), changedAt);
  }

  TaskView toView(List<AssignedRobot> robots) {
    return TaskView.of(toMission(robots), null, changedAt);
  }

  private Mission toMission(List<AssignedRobot> robots) {
    return new Mission(
        toTask(),
        state,
        robots,
        held,
        ending,
        place(setDownX, setDownY),
        trouble == null ? null : trouble.toTrouble(),
        loadId == null || loadSince == null ? null : new LoadRecord(loadId, loadSince),
        new StopProgress(stop, waitingSince, StopsJson.readFetchedBefore(stops)));
  }

  private TransportTask toTask() {
    return new TransportTask(
        id,
        name,
        loadKg,
        start.toTaskPlace(),
        goal.toTaskPlace(),
        floor,
        priority,
        deadline,
        loadSize(loadLength, loadWidth),
        userName,
        userId,
        createdAt,
        order == null ? null : order.toOrderPart(),
        RobotNames.read(onlyRobots),
        StopsJson.read(stops),
        arm());
  }

  private @Nullable ArmHandling arm() {
    return armPickX == null || armPickY == null || armPlaceX == null || armPlaceY == null
        ? null
        : new ArmHandling(new Vec2(armPickX, armPickY), new Vec2(armPlaceX, armPlaceY));
  }

  /** Null where nobody said it. */
  static @Nullable LoadSize loadSize(@Nullable Double length, @Nullable Double width) {
    return length == null || width == null ? null : new LoadSize(length, width);
  }

  private static @Nullable TaskPlace place(@Nullable Double x, @Nullable Double y) {
    return x == null || y == null ? null : new TaskPlace(new Vec2(x, y), null);
  }
}
