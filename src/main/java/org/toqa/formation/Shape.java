package org.toqa.formation;

import java.util.ArrayList;
import java.util.List;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

/**
 * Who is where round a load: a line of two, a triangle of three, a ring of more. Places are in the
 * load's frame: origin in its middle, x along its length and forward, y left. The leader is in
 * front, the followers counter-clockwise from it.
 *
 * @param leader the leader's place, metres
 * @param followers the followers' places, metres
 * @param mobility how it can be led
 */
public record Shape(Vec2 leader, List<Vec2> followers, GroupMobility mobility) {

  public static final int MOST_ROBOTS = 12;

  private static final double LARGEST_LENGTH = 20;

  /** Metres of air between a robot and the load, and between two robots. */
  private static final double GAP = 0.02;

  /** What a path keeps round a corner beyond the outermost robot's lateral offset (Tanta). */
  private static final double CORNER_MARGIN = 0.2;

  /**
   * @throws IllegalArgumentException if there are none or too many
   */
  public Shape {
    followers = List.copyOf(followers);
    if (followers.isEmpty() || followers.size() >= MOST_ROBOTS) {
      throw new IllegalArgumentException(
          "A formation has 1 to %d followers, not %d."
              .formatted(MOST_ROBOTS - 1, followers.size()));
    }
  }

  /** One that can be led in any direction. */
  public Shape(Vec2 leader, List<Vec2> followers) {
    this(leader, followers, GroupMobility.SHIFTING);
  }

  /** The same of robots that can do less, or more. */
  public Shape withMobility(GroupMobility other) {
    return new Shape(leader, followers, other);
  }

  /** The law that asks the most, of those that its robots follow by. */
  public FollowerLawType law() {
    return mobility.law();
  }

  /**
   * The shape for so many robots.
   *
   * @param length of the load along the direction of driving, metres
   * @param width of the load, metres
   * @param robotRadius metres, of the largest of them
   * @throws IllegalArgumentException if a number is out of range
   */
  public static Shape around(int robots, double length, double width, double robotRadius) {
    if (robots < 2 || robots > MOST_ROBOTS) {
      throw new IllegalArgumentException(
          "A formation has 2 to %d robots, not %d.".formatted(MOST_ROBOTS, robots));
    }
    requireLength("load's length", length);
    requireLength("load's width", width);
    requireLength("robot's radius", robotRadius);
    double radius = ringRadius(robots, length, width, robotRadius);
    List<Vec2> ring = new ArrayList<>();
    for (int i = 0; i < robots; i++) {
      ring.add(new Vec2(radius, 0).rotated(2 * Math.PI * i / robots));
    }
    return new Shape(ring.getFirst(), ring.subList(1, robots));
  }

  private static double ringRadius(int robots, double length, double width, double robotRadius) {
    double load = robots == 2 ? length / 2 : Math.hypot(length, width) / 2;
    double neighbours = (2 * robotRadius + GAP) / (2 * Math.sin(Math.PI / robots));
    return Math.max(load + robotRadius + GAP, neighbours);
  }

  /** The followers' places in the leader's frame, metres: x forward, y left. */
  public List<Vec2> offsets() {
    return followers.stream().map(place -> place.minus(leader)).toList();
  }

  /** Where the leader is while the load is there, both in the map frame. */
  public Pose leaderAt(Pose load) {
    return load.compose(new Pose(leader.x(), leader.y(), 0));
  }

  /** Where the load is while the leader is there, both in the map frame. */
  public Pose loadAt(Pose leaderPose) {
    return leaderPose.compose(new Pose(-leader.x(), -leader.y(), 0));
  }

  /**
   * Where the followers shall be, in their order, while the leader is there, map frame; all face
   * alike.
   */
  public List<Pose> followersAt(Pose leaderPose) {
    return offsets().stream()
        .map(offset -> leaderPose.compose(new Pose(offset.x(), offset.y(), 0)))
        .toList();
  }

  /** Metres from the middle of the load to that of the robots: at 0 they carry equal shares. */
  public double imbalance() {
    Vec2 sum = followers.stream().reduce(leader, Vec2::plus);
    return sum.norm() / (1 + followers.size());
  }

  /** Metres from the leader to the follower that is farthest from it. */
  public double reach() {
    return offsets().stream().mapToDouble(Vec2::norm).max().orElseThrow();
  }

  /** The tightest circle that the leader of this shape may drive, metres. */
  public double smallestRadius() {
    double lateral = offsets().stream().mapToDouble(o -> Math.abs(o.y())).max().orElseThrow();
    double lengthwise = offsets().stream().mapToDouble(o -> Math.abs(o.x())).max().orElseThrow();
    return Math.max(
        law().roundness() * (lateral + CORNER_MARGIN), law().lengthFactor() * lengthwise);
  }

  private static void requireLength(String name, double metres) {
    if (!(metres > 0 && metres <= LARGEST_LENGTH)) {
      throw new IllegalArgumentException(
          "The %s must be more than 0 and at most %.0f m, not %s."
              .formatted(name, LARGEST_LENGTH, metres));
    }
  }
}
