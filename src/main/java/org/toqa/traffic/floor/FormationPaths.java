package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DriveSpeeds;

/**
 * Whether formations that stand round one load have a path to its goal on a floor where nobody else
 * is: one that {@link FloorTraffic} finds too. What is found for one is not searched again for
 * another of the same shape that faces elsewhere. Confined to one thread.
 */
public final class FormationPaths {
  /** Metres; shapes that differ by less are the same. */
  private static final double SAME = 1e-6;

  private final OccupancyGrid grid;
  private final BitSet walls;
  private final Vec2 goal;

  /** By shape and margin: states of the leader from where there is none. */
  private final Map<List<Number>, BitSet> dead = new HashMap<>();

  /**
   * @param goal where the load is carried, metres, map frame
   */
  public FormationPaths(OccupancyGrid grid, Vec2 goal) {
    this.grid = grid;
    this.walls = grid.occupied();
    this.goal = goal;
  }

  /**
   * @param leader where it stands, map frame
   */
  public boolean hasPath(FormationFootprint formation, Pose leader) {
    Pose start = FormationPlanner.start(grid, leader);
    double metres = formation.shape().loadAt(start).position().distanceTo(goal);
    return metres < FormationLattice.goalTolerance(grid)
        || FormationPlanner.MARGINS.stream()
            .anyMatch(margin -> hasPath(formation, start, margin));
  }

  private boolean hasPath(FormationFootprint formation, Pose start, double margin) {
    FormationClearance clearance =
        new FormationClearance(grid, formation, start, walls, List.of(), margin);
    BitSet deadStates = dead.computeIfAbsent(key(formation, margin), _ -> new BitSet());
    return FormationPlanner.trajectory(
            grid, formation.shape(), start, goal, DriveSpeeds.DEFAULT, clearance, deadStates)
        .isPresent();
  }

  private static List<Number> key(FormationFootprint formation, double margin) {
    List<Number> key = new ArrayList<>(List.of(margin));
    for (Vec2 offset : formation.shape().offsets()) {
      key.add(Math.round(offset.x() / SAME));
      key.add(Math.round(offset.y() / SAME));
    }
    return key;
  }
}
