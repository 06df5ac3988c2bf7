package org.toqa.formation.swarm;

import java.util.HashMap;
import java.util.Map;
import org.toqa.geometry.Vec2;

/**
 * Leaves loops by memory instead of chance: where the virtual leader comes again to a place in the
 * same direction, after a way that is long enough for a loop, the swarm has been led round. From
 * there it does not turn toward the target for a detour, which doubles with each time, and so gets
 * out of what it was held by.
 *
 * @param square metres: places nearer than that are one
 * @param visits when each place was last come to in each direction, and how many loops led there
 * @param here the place and direction now
 * @param driven metres so far
 * @param detour metres for which the swarm still goes straight on where it sees nothing
 */
public record LoopMemory(
    double square, Map<Place, Visit> visits, Place here, double driven, double detour) {

  private static final int SECTORS = 8;

  /** The longest detour is the first one, doubled so often. */
  private static final int MOST_DOUBLINGS = 5;

  /** Squares that a loop is long at least. */
  private static final int SHORTEST_LOOP = 6;

  /** A place and a direction, as numbers of squares and of an eighth of a turn. */
  public record Place(int column, int row, int sector) {}

  /**
   * @param at metres driven when the swarm was there last
   * @param loops that led there
   */
  public record Visit(double at, int loops) {}

  public LoopMemory {
    visits = Map.copyOf(visits);
  }

  /** Before the first step. */
  public static LoopMemory empty(double square) {
    return new LoopMemory(square, Map.of(), new Place(0, 0, -1), 0, 0);
  }

  /**
   * After a step.
   *
   * @param leader metres, map frame
   * @param direction of motion, radians
   * @param step metres in this step
   */
  public LoopMemory next(Vec2 leader, double direction, double step) {
    double way = driven + step;
    double left = Math.max(0, detour - step);
    int sector = Math.floorMod((int) Math.rint(direction / (2 * Math.PI) * SECTORS), SECTORS);
    Place place =
        new Place(
            (int) Math.floor(leader.x() / square), (int) Math.floor(leader.y() / square), sector);
    if (place.equals(here)) {
      return new LoopMemory(square, visits, here, way, left);
    }
    Visit last = visits.get(place);
    boolean isLoop = last != null && way - last.at() > SHORTEST_LOOP * square;
    int loops = (last == null ? 0 : last.loops()) + (isLoop ? 1 : 0);
    Map<Place, Visit> known = new HashMap<>(visits);
    known.put(place, new Visit(way, loops));
    double added = isLoop ? square * (1 << Math.min(MOST_DOUBLINGS, loops)) : 0;
    return new LoopMemory(square, known, place, way, Math.max(left, added));
  }

  /** Whether the swarm goes straight on where it sees nothing. */
  public boolean isDetour() {
    return detour > 0;
  }
}
