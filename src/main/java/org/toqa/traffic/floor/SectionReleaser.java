package org.toqa.traffic.floor;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.grid.Cell;
import org.toqa.grid.OccupancyGrid;
import org.toqa.traffic.floor.ReservedPath.Dependency;

/**
 * Lets robots go on: a stretch is released when no other robot holds a cell of it and whoever comes
 * before has left.
 */
final class SectionReleaser {
  private static final Duration SPLIT_CORNER_AFTER = Duration.ofMillis(500);

  /** Released ahead of a robot: at least so many stretches, and so many seconds of driving. */
  private static final int SECTIONS_AHEAD = 2;

  private static final double SECONDS_AHEAD = 3;

  private final SectionFitter fitter;
  private final Map<String, TrafficRobot> robots;
  private final CellAllocations allocations;

  SectionReleaser(
      SectionFitter fitter, Map<String, TrafficRobot> robots, CellAllocations allocations) {
    this.fitter = fitter;
    this.robots = robots;
    this.allocations = allocations;
  }

  void release(TrafficRobot m, Instant now) {
    ReservedPath path = m.path;
    if (path == null || !m.movable || m.stalled) {
      return;
    }
    while (m.released < path.sectionCount() && !isEnoughAhead(m, path)) {
      if (!canEnter(m, path, m.released)) {
        if (!hasWaited(m, now) || !splitCorner(m, path)) {
          return;
        }
        path = Objects.requireNonNull(m.path);
        continue;
      }
      if (m.completed == m.released) {
        m.lastProgress = now;
      }
      allocations.allocate(m, path.sections().get(m.released).cells());
      m.released++;
      m.blockedSince = null;
      m.blockedReason = null;
    }
  }

  private static boolean isEnoughAhead(TrafficRobot m, ReservedPath path) {
    double seconds = 0;
    for (int i = m.completed; i < m.released; i++) {
      seconds += path.sections().get(i).duration();
    }
    return m.released - m.completed >= SECTIONS_AHEAD && seconds >= SECONDS_AHEAD;
  }

  private boolean canEnter(TrafficRobot m, ReservedPath path, int index) {
    Section section = path.sections().get(index);
    Vec2 where = section.end().position();
    for (TrafficRobot other : allocations.otherHolders(m, section.cells())) {
      if (m.isDriving() || !Clearance.isKept(m, m.releasedEnd(), section, other)) {
        m.blockedReason = new WaitReason.RobotPassing(other.name, where);
        return false;
      }
    }
    if (index < path.inherited() || !path.isShared()) {
      return true;
    }
    int last = path.visitAfterSections(index + 1);
    for (int v = path.visitAfterSections(index) + 1; v <= last; v++) {
      Dependency dependency = path.dependencies().get(v);
      if (dependency != null && !isOver(dependency)) {
        m.blockedReason = new WaitReason.RobotPassing(dependency.robot(), where);
        return false;
      }
    }
    return true;
  }

  private boolean isOver(Dependency dependency) {
    TrafficRobot other = robots.get(dependency.robot());
    return other == null
        || other.pathNumber != dependency.pathNumber()
        || other.path == null
        || other.path.visitAfterSections(other.completed) > dependency.visit();
  }

  /** Whether it has stood before the stretch for a little. */
  private static boolean hasWaited(TrafficRobot m, Instant now) {
    if (m.completed < m.released) {
      return false;
    }
    if (m.blockedSince == null) {
      m.blockedSince = now;
    }
    return m.blockedSince.plus(SPLIT_CORNER_AFTER).isBefore(now);
  }

  /**
   * A corner that is rounded needs the cells before and behind it at once; a robot that has waited
   * for both drives up to the corner, turns there on the spot, and so needs one at a time.
   */
  private boolean splitCorner(TrafficRobot m, ReservedPath path) {
    int index = m.released;
    OccupancyGrid lattice = path.lattice();
    if (lattice == null || index < path.inherited()) {
      return false;
    }
    int from = path.visitAfterSections(index);
    int until = path.visitAfterSections(index + 1);
    if (until - from < 2) {
      return false;
    }
    List<Cell> visits = path.visits();
    Pose pose = path.poseAfter(index);
    List<Waypoint> waypoints =
        JointPlan.waypointsFromCentre(lattice, visits, from, v -> v > from && v < until);
    List<Section> sections =
        fitter.fit(
            m, pose, waypoints, lattice.resolution(), new PassingPlaces.CellCentres(lattice));
    m.path =
        path.withSectionsFrom(
            index, sections, JointPlan.visitsAtEnds(lattice, pose, sections, visits, from));
    m.isChangeUnsent = true;
    m.blockedSince = null;
    return true;
  }
}
