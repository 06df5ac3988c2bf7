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
import org.toqa.traffic.floor.Course.Wait;

/**
 * Lets robots go on: a stretch is released when no other robot holds a cell of it and whoever comes
 * before has left.
 */
final class Releases {
  private static final Duration BREAK_AFTER = Duration.ofMillis(500);

  /** Released ahead of a robot: at least so many stretches, and so many seconds of driving. */
  private static final int STRETCHES_AHEAD = 2;

  private static final double SECONDS_AHEAD = 3;

  private final CourseFitter fitter;
  private final Map<String, Mover> movers;
  private final Holdings holdings;

  Releases(CourseFitter fitter, Map<String, Mover> movers, Holdings holdings) {
    this.fitter = fitter;
    this.movers = movers;
    this.holdings = holdings;
  }

  void release(Mover m, Instant now) {
    Course course = m.course;
    if (course == null || !m.movable || m.stalled) {
      return;
    }
    while (m.released < course.size() && !isEnoughAhead(m, course)) {
      if (!mayEnter(m, course, m.released)) {
        if (!hasWaited(m, now) || !breakCorner(m, course)) {
          return;
        }
        course = Objects.requireNonNull(m.course);
        continue;
      }
      if (m.done == m.released) {
        m.lastProgress = now;
      }
      holdings.add(m, course.stretches().get(m.released).cells());
      m.released++;
      m.blockedSince = null;
      m.obstruction = null;
    }
  }

  private static boolean isEnoughAhead(Mover m, Course course) {
    double seconds = 0;
    for (int i = m.done; i < m.released; i++) {
      seconds += course.stretches().get(i).duration();
    }
    return m.released - m.done >= STRETCHES_AHEAD && seconds >= SECONDS_AHEAD;
  }

  private boolean mayEnter(Mover m, Course course, int index) {
    Stretch stretch = course.stretches().get(index);
    Vec2 where = stretch.end().position();
    for (Mover other : holdings.others(m, stretch.cells())) {
      if (m.isDriving() || !Clearance.isKept(m, m.releasedEnd(), stretch, other)) {
        m.obstruction = new Hindrance.Passing(other.name, where);
        return false;
      }
    }
    if (index < course.base() || !course.isShared()) {
      return true;
    }
    int last = course.visitAfterStretches(index + 1);
    for (int v = course.visitAfterStretches(index) + 1; v <= last; v++) {
      Wait wait = course.waits().get(v);
      if (wait != null && !isOver(wait)) {
        m.obstruction = new Hindrance.Passing(wait.robot(), where);
        return false;
      }
    }
    return true;
  }

  private boolean isOver(Wait wait) {
    Mover other = movers.get(wait.robot());
    return other == null
        || other.courseNumber != wait.course()
        || other.course == null
        || other.course.visitAfterStretches(other.done) > wait.visit();
  }

  /** Whether it has stood before the stretch for a little. */
  private static boolean hasWaited(Mover m, Instant now) {
    if (m.done < m.released) {
      return false;
    }
    if (m.blockedSince == null) {
      m.blockedSince = now;
    }
    return m.blockedSince.plus(BREAK_AFTER).isBefore(now);
  }

  /**
   * A corner that is rounded needs the cells before and behind it at once; a robot that has waited
   * for both drives up to the corner, turns there on the spot, and so needs one at a time.
   */
  private boolean breakCorner(Mover m, Course course) {
    int index = m.released;
    OccupancyGrid lattice = course.lattice();
    if (lattice == null || index < course.base()) {
      return false;
    }
    int from = course.visitAfterStretches(index);
    int until = course.visitAfterStretches(index + 1);
    if (until - from < 2) {
      return false;
    }
    List<Cell> visits = course.visits();
    Pose pose = course.poseAfter(index);
    List<Waypoint> way = JointPlan.fromMiddle(lattice, visits, from, v -> v > from && v < until);
    List<Stretch> stretches =
        fitter.fit(m, pose, way, lattice.resolution(), new Halts.Middles(lattice));
    m.course =
        course.redriven(
            index, stretches, JointPlan.visitsAfter(lattice, pose, stretches, visits, from));
    m.redriven = true;
    m.blockedSince = null;
    return true;
  }
}
