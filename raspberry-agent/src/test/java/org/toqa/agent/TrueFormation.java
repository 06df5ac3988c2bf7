package org.toqa.agent;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.ConcurrentHashMap;
import org.toqa.agent.chassis.Surroundings;
import org.toqa.formation.Shape;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.sim.Body;
import org.toqa.sim.ClearanceJudge;
import org.toqa.sim.ClearanceJudge.Clearance;
import org.toqa.sim.Participant;

/** Looks at where the robots of a group really are, tick by tick. */
final class TrueFormation implements Participant {
  private final Shape shape;
  private final double radius;
  private final Map<String, Pose> poses = new ConcurrentHashMap<>();
  private final ClearanceJudge judge = new ClearanceJudge(null);
  private volatile double largestError;

  /**
   * @param radius of each robot, metres
   */
  TrueFormation(Shape shape, double radius) {
    this.shape = shape;
    this.radius = radius;
  }

  /** An endless empty floor that says where the robot really is. */
  Surroundings surroundings(String robot) {
    return new Surroundings() {
      @Override
      public void setTruePose(Pose truth) {
        poses.put(robot, truth);
      }

      @Override
      public double distance(Pose ray, double farthest) {
        return Surroundings.EMPTY.distance(ray, farthest);
      }

      @Override
      public boolean isMarked(Vec2 point) {
        return Surroundings.EMPTY.isMarked(point);
      }
    };
  }

  @Override
  public void tick(long nanos) {
    List<Pose> places = new ArrayList<>();
    List<Body> bodies = new ArrayList<>();
    for (int i = 0; i <= shape.followers().size(); i++) {
      String name = FormationRig.name(i);
      places.add(Objects.requireNonNull(poses.get(name), name));
      bodies.add(Body.disc(name, places.getLast().position(), radius));
    }
    judge.judge(Duration.ofNanos(nanos), bodies);
    List<Pose> wanted = shape.followersAt(places.getFirst());
    for (int i = 0; i < wanted.size(); i++) {
      largestError = Math.max(largestError, wanted.get(i).distanceTo(places.get(i + 1)));
    }
  }

  /** No two robots have touched. */
  void assertApart() {
    Clearance nearest = judge.betweenBodies().orElseThrow();
    assertFalse(nearest.isTouch(), nearest::toString);
  }

  /**
   * Every follower was always near its place beside the leader, both as they really were.
   *
   * @param metres how near
   */
  void assertInShape(double metres) {
    assertTrue(judge.samples() > 0);
    assertTrue(largestError < metres, () -> largestError + " m off its place");
  }

  /**
   * The leader really is where it shall be: a group whose robots are all wrong in the same way is
   * in shape too.
   *
   * @param metres how near
   */
  void assertLeaderAt(Pose goal, double metres) {
    Pose leader = Objects.requireNonNull(poses.get(FormationRig.name(0)));
    assertTrue(goal.distanceTo(leader) < metres, () -> leader + " is not near " + goal);
  }
}
