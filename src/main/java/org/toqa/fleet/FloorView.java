package org.toqa.fleet;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.grid.CellRuns;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.wording.Sentence;

/**
 * A floor as readers see it: what blocks it beside its walls and the robots that drive.
 *
 * @param hold by an operator, of all its robots; null: they may drive
 * @param obstacles where robots have seen something that the map does not show
 * @param silentRobotCells by name, the robots that are not heard of, with the cells that stay
 *     reserved for each
 * @param leftLoads those of ended tasks that lie on the floor
 * @param chargerShortage null: the charging points are enough, as far as is known
 */
public record FloorView(
    String name,
    @Nullable Hold hold,
    CellRuns obstacles,
    Map<String, CellRuns> silentRobotCells,
    List<StandstillView> standstills,
    List<FaultyCharger> faultyChargers,
    List<LeftLoad> leftLoads,
    @Nullable ChargerShortage chargerShortage) {

  public FloorView {
    silentRobotCells = Map.copyOf(silentRobotCells);
    standstills = List.copyOf(standstills);
    faultyChargers = List.copyOf(faultyChargers);
    leftLoads = List.copyOf(leftLoads);
  }

  /**
   * A charging point that does not charge.
   *
   * @param where metres, map frame
   */
  public record FaultyCharger(String name, Vec2 where, Instant since, Sentence text) {}

  /**
   * A load that an ended task left on the floor.
   *
   * @param where its middle, metres, map frame
   */
  public record LeftLoad(
      long task, String name, Vec2 where, @Nullable LoadSize size, Sentence text) {}

  /**
   * Robots wait to charge.
   *
   * @param chargers how many charging points there are
   * @param needed how many would do
   */
  public record ChargerShortage(int chargers, int needed, Sentence text) {}

  /**
   * Robots that do not get on.
   *
   * @param positions where they are, metres, map frame, in the order of the robots
   * @param text who, where, and what is done about it
   */
  public record StandstillView(
      List<String> robots, List<Vec2> positions, Instant since, Sentence text) {
    public StandstillView {
      robots = List.copyOf(robots);
      positions = List.copyOf(positions);
    }
  }
}
