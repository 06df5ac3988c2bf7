package org.toqa.fleet.floor;

import java.time.Instant;
import java.util.BitSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Predicate;
import org.toqa.fleet.FloorView.LeftLoad;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.grid.Disc;
import org.toqa.grid.OccupancyGrid;
import org.toqa.mission.Mission;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Loads that ended missions left on the floor. Each keeps robots off the cells that it may cover,
 * whatever its heading, once the robot that set it down is off them; and lets robots come again
 * while one is on its way to fetch it.
 */
final class LeftLoads {
  /** Metres; whoever fetches a load so near to where it lies fetches this one. */
  private static final double SAME_PLACE = 0.05;

  private final OccupancyGrid grid;

  /** By task. */
  private final Map<Long, Entry> loads = new LinkedHashMap<>();

  private record Entry(
      Mission mission, Instant endedAt, Vec2 where, BitSet cells, boolean blocking) {
    Entry withBlocking(boolean next) {
      return new Entry(mission, endedAt, where, cells, next);
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
      loads.put(
          mission.id(), new Entry(mission, at, where.get(), cellsAt(where.get(), mission), false));
    }
  }

  private BitSet cellsAt(Vec2 where, Mission mission) {
    LoadSize size = Objects.requireNonNullElse(mission.task().size(), LoadSize.DEFAULT);
    BitSet cells = new BitSet();
    for (Cell cell : new Disc(Math.hypot(size.length(), size.width()) / 2).cellsAt(grid, where)) {
      cells.set(grid.index(cell));
    }
    return cells;
  }

  /** The ended mission whose load lies on the floor. */
  Optional<Mission> missionOf(long task) {
    return Optional.ofNullable(loads.get(task)).map(Entry::mission);
  }

  /** When the mission ended, whose load lies on the floor. */
  Optional<Instant> endOf(long task) {
    return Optional.ofNullable(loads.get(task)).map(Entry::endedAt);
  }

  /** The ended missions whose loads lie there. */
  List<Mission> at(Vec2 place) {
    return loads.values().stream().filter(load -> isAt(load, place)).map(Entry::mission).toList();
  }

  private static boolean isAt(Entry load, Vec2 place) {
    return load.where().distanceTo(place) < SAME_PLACE;
  }

  /**
   * The cells that robots must not enter now.
   *
   * @param fetched where robots are on their way to fetch loads
   * @param isInUse whether robots are on some of those cells, or may be
   */
  BitSet blockedCells(List<Vec2> fetched, Predicate<BitSet> isInUse) {
    BitSet blocked = new BitSet();
    loads.replaceAll(
        (_, load) ->
            load.withBlocking(
                fetched.stream().noneMatch(place -> isAt(load, place))
                    && (load.blocking() || !isInUse.test(load.cells()))));
    loads.values().stream().filter(Entry::blocking).forEach(load -> blocked.or(load.cells()));
    return blocked;
  }

  List<LeftLoad> views() {
    return loads.values().stream().map(LeftLoads::view).toList();
  }

  private static LeftLoad view(Entry load) {
    Mission mission = load.mission();
    return new LeftLoad(
        mission.id(),
        mission.task().name(),
        load.where(),
        mission.task().size(),
        Phrase.LEFT_LOAD.with(Sentence.of(load.where())));
  }
}
