package org.toqa.fleet.manager;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Function;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.fleet.TaskView;
import org.toqa.fleet.dispatch.FloorFleet;
import org.toqa.fleet.dispatch.TaskFloors;
import org.toqa.wording.Phrase;

/** Asks the floor that a question concerns, or answers that there is none. */
final class FloorRouter {
  private final FloorDirectory floors;
  private final RobotFloors robots;
  private final TaskFloors taskFloors;
  private final MissingFloors missingFloors;

  FloorRouter(
      FloorDirectory floors,
      RobotFloors robots,
      TaskFloors taskFloors,
      MissingFloors missingFloors) {
    this.floors = floors;
    this.robots = robots;
    this.taskFloors = taskFloors;
    this.missingFloors = missingFloors;
  }

  <T> CompletionStage<Answer<T>> askFloor(
      String floor, Function<FloorFleet, CompletionStage<Answer<T>>> question) {
    return answered(
        floors.find(floor).map(entry -> entry.ask(question)), () -> FloorDirectory.unknown(floor));
  }

  /** The same of what must not wait for a change of the map. */
  <T> CompletionStage<Answer<T>> askFloorAtOnce(
      String floor, Function<FloorFleet, CompletionStage<Answer<T>>> question) {
    return answered(
        floors.find(floor).map(entry -> entry.askAtOnce(question)),
        () -> FloorDirectory.unknown(floor));
  }

  /** Asks the floor that an order names, or that has the stations that it names. */
  <T> CompletionStage<Answer<T>> askResolved(
      @Nullable String floor,
      Where start,
      Where goal,
      Function<FloorFleet, CompletionStage<Answer<T>>> question) {
    return answered(
        floors.resolve(floor, start, goal).map(entry -> entry.ask(question)),
        () -> new Answer.Rejected<>("floor", floors.noSuchFloor(floor)));
  }

  /** Asks the floor where the robot is. */
  <T> CompletionStage<Answer<T>> askFloorOf(
      String robot, Function<FloorFleet, CompletionStage<Answer<T>>> question) {
    return answered(withRobot(robot).map(entry -> entry.ask(question)), () -> unknownRobot(robot));
  }

  /** The same of what must not wait for a change of the map. */
  <T> CompletionStage<Answer<T>> askFloorOfAtOnce(
      String robot, Function<FloorFleet, CompletionStage<Answer<T>>> question) {
    return answered(
        withRobot(robot).map(entry -> entry.askAtOnce(question)), () -> unknownRobot(robot));
  }

  /** Asks the floor that has the task, or where its load lies. */
  CompletionStage<Answer<TaskView>> askFloorOfTask(
      long task, Function<FloorFleet, CompletionStage<Answer<TaskView>>> question) {
    return answered(withTask(task).map(entry -> entry.ask(question)), () -> endedTask(task));
  }

  /** The same of what must not wait for a change of the map. */
  CompletionStage<Answer<TaskView>> askFloorOfTaskAtOnce(
      long task, Function<FloorFleet, CompletionStage<Answer<TaskView>>> question) {
    return answered(withTask(task).map(entry -> entry.askAtOnce(question)), () -> endedTask(task));
  }

  private Optional<FloorEntry> withTask(long task) {
    return taskFloors.floorOf(task).flatMap(floors::find);
  }

  private Answer<TaskView> endedTask(long task) {
    return new Answer.Conflict<>(
        missingFloors.alertOfTask(task).orElseGet(() -> Phrase.TASK_HAS_ENDED.with(task)), null);
  }

  private Optional<FloorEntry> withRobot(String robot) {
    return robots.floorOf(robot).flatMap(floors::find);
  }

  private static <T> Answer<T> unknownRobot(String robot) {
    return new Answer.Unknown<>(Phrase.NO_SUCH_ROBOT.with(robot));
  }

  private static <T> CompletionStage<Answer<T>> answered(
      Optional<CompletionStage<Answer<T>>> asked, Supplier<Answer<T>> otherwise) {
    return asked
        .map(answer -> FloorEntry.orIfRemoved(answer, otherwise))
        .orElseGet(() -> CompletableFuture.completedFuture(otherwise.get()));
  }
}
