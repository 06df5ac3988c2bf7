package org.toqa.fleet.dispatch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.time.Instant;
import java.util.AbstractList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.toqa.allocation.PlaceUse;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.TaskView;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.mission.AssignedRobot;
import org.toqa.mission.Mission;
import org.toqa.mission.Phase;
import org.toqa.mission.Stop;
import org.toqa.mission.StopProgress;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.testbed.Hall;
import org.toqa.testbed.Views;
import org.toqa.wording.Phrase;

class PlacesInUseTest {
  private static final Instant NOON = Instant.parse("2026-06-01T12:00:00Z");

  @Test
  void carrierStandsAtThePlaceThatItHasNotLeft() {
    TaskView task = task(7, TaskState.CARRYING);
    List<PlaceUse> away = PlacesInUse.of(List.of(task).stream(), List.of(robot("r1", 7L, 5, 5)));
    List<PlaceUse> there = PlacesInUse.of(List.of(task).stream(), List.of(robot("r1", 7L, 7, 0)));
    List<PlaceUse> other = PlacesInUse.of(List.of(task).stream(), List.of(robot("r1", 8L, 7, 0)));

    assertEquals(List.of(place(task.task().goal())), away);
    assertEquals(List.of(place(task.task().start()), place(task.task().goal())), there);
    assertEquals(away, other);
  }

  /** That may take hours. */
  @Test
  void whoWaitsForAPersonAloneKeepsTheStopWhereItIsAndNoLaterOne() {
    List<Vec2> all = List.of(new Vec2(7, 3), new Vec2(7, 9));
    assertEquals(List.of(new Vec2(7, 3)), usedWhileWaiting(true, null));
    assertEquals(all, usedWhileWaiting(true, Duration.ofHours(1)));
    assertEquals(all, usedWhileWaiting(false, Duration.ofHours(1)));
  }

  /** At the second of three stops; its robots stand round a large load. */
  private static List<Vec2> usedWhileWaiting(boolean awaitsPerson, @Nullable Duration waitTime) {
    TransportTask task = task(7, TaskState.CARRYING).task();
    TaskPlace middle = new TaskPlace(new Vec2(7, 3), null);
    Mission mission =
        new Mission(
            task.withStops(
                List.of(
                    Stop.at(task.start()),
                    new Stop(middle, awaitsPerson, waitTime),
                    Stop.at(task.goal()))),
            TaskState.CARRYING,
            List.of(new AssignedRobot("r1", Phase.TO_GOAL, true, false)),
            false,
            null,
            null,
            null,
            null,
            new StopProgress(1, NOON, 1));
    return PlacesInUse.of(
            Stream.of(TaskView.of(mission, null, NOON)), List.of(robot("r1", 7L, 7, 4.5)))
        .stream()
        .map(PlaceUse::place)
        .toList();
  }

  /** They are asked for with each report of a floor. */
  @Test
  void eachRobotIsLookedAtOnceHoweverManyTasksThereAre() {
    AtomicInteger looks = new AtomicInteger();
    List<RobotView> robots =
        counted(
            IntStream.range(0, 500).mapToObj(i -> robot("r" + i, (long) i, i, 0)).toList(), looks);

    PlacesInUse.of(IntStream.range(0, 500).mapToObj(i -> task(i, TaskState.TO_OBJECT)), robots);

    assertTrue(looks.get() <= 500, () -> looks + " looks");
  }

  private static <T> List<T> counted(List<T> list, AtomicInteger looks) {
    return new AbstractList<>() {
      @Override
      public T get(int index) {
        looks.incrementAndGet();
        return list.get(index);
      }

      @Override
      public int size() {
        return list.size();
      }
    };
  }

  private static PlaceUse place(TaskPlace place) {
    return new PlaceUse(7, place.position(), false);
  }

  /** From (id, 0) to (id, 9). */
  private static TaskView task(long id, TaskState state) {
    TransportTask task =
        new TransportTask(
            id,
            "t",
            2,
            new TaskPlace(new Vec2(id, 0), null),
            new TaskPlace(new Vec2(id, 9), null),
            "hall",
            0,
            null,
            null,
            "boss",
            NOON);
    return Views.task(task, state, false, List.of("r1"), null, null, false, null, null, NOON);
  }

  private static RobotView robot(String name, long task, double x, double y) {
    return Hall.robot(name, RobotState.DRIVING, new Pose(x, y, 0), "127.0.0.1", 7275)
        .withWork(
            new RobotView.Work(task, Phase.TO_GOAL, false, null, Phrase.LOOKING_FOR_ROBOT.with()));
  }
}
