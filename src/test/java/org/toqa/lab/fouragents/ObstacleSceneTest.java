package org.toqa.lab.fouragents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.toqa.avoidance.fouragents.DifferentialBody;
import org.toqa.avoidance.fouragents.FourAgentsSettings;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;

class ObstacleSceneTest {
  private static final FourAgentsSettings SETTINGS = SceneDrive.khepera();

  @Test
  void aSceneIsReadFromItsLines() {
    ObstacleScene scene =
        ObstacleScene.parse(
            "a",
            List.of(
                "# a comment",
                "size 2 1",
                "start 0.1 0.5 0",
                "target 1.9 0.5",
                "static 1,0.4 1.2,0.4 1.2,0.6 1,0.6",
                "moving 0.04 0.5,0.1 0.5,0.9 0.05"));

    assertEquals(new Vec2(2, 1), scene.size());
    assertEquals(new Vec2(1.1, 0.5), scene.known().getFirst().centre());
    MovingDisc disc = scene.moving().getFirst();
    // 0.8 m at 0.05 m/s: there after 16 s, back after 32 s
    assertEquals(0.9, disc.at(16).y(), 1e-9);
    assertEquals(0.5, disc.at(24).y(), 1e-9);
    assertEquals(0.1, disc.at(32).y(), 1e-9);
  }

  @Test
  void aLineThatIsNoneIsTold() {
    IllegalArgumentException told =
        assertThrows(
            IllegalArgumentException.class,
            () -> ObstacleScene.parse("a", List.of("statik 1,1 2,2 3,1")));

    assertEquals("a: what is 'statik 1,1 2,2 3,1'?", told.getMessage());
  }

  /** Round the corner of a wide square: the tangents and arcs of a disc of 0.1 m, by hand. */
  @Test
  void theShortestPathIsThatOfTheDisc() {
    ObstacleScene scene =
        new ObstacleScene(
            "square",
            new Vec2(2, 2),
            new Pose(0.2, 1, 0),
            new Vec2(1.8, 1),
            List.of(
                List.of(
                    new Vec2(0.8, 0.8),
                    new Vec2(1.2, 0.8),
                    new Vec2(1.2, 1.2),
                    new Vec2(0.8, 1.2))),
            List.of());
    // twice a tangent from (0.2, 1) to the circle of 0.1 m at the corner (0.8, 1.2) and an arc to
    // its top, and 0.4 m along the top. From the corner the start lies at 180 + 18.4 degrees, the
    // touching point acos(0.1 / away) before it, the top at 90 degrees
    double away = Math.hypot(0.6, 0.2);
    double tangent = Math.sqrt(away * away - 0.1 * 0.1);
    double touching = Math.PI + Math.atan2(0.2, 0.6) - Math.acos(0.1 / away);
    double expected = 2 * (tangent + 0.1 * (touching - Math.PI / 2)) + 0.4;

    assertEquals(expected, scene.shortest(0.1).orElseThrow(), 1e-6);
  }

  /** A disc of 0.04 m that comes at 0.05 m/s from 0.3 m behind; the robot's target is ahead. */
  private static SceneDrive.Result hitFromBehind(double wheelSpeed) {
    DifferentialBody body = SETTINGS.body();
    FourAgentsSettings settings =
        new FourAgentsSettings(
            new DifferentialBody(body.radius(), body.track(), wheelSpeed, body.acceleration()),
            SETTINGS.sensorRange(),
            SETTINGS.danger(),
            SETTINGS.arrival(),
            SETTINGS.margin(),
            SETTINGS.approach(),
            SETTINGS.cruise(),
            SETTINGS.hysteresis(),
            SETTINGS.tolerance(),
            SETTINGS.convergence());
    ObstacleScene scene =
        new ObstacleScene(
            "hit",
            new Vec2(2, 1),
            new Pose(0.5, 0.5, 0),
            new Vec2(1.9, 0.5),
            List.of(),
            List.of(new MovingDisc(0.04, new Vec2(0.2, 0.5), new Vec2(1.9, 0.5), 0.05)));
    return new SceneDrive(scene, settings, 0, new SplittableRandom(1)).run();
  }

  /** Slower than 2 mm/s is standing; between the rims are 0.3 - 0.035 - 0.04 m. */
  @Test
  void whatComesOverARobotThatStandsCountsApart() {
    SceneDrive.Result stands = hitFromBehind(0.001);
    SceneDrive.Result drives = hitFromBehind(0.01);

    assertEquals(SceneDrive.End.HIT_STANDING, stands.end());
    assertEquals(0.225 / 0.05, stands.seconds(), 0.2);
    assertEquals(SceneDrive.End.CONTACT, drives.end());
  }

  @Test
  void aRobotInTheOpenArrivesStraightAhead() {
    ObstacleScene scene =
        new ObstacleScene(
            "open",
            new Vec2(1, 1),
            new Pose(0.1, 0.5, 0),
            new Vec2(0.9, 0.5),
            List.of(),
            List.of());

    SceneDrive.Result result = new SceneDrive(scene, SETTINGS, 0, new SplittableRandom(1)).run();

    assertTrue(result.isReached());
    assertEquals(0.8 - SceneDrive.THERE, result.metres(), 0.002); // a step is 2 mm long
    assertEquals(0, result.switches());
  }

  @Test
  void theSameSeedMakesTheSameSceneAndTheSameDrive() {
    SceneGenerator.Solvable one = generated(7);
    SceneGenerator.Solvable again = generated(7);

    assertEquals(one, again);
    assertEquals(driven(one.scene()), driven(again.scene()));
  }

  private static SceneGenerator.Solvable generated(long seed) {
    return new SceneGenerator(
            SETTINGS.body().radius(), SETTINGS.margin(), SETTINGS.body().wheelSpeed())
        .next("scene", new SplittableRandom(seed));
  }

  private static SceneDrive.Result driven(ObstacleScene scene) {
    return new SceneDrive(scene, SETTINGS, 0.01, new SplittableRandom(3)).run();
  }

  /** What is said of generated scenes, by other sums than the generator's. */
  @Test
  void generatedScenesKeepWhatIsSaidOfThem() {
    for (long seed = 1; seed <= 20; seed++) {
      SceneGenerator.Solvable solvable = generated(seed);
      ObstacleScene scene = solvable.scene();
      double straight = scene.start().position().distanceTo(scene.target());
      assertTrue(solvable.shortest() >= straight - 1e-9);
      for (List<Vec2> corners : scene.standing()) {
        assertTrue(isConvex(corners));
      }
      for (MovingDisc disc : scene.moving()) {
        assertTrue(disc.speed() <= SETTINGS.body().wheelSpeed() / 2);
        for (double time = 0; time < 100; time += 0.5) {
          for (List<Vec2> corners : scene.standing()) {
            assertTrue(Outlines.distance(corners, disc.at(time)) > disc.radius());
          }
        }
      }
    }
  }

  private static boolean isConvex(List<Vec2> corners) {
    int count = corners.size();
    for (int i = 0; i < count; i++) {
      Vec2 a = corners.get((i + 1) % count).minus(corners.get(i));
      Vec2 b = corners.get((i + 2) % count).minus(corners.get((i + 1) % count));
      if (a.x() * b.y() - a.y() * b.x() < 0) {
        return false;
      }
    }
    return true;
  }
}
