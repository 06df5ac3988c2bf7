package org.toqa.traffic.floor;

import java.util.BitSet;
import java.util.List;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Disc;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.Segment;
import org.toqa.motion.Trajectory;

/**
 * What a formation keeps clear of on one path. It may have been stopped anywhere, a little beside
 * where it should be: what it touches already it comes no nearer to until it is on the lattice.
 */
final class FormationClearance {
  /** Of the margin, metres, that may be missing between two places where it is looked at. */
  private static final double MOST_BULGE = 0.02;

  /** Metres from the start. */
  private static final double AROUND_START = 1.5;

  /** Metres; what it would have to be deeper in is no wall: something was seen under it. */
  private static final double DEEPEST = 0.08;

  /** Metres. */
  private static final double ROUNDING = 1e-3;

  private final OccupancyGrid grid;
  private final FormationFootprint formation;

  /** With the margin that it keeps where it enters the lattice. */
  private final FormationFootprint entering;

  /** What of it must nowhere touch anything. */
  private final FormationFootprint touching;

  /** Walls and obstacles. */
  private final BitSet solid;

  /** What others have or will need. */
  private final AreaIndex claimed;

  /** The cells in which it may come too near to these. */
  private final BitSet nearClaimed = new BitSet();

  /** What it covers where it is. */
  private final SweptArea standing;

  private final Pose start;
  private final double margin;
  private final double marginAtStart;

  /**
   * @param start of the leader, map frame
   * @param blocked walls and obstacles
   * @param claimedByOthers what others have or will need
   * @param margin kept from walls while a path is looked for, metres
   * @param marginAtStart kept from walls round the start, metres
   */
  FormationClearance(
      OccupancyGrid grid,
      FormationFootprint formation,
      Pose start,
      BitSet blocked,
      List<SweptArea> claimedByOthers,
      double margin,
      double marginAtStart) {
    this.grid = grid;
    this.margin = margin;
    this.formation = formation;
    this.start = start;
    this.marginAtStart = marginAtStart;
    this.solid = (BitSet) blocked.clone();
    this.claimed = new AreaIndex(claimedByOthers);
    claimedByOthers.forEach(area -> area.cells(grid, Clearance.BETWEEN_ROBOTS).addTo(nearClaimed));
    this.standing = SweptArea.at(formation.discs(start));
    double kept = marginAtStart - lack(start);
    this.entering = formation.widened(kept);
    this.touching = formation.widened(Math.min(0, kept));
  }

  /** So much of the margin it lacks where it is, metres; what it is deep in is solid no more. */
  private double lack(Pose start) {
    double lack = 0;
    for (PlacedDisc disc : formation.discs(start)) {
      double reach = disc.radius() + marginAtStart;
      BitSet touched = new BitSet();
      SweptArea.at(disc.centre(), reach).cells(grid, 0).addTo(touched);
      touched.and(solid);
      for (int i = touched.nextSetBit(0); i >= 0; i = touched.nextSetBit(i + 1)) {
        double gap = Disc.distanceToCell(grid, disc.centre(), grid.cell(i));
        if (disc.radius() - gap > DEEPEST) {
          solid.clear(i);
        } else {
          lack = Math.max(lack, reach - gap + ROUNDING);
        }
      }
    }
    return lack;
  }

  /** Whether it can be there on its way, with a margin. */
  boolean isKeptAt(Pose leader) {
    return isKeptAt(Vec2.ZERO, formation.placement(leader));
  }

  /**
   * @param beside from where the placement is told, metres, map frame
   */
  boolean isKeptAt(Vec2 beside, FormationFootprint.Placement placement) {
    Pose leader = placement.leader();
    double east = beside.x() + leader.x() - start.x();
    double north = beside.y() + leader.y() - start.y();
    boolean isAroundStart = east * east + north * north < AROUND_START * AROUND_START;
    double kept = isAroundStart ? marginAtStart : margin;
    return formation.isClearOf(grid, beside, placement, kept, solid)
        && (formation.isClearOf(grid, beside, placement, 0, nearClaimed)
            || isOffClaimed(
                SweptArea.at(
                    formation.discs(
                        new Pose(
                            beside.x() + leader.x(), beside.y() + leader.y(), leader.theta())))));
  }

  /** The formation as it is where its leader is at a pose, which may be told from any point. */
  FormationFootprint.Placement placement(Pose leader) {
    return formation.placement(leader);
  }

  private boolean isOffClaimed(SweptArea area) {
    return claimed.isKept(standing, area);
  }

  /**
   * How far apart it may be looked at, metres, so that the margin covers what is between: a disc of
   * radius r bulges by d * d / (8 r) beyond two of them that are d apart.
   */
  double spacing() {
    return Math.sqrt(8 * formation.smallestRadius() * Math.min(MOST_BULGE, marginAtStart));
  }

  /** Whether it can be led along that from where it is, and comes no nearer than it is. */
  boolean isKeptOnEntry(Trajectory trajectory) {
    return isOff(entering, trajectory);
  }

  /** Whether it touches nothing on that, which begins where it is. */
  boolean isKeptOn(Trajectory trajectory) {
    return isOff(touching, trajectory);
  }

  private boolean isOff(FormationFootprint footprint, Trajectory trajectory) {
    Pose pose = trajectory.start();
    for (Segment segment : trajectory.segments()) {
      if (footprint.sweptArea(pose, segment).cells(grid, 0).intersects(solid)
          || !isOffClaimed(formation.sweptArea(pose, segment))) {
        return false;
      }
      pose = pose.advanced(segment.twist(), segment.t());
    }
    return true;
  }
}
