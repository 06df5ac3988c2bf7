package org.toqa.lab.fouragents;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.random.RandomGenerator;
import org.toqa.avoidance.fouragents.DifferentialBody;
import org.toqa.avoidance.fouragents.DrivingAgent;
import org.toqa.avoidance.fouragents.FourAgents;
import org.toqa.avoidance.fouragents.FourAgentsSettings;
import org.toqa.avoidance.fouragents.RangeRing;
import org.toqa.avoidance.fouragents.StaticObstacle;
import org.toqa.avoidance.fouragents.WheelVelocities;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

/**
 * Drives a simulated robot through a scene: wheels that accelerate as far as they can and slip,
 * sensors that are cones of three rays with noise. Where it is the robot knows exactly, as in the
 * paper.
 */
final class SceneDrive {

  /** Seconds between two steps of the law, and of the world. */
  private static final double STEP = 0.02;

  /** Metres from the target that are there. */
  static final double THERE = 0.01;

  /** Metres a second; a robot that is slower stands. */
  private static final double STANDING = 0.002;

  /** Seconds after which a robot that has not arrived never will. */
  private static final double LATEST = 180;

  /** Steps between two points of the track that is drawn. */
  private static final int TRACK = 10;

  /** Seconds between them. */
  static final double TRACK_STEP = TRACK * STEP;

  private final ObstacleScene scene;
  private final FourAgentsSettings settings;
  private final double noise;
  private final RandomGenerator random;
  private final List<StaticObstacle> known;
  private final List<Pose> beams;

  /**
   * @param noise standard deviation of readings and of what each wheel rolls in a step, a share
   */
  SceneDrive(
      ObstacleScene scene, FourAgentsSettings settings, double noise, RandomGenerator random) {
    this.scene = scene;
    this.settings = settings;
    this.noise = noise;
    this.random = random;
    this.known = scene.known();
    this.beams = settings.ring().beams();
  }

  /** How a drive ended. */
  enum End {
    REACHED,
    /** The robot drove into something, or something into the driving robot. */
    CONTACT,
    /** Something drove into the robot that stood. */
    HIT_STANDING,
    LATE
  }

  /**
   * A drive.
   *
   * @param seconds it took
   * @param metres it went
   * @param nearest metres between the robot and anything, at the nearest
   * @param switches how often another agent took over
   * @param seconds by agent
   * @param track where the robot was
   */
  record Result(
      End end,
      double seconds,
      double metres,
      double nearest,
      int switches,
      Map<DrivingAgent, Double> driving,
      List<Vec2> track) {
    boolean isReached() {
      return end == End.REACHED;
    }
  }

  Result run() {
    FourAgents agents = new FourAgents(settings);
    FourAgents.State state = FourAgents.State.START;
    Pose robot = scene.start();
    WheelVelocities wheels = WheelVelocities.ZERO;
    Map<DrivingAgent, Double> driving = new EnumMap<>(DrivingAgent.class);
    List<Vec2> track = new ArrayList<>();
    double metres = 0;
    double nearest = Double.POSITIVE_INFINITY;
    int switches = 0;
    End end = End.LATE;
    int step = 0;
    for (; step * STEP < LATEST; step++) {
      double time = step * STEP;
      if (step % TRACK == 0) {
        track.add(robot.position());
      }
      double gap = gap(robot.position(), time);
      nearest = Math.min(nearest, gap);
      if (gap <= 0) {
        boolean isStanding = Math.max(Math.abs(wheels.left()), Math.abs(wheels.right())) < STANDING;
        end = isStanding ? End.HIT_STANDING : End.CONTACT;
        break;
      }
      if (robot.position().distanceTo(scene.target()) <= THERE) {
        end = End.REACHED;
        break;
      }
      FourAgents.Decision decision =
          agents.step(
              state, new FourAgents.Input(robot, ranges(robot, time), scene.target(), known, STEP));
      switches += decision.state().driving() == state.driving() ? 0 : 1;
      state = decision.state();
      driving.merge(state.driving(), STEP, Double::sum);
      wheels = accelerated(wheels, decision.wheels());
      Pose next = robot.advanced(settings.body().twist(slipped(wheels)), STEP);
      metres += next.distanceTo(robot);
      robot = next;
    }
    track.add(robot.position());
    return new Result(end, step * STEP, metres, nearest, switches, driving, track);
  }

  /** Metres between the robot's rim and the nearest obstacle. */
  private double gap(Vec2 robot, double time) {
    double gap = Double.POSITIVE_INFINITY;
    for (List<Vec2> corners : scene.standing()) {
      gap = Math.min(gap, Outlines.distance(corners, robot));
    }
    for (MovingDisc disc : scene.moving()) {
      gap = Math.min(gap, disc.at(time).distanceTo(robot) - disc.radius());
    }
    return gap - settings.body().radius();
  }

  private List<Double> ranges(Pose robot, double time) {
    List<Double> ranges = new ArrayList<>(beams.size());
    double farthest = settings.sensorRange();
    for (Pose beam : beams) {
      double range = farthest;
      for (Pose ray : RangeRing.rays(robot.compose(beam))) {
        range = seen(ray, time, range);
      }
      boolean isSeen = range < farthest;
      double read = isSeen ? range * (1 + noise * random.nextGaussian()) : farthest;
      ranges.add(Math.clamp(read, 0, farthest));
    }
    return ranges;
  }

  private double seen(Pose ray, double time, double farthest) {
    double range = farthest;
    for (StaticObstacle obstacle : known) {
      range = obstacle.range(ray, range);
    }
    for (MovingDisc disc : scene.moving()) {
      range = Outlines.seen(disc.at(time), disc.radius(), ray, range);
    }
    return range;
  }

  private WheelVelocities accelerated(WheelVelocities now, WheelVelocities wanted) {
    double most = settings.body().acceleration() * STEP;
    return new WheelVelocities(
        now.left() + Math.clamp(wanted.left() - now.left(), -most, most),
        now.right() + Math.clamp(wanted.right() - now.right(), -most, most));
  }

  private WheelVelocities slipped(WheelVelocities wheels) {
    return new WheelVelocities(
        wheels.left() * (1 + noise * random.nextGaussian()),
        wheels.right() * (1 + noise * random.nextGaussian()));
  }

  /** The seed's robot with the numbers that were chosen for it. */
  static FourAgentsSettings khepera() {
    return FourAgentsSettings.of(DifferentialBody.KHEPERA_II);
  }
}
