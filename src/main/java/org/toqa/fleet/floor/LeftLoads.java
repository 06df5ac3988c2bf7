package org.toqa.fleet.floor;

import java.time.Instant;
import java.util.BitSet;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.FloorView.BoxView;
import org.toqa.fleet.FloorView.LeftLoad;
import org.toqa.fleet.LoadView;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.Disc;
import org.toqa.grid.OccupancyGrid;
import org.toqa.mission.ArmHandling;
import org.toqa.mission.Mission;
import org.toqa.mission.TransportTask;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.traffic.floor.FloorTraffic;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Loads that ended missions left on the floor, and boxes that a supervisor saw there. Each keeps
 * robots off the cells that it may cover, whatever its heading: all but those that stand there, as
 * the one that set it down does, and those that fetch it.
 */
final class LeftLoads {
  private static final BitSet NO_CELLS = new BitSet();

  private final OccupancyGrid grid;

  /** By task. */
  private final Map<Long, Load> loads = new LinkedHashMap<>();

  private Map<Integer, Box> boxes = Map.of();

  private final Map<String, BitSet> passable = new HashMap<>();

  /** What lies on the floor. */
  private sealed interface Lying {
    Vec2 where();

    BitSet cells();

    boolean isFetchedBy(Mission mission);
  }

  private record Load(Mission mission, Instant endedAt, Vec2 where, BitSet cells) implements Lying {
    @Override
    public boolean isFetchedBy(Mission other) {
      TransportTask left = mission.task();
      return where.distanceTo(other.object().position()) < LoadView.SAME_PLACE
          && other.task().hasLoadOf(left.load(), left.size());
    }
  }

  private record Box(int number, Vec2 where, BitSet cells) implements Lying {
    @Override
    public boolean isFetchedBy(Mission mission) {
      ArmHandling arm = mission.task().arm();
      Vec2 fetched = arm == null ? mission.object().position() : arm.pick();
      return where.distanceTo(fetched) < LoadView.SAME_PLACE;
    }
  }

  LeftLoads(OccupancyGrid grid) {
    this.grid = grid;
  }

  /**
   * The mission is so now: it left a load, has none on the floor any more, or never had.
   *
   * @param at when it ended
   */
  void update(Mission mission, Instant at) {
    Optional<Vec2> where = mission.leftLoad().map(place -> place.position());
    if (where.isEmpty()) {
      loads.remove(mission.id());
    } else {
      LoadSize size = Objects.requireNonNullElse(mission.task().size(), LoadSize.DEFAULT);
      loads.put(mission.id(), new Load(mission, at, where.get(), cellsAt(where.get(), size)));
    }
  }

  /** These lie there now, instead of those before; delivered ones are in nobody's way any more. */
  void setBoxes(List<BoxView> seen) {
    Map<Integer, Box> next = new LinkedHashMap<>();
    for (BoxView box : seen) {
      if (!box.delivered()) {
        Box known = boxes.get(box.box());
        next.put(
            box.box(),
            known != null && known.where().equals(box.where())
                ? known
                : new Box(box.box(), box.where(), cellsAt(box.where(), LoadSize.DEFAULT)));
      }
    }
    boxes = next;
  }

  /** Whether none lie there, and no robot is still said to go over some. */
  boolean isEmpty() {
    return isNone() && passable.isEmpty();
  }

  private boolean isNone() {
    return loads.isEmpty() && boxes.isEmpty();
  }

  private Stream<Lying> all() {
    return Stream.concat(loads.values().stream(), boxes.values().stream());
  }

  private BitSet cellsAt(Vec2 where, LoadSize size) {
    BitSet cells = new BitSet();
    for (Cell cell : new Disc(Math.hypot(size.length(), size.width()) / 2).cellsAt(grid, where)) {
      cells.set(grid.index(cell));
    }
    return cells;
  }

  /** The ended mission whose load lies on the floor. */
  Optional<Mission> missionOf(long task) {
    return Optional.ofNullable(loads.get(task)).map(Load::mission);
  }

  /** When the mission ended, whose load lies on the floor. */
  Optional<Instant> endOf(long task) {
    return Optional.ofNullable(loads.get(task)).map(Load::endedAt);
  }

  /** The ended mission whose load, of the same weight and size, lies where it fetches its own. */
  List<Mission> fetchedBy(Mission mission) {
    return loads.values().stream()
        .filter(load -> load.isFetchedBy(mission))
        .map(Load::mission)
        .limit(1)
        .toList();
  }

  /** The task whose load may cover that place. */
  Optional<Long> taskAt(Vec2 place) {
    return loads.values().stream()
        .filter(load -> isOn(load, place))
        .map(load -> load.mission().id())
        .findFirst();
  }

  /** The box that may cover that place. */
  Optional<Integer> boxAt(Vec2 place) {
    return boxes.values().stream().filter(box -> isOn(box, place)).map(Box::number).findFirst();
  }

  /** The cells that they may cover. */
  BitSet cells() {
    BitSet cells = new BitSet();
    all().forEach(lying -> cells.or(lying.cells()));
    return cells;
  }

  /** By robot, those of the cells that it may go over. */
  Map<String, BitSet> passable() {
    return passable;
  }

  /**
   * A robot may go over a load that it fetches; and out of one that it stands in until it is off
   * it, away from its middle.
   *
   * @param fetching for which it fetches a load; null: it fetches none
   */
  void updatePassable(String robot, @Nullable Mission fetching, FloorTraffic traffic) {
    BitSet before = passable.getOrDefault(robot, NO_CELLS);
    BitSet now = new BitSet();
    for (Lying load : all().toList()) {
      if (fetching != null && load.isFetchedBy(fetching)) {
        now.or(load.cells());
      } else if (before.intersects(load.cells())
          && (traffic.standingCells(robot).intersects(load.cells())
              || traffic.isAhead(robot, load.cells()))) {
        BitSet same = (BitSet) before.clone();
        same.and(load.cells());
        now.or(same);
      } else if (isOn(load, traffic.position(robot))) {
        now.or(outward(load, traffic.position(robot), traffic.standingCells(robot)));
      }
    }
    if (now.isEmpty()) {
      passable.remove(robot);
    } else {
      passable.put(robot, now);
    }
  }

  /** A robot may say that it is beside the map. */
  private boolean isOn(Lying load, Vec2 place) {
    Cell cell = grid.cellAt(place);
    return grid.contains(cell) && load.cells().get(grid.index(cell));
  }

  /** Forgets robots that are here no more. */
  void keepRobots(Set<String> robots) {
    passable.keySet().retainAll(robots);
  }

  /** The cells that are no nearer to the load's middle than a robot, and those that it is on. */
  private BitSet outward(Lying load, Vec2 robot, BitSet standing) {
    double from = load.where().distanceTo(robot);
    BitSet cells = (BitSet) standing.clone();
    cells.and(load.cells());
    load.cells().stream()
        .filter(cell -> load.where().distanceTo(grid.centre(grid.cell(cell))) >= from)
        .forEach(cells::set);
    return cells;
  }

  /** Whether one that the robot may not go over is on what it has been told to drive. */
  boolean isAhead(String robot, FloorTraffic traffic) {
    if (isNone()) {
      return false;
    }
    BitSet cells = cells();
    cells.andNot(passable.getOrDefault(robot, NO_CELLS));
    return !cells.isEmpty() && traffic.isAhead(robot, cells);
  }

  List<LeftLoad> views() {
    return loads.values().stream().map(LeftLoads::view).toList();
  }

  private static LeftLoad view(Load load) {
    Mission mission = load.mission();
    return new LeftLoad(
        mission.id(),
        mission.loadRecord(),
        mission.task().name(),
        mission.task().load(),
        load.where(),
        mission.task().size(),
        Phrase.LEFT_LOAD.with(Sentence.of(load.where())));
  }
}
