package org.toqa.fleet;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Vec2;
import org.toqa.grid.CellRuns;
import org.toqa.mission.LoadRecord;
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
 * @param seen the same obstacles one by one, with their age, also doubted ones
 * @param heldLoads where robots hold loads that several carry
 * @param map names the map in force; another one has another name
 * @param zones by which the allocator {@code zones} decides, in their order; empty without robots
 * @param boxes those that a supervisor knows of, as far as they lie somewhere
 */
public record FloorView(
    String name,
    @Nullable Hold hold,
    CellRuns obstacles,
    Map<String, CellRuns> silentRobotCells,
    List<StandstillView> standstills,
    List<FaultyCharger> faultyChargers,
    List<LeftLoad> leftLoads,
    @Nullable ChargerShortage chargerShortage,
    List<SeenObstacle> seen,
    List<HeldLoad> heldLoads,
    List<ZoneView> zones,
    String map,
    List<BoxView> boxes) {

  public FloorView {
    silentRobotCells = Map.copyOf(silentRobotCells);
    standstills = List.copyOf(standstills);
    faultyChargers = List.copyOf(faultyChargers);
    leftLoads = List.copyOf(leftLoads);
    seen = List.copyOf(seen);
    heldLoads = List.copyOf(heldLoads);
    zones = List.copyOf(zones);
    boxes = List.copyOf(boxes);
  }

  public FloorView withZones(List<ZoneView> next) {
    return new FloorView(
        name,
        hold,
        obstacles,
        silentRobotCells,
        standstills,
        faultyChargers,
        leftLoads,
        chargerShortage,
        seen,
        heldLoads,
        next,
        map,
        boxes);
  }

  public FloorView withBoxes(List<BoxView> next) {
    return new FloorView(
        name,
        hold,
        obstacles,
        silentRobotCells,
        standstills,
        faultyChargers,
        leftLoads,
        chargerShortage,
        seen,
        heldLoads,
        zones,
        map,
        next);
  }

  /**
   * A box that a supervisor knows of.
   *
   * @param box the number on it
   * @param where it lies, metres, map frame
   * @param delivered whether that is its target
   */
  public record BoxView(int box, Vec2 where, boolean delivered) {}

  /**
   * An obstacle that robots have seen: cells that touch.
   *
   * @param robots that see it, or did within the time that it is remembered
   * @param since when one saw it first
   * @param last when one saw it last, to the second
   * @param isDoubted whether robots may drive there, since one alone has seen it for long
   */
  public record SeenObstacle(
      CellRuns cells, List<String> robots, Instant since, Instant last, boolean isDoubted) {
    public SeenObstacle {
      robots = List.copyOf(robots);
    }
  }

  /** Where the robots of a task hold its load. */
  public record HeldLoad(long task, List<HoldPoint> points) {
    public HeldLoad {
      points = List.copyOf(points);
    }
  }

  /**
   * A robot's part of the floor, by the allocator {@code zones}.
   *
   * @param low corner, metres, map frame
   * @param high corner, metres, map frame
   */
  public record ZoneView(String robot, Vec2 low, Vec2 high) {}

  /**
   * @param at metres from the load's middle: x to where the robots face, y to their left
   * @param place likewise, where the robot is meanwhile
   * @param share kilograms that the robot is to bear there
   * @param measured kilograms that it bears as it measures, in tenths; null: it does not say
   */
  public record HoldPoint(
      String robot, Vec2 at, Vec2 place, double share, @Nullable Double measured) {}

  /**
   * A charging point that does not charge.
   *
   * @param where metres, map frame
   */
  public record FaultyCharger(String name, Vec2 where, Instant since, Sentence text) {}

  /**
   * A load that an ended task left on the floor.
   *
   * @param task that left it
   * @param name of that task
   * @param weight kilograms
   * @param where its middle, metres, map frame
   */
  public record LeftLoad(
      long task,
      LoadRecord load,
      String name,
      double weight,
      Vec2 where,
      @Nullable LoadSize size,
      Sentence text) {}

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
