package org.toqa.formation.swarm;

import java.util.HashMap;
import java.util.Map;
import org.toqa.geometry.Vec2;

/**
 * Leaves loops by memory instead of chance: where the virtual leader comes again to a place in the
 * same direction, the swarm has been led round. From there it does not turn toward the target for a
 * detour, which doubles with each time, and so gets out of what it was held by.
 *
 * @param square metres: places nearer than that are one
 * @param visits how often each place was come to in each direction
 * @param here the place and direction now
 * @param detour metres for which the swarm still goes straight on where it sees nothing
 */
public record LoopMemory(double square, Map<Visit, Integer> visits, Visit here, double detour) {

  private static final int SECTORS = 8;

  /** The longest detour is the first one, doubled so often. */
  private static final int MOST_DOUBLINGS = 5;

  /** A place and a direction, as numbers of squares and of an eighth of a turn. */
  public record Visit(int column, int row, int sector) {}

  public LoopMemory {
    visits = Map.copyOf(visits);
  }

  /** Before the first step. */
  public static LoopMemory empty(double square) {
    return new LoopMemory(square, Map.of(), new Visit(0, 0, -1), 0);
  }

  /**
   * After a step.
   *
   * @param leader metres, map frame
   * @param direction of motion, radians
   * @param driven metres in this step
   */
  public LoopMemory next(Vec2 leader, double direction, double driven) {
    double left = Math.max(0, detour - driven);
    int sector = Math.floorMod((int) Math.rint(direction / (2 * Math.PI) * SECTORS), SECTORS);
    Visit visit =
        new Visit(
            (int) Math.floor(leader.x() / square), (int) Math.floor(leader.y() / square), sector);
    if (visit.equals(here)) {
      return new LoopMemory(square, visits, here, left);
    }
    Map<Visit, Integer> counted = new HashMap<>(visits);
    int before = counted.merge(visit, 1, Integer::sum) - 1;
    double added =
        before == 0 ? left : Math.max(left, square * (1 << Math.min(MOST_DOUBLINGS, before)));
    return new LoopMemory(square, counted, visit, added);
  }

  /** Whether the swarm goes straight on where it sees nothing. */
  public boolean isDetour() {
    return detour > 0;
  }
}
