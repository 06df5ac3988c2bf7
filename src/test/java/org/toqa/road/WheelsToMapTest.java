package org.toqa.road;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.sim.Participant;
import org.toqa.sim.SimulatedRobot;
import org.toqa.sim.VirtualClock;
import tools.jackson.databind.JsonNode;

/** The way of a report: from wheels that turn to the live events that the map is drawn by. */
@Timeout(600)
class WheelsToMapTest {
  /** What odometry and the grid of poses may differ from the truth, metres. */
  private static final double TOLERANCE = 0.05;

  @TempDir private Path folder;

  /** It is not at its parking point, so it drives there by itself. */
  @Test
  void whereTheWheelsTakeTheRobotIsWhatTheMapIsTold() throws Exception {
    Vec2 away = RoadWorld.GOODS_OUT;
    RoadWorld.walk(
        folder,
        List.of(new SimulatedRobot(RoadWorld.ROBOT, new Pose(away.x(), away.y(), 0), 5, 1)),
        road -> {
          List<Vec2> told = new ArrayList<>();
          WaitingForMap map = new WaitingForMap(road);
          road.clock().add(map, VirtualClock.STEP);
          road.api()
              .awaitSnapshot(
                  snapshot -> {
                    assertFalse(road.isLate(), () -> "it never came home: " + told);
                    map.told(snapshot);
                    JsonNode pose = poseOf(snapshot);
                    if (pose == null) {
                      return false;
                    }
                    told.add(new Vec2(pose.get("x").asDouble(), pose.get("y").asDouble()));
                    return told.getLast().distanceTo(RoadWorld.PARKING) < TOLERANCE;
                  });

          assertTrue(road.distanceTo(RoadWorld.PARKING) < 2 * TOLERANCE, "it is really there");
          assertTrue(told.getFirst().distanceTo(away) < TOLERANCE, "it began at " + told);
          // 1.8 m at no more than 0.5 m/s, one at least in every 0.4 s: 9
          assertTrue(told.stream().distinct().count() >= 9, "it was seen on its way: " + told);
          List<Pose> track = road.track();
          for (Vec2 seen : told) {
            double off =
                track.stream().mapToDouble(p -> p.position().distanceTo(seen)).min().orElseThrow();
            assertTrue(off < TOLERANCE, seen + " is off where the robot was by " + off);
          }
        });
  }

  /** While there is something that the map was not told, the world soon goes on no more. */
  private static final class WaitingForMap implements Participant {
    private static final long LONGEST_NANOS = 400_000_000;

    private final RoadWorld road;
    private volatile long toldVersion;
    private volatile long toldNanos;

    WaitingForMap(RoadWorld road) {
      this.road = road;
    }

    void told(JsonNode snapshot) {
      toldVersion = snapshot.get("version").asLong();
      toldNanos = road.clock().nanos();
    }

    @Override
    public void tick(long nanos) {}

    @Override
    public boolean isReady(long nanos) {
      return toldVersion >= road.publishedVersion() || nanos - toldNanos < LONGEST_NANOS;
    }
  }

  private static @Nullable JsonNode poseOf(JsonNode snapshot) {
    JsonNode robots = snapshot.get("robots");
    JsonNode pose = robots.size() == 1 ? robots.get(0).get("pose") : null;
    return pose == null || pose.isNull() ? null : pose;
  }
}
