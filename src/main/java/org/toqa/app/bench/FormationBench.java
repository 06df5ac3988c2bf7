package org.toqa.app.bench;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.function.Supplier;
import org.toqa.agent.chassis.SimulatedWheels;
import org.toqa.app.bench.FormationRun.Group;
import org.toqa.app.command.Arguments;
import org.toqa.app.command.SeedOption;
import org.toqa.app.server.WebappFolder;
import org.toqa.formation.FollowerLawType;
import org.toqa.formation.Gains;
import org.toqa.grid.Inflation;
import org.toqa.grid.OccupancyGrid;
import org.toqa.motion.DriveSpeeds;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code toqa bench formation}: how well robots keep their places under one load. */
@Command(
    name = "formation",
    description = "Measure how well robots keep a formation and follow a path.",
    footer = {
      "",
      "Prints JSON. formations: three robots carry a load of 0.4 m x 0.4 m along the",
      "hall of the shipped map and through a door, for each control law and each",
      "delay of the robots' links: rmsMetres and maxMetres (distance of a follower",
      "from its place by odometry), trueRmsMetres and trueMaxMetres (the true",
      "distance, with slip and wheel errors), seconds, arrived, free (no robot was on",
      "occupied ground, by odometry). tracking: one robot follows a path: metres (its",
      "length), endMetres (distance from its end by odometry), trueEndMetres (the",
      "true distance).",
      "",
      "Robots that cannot drive sideways (law non-holonomic) take corners 2.5 times as",
      "wide, at 0.12 m/s instead of 0.25 m/s.",
      "",
      "Exits 1 if the omni law misses a target: RMS 0.01 m and maximum 0.03 m at",
      "20 ms, maximum 0.05 m at 100 ms, tracking 0.01 m."
    })
final class FormationBench implements Callable<Integer> {
  /** The robot's, metres (Tanta). */
  private static final double RADIUS = 0.1275;

  private static final int[] DELAYS_MS = {20, 100};
  private static final double TARGET_RMS = 0.01;
  private static final double TARGET_MAX = 0.03;
  private static final double TARGET_MAX_LATE = 0.05;
  private static final double TARGET_TRACKING = 0.01;

  private final Supplier<Path> shippedMap;

  @Spec private CommandSpec spec = CommandSpec.create();

  @Mixin private SeedOption seed = new SeedOption();

  @Option(
      names = "--slip",
      defaultValue = "1",
      paramLabel = "PERCENT",
      description =
          "Slip of a wheel in each step, standard deviation, 0 to 10 (default:"
              + " ${DEFAULT-VALUE}).")
  private double slip;

  @Option(
      names = "--wheel-size-error",
      defaultValue = "0.1",
      paramLabel = "PERCENT",
      description =
          "Error of each wheel's size, standard deviation, 0 to 5 (default:"
              + " ${DEFAULT-VALUE}).")
  private double sizeError;

  record Report(long seed, List<Formation> formations, TrackingRun.Report tracking) {}

  /**
   * @param delayMs from when a message is sent until it arrives, milliseconds
   */
  record Formation(String law, int delayMs, FormationRun.Report error) {}

  FormationBench() {
    this(WebappFolder::shippedMap);
  }

  /**
   * @param shippedMap on which the path lies
   */
  FormationBench(Supplier<Path> shippedMap) {
    this.shippedMap = shippedMap;
  }

  @Override
  public Integer call() {
    Arguments arguments = new Arguments(spec);
    arguments.requireDecimalBetween("--slip", slip, 0, 10);
    arguments.requireDecimalBetween("--wheel-size-error", sizeError, 0, 5);
    OccupancyGrid free = Inflation.inflate(arguments.readGrid(shippedMap.get()), RADIUS);
    SimulatedWheels three = SimulatedWheels.omni(slip / 100, sizeError / 100);
    SimulatedWheels two = SimulatedWheels.differential(slip / 100, sizeError / 100);
    Group omni = group(FollowerLawType.OMNI, three);
    Group wheeled = group(FollowerLawType.NON_HOLONOMIC, two);
    List<Formation> formations = new ArrayList<>();
    for (int delay : DELAYS_MS) {
      formations.add(formation("omni", omni, delay, free));
    }
    for (int delay : DELAYS_MS) {
      formations.add(formation("non-holonomic", wheeled, delay, free));
    }
    Report report =
        new Report(seed.value(), formations, new TrackingRun(three, seed.value()).run());
    new BenchOutput(spec).printReport(report);
    return meetsTargets(report) ? ExitCode.OK : ExitCode.SOFTWARE;
  }

  private static Group group(FollowerLawType law, SimulatedWheels wheels) {
    double speed = Math.min(DriveSpeeds.DEFAULT.forward(), law.mostSpeed());
    return new Group(law.withGains(Gains.DEFAULT), wheels, law.tolerance(), speed, law.roundness());
  }

  private Formation formation(String name, Group group, int delayMs, OccupancyGrid free) {
    return new Formation(
        name, delayMs, new FormationRun(group, RADIUS, delayMs / 1e3, free, seed.value()).run());
  }

  private static boolean meetsTargets(Report report) {
    FormationRun.Report soon = report.formations().get(0).error();
    FormationRun.Report late = report.formations().get(1).error();
    return report.formations().stream().allMatch(f -> f.error().free() && f.error().arrived())
        && soon.rmsMetres() < TARGET_RMS
        && soon.maxMetres() < TARGET_MAX
        && late.maxMetres() < TARGET_MAX_LATE
        && report.tracking().endMetres() < TARGET_TRACKING;
  }
}
