package org.toqa.testbed;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FloorView;
import org.toqa.fleet.FloorView.ChargerShortage;
import org.toqa.fleet.FloorView.FaultyCharger;
import org.toqa.fleet.FloorView.LeftLoad;
import org.toqa.fleet.FloorView.SeenObstacle;
import org.toqa.fleet.FloorView.StandstillView;
import org.toqa.fleet.Hold;
import org.toqa.fleet.TaskView;
import org.toqa.grid.CellRuns;
import org.toqa.mission.LoadRecord;
import org.toqa.mission.Question;
import org.toqa.mission.StopProgress;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TaskState;
import org.toqa.mission.TransportTask;
import org.toqa.wording.Sentence;

/** Views for tests that are about a part of them only. */
public final class Views {
  private Views() {}

  /** A floor without what is only shown. */
  public static FloorView floor(
      String name,
      @Nullable Hold hold,
      CellRuns obstacles,
      Map<String, CellRuns> silentRobotCells,
      List<StandstillView> standstills,
      List<FaultyCharger> faultyChargers,
      List<LeftLoad> leftLoads,
      @Nullable ChargerShortage chargerShortage) {
    return new FloorView(
        name,
        hold,
        obstacles,
        silentRobotCells,
        standstills,
        faultyChargers,
        leftLoads,
        chargerShortage,
        List.of(),
        List.of(),
        List.of(),
        Hall.floor().version(),
        List.of());
  }

  /** A floor where robots see these, and nothing else is. */
  public static FloorView floorWith(String name, List<SeenObstacle> seen) {
    return new FloorView(
        name,
        null,
        CellRuns.NONE,
        Map.of(),
        List.of(),
        List.of(),
        List.of(),
        null,
        seen,
        List.of(),
        List.of(),
        Hall.floor().version(),
        List.of());
  }

  /** A task with its own load, which is where it was when the task was ordered. */
  public static TaskView task(
      TransportTask task,
      TaskState state,
      boolean held,
      List<String> robots,
      @Nullable TaskPlace loadAt,
      @Nullable Sentence waitingFor,
      boolean blocked,
      @Nullable Question needs,
      @Nullable Sentence late,
      Instant changedAt) {
    return new TaskView(
        task,
        state,
        held,
        robots,
        loadAt,
        waitingFor,
        blocked,
        needs,
        late,
        changedAt,
        new LoadRecord(task.id(), task.createdAt()),
        StopProgress.START,
        null);
  }
}
