package org.toqa.fleet.floor;

import java.time.Instant;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.FloorView;
import org.toqa.fleet.FloorView.ChargerShortage;
import org.toqa.fleet.FloorView.FaultyCharger;
import org.toqa.fleet.FloorView.HeldLoad;
import org.toqa.fleet.FloorView.LeftLoad;
import org.toqa.fleet.FloorView.StandstillView;
import org.toqa.fleet.Hold;
import org.toqa.fleet.floor.ObstacleMap.Obstacle;
import org.toqa.geometry.Vec2;
import org.toqa.grid.CellRuns;
import org.toqa.grid.FloorMap;
import org.toqa.traffic.floor.FloorTraffic;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * What a floor learns beside its map: obstacles, which it tells the traffic, and standstills, which
 * the traffic tells it; and what the history says of them.
 */
final class FloorWatch {
  private final FloorMap floor;
  private final FloorTraffic traffic;
  private final ObstacleMap obstacles;
  private final StandstillTracker standstills;
  private BitSet underLoads = new BitSet();

  /** A line for the history of a robot and of the task that it has. */
  record HistoryLine(EventKind kind, String robot, Sentence text) {}

  FloorWatch(FloorMap floor, FloorTraffic traffic) {
    this.floor = floor;
    this.traffic = traffic;
    this.obstacles = new ObstacleMap(floor.grid());
    this.standstills = new StandstillTracker(floor.grid());
  }

  /**
   * @param from where the robot is, map frame
   * @param percepts metres, map frame
   */
  List<HistoryLine> addPercepts(String robot, Vec2 from, List<Vec2> percepts, Instant now) {
    List<Vec2> seen = percepts.stream().map(percept -> beyondOwnCell(from, percept)).toList();
    return obstacles.addPercepts(robot, seen, cell -> isOfOther(robot, cell), now).stream()
        .map(
            obstacle ->
                new HistoryLine(
                    EventKind.FLOOR_OBSTACLE,
                    robot,
                    Phrase.SEES_OBSTACLE.with(robot, sentence(obstacle))))
        .toList();
  }

  /** Whether another robot is there, or a load that is known. */
  private boolean isOfOther(String robot, int cell) {
    return underLoads.get(cell)
        || traffic.robotsAt(cell).stream().anyMatch(other -> !other.equals(robot));
  }

  /** What a robot sees in the cell that it is in fills the next one: it cannot be there. */
  private Vec2 beyondOwnCell(Vec2 from, Vec2 percept) {
    Vec2 away = percept.minus(from);
    boolean isInOwnCell = floor.grid().cellAt(percept).equals(floor.grid().cellAt(from));
    double diagonal = Math.sqrt(2) * floor.grid().resolution();
    return isInOwnCell && away.norm() > 0 ? from.plus(away.times(diagonal / away.norm())) : percept;
  }

  /**
   * Tells the traffic which obstacles there are; to be called before it decides.
   *
   * @param loads cells under loads that lie on the floor
   * @param passable by robot, those of the cells that it may go over
   */
  List<HistoryLine> updateObstacles(BitSet loads, Map<String, BitSet> passable, Instant now) {
    List<HistoryLine> lines = new ArrayList<>();
    for (Obstacle gone : obstacles.forgetExpired(now)) {
      lines.add(line(EventKind.FLOOR_OBSTACLE_GONE, gone, Phrase.OBSTACLE_GONE));
    }
    for (Obstacle doubted : obstacles.takeDoubted()) {
      lines.add(line(EventKind.FLOOR_OBSTACLE_DOUBTED, doubted, Phrase.OBSTACLE_DOUBTED));
    }
    underLoads = loads;
    BitSet cells = obstacles.cells();
    cells.or(loads);
    traffic.setObstacles(cells, passable);
    return lines;
  }

  private HistoryLine line(EventKind kind, Obstacle obstacle, Phrase phrase) {
    return new HistoryLine(kind, obstacle.seenBy(), phrase.with(sentence(obstacle)));
  }

  /**
   * Asks the traffic who is at a standstill; to be called after it decided.
   *
   * @param mayStand whether a robot is not expected to move
   */
  List<HistoryLine> updateStandstills(Predicate<String> mayStand) {
    StandstillTracker.Change change =
        standstills.update(
            traffic.standstills().stream()
                .filter(s -> !s.robots().stream().allMatch(mayStand))
                .toList());
    List<HistoryLine> remarks = new ArrayList<>();
    for (StandstillView begun : change.begun()) {
      begun
          .robots()
          .forEach(
              r -> remarks.add(new HistoryLine(EventKind.TRAFFIC_STANDSTILL, r, begun.text())));
    }
    for (StandstillView over : change.ended()) {
      Sentence text = StandstillTracker.endSentence(over);
      over.robots().forEach(r -> remarks.add(new HistoryLine(EventKind.TRAFFIC_RESOLVED, r, text)));
    }
    return remarks;
  }

  /**
   * @param hold as in {@link FloorView}
   * @param kept as in {@link FloorView}
   */
  FloorView view(
      @Nullable Hold hold,
      Map<String, CellRuns> kept,
      List<FaultyCharger> faultyChargers,
      List<LeftLoad> leftLoads,
      @Nullable ChargerShortage chargerShortage,
      List<HeldLoad> heldLoads) {
    return new FloorView(
        floor.name(),
        hold,
        CellRuns.of(obstacles.cells()),
        kept,
        standstills.lasting(),
        faultyChargers,
        leftLoads,
        chargerShortage,
        obstacles.views(),
        heldLoads,
        List.of(),
        floor.version(),
        List.of());
  }

  private Sentence sentence(Obstacle obstacle) {
    return Sentence.of(floor.grid().centre(obstacle.cell()));
  }
}
