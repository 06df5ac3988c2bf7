package org.toqa.app.bench;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.toqa.agent.chassis.SimulatedWheels;
import org.toqa.agent.drive.MotionLimits;
import org.toqa.agent.drive.PaceLimits;
import org.toqa.agent.drive.ReferenceTrajectory;
import org.toqa.agent.drive.SegmentRunner;
import org.toqa.formation.Follower;
import org.toqa.formation.FollowerLaw;
import org.toqa.formation.FormationMonitor;
import org.toqa.formation.Shape;
import org.toqa.formation.TrajectoryRules;
import org.toqa.formation.Verdict.Drive;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.geometry.Vec2;
import org.toqa.geometry.Waypoint;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DriveKind;
import org.toqa.motion.DriveSpeeds;
import org.toqa.motion.SegmentFitter;
import org.toqa.motion.Trajectory;

/**
 * Three robots round one load, from the lab's hall through a door: the daemon's own leader and
 * followers over simulated bodies, and messages that are delayed. The leader always goes on three
 * omnidirectional wheels.
 */
final class FormationRun {
  private static final MotionLimits LIMITS = new MotionLimits(0.5, 3.5, 0.5, 3);
  private static final double LOAD_SIDE = 0.4;
  private static final int ROBOTS = 3;

  private static final double POSE_PERIOD = 0.2;
  private static final double USUAL_DELAY = 0.02;
  private static final double MAX_SECONDS = 600;

  private static final Pose START = new Pose(2.5, 6.75, 0);
  private static final List<Vec2> CORNERS =
      List.of(new Vec2(9.3, 6.75), new Vec2(9.3, 3.15), new Vec2(11.4, 3.15));

  private final double delay;
  private final OccupancyGrid free;
  private final Shape shape;
  private final SegmentRunner runner;
  private final FormationMonitor watch;
  private final SimulatedBody leader;
  private final List<FollowerRobot> followers = new ArrayList<>();
  private final Deque<Message> inFlight = new ArrayDeque<>();

  private double squaredErrors;
  private double maxError;
  private double trueSquaredErrors;
  private double trueMaxError;
  private long samples;
  private boolean allFree = true;

  /**
   * Robots of one kind.
   *
   * @param wheels the followers'
   * @param tolerance how far one may be from its place, metres
   * @param maxSpeed of any robot of the group, metres a second
   * @param roundness radius of the corners, as a multiple of the smallest that the shape allows
   */
  record Group(
      FollowerLaw law,
      SimulatedWheels wheels,
      double tolerance,
      double maxSpeed,
      double roundness) {}

  /** A follower with its body. */
  private record FollowerRobot(String name, Follower follower, SimulatedBody body) {}

  /** A leader's pose, or a follower's answer. */
  private record Message(double arrivesAt, Runnable receive) {}

  /**
   * @param rmsMetres distance of a follower from its place by odometry, root mean square
   * @param maxMetres the same, the greatest
   * @param trueRmsMetres the true distance, root mean square
   * @param trueMaxMetres the same, the greatest
   * @param seconds of simulated time
   * @param arrived whether the leader came to the path's end in time
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
   * @param delay from when a message is sent until it arrives, seconds
   * @param free the map, inflated by the robot's radius
   * @param seed of slip and wheel sizes
   */
  FormationRun(Group group, double radius, double delay, OccupancyGrid free, long seed) {
    this.delay = delay;
    this.free = free;
    shape = Shape.around(ROBOTS, LOAD_SIDE, LOAD_SIDE, radius);
    Trajectory trajectory = trajectory(shape, group);
    runner =
        new SegmentRunner(
            new ReferenceTrajectory(
                START,
                trajectory.segments(),
                trajectory.segments().size(),
                PaceLimits.forLeader(LIMITS, shape.reach())),
            DriveKind.OMNI);
    leader =
        new SimulatedBody(
            START, SimulatedWheels.omni(group.wheels().slip(), group.wheels().sizeError()), seed);
    for (int i = 0; i < shape.followers().size(); i++) {
      followers.add(
          new FollowerRobot(
              "r" + (i + 2),
              new Follower(group.law(), shape.offsets().get(i), group.tolerance(), USUAL_DELAY),
              new SimulatedBody(shape.followersAt(START).get(i), group.wheels(), seed + i + 1)));
    }
    watch =
        new FormationMonitor(
            followers.stream().map(FollowerRobot::name).toList(), group.tolerance());
  }

  private static Trajectory trajectory(Shape shape, Group group) {
    TrajectoryRules rules = new TrajectoryRules(shape, group.maxSpeed());
    double cornerLength = rules.cornerLength(Math.PI / 2) * group.roundness();
    return rules.slowed(
        new SegmentFitter(DriveSpeeds.DEFAULT, cornerLength)
            .fit(START, CORNERS.stream().map(corner -> new Waypoint(corner, false)).toList()));
  }

  Report run() {
    double seconds = 0;
    for (int tick = 0; seconds < MAX_SECONDS && !runner.isAtEnd(); tick++) {
      seconds = tick * SimulatedBody.TICK;
      leader.advance();
      followers.forEach(member -> member.body().advance());
      deliver(seconds);
      if (tick % Math.round(POSE_PERIOD / SimulatedBody.TICK) == 0) {
        sendLeaderPose(seconds);
      }
      double pace = watch.verdict(seconds) instanceof Drive(double onward) ? onward : 0;
      leader.setCommand(runner.steer(leader.pose(), SimulatedBody.TICK, pace));
      for (FollowerRobot member : followers) {
        member.body().setCommand(member.follower().steer(member.body().pose(), seconds));
      }
      measure();
    }
    leader.close();
    followers.forEach(member -> member.body().close());
    return new Report(
        Math.sqrt(squaredErrors / samples),
        maxError,
        Math.sqrt(trueSquaredErrors / samples),
        trueMaxError,
        seconds,
        runner.isAtEnd(),
        allFree);
  }

  private void sendLeaderPose(double now) {
    Pose pose = leader.pose();
    Twist twist = runner.trajectory().twist();
    for (FollowerRobot member : followers) {
      send(
          now,
          () -> {
            member.follower().receive(pose, twist, now + delay);
            sendAnswer(member, now + delay);
          });
    }
  }

  private void sendAnswer(FollowerRobot member, double now) {
    member.follower().steer(member.body().pose(), now);
    double error = member.follower().error();
    boolean follows = member.follower().trouble().isEmpty();
    send(now, () -> watch.recordAnswer(member.name(), error, follows, now + delay));
  }

  private void send(double now, Runnable heard) {
    inFlight.addLast(new Message(now + delay, heard));
  }

  private void deliver(double now) {
    while (!inFlight.isEmpty() && inFlight.getFirst().arrivesAt() <= now + 1e-9) {
      inFlight.removeFirst().receive().run();
    }
  }

  private void measure() {
    List<Pose> places = shape.followersAt(leader.pose());
    List<Pose> truePlaces = shape.followersAt(leader.truePose());
    allFree &= isFree(leader.pose());
    for (int i = 0; i < followers.size(); i++) {
      SimulatedBody body = followers.get(i).body();
      double error = places.get(i).distanceTo(body.pose());
      double trueError = truePlaces.get(i).distanceTo(body.truePose());
      squaredErrors += error * error;
      maxError = Math.max(maxError, error);
      trueSquaredErrors += trueError * trueError;
      trueMaxError = Math.max(trueMaxError, trueError);
      samples++;
      allFree &= isFree(body.pose());
    }
  }

  private boolean isFree(Pose pose) {
    return free.isFree(pose.position());
  }
}
