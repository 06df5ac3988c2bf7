package org.toqa.traffic.floor;

import java.util.List;
import java.util.function.Function;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.MoveRules;
import org.toqa.motion.Segment;

/**
 * Whether what is driven, arcs too, keeps the directions of a floor's areas. Planners over cells
 * know these from middle to middle; a round corner may lead over a border before it has turned.
 */
final class DirectionCheck {
  /** Radians; an arc is looked at in pieces that turn no more. */
  private static final double PIECE = Math.PI / 18;

  private DirectionCheck() {}

  /**
   * Whether a robot keeps them, but for {@link MoveRules#SLACK}.
   *
   * @param start where the first section begins, map frame
   */
  static boolean isKept(MoveRules rules, Pose start, List<Section> sections) {
    if (!rules.isDirected()) {
      return true;
    }
    double metres = 0;
    Pose pose = start;
    for (Section section : sections) {
      for (Segment segment : section.segments()) {
        metres += metresAgainst(rules, Pose::position, pose, segment);
        pose = pose.advanced(segment.twist(), segment.t());
      }
    }
    return metres <= MoveRules.SLACK;
  }

  /**
   * Whether the middle of what a group carries keeps them on each segment.
   *
   * @param load where that is when the leader is at a pose, map frame
   */
  static boolean isKept(
      MoveRules rules, Function<Pose, Vec2> load, Pose start, List<Segment> segments) {
    if (!rules.isDirected()) {
      return true;
    }
    Pose pose = start;
    for (Segment segment : segments) {
      if (metresAgainst(rules, load, pose, segment) > MoveRules.SLACK) {
        return false;
      }
      pose = pose.advanced(segment.twist(), segment.t());
    }
    return true;
  }

  private static double metresAgainst(
      MoveRules rules, Function<Pose, Vec2> middle, Pose start, Segment segment) {
    int pieces = 1 + (int) (Math.abs(segment.angle()) / PIECE);
    double metres = 0;
    Pose pose = start;
    for (int i = 0; i < pieces; i++) {
      Pose next = pose.advanced(segment.twist(), segment.t() / pieces);
      metres += rules.metresAgainst(middle.apply(pose), middle.apply(next));
      pose = next;
    }
    return metres;
  }
}
