package org.toqa.app.bench;

import java.time.Duration;
import java.time.InstantSource;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
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

  /** By floor: of bodies where they really are. */
  private final Map<String, ClearanceJudge> truths;

  /** By floor: of robots where they report themselves. */
  private final Map<String, ClearanceJudge> reported = new HashMap<>();

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
   * @param nearestMetres the smallest distance between the edges of two robots of a floor as they
   *     reported themselves; negative where they overlapped
   * @param trueNearestMetres the smallest distance between two bodies as they really were; null:
   *     there were no two
   * @param trueWallMetres the same between a body and a wall; null: none came near one
   * @param trueSamples how many moments these two were looked for at, of all floors together
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
   * @param truths look at where bodies are meanwhile, by floor
   */
  FleetMeter(InstantSource fleetTime, Map<String, ClearanceJudge> truths) {
    meter = new ProcessMeter(fleetTime);
    this.truths = truths;
  }

  /** Adds a snapshot, each one after those before it. */
  void observe(FleetSnapshot snapshot) {
    Set<Long> ended = isFirst ? doneBefore : done;
    isFirst = false;
    snapshot.tasks().stream()
        .filter(task -> task.state() == TaskState.DONE && !doneBefore.contains(task.id()))
        .forEach(task -> ended.add(task.id()));
    Map<String, List<Body>> bodies =
        snapshot.robots().stream()
            .collect(
                Collectors.groupingBy(
                    RobotView::floor,
                    Collectors.flatMapping(FleetMeter::reportedBody, Collectors.toList())));
    bodies.forEach(this::observe);
  }

  private void observe(String floor, List<Body> bodies) {
    for (Body body : bodies) {
      Vec2 place = body.core().getFirst();
      Vec2 before = positions.put(body.name(), place);
      metres += before == null ? 0 : before.distanceTo(place);
    }
    reported.computeIfAbsent(floor, _ -> new ClearanceJudge(null)).judge(Duration.ZERO, bodies);
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
        least(reported, ClearanceJudge::betweenBodies).orElse(Double.POSITIVE_INFINITY),
        least(truths, ClearanceJudge::betweenBodies).orElse(null),
        least(truths, ClearanceJudge::toWall).orElse(null),
        truths.values().stream().mapToLong(ClearanceJudge::samples).sum(),
        heapBefore,
        HeapMemory.usedMegabytes());
  }

  /** The smallest of all floors, metres. */
  private static Optional<Double> least(
      Map<String, ClearanceJudge> judges, Function<ClearanceJudge, Optional<Clearance>> distance) {
    return judges.values().stream()
        .map(distance)
        .flatMap(Optional::stream)
        .map(Clearance::metres)
        .min(Comparator.naturalOrder());
  }
}
