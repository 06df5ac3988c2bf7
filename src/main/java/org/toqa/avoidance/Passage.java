package org.toqa.avoidance;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.toqa.avoidance.Corridor.Place;
import org.toqa.geometry.Vec2;

/**
 * How a robot gets through a corridor among the things that it sees. Only what it would come too
 * near to counts: a wall beside its path does not, however near.
 *
 * @param blocking what it must stop before, map frame
 * @param beside what it can pass by stepping aside, map frame
 * @param ahead metres from the robot's rim, along its path, to the nearest that blocks; infinite
 *     where nothing does
 */
public record Passage(List<Vec2> blocking, List<Vec2> beside, double ahead) {

  /** Metres between robot and things that it passes. */
  public static final double CLEARANCE = 0.01;

  /**
   * Metres between robot and what it stops before: room to turn away, and on a map with cells of
   * 0.30 m what it sees is in another cell than its own middle.
   */
  public static final double STOP_GAP = 0.18;

  public Passage {
    blocking = List.copyOf(blocking);
    beside = List.copyOf(beside);
  }

  /** Metres that it may still go, at least 0. */
  public double freeDistance() {
    return Math.max(0, ahead - STOP_GAP);
  }

  /** Whether a point is one of those that count. */
  public boolean isRelevant(Vec2 point) {
    return blocking.contains(point) || beside.contains(point);
  }

  /**
   * How a robot gets through.
   *
   * @param seen points, metres, map frame
   * @param radius of the robot, metres
   * @param mostAside metres that it can step aside
   */
  public static Passage through(
      Corridor corridor, List<Vec2> seen, double radius, double mostAside) {
    List<Vec2> blocking = new ArrayList<>();
    List<Vec2> beside = new ArrayList<>();
    double blocked = Double.POSITIVE_INFINITY;
    for (Vec2 point : seen) {
      Optional<Place> place = corridor.place(point);
      // metres by which the robot would come too near
      double intrusion = place.map(p -> radius + CLEARANCE - p.distance()).orElse(0.0);
      if (intrusion <= 0) {
        continue;
      }
      Place where = place.orElseThrow();
      if (intrusion > mostAside) {
        blocking.add(point);
        blocked = Math.min(blocked, where.along());
      } else {
        beside.add(point);
      }
    }
    return new Passage(blocking, beside, Math.max(0, blocked - radius));
  }
}
