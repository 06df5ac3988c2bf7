package org.toqa.lab.csm;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.toqa.geometry.Vec2;
import org.toqa.lab.drawing.Animation;
import org.toqa.lab.drawing.Chart;
import org.toqa.lab.drawing.Colour;
import org.toqa.lab.drawing.Drawing;
import org.toqa.lab.drawing.Scene;
import org.toqa.lab.experiment.Experiment;
import org.toqa.lab.experiment.Figure;
import org.toqa.lab.experiment.Parameter;
import org.toqa.lab.experiment.Report;
import org.toqa.lab.experiment.Run;
import org.toqa.lab.experiment.Table;
import org.toqa.lab.experiment.Value;
import org.toqa.lab.experiment.Verdict;
import org.toqa.motion.WheelCommand;
import org.toqa.planning.exact.ShortestDiscPath;
import org.toqa.planning.smooth.DiscSpace;
import org.toqa.planning.smooth.SmoothMethod;
import org.toqa.planning.smooth.curve.SmoothCurve;
import org.toqa.planning.smooth.curve.SplineFitter;

/** Three robots on three floors in the static environment: planned, driven, and what it says. */
public final class CsmStatic implements Experiment {
  private static final String LAYOUT =
      "The obstacles of the paper are not published; ours are, and the bound is the exact shortest"
          + " path among them.";

  private static final List<SmoothMethod> METHODS =
      List.of(SmoothMethod.RRT_STAR, SmoothMethod.PARTICLE_SWARM, SmoothMethod.HYBRID);

  /** Of the three robots: path length (cm), iteration of the best cost, and of all iterations. */
  private static final double[][] PLANNED = {{292.7, 50, 100}, {285.51, 40, 50}, {225.7, 45, 50}};

  /** Table I, static: desired path, actual path, error; cm. */
  private static final double[][] TABLE_I = {
    {291.7287, 292.1196, 0.3910}, {280.2159, 280.2382, 0.0224}, {228.2956, 227.9676, 0.328}
  };

  /** Centimetres. */
  private static final double MOST_POSITION_ERROR = 1.5;

  /** Radians. */
  private static final double MOST_ORIENTATION_ERROR = 1;

  @Override
  public String name() {
    return "csm-static";
  }

  @Override
  public String title() {
    return "three robots among static obstacles: planned by RRT* and PSO, and driven";
  }

  @Override
  public String source() {
    return CsmParameters.SOURCE
        + ": figures 8, 9, 16 to 19, 21 and 25, equations 9 and 14, table I";
  }

  @Override
  public List<Parameter> parameters() {
    List<Parameter> all = new ArrayList<>(CsmParameters.OF_BODY);
    all.add(CsmParameters.RADIUS);
    all.add(CsmParameters.ITERATIONS);
    return all;
  }

  @Override
  public Report run(Run run) {
    Result result = new Result();
    for (CsmFloor floor : CsmFloor.all()) {
      run.progress(0.25 * (floor.number() - 1), "robot " + floor.number());
      plan(floor, run, result);
    }
    run.progress(0.75, "the curves of the paper");
    StaticDrive nine =
        StaticDrive.of(
            "equation 9", List.of(PublishedCurve.EQUATION_9), CsmFloor.read(1), run, run.seed());
    StaticDrive fourteen =
        StaticDrive.of(
            "equation 14", List.of(PublishedCurve.EQUATION_14), CsmFloor.read(3), run, run.seed());
    result.drives.add(nine);
    result.drives.add(fourteen);
    addTableI(result);
    addCurves(result.figures);
    addDriving(result);
    run.progress(0.85, "other values of the parameters");
    Table sensitivity = sensitivity(run);
    addDrawings(result);
    return new Report(
        result.figures,
        List.of(paths(result), methods(result), tracking(result), sensitivity),
        result.drawings,
        List.of(
            "The paper says that equation 9 is of the third order; it is of the fourth.",
            "Iterations of ours are single samples of the tree and moves of the swarm; the paper's"
                + " are not defined."));
  }

  /** What was measured so far. */
  private static final class Result {
    final List<Figure> figures = new ArrayList<>();
    final List<StaticDrive> drives = new ArrayList<>();
    final List<Drawing> drawings = new ArrayList<>();
    final List<List<String>> paths = new ArrayList<>();
    final List<List<String>> methods = new ArrayList<>();
  }

  private void plan(CsmFloor floor, Run run, Result result) {
    String robot = "robot " + floor.number();
    double radius = run.value(CsmParameters.RADIUS);
    long iterations = Math.round(run.value(CsmParameters.ITERATIONS));
    DiscSpace space = DiscSpace.of(floor.grid(), radius);
    OptionalDouble shortest =
        new ShortestDiscPath(floor.grid(), radius).length(floor.start(), floor.goal());
    Value bound =
        shortest.isPresent() ? Value.of(rounded(100 * shortest.getAsDouble()), "cm") : Value.NONE;
    List<Chart.Series> costs = new ArrayList<>();
    for (SmoothMethod method : METHODS) {
      run.checkStopped();
      List<PlannedPath> found = new ArrayList<>();
      for (int i = 0; i < run.runs(); i++) {
        found.add(PlannedPath.of(method, space, floor, iterations, run.seedOf(i)));
      }
      costs.add(found.getFirst().series(iterations));
      result.methods.add(methodRow(floor, found, shortest));
      if (method == SmoothMethod.HYBRID) {
        addPlanned(floor, found.getFirst(), space, run, bound, result);
      }
    }
    result.drawings.add(
        new Chart(
            "cost-" + floor.number(),
            robot + ": best cost by iteration (tree and swarm)",
            "iteration",
            "cm",
            costs));
  }

  private static void addPlanned(
      CsmFloor floor, PlannedPath planned, DiscSpace space, Run run, Value bound, Result result) {
    if (planned.path() == null) {
      throw new IllegalStateException("There is no path on floor " + floor.number() + ".");
    }
    String robot = "robot " + floor.number();
    SmoothCurve curve = new SplineFitter(space).fit(planned.path().points());
    StaticDrive drive =
        StaticDrive.of(robot + ", ours", curve.pieces(), floor, run, run.seed() + floor.number());
    result.drives.add(drive);
    double[] published = PLANNED[floor.number() - 1];
    result.figures.add(
        Figure.notComparable(
                robot + ": path length",
                Value.of(published[0], "cm"),
                Value.of(rounded(100 * curve.length()), "cm"),
                LAYOUT)
            .withBound(bound));
    result.figures.add(
        Figure.notComparable(
            robot + ": iteration of the best cost",
            Value.of(published[1], ""),
            Value.of((double) planned.settledAfter(), ""),
            "Neither obstacles nor what an iteration does are published; ours is the first within"
                + " a thousandth of the last."));
    result.paths.add(
        List.of(
            robot,
            text(100 * floor.start().distanceTo(floor.goal()), 2),
            bound.text(),
            text(planned.centimetres(), 2),
            text(100 * curve.length(), 2),
            text(published[0], 2)));
    result.drawings.add(scene(floor, curve, drive));
  }

  private static Animation scene(CsmFloor floor, SmoothCurve curve, StaticDrive drive) {
    List<Scene.Mark> marks = new ArrayList<>(floor.marks());
    if (floor.number() == 1) {
      marks.add(published(PublishedCurve.EQUATION_9, "equation 9 of the paper"));
    }
    if (floor.number() == 3) {
      marks.add(published(PublishedCurve.EQUATION_14, "equation 14 of the paper"));
    }
    marks.add(new Scene.Line(curve.points(0.01), Colour.BLUE, false, "our path"));
    List<Vec2> driven = drive.drive().samples().stream().map(s -> s.truth().position()).toList();
    marks.add(new Scene.Line(driven, Colour.RED, true, "driven in truth"));
    Scene ground =
        new Scene(
            "floor-" + floor.number(),
            "Robot " + floor.number() + ": obstacles of ours, 250 x 250 cm",
            Vec2.ZERO,
            new Vec2(CsmFloor.SIDE, CsmFloor.SIDE),
            marks);
    return Animation.of(
        ground,
        WheelCommand.SAMPLE,
        List.of(new Animation.Body("robot", DynamicDrive.BODY, Colour.BLUE, driven)));
  }

  private static Scene.Line published(PublishedCurve curve, String label) {
    List<Vec2> points = new ArrayList<>();
    for (int i = 0; i <= 200; i++) {
      points.add(curve.position(curve.end() * i / 200));
    }
    return new Scene.Line(points, Colour.ORANGE, true, label);
  }

  private static void addTableI(Result result) {
    for (int i = 0; i < TABLE_I.length; i++) {
      StaticDrive drive = result.drives.get(i);
      String robot = "robot " + (i + 1);
      double[] published = TABLE_I[i];
      result.figures.add(
          Figure.notComparable(
              robot + ": actual path",
              Value.of(published[1], "cm"),
              Value.of(rounded(100 * drive.actual()), "cm"),
              LAYOUT));
      double error = 100 * Math.abs(drive.actual() - drive.desired());
      result.figures.add(
          Figure.atMost(robot + ": actual less desired path", published[2], rounded(error), "cm")
              .because("On our path, by the answers of the robot."));
    }
  }

  /** What the paper's own equations say, which needs no obstacles. */
  private static void addCurves(List<Figure> figures) {
    PublishedCurve nine = PublishedCurve.EQUATION_9;
    PublishedCurve fourteen = PublishedCurve.EQUATION_14;
    figures.add(
        Figure.near("robot 1: desired path", TABLE_I[0][0], rounded(nine.length()), 0.01, "cm")
            .because("Measured: the length of equation 9, within 1 percent."));
    figures.add(
        Figure.notComparable(
            "robot 2: desired path",
            Value.of(TABLE_I[1][0], "cm"),
            Value.NONE,
            "The coefficients of its equation 12 are not printed."));
    figures.add(
        Figure.near("robot 3: desired path", TABLE_I[2][0], rounded(fourteen.length()), 0.01, "cm")
            .because("Measured: the length of equation 14, which does not end at its goal."));
    figures.add(
        new Figure(
            "robot 3: y at the end of equation 14",
            Value.of(200, "cm"),
            Value.of(rounded(fourteen.y(fourteen.to())), "cm"),
            Value.NONE,
            Verdict.REFUTED,
            "The goal is (210, 200); no rounding of printed digits makes up for it."));
  }

  private static void addDriving(Result result) {
    for (StaticDrive drive : result.drives) {
      result.figures.add(
          Figure.atMost(
              drive.name() + ": position error, at most",
              MOST_POSITION_ERROR,
              rounded(100 * drive.positionError()),
              "cm"));
      result.figures.add(
          Figure.atMost(
              drive.name() + ": orientation error, at most",
              MOST_ORIENTATION_ERROR,
              rounded(drive.orientationError()),
              "rad"));
    }
    double speed = result.drives.stream().mapToDouble(StaticDrive::wheelSpeed).max().orElse(0);
    double amplitude = result.drives.stream().mapToDouble(StaticDrive::amplitude).max().orElse(0);
    double pulse = result.drives.stream().mapToDouble(StaticDrive::pulse).max().orElse(0);
    double on = result.drives.stream().mapToDouble(StaticDrive::on).max().orElse(0);
    result.figures.add(Figure.atMost("wheel speed, at most", 0.52, rounded(speed), "m/s"));
    result.figures.add(Figure.atMost("ISPA, at most", 255, amplitude, ""));
    result.figures.add(
        Figure.atMost("pulse time by its formula, at most", 33, rounded(pulse), "ms"));
    result.figures.add(
        new Figure(
            "pulse within a sample",
            Value.of(33, "ms"),
            Value.of(rounded(on), "ms"),
            Value.of(1000 * WheelCommand.SAMPLE, "ms"),
            Verdict.REFUTED,
            "A pulse of 33 ms does not end within a sample of 30 ms; T_on of equation 8 does, with"
                + " the sample as its period."));
  }

  private static void addDrawings(Result result) {
    List<Chart.Series> errors = new ArrayList<>();
    for (StaticDrive drive : result.drives) {
      List<Chart.Point> points = new ArrayList<>();
      for (TrackedDrive.Sample sample : drive.drive().samples()) {
        points.add(new Chart.Point(sample.command().time(), 100 * sample.positionError()));
      }
      errors.add(new Chart.Series(drive.name(), points));
    }
    result.drawings.add(
        new Chart("position-error", "Position error by the answers", "s", "cm", errors));
    List<Chart.Point> left = new ArrayList<>();
    List<Chart.Point> right = new ArrayList<>();
    for (TrackedDrive.Sample sample : result.drives.getFirst().drive().samples()) {
      left.add(new Chart.Point(sample.command().time(), sample.command().left().speed()));
      right.add(new Chart.Point(sample.command().time(), sample.command().right().speed()));
    }
    result.drawings.add(
        new Chart(
            "wheel-speeds",
            "Robot 1: speeds of its wheels",
            "s",
            "m/s",
            List.of(new Chart.Series("left", left), new Chart.Series("right", right))));
  }

  private static Table paths(Result result) {
    return new Table(
        "paths",
        "Paths (cm)",
        List.of("robot", "straight line", "exact shortest", "way points", "spline", "published"),
        result.paths);
  }

  private static Table methods(Result result) {
    return new Table(
        "methods",
        "What tree and swarm do (cm, over all runs)",
        List.of("robot", "method", "found", "median", "worst", "over shortest", "settled after"),
        result.methods);
  }

  private static List<String> methodRow(
      CsmFloor floor, List<PlannedPath> found, OptionalDouble shortest) {
    double[] lengths =
        found.stream()
            .mapToDouble(PlannedPath::centimetres)
            .filter(Double::isFinite)
            .sorted()
            .toArray();
    boolean hasNone = lengths.length == 0;
    double median = hasNone ? Double.NaN : lengths[lengths.length / 2];
    return List.of(
        "robot " + floor.number(),
        found.getFirst().name(),
        lengths.length + " of " + found.size(),
        hasNone ? "-" : text(median, 2),
        hasNone ? "-" : text(lengths[lengths.length - 1], 2),
        hasNone || shortest.isEmpty()
            ? "-"
            : text(100 * (median / (100 * shortest.getAsDouble()) - 1), 2) + " %",
        hasNone ? "-" : Long.toString(found.getFirst().settledAfter()));
  }

  private static Table tracking(Result result) {
    List<List<String>> rows = new ArrayList<>();
    for (StaticDrive drive : result.drives) {
      rows.add(
          List.of(
              drive.name(),
              text(100 * drive.desired(), 4),
              text(100 * drive.actual(), 4),
              text(100 * Math.abs(drive.actual() - drive.desired()), 4),
              text(100 * drive.positionError(), 3),
              text(100 * drive.aside(), 3),
              text(drive.orientationError(), 4),
              text(100 * drive.trueError(), 2),
              text(100 * drive.trueErrorWithRanges(), 2)));
    }
    return new Table(
        "tracking",
        "Driven (cm, rad): by the answers of the robot, and in truth without and with ranges",
        List.of(
            "path",
            "desired",
            "actual",
            "error",
            "position error",
            "beside",
            "orientation error",
            "error in truth",
            "with ranges"),
        rows);
  }

  private static Table sensitivity(Run run) {
    List<List<String>> rows = new ArrayList<>();
    addSensitivity(rows, run, CsmParameters.DELAY, 0.0, 0.04, 0.1, 0.2);
    addSensitivity(rows, run, CsmParameters.LAG, 0.0, 0.05, 0.1, 0.2);
    addSensitivity(rows, run, CsmParameters.SLIP, 0.0, 0.01, 0.05);
    addSensitivity(rows, run, CsmParameters.WHEEL_SIZE, 0.0, 0.001, 0.01);
    addSensitivity(rows, run, CsmParameters.RANGE_NOISE, 0.001, 0.03, 0.1);
    return new Table(
        "sensitivity",
        "Equation 9 with other values of one parameter",
        List.of(
            "parameter",
            "value",
            "position error (cm)",
            "orientation error",
            "in truth (cm)",
            "with ranges"),
        rows);
  }

  private static void addSensitivity(
      List<List<String>> rows, Run run, Parameter parameter, double... values) {
    for (double value : values) {
      run.checkStopped();
      StaticDrive drive =
          StaticDrive.of(
              "",
              List.of(PublishedCurve.EQUATION_9),
              CsmFloor.read(1),
              run.with(parameter, value),
              run.seed());
      rows.add(
          List.of(
              parameter.name(),
              Value.of(value, parameter.unit()).text(),
              text(100 * drive.positionError(), 3),
              text(drive.orientationError(), 4),
              text(100 * drive.trueError(), 2),
              text(100 * drive.trueErrorWithRanges(), 2)));
    }
  }

  private static String text(double value, int decimals) {
    return String.format(Locale.ROOT, "%." + decimals + "f", value);
  }

  /** To four decimals, as the paper has them. */
  private static double rounded(double value) {
    return Math.round(value * 1e4) / 1e4;
  }
}
