package org.toqa.traffic.floor;

import java.util.AbstractList;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.RandomAccess;
import org.jspecify.annotations.Nullable;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.motion.Segment;

/**
 * The rest of a robot's path as a line, map frame.
 *
 * @param released how many of the points it may drive to
 * @param deviation how far it is off that; null while it may drive none of it
 */
public record RemainingPath(List<Vec2> points, int released, @Nullable PathDeviation deviation) {

  public static final RemainingPath NONE = new RemainingPath(List.of(), 0, null);

  /** An arc is drawn in pieces of at most this angle, radians. */
  private static final double MAX_ARC_PIECE = 0.3;

  public RemainingPath {
    points = points instanceof Joined ? points : List.copyOf(points);
  }

  /** Two immutable lists, one behind the other: the long one is shared from tick to tick. */
  private static final class Joined extends AbstractList<Vec2> implements RandomAccess {
    private final List<Vec2> near;
    private final List<Vec2> behind;

    Joined(List<Vec2> near, List<Vec2> behind) {
      this.near = List.copyOf(near);
      this.behind = behind;
    }

    @Override
    public Vec2 get(int index) {
      return index < near.size() ? near.get(index) : behind.get(index - near.size());
    }

    @Override
    public int size() {
      return near.size() + behind.size();
    }
  }

  /**
   * What lies behind the section that a robot is on: the same from tick to tick until it has
   * completed that section or is released more.
   *
   * @param releasedPoints how many of the points it may drive to
   */
  record Behind(ReservedPath path, int done, int released, List<Vec2> points, int releasedPoints) {

    /**
     * @param done so many sections are completed; the robot is on the next one
     */
    static Behind of(ReservedPath path, int done, int released) {
      int releasedPoints = 0;
      for (int i = done + 1; i < released; i++) {
        for (Segment segment : path.sections().get(i).segments()) {
          releasedPoints += segment.speed() == 0 ? 0 : pieces(segment);
        }
      }
      return new Behind(path, done, released, new Line(path, done), releasedPoints);
    }

    @SuppressWarnings("ReferenceEquality") // a path is compared at each tick
    boolean isOf(ReservedPath other, int otherDone, int otherReleased) {
      return path == other && done == otherDone && released == otherReleased;
    }
  }

  /**
   * The points of a path behind a section, found by whoever first looks at them: that is a page's
   * business, and no tick waits for it. Any thread may find them again.
   */
  private static final class Line extends AbstractList<Vec2> implements RandomAccess {
    private final ReservedPath path;
    private final int section;
    private volatile @Nullable List<Vec2> found;

    Line(ReservedPath path, int section) {
      this.path = path;
      this.section = section;
    }

    private List<Vec2> points() {
      List<Vec2> known = found;
      if (known == null) {
        known = new ArrayList<>();
        for (int i = section + 1; i < path.sectionCount(); i++) {
          List<Vec2> line = line(path, i);
          known.addAll(line.subList(1, line.size()));
        }
        found = known;
      }
      return known;
    }

    @Override
    public Vec2 get(int index) {
      return points().get(index);
    }

    @Override
    public int size() {
      return points().size();
    }
  }

  static RemainingPath of(Behind behind, Pose now, Optional<PathDeviation> deviation) {
    List<Vec2> points = new ArrayList<>(List.of(now.position()));
    if (behind.done < behind.path.sectionCount()) {
      List<Vec2> line = line(behind.path, behind.done);
      points.addAll(line.subList(passed(line, now.position()), line.size()));
    }
    int released = behind.done < behind.released ? points.size() + behind.releasedPoints : 1;
    return new RemainingPath(new Joined(points, behind.points), released, deviation.orElse(null));
  }

  /** One section, from where it begins. */
  private static List<Vec2> line(ReservedPath path, int section) {
    Pose pose = path.poseAfter(section);
    List<Vec2> line = new ArrayList<>(List.of(pose.position()));
    for (Segment segment : path.sections().get(section).segments()) {
      if (segment.speed() != 0) {
        int pieces = pieces(segment);
        for (int k = 1; k <= pieces; k++) {
          line.add(pose.advanced(segment.twist(), segment.t() * k / pieces).position());
        }
      }
      pose = pose.advanced(segment.twist(), segment.t());
    }
    return line;
  }

  /** In how many straights a segment is drawn that is not a turn on the spot. */
  private static int pieces(Segment segment) {
    return Math.max(1, (int) Math.ceil(Math.abs(segment.angle()) / MAX_ARC_PIECE));
  }

  /** How many points of a line lie behind a robot on it: those up to the piece nearest to it. */
  private static int passed(List<Vec2> line, Vec2 robot) {
    int nearest = 1;
    double distance = Double.POSITIVE_INFINITY;
    for (int i = 1; i < line.size(); i++) {
      double here = robot.distanceToLine(line.get(i - 1), line.get(i));
      if (here < distance) {
        nearest = i;
        distance = here;
      }
    }
    return nearest;
  }
}
