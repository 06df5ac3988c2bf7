package org.toqa.app.bench;

import java.time.Duration;
import java.time.InstantSource;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.app.bench.meter.HeapMemory;
import org.toqa.app.bench.meter.ProcessMeter;
import org.toqa.fleet.FleetSnapshot;
import org.toqa.fleet.RobotView;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TaskState;
import org.toqa.sim.Body;
import org.toqa.sim.ClearanceJudge;
import org.toqa.sim.ClearanceJudge.Clearance;

/** Measures the fleet of this process, from when it is made until it reports. */
final class FleetMeter {
  private final ProcessMeter meter;
  private final ClearanceJudge truth;

  /** Of robots where they report themselves. */
  private final ClearanceJudge reported = new ClearanceJudge(null);

  private final double heapBefore = HeapMemory.usedMegabytes();

  /** Those that had ended before. */
  private final Set<Long> doneBefore = new HashSet<>();

  private final Set<Long> done = new HashSet<>();
  private final Map<String, Vec2> positions = new HashMap<>();
  private boolean isFirst = true;
  private double metres;

  /**
   * @param robots how many were seen
   * @param seconds of real time that it took
   * @param pace as in {@link ProcessMeter.Reading}
   * @param cores as there
   * @param metresDriven by all robots together
   * @param tasksDone how many tasks were completed meanwhile
   * @param nearestMetres the smallest distance between the edges of two robots as they reported
   *     themselves; negative where they overlapped
   * @param trueNearestMetres the smallest distance between two bodies as they really were; null:
   *     there were no two
   * @param trueWallMetres the same between a body and a wall; null: none came near one
   * @param trueSamples how many moments these two were looked for at
   * @param heapBeforeMb heap in use at the start, in units of 10^6 bytes, after a garbage
   *     collection
   * @param heapAfterMb the same at the end
   */
  record Report(
      int robots,
      double seconds,
      double pace,
      double cores,
      double metresDriven,
      int tasksDone,
      double nearestMetres,
      @Nullable Double trueNearestMetres,
      @Nullable Double trueWallMetres,
      long trueSamples,
      double heapBeforeMb,
      double heapAfterMb) {}

  /**
   * @param fleetTime the fleet's own clock
   * @param truth looks at where bodies are meanwhile
   */
  FleetMeter(InstantSource fleetTime, ClearanceJudge truth) {
    meter = new ProcessMeter(fleetTime);
    this.truth = truth;
  }

  /** Adds a snapshot, each one after those before it. */
  void observe(FleetSnapshot snapshot) {
    Set<Long> ended = isFirst ? doneBefore : done;
    isFirst = false;
    snapshot.tasks().stream()
        .filter(task -> task.state() == TaskState.DONE && !doneBefore.contains(task.id()))
        .forEach(task -> ended.add(task.id()));
    List<Body> bodies = snapshot.robots().stream().flatMap(FleetMeter::reportedBody).toList();
    for (Body body : bodies) {
      Vec2 place = body.core().getFirst();
      Vec2 before = positions.put(body.name(), place);
      metres += before == null ? 0 : before.distanceTo(place);
    }
    reported.judge(Duration.ZERO, bodies);
  }

  private static Stream<Body> reportedBody(RobotView robot) {
    return Stream.ofNullable(robot.telemetry().pose())
        .map(
            pose -> Body.disc(robot.name(), pose.position(), robot.capabilities().footprint() / 2));
  }

  Report report() {
    ProcessMeter.Reading reading = meter.read();
    return new Report(
        positions.size(),
        reading.seconds(),
        reading.pace(),
        reading.cores(),
        metres,
        done.size(),
        reported.betweenBodies().map(Clearance::metres).orElse(Double.POSITIVE_INFINITY),
        truth.betweenBodies().map(Clearance::metres).orElse(null),
        truth.toWall().map(Clearance::metres).orElse(null),
        truth.samples(),
        heapBefore,
        HeapMemory.usedMegabytes());
  }
}
