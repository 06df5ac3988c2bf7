package org.toqa.lab.fouragents;

import java.util.ArrayList;
import java.util.List;
import java.util.random.RandomGenerator;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

/**
 * Makes scenes that can be solved: convex obstacles of three to six corners anywhere, and round
 * ones that move at up to half the robot's speed clear of what stands. A scene has a path for the
 * robot with its margin; whether the law finds one is what is measured.
 */
final class SceneGenerator {
  private static final Vec2 SIZE = new Vec2(1.6, 1.2);

  /** Metres from the start within which nothing is at first, and from the target nothing stands. */
  private static final double CLEAR = 0.12;

  private static final int MOST_STANDING = 6;
  private static final int MOST_MOVING = 3;
  private static final double MOVING_RADIUS = 0.04;

  private final double robotRadius;
  private final double margin;
  private final double robotSpeed;

  SceneGenerator(double robotRadius, double margin, double robotSpeed) {
    this.robotRadius = robotRadius;
    this.margin = margin;
    this.robotSpeed = robotSpeed;
  }

  /** A scene and the length of the shortest path of the robot itself in it, metres. */
  record Solvable(ObstacleScene scene, double shortest) {}

  Solvable next(String name, RandomGenerator random) {
    while (true) {
      ObstacleScene scene = scene(name, random);
      if (scene.shortest(robotRadius + margin).isPresent()) {
        return new Solvable(scene, scene.shortest(robotRadius).orElseThrow());
      }
    }
  }

  private ObstacleScene scene(String name, RandomGenerator random) {
    Pose start = new Pose(0.1, 0.1 + random.nextDouble(SIZE.y() - 0.2), 0);
    Vec2 target = new Vec2(SIZE.x() - 0.1, 0.1 + random.nextDouble(SIZE.y() - 0.2));
    List<List<Vec2>> standing = new ArrayList<>();
    int wanted = 1 + random.nextInt(MOST_STANDING);
    while (standing.size() < wanted) {
      List<Vec2> corners = convex(random);
      double toStart = Outlines.distance(corners, start.position());
      if (Math.min(toStart, Outlines.distance(corners, target)) > CLEAR) {
        standing.add(corners);
      }
    }
    List<MovingDisc> moving = new ArrayList<>();
    int discs = random.nextInt(MOST_MOVING + 1);
    for (int tries = 0; moving.size() < discs && tries < 200; tries++) {
      MovingDisc disc = disc(random);
      if (disc.from().distanceTo(start.position()) > CLEAR + 2 * MOVING_RADIUS
          && disc.from().distanceTo(disc.to()) > 0.2
          && standing.stream().allMatch(corners -> isClear(disc, corners))) {
        moving.add(disc);
      }
    }
    return new ObstacleScene(name, SIZE, start, target, standing, moving);
  }

  /** Corners on a circle, in the order of their angles: a convex outline. */
  private static List<Vec2> convex(RandomGenerator random) {
    Vec2 centre =
        new Vec2(0.2 + random.nextDouble(SIZE.x() - 0.4), 0.1 + random.nextDouble(SIZE.y() - 0.2));
    double radius = 0.05 + random.nextDouble(0.10);
    int count = 3 + random.nextInt(4);
    double turn = random.nextDouble(2 * Math.PI);
    List<Vec2> corners = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      double angle = turn + 2 * Math.PI * (i + 0.7 * random.nextDouble()) / count;
      corners.add(centre.plus(new Vec2(radius, 0).rotated(angle)));
    }
    return corners;
  }

  private MovingDisc disc(RandomGenerator random) {
    Vec2 from = new Vec2(random.nextDouble(SIZE.x()), random.nextDouble(SIZE.y()));
    Vec2 to = new Vec2(random.nextDouble(SIZE.x()), random.nextDouble(SIZE.y()));
    double speed = robotSpeed * (0.1 + random.nextDouble(0.4));
    return new MovingDisc(MOVING_RADIUS, from, to, speed);
  }

  private boolean isClear(MovingDisc disc, List<Vec2> corners) {
    double nearest = Double.POSITIVE_INFINITY;
    for (int i = 0; i < corners.size(); i++) {
      nearest =
          Math.min(
              nearest,
              Vec2.distanceBetweenLines(
                  disc.from(), disc.to(), corners.get(i), corners.get((i + 1) % corners.size())));
    }
    return nearest > disc.radius() && !Outlines.contains(corners, disc.from());
  }
}
