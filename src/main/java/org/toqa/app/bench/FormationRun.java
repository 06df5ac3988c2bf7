package org.toqa.app.bench;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.toqa.agent.MotionLimits;
import org.toqa.agent.PaceLimits;
import org.toqa.agent.SegmentRunner;
import org.toqa.agent.Way;
import org.toqa.agent.chassis.SimulatedWheels;
import org.toqa.formation.Follower;
import org.toqa.formation.FollowerLaw;
import org.toqa.formation.FormationWatch;
import org.toqa.formation.Shape;
import org.toqa.formation.Verdict.Onward;
import org.toqa.formation.WayRules;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DriveSpeeds;
import org.toqa.motion.SegmentFitter;
import org.toqa.motion.Trajectory;

/**
 * Three robots round one load, from the lab's hall through a door: the daemon's own leader and
 * followers over simulated bodies, and messages that take their time. The leader always goes on
 * three omnidirectional wheels.
 */
final class FormationRun {
  private static final MotionLimits LIMITS = new MotionLimits(0.5, 3.5, 0.5, 3);
  private static final double LOAD = 0.4;
  private static final int ROBOTS = 3;

  private static final double PERIOD = 0.2;
  private static final double USUAL_DELAY = 0.02;
  private static final double LONGEST_SECONDS = 600;

  private static final Pose START = new Pose(2.5, 6.75, 0);
  private static final List<Vec2> CORNERS =
      List.of(new Vec2(9.3, 6.75), new Vec2(9.3, 3.15), new Vec2(11.4, 3.15));

  private final double delay;
  private final OccupancyGrid free;
  private final Shape shape;
  private final SegmentRunner runner;
  private final FormationWatch watch;
  private final SimulatedDrive leader;
  private final List<Member> followers = new ArrayList<>();
  private final Deque<Message> underWay = new ArrayDeque<>();

  private double squares;
  private double worst;
  private double trueSquares;
  private double trueWorst;
  private long samples;
  private boolean allFree = true;

  /**
   * Robots of one kind.
   *
   * @param wheels the followers'
   * @param tolerance metres that one may be off its place
   * @param fastest metres a second that any of them shall be
   * @param roundness radius of the corners, as a multiple of the smallest that the shape allows
   */
  record Group(
      FollowerLaw law,
      SimulatedWheels wheels,
      double tolerance,
      double fastest,
      double roundness) {}

  /** A follower with its body. */
  private record Member(String name, Follower follower, SimulatedDrive body) {}

  /** A leader's pose, or a follower's answer. */
  private record Message(double arrives, Runnable heard) {}

  /**
   * @param arrived whether the leader came to the way's end in time
   * @param free whether all robots were on free ground, by their odometries
   */
  record Report(
      double rmsMetres,
      double maxMetres,
      double trueRmsMetres,
      double trueMaxMetres,
      double seconds,
      boolean arrived,
      boolean free) {}

  /**
   * @param radius a robot's, metres
   * @param delay seconds that each message is under way
   * @param free the map, inflated by the robot's radius
   */
  FormationRun(Group group, double radius, double delay, OccupancyGrid free, long seed) {
    this.delay = delay;
    this.free = free;
    shape = Shape.around(ROBOTS, LOAD, LOAD, radius);
    Trajectory way = way(shape, group);
    runner =
        new SegmentRunner(
            new Way(
                START,
                way.segments(),
                way.segments().size(),
                PaceLimits.leading(LIMITS, shape.reach())));
    leader =
        new SimulatedDrive(
            START, SimulatedWheels.omni(group.wheels().slip(), group.wheels().sizeError()), seed);
    for (int i = 0; i < shape.followers().size(); i++) {
      followers.add(
          new Member(
              "r" + (i + 2),
              new Follower(group.law(), shape.offsets().get(i), group.tolerance(), USUAL_DELAY),
              new SimulatedDrive(shape.followersAt(START).get(i), group.wheels(), seed + i + 1)));
    }
    watch = new FormationWatch(followers.stream().map(Member::name).toList(), group.tolerance());
  }

  private static Trajectory way(Shape shape, Group group) {
    WayRules rules = new WayRules(shape, group.fastest());
    double cornerLength = rules.cornerLength(Math.PI / 2) * group.roundness();
    return rules.slowed(
        new SegmentFitter(DriveSpeeds.DEFAULT, cornerLength)
            .fit(START, CORNERS.stream().map(corner -> new Waypoint(corner, false)).toList()));
  }

  Report run() {
    double seconds = 0;
    for (int tick = 0; seconds < LONGEST_SECONDS && !runner.isAtEnd(); tick++) {
      seconds = tick * SimulatedDrive.TICK;
      leader.live();
      followers.forEach(member -> member.body().live());
      deliver(seconds);
      if (tick % Math.round(PERIOD / SimulatedDrive.TICK) == 0) {
        tell(seconds);
      }
      double pace = watch.verdict(seconds) instanceof Onward(double onward) ? onward : 0;
      leader.command(runner.steer(leader.pose(), SimulatedDrive.TICK, pace));
      for (Member member : followers) {
        member.body().command(member.follower().steer(member.body().pose(), seconds));
      }
      measure();
    }
    leader.close();
    followers.forEach(member -> member.body().close());
    return new Report(
        Math.sqrt(squares / samples),
        worst,
        Math.sqrt(trueSquares / samples),
        trueWorst,
        seconds,
        runner.isAtEnd(),
        allFree);
  }

  private void tell(double now) {
    Pose pose = leader.pose();
    Twist twist = runner.way().twist();
    for (Member member : followers) {
      send(
          now,
          () -> {
            member.follower().hear(pose, twist, now + delay);
            answer(member, now + delay);
          });
    }
  }

  private void answer(Member member, double now) {
    member.follower().steer(member.body().pose(), now);
    double error = member.follower().error();
    boolean follows = member.follower().trouble().isEmpty();
    send(now, () -> watch.answered(member.name(), error, follows, now + delay));
  }

  private void send(double now, Runnable heard) {
    underWay.addLast(new Message(now + delay, heard));
  }

  private void deliver(double now) {
    while (!underWay.isEmpty() && underWay.getFirst().arrives() <= now + 1e-9) {
      underWay.removeFirst().heard().run();
    }
  }

  private void measure() {
    List<Pose> places = shape.followersAt(leader.pose());
    List<Pose> truePlaces = shape.followersAt(leader.truth());
    allFree &= isFree(leader.pose());
    for (int i = 0; i < followers.size(); i++) {
      SimulatedDrive body = followers.get(i).body();
      double error = places.get(i).distanceTo(body.pose());
      double trueError = truePlaces.get(i).distanceTo(body.truth());
      squares += error * error;
      worst = Math.max(worst, error);
      trueSquares += trueError * trueError;
      trueWorst = Math.max(trueWorst, trueError);
      samples++;
      allFree &= isFree(body.pose());
    }
  }

  private boolean isFree(Pose pose) {
    return free.isFree(pose.position());
  }
}
