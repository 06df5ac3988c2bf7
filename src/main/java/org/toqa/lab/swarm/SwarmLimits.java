package org.toqa.lab.swarm;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.UnaryOperator;
import org.toqa.formation.swarm.SwarmLaw;
import org.toqa.geometry.Vec2;
import org.toqa.lab.drawing.Animation;
import org.toqa.lab.drawing.Chart;
import org.toqa.lab.drawing.Colour;
import org.toqa.lab.drawing.Scene;
import org.toqa.lab.experiment.Experiment;
import org.toqa.lab.experiment.Parameter;
import org.toqa.lab.experiment.Report;
import org.toqa.lab.experiment.Run;
import org.toqa.lab.experiment.Table;
import org.toqa.statistics.Percentiles;

/**
 * {@code virtual-leader-limits}: delay, a map that changes, and noise, which the paper names as its
 * limits, with its law, with one that keeps the shape, and with one that also remembers where it
 * was instead of leaving loops by chance.
 */
public final class SwarmLimits implements Experiment {
  private static final List<String> MAPS = List.of("simple", "complex");
  private static final double[] SPEEDS = {0.5, 1, 1.5, 2};
  private static final int TURN = 5;

  /** Drives with each speed, map and condition in a run. */
  private static final int DRIVES = 3;

  @Override
  public String name() {
    return "virtual-leader-limits";
  }

  @Override
  public String title() {
    return "A swarm behind a virtual leader: its named limits, and without them";
  }

  @Override
  public String source() {
    return "Toibazarov, Baiseitov, Kyzyrkanov, Aljavarneh, Atanov 2023: section 6, limitations";
  }

  @Override
  public List<Parameter> parameters() {
    return SwarmSetup.PARAMETERS;
  }

  /** What the swarm is put under. */
  private record Condition(
      String name, int delay, double rangeNoise, double actuatorNoise, boolean isChanging) {
    SwarmSetup of(SwarmSetup setup) {
      return setup.under(delay, rangeNoise, actuatorNoise, isChanging);
    }
  }

  private static final List<Condition> CONDITIONS =
      List.of(
          new Condition("as published", 0, 0, 0, false),
          new Condition("delay of 10 steps", 10, 0, 0, false),
          new Condition("delay of 30 steps", 30, 0, 0, false),
          new Condition("ranges with 10 % noise", 0, 0.1, 0, false),
          new Condition("wheels with 20 % noise", 0, 0, 0.2, false),
          new Condition("wheels with 50 % noise", 0, 0, 0.5, false),
          new Condition("an obstacle appears", 0, 0, 0, true),
          new Condition("all of it", 10, 0.1, 0.2, true));

  /** All drives under a condition. */
  private record Drives(List<SwarmDrive.Result> results) {
    long arrived() {
      return results.stream().filter(SwarmDrive.Result::isReached).count();
    }

    double lost() {
      return results.stream().mapToInt(SwarmDrive.Result::lost).average().orElse(0);
    }

    /** The median of the shape errors at the end, metres; NaN where none arrived. */
    double shapeError() {
      double[] errors =
          results.stream()
              .filter(SwarmDrive.Result::isReached)
              .mapToDouble(SwarmDrive.Result::shapeError)
              .toArray();
      return errors.length == 0 ? Double.NaN : new Percentiles(errors).percentile(0.5);
    }
  }

  /** A law that is driven by. */
  private record Variant(String name, UnaryOperator<SwarmSetup> setup, SwarmLaw law) {}

  private static final SwarmLaw WITH_CHANCE = SwarmLaw.published(Math.toRadians(TURN));

  /** Loops are left by memory alone. */
  private static final SwarmLaw WITHOUT_CHANCE = new SwarmLaw(Math.toRadians(TURN), 0, 0);

  private static final Variant PUBLISHED =
      new Variant("published", UnaryOperator.identity(), WITH_CHANCE);

  private static final Variant EXTENDED =
      new Variant("extended", setup -> setup.keepingShape().remembering(), WITHOUT_CHANCE);

  private static final List<Variant> VARIANTS =
      List.of(
          PUBLISHED,
          new Variant("that keeps the shape", SwarmSetup::keepingShape, WITH_CHANCE),
          EXTENDED);

  @Override
  public Report run(Run run) {
    SwarmSetup setup = SwarmSetup.of(run);
    List<List<String>> rows = new ArrayList<>();
    for (int i = 0; i < CONDITIONS.size(); i++) {
      Condition condition = CONDITIONS.get(i);
      for (int j = 0; j < VARIANTS.size(); j++) {
        Variant variant = VARIANTS.get(j);
        run.progress(
            (i + j / (double) VARIANTS.size()) / CONDITIONS.size(),
            condition.name() + ", law " + variant.name());
        rows.add(row(condition.name(), variant.name(), drives(condition.of(setup), variant, run)));
      }
    }
    return new Report(
        List.of(),
        List.of(
            new Table(
                "limits",
                "Both maps, w = 5, v = 0.5 to 2",
                List.of("condition", "law", "arrived", "mean lost", "shape error (m)"),
                rows)),
        List.of(shape(setup, run), scene(CONDITIONS.getLast().of(setup), run)),
        List.of(
            "The paper says what it did not look at and has no figures of it, so there are none to"
                + " compare.",
            "The law that keeps the shape drives each robot back to its place, keeps a clearance of"
                + " a robot's width, and leaves loops by chance as the published one. The extended"
                + " law keeps the shape too, and leaves loops by memory, without chance.",
            "The shape error is the RMS distance of the robots from their wanted places, at the"
                + " target."));
  }

  private static Drives drives(SwarmSetup setup, Variant variant, Run run) {
    List<SwarmDrive.Result> results = new ArrayList<>();
    for (String map : MAPS) {
      SwarmMap one = SwarmMap.named(map);
      for (double speed : SPEEDS) {
        for (int i = 0; i < DRIVES * run.runs(); i++) {
          run.checkStopped();
          SplittableRandom random =
              new SplittableRandom(run.seedOf(i) * 1_000_003 + (long) (speed * 10));
          results.add(drive(one, setup, variant, speed, random).run());
        }
      }
    }
    return new Drives(results);
  }

  private static SwarmDrive drive(
      SwarmMap map, SwarmSetup setup, Variant variant, double speed, SplittableRandom random) {
    return new SwarmDrive(map, variant.setup().apply(setup), variant.law(), speed, random);
  }

  private static List<String> row(String condition, String law, Drives drives) {
    return List.of(
        condition,
        law,
        drives.arrived() + " of " + drives.results().size(),
        SwarmSweep.text(drives.lost(), 2),
        SwarmSweep.text(drives.shapeError(), 2));
  }

  /** The first figure: how the shape is kept over the way. */
  private static Chart shape(SwarmSetup setup, Run run) {
    List<Chart.Series> series = new ArrayList<>();
    for (double noise : new double[] {0, 0.2}) {
      for (Variant variant : List.of(PUBLISHED, EXTENDED)) {
        String name = "%s law, wheels %s".formatted(variant.name(), noise);
        series.add(series(name, setup.under(0, 0, noise, false), variant, run));
      }
    }
    return new Chart(
        "shape",
        "RMS distance from the wanted places, simple map, v = 1, w = 5",
        "way of the virtual leader (m)",
        "m",
        series);
  }

  /** The extended law under all of it, where an obstacle appears on the way. */
  private static Animation scene(SwarmSetup setup, Run run) {
    SwarmMap map = SwarmMap.named("simple");
    List<Scene.Mark> marks = new ArrayList<>(setup.changed(map).marks());
    marks.add(new Scene.Disc(SwarmMap.TARGET, setup.targetRadius(), Colour.RED));
    Scene ground =
        new Scene(
            "all-of-it",
            "The extended law under all of it, v = 1, w = 5",
            Vec2.ZERO,
            map.size(),
            marks);
    return Animation.of(
        ground,
        SwarmDrive.STEP,
        drive(map, setup, EXTENDED, 1, new SplittableRandom(run.seed())).bodies());
  }

  private static Chart.Series series(String name, SwarmSetup setup, Variant variant, Run run) {
    SwarmMap map = SwarmMap.named("simple");
    SwarmDrive.Result result =
        drive(map, setup, variant, 1, new SplittableRandom(run.seed())).run();
    List<Chart.Point> points = new ArrayList<>();
    double driven = 0;
    List<Vec2> track = result.track();
    for (int i = 0; i < result.shapeErrors().size(); i++) {
      driven += track.get(i).distanceTo(track.get(i + 1));
      points.add(new Chart.Point(driven, result.shapeErrors().get(i)));
    }
    return new Chart.Series(name, points);
  }
}
