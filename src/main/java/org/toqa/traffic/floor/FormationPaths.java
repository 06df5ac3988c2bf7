package org.toqa.traffic.floor;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.formation.Shape;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Margins;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DriveSpeeds;
import org.toqa.motion.Trajectory;

/**
 * Whether formations that stand round one load have a path to its goal on a floor where nobody else
 * is: one that {@link FloorTraffic} finds too. What is found for one is not searched again for
 * another of the same shape that faces elsewhere. Confined to one thread.
 */
public final class FormationPaths {
  /** Metres; shapes that differ by less are the same. */
  private static final double SAME = 1e-6;

  private final OccupancyGrid grid;
  private final Margins margins;
  private final BitSet walls;
  private final Vec2 goal;

  /** By shape, margin, and whether it may shift: states of the leader from where there is none. */
  private final Map<List<Number>, BitSet> dead = new HashMap<>();

  /** Where the load was nearest to the goal in what was searched in vain, metres, map frame. */
  private @Nullable Vec2 nearest;

  /**
   * @param goal where the load is carried, metres, map frame
   */
  public FormationPaths(OccupancyGrid grid, Margins margins, Vec2 goal) {
    this.grid = grid;
    this.margins = margins;
    this.walls = grid.occupied();
    this.goal = goal;
  }

  /**
   * @param leader where it stands, map frame
   * @param shifting whether it may be led sideways, where it can be
   */
  public boolean hasPath(FormationFootprint formation, Pose leader, boolean shifting) {
    Pose start = FormationPlanner.start(grid, leader);
    return isAtGoal(formation, start)
        || rules(formation, shifting)
            .anyMatch(rules -> searchBeyondDead(formation, start, rules).isPresent());
  }

  /**
   * Where the leader stands at the end of the path to the goal that {@link FormationPlanner} finds
   * on an empty floor; empty: there is none.
   *
   * @param leader where it stands, map frame
   * @param shifting whether it may be led sideways, where it can be
   */
  public Optional<Pose> endOfPath(FormationFootprint formation, Pose leader, boolean shifting) {
    Pose start = FormationPlanner.start(grid, leader);
    return isAtGoal(formation, start)
        ? Optional.of(start)
        : rules(formation, shifting)
            .flatMap(rules -> endOfPath(formation, start, rules).stream())
            .findFirst();
  }

  private boolean isAtGoal(FormationFootprint formation, Pose leader) {
    return formation.shape().loadAt(leader).position().distanceTo(goal)
        < FormationLattice.goalTolerance(grid);
  }

  private Stream<FormationPlanner.Rules> rules(FormationFootprint formation, boolean shifting) {
    return FormationPlanner.rules(margins, shifting && formation.shape().mobility().canShift());
  }

  /** Of paths that are alike it depends on all that is searched which one is found. */
  private Optional<Pose> endOfPath(
      FormationFootprint formation, Pose start, FormationPlanner.Rules rules) {
    return searchBeyondDead(formation, start, rules)
        .flatMap(_ -> search(formation, start, rules, new BitSet()))
        .map(Trajectory::end);
  }

  private Optional<Trajectory> searchBeyondDead(
      FormationFootprint formation, Pose start, FormationPlanner.Rules rules) {
    BitSet deadStates = dead.computeIfAbsent(key(formation, rules), _ -> new BitSet());
    Optional<Trajectory> path = search(formation, start, rules, deadStates);
    if (path.isEmpty()) {
      recordNearest(formation.shape(), deadStates);
    }
    return path;
  }

  private Optional<Trajectory> search(
      FormationFootprint formation, Pose start, FormationPlanner.Rules rules, BitSet deadStates) {
    FormationClearance clearance =
        new FormationClearance(
            grid, formation, start, walls, List.of(), margins.formation(), rules.margin());
    return FormationPlanner.trajectory(
        grid,
        formation.shape(),
        start,
        goal,
        DriveSpeeds.DEFAULT,
        clearance,
        rules.shifting(),
        deadStates);
  }

  private void recordNearest(Shape shape, BitSet states) {
    FormationLattice lattice = FormationLattice.of(grid);
    for (int state = states.nextSetBit(0); state >= 0; state = states.nextSetBit(state + 1)) {
      Vec2 load = shape.loadAt(lattice.pose(state)).position();
      if (nearest == null || load.distanceTo(goal) < nearest.distanceTo(goal)) {
        nearest = load;
      }
    }
  }

  /**
   * Where the load comes nearest to the goal, metres, map frame; empty where no formation that was
   * asked about can move at all.
   */
  public Optional<Vec2> nearest() {
    return Optional.ofNullable(nearest);
  }

  /** Whether there is room for the formation at the goal, in some heading. */
  public boolean hasRoomAtGoal(FormationFootprint formation) {
    FormationLattice lattice = FormationLattice.of(grid);
    double tolerance = FormationLattice.goalTolerance(grid);
    boolean[] hasRoom = {false};
    lattice.forEachPointAround(
        goal,
        formation.shape().leader().norm() + tolerance,
        (column, row) -> {
          for (int heading = 0; heading < 8 && !hasRoom[0]; heading++) {
            Pose leader = lattice.pose(lattice.state(column, row, heading));
            hasRoom[0] =
                formation.shape().loadAt(leader).position().distanceTo(goal) < tolerance
                    && formation.isClearOf(grid, leader, margins.formation(), walls);
          }
        });
    return hasRoom[0];
  }

  /** Metres that a passage must be wide so that the formation comes through. */
  public double passageWidth(FormationFootprint formation) {
    return formation.width() + 2 * margins.formation();
  }

  private static List<Number> key(FormationFootprint formation, FormationPlanner.Rules rules) {
    List<Number> key = new ArrayList<>(List.of(rules.margin(), rules.shifting() ? 1 : 0));
    for (Vec2 offset : formation.shape().offsets()) {
      key.add(Math.round(offset.x() / SAME));
      key.add(Math.round(offset.y() / SAME));
    }
    return key;
  }
}
