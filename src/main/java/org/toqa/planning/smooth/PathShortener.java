package org.toqa.planning.smooth;

import java.util.function.BooleanSupplier;

/**
 * Pulls a path taut: it leaves out way points that are not needed, slides the others along their
 * legs as far as the legs stay free, and cuts corners, so that the line hugs a wall's corner with
 * several small bends. What comes out cannot be shortened by moving one way point; it is the
 * shortest path of those that go round the same obstacles on the same sides, up to the small bends.
 */
final class PathShortener {
  /** Halvings by which the end of what is free is found: a share of 1/4096 of a leg. */
  private static final int HALVINGS = 12;

  /** Corners below this angle, radians, are not cut. */
  private static final double SMALLEST_CUT = Math.toRadians(14);

  /** Cells along both legs; what is shorter is not cut. */
  private static final double SHORTEST_LEG = 1e-3;

  /** A round that shortens the path by a smaller share was the last. */
  private static final double ENOUGH = 2e-6;

  private final DiscSpace space;
  private final BooleanSupplier isOver;

  /**
   * @param isOver whether to leave a path as it is by now; it is free at any time
   */
  PathShortener(DiscSpace space, BooleanSupplier isOver) {
    this.space = space;
    this.isOver = isOver;
  }

  /** Leaves out and slides way points, once each; no corner is cut. The path must be free. */
  void shorten(WayPoints path) {
    leaveOut(path);
    slideAll(path);
  }

  /** Pulls it taut, in up to so many rounds. The path must be free. */
  void pullTaut(WayPoints path, int rounds) {
    double before = path.length();
    for (int round = 0; round < rounds && !isOver.getAsBoolean(); round++) {
      cutCorners(path);
      slideAll(path);
      double after = path.length();
      if (before - after < ENOUGH * before && round > 1) {
        return;
      }
      before = after;
    }
  }

  /** From each way point the line goes to the last one that is seen from it. */
  private void leaveOut(WayPoints path) {
    for (int i = 0; i + 2 < path.size() && !isOver.getAsBoolean(); i++) {
      int seen = i + 1;
      int step = 1;
      while (seen + step < path.size() && isFree(path, i, seen + step)) {
        seen += step;
        step *= 2;
      }
      for (; step > 0; step /= 2) {
        if (seen + step < path.size() && isFree(path, i, seen + step)) {
          seen += step;
        }
      }
      path.remove(i + 1, seen);
    }
  }

  private boolean isFree(WayPoints path, int from, int to) {
    return space.isFree(path.x(from), path.y(from), path.x(to), path.y(to));
  }

  private void slideAll(WayPoints path) {
    for (int i = 1; i + 1 < path.size() && !isOver.getAsBoolean(); i++) {
      if (isFree(path, i - 1, i + 1)) {
        path.remove(i, i + 1);
        i = Math.max(0, i - 2);
      } else {
        slide(path, i, i - 1, i + 1);
        slide(path, i, i + 1, i - 1);
      }
    }
  }

  /** Slides a way point toward one neighbour as far as the line to the other one stays free. */
  private void slide(WayPoints path, int index, int toward, int other) {
    double fromX = path.x(index);
    double fromY = path.y(index);
    double alongX = path.x(toward) - fromX;
    double alongY = path.y(toward) - fromY;
    double free = 0;
    double blocked = 1;
    for (int i = 0; i < HALVINGS; i++) {
      double middle = (free + blocked) / 2;
      if (space.isFree(
          fromX + middle * alongX, fromY + middle * alongY, path.x(other), path.y(other))) {
        free = middle;
      } else {
        blocked = middle;
      }
    }
    path.set(index, fromX + free * alongX, fromY + free * alongY);
  }

  private void cutCorners(WayPoints path) {
    for (int i = 1; i + 1 < path.size() && !isOver.getAsBoolean(); i++) {
      double before = path.leg(i);
      double after = path.leg(i + 1);
      if (Math.min(before, after) > SHORTEST_LEG && bend(path, i, before, after) > SMALLEST_CUT) {
        i += cut(path, i, Math.min(before, after) / 2);
      }
    }
  }

  /** Radians between the legs before and after a way point. */
  private static double bend(WayPoints path, int index, double before, double after) {
    double cos =
        ((path.x(index) - path.x(index - 1)) * (path.x(index + 1) - path.x(index))
                + (path.y(index) - path.y(index - 1)) * (path.y(index + 1) - path.y(index)))
            / (before * after);
    return Math.acos(Math.clamp(cos, -1, 1));
  }

  /**
   * Puts two way points for one, equally far from it on both legs, as far as their line is free.
   *
   * @param most cells from the corner
   * @return how many way points there are more
   */
  private int cut(WayPoints path, int index, double most) {
    double x = path.x(index);
    double y = path.y(index);
    double before = path.leg(index);
    double after = path.leg(index + 1);
    double backX = (path.x(index - 1) - x) / before;
    double backY = (path.y(index - 1) - y) / before;
    double onX = (path.x(index + 1) - x) / after;
    double onY = (path.y(index + 1) - y) / after;
    double free = 0;
    double blocked = 2 * most;
    for (int i = 0; i < HALVINGS; i++) {
      double middle = (free + blocked) / 2;
      if (space.isFree(
          x + middle * backX, y + middle * backY, x + middle * onX, y + middle * onY)) {
        free = middle;
      } else {
        blocked = middle;
      }
    }
    double cut = Math.min(free, most);
    if (cut <= SHORTEST_LEG / 4) {
      return 0;
    }
    path.set(index, x + cut * backX, y + cut * backY);
    path.insert(index + 1, x + cut * onX, y + cut * onY);
    return 1;
  }
}
