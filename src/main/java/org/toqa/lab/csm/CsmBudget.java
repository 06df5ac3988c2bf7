package org.toqa.lab.csm;

import static org.toqa.lab.csm.CsmParameters.LIMITS;
import static org.toqa.lab.csm.CsmParameters.PLANNED;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.toqa.driving.DrivenLine;
import org.toqa.driving.WheelTracker;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Twist;
import org.toqa.lab.experiment.Experiment;
import org.toqa.lab.experiment.Figure;
import org.toqa.lab.experiment.Parameter;
import org.toqa.lab.experiment.Report;
import org.toqa.lab.experiment.Run;
import org.toqa.lab.experiment.Table;
import org.toqa.lab.experiment.Value;
import org.toqa.motion.WheelCommand;
import org.toqa.motion.WheelSchedule;
import org.toqa.statistics.Percentiles;

/** What one sample costs the server, of the 30 ms that there are for all robots. */
public final class CsmBudget implements Experiment {
  private static final Parameter ROBOTS =
      new Parameter("robots", 1000, 1, 100_000, "", "whose samples are computed one after another");

  private static final Parameter SAMPLES =
      new Parameter("samples", 200, 10, 2000, "", "of each robot that are measured");

  /** Milliseconds. */
  private static final double SAMPLE_OF_PAPER = 2.57;

  private static final double THIRD_ROBOT_STATIC = 2.75;
  private static final double SEND = 2.5;
  private static final double RECEIVE = 2.5;
  private static final double REPLAN = 4.497;
  private static final double LIMIT = 1000 * WheelCommand.SAMPLE;

  private static final int REPLANS = 20;

  private static final String NETWORK =
      "The paper's wireless network is not published; no network is measured here.";

  private static final String TIME =
      "A time of this machine, median; of the paper's nothing is known.";

  @Override
  public String name() {
    return "csm-budget";
  }

  @Override
  public String title() {
    return "what a sample of 30 ms costs: computing for one robot, for a thousand, and replanning";
  }

  @Override
  public String source() {
    return CsmParameters.SOURCE + ": tables II, III and IV";
  }

  @Override
  public List<Parameter> parameters() {
    List<Parameter> all = new ArrayList<>(List.of(ROBOTS, SAMPLES));
    all.addAll(CsmParameters.OF_BODY);
    all.addAll(List.of(CsmParameters.RADIUS, CsmParameters.ITERATIONS));
    return all;
  }

  @Override
  public Report run(Run run) {
    CsmFloor floor = CsmFloor.read(1);
    run.progress(0, "planning a path");
    DrivenLine line = CsmDynamic.line(floor, run, run.seed());
    run.progress(0.1, "samples of robots");
    Samples samples = samples(run);
    run.progress(0.7, "schedules");
    Percentiles schedules = schedules(run);
    run.progress(0.8, "replanning");
    Percentiles replans = replans(floor, line, run);
    return new Report(
        figures(samples, replans),
        List.of(times(samples, schedules, replans), budget(samples, replans)),
        List.of(),
        List.of(
            "Times differ from run to run and from machine to machine; everything else does not.",
            "Send and receive of 2.5 ms each are the paper's own in all sums."));
  }

  /**
   * @param robots how many there are
   * @param one milliseconds for a sample of one robot: its pose predicted, its law, its wheels
   * @param all milliseconds for a sample of all robots
   */
  private record Samples(double robots, Percentiles one, Percentiles all) {}

  private static Samples samples(Run run) {
    int robots = (int) Math.round(run.value(ROBOTS));
    int count = (int) Math.round(run.value(SAMPLES));
    WheelSchedule schedule = schedule();
    Pose start = start();
    List<WheelCommand> commands = schedule.commands();
    Percentiles all = percentiles(List.of());
    List<Double> each = new ArrayList<>();
    for (int round = 0; round < 2; round++) { // the first one warms up
      each.clear();
      List<WheelTracker> trackers = new ArrayList<>();
      for (int i = 0; i < robots; i++) {
        trackers.add(new WheelTracker(LIMITS, CsmParameters.RESPONSE));
      }
      Pose reference = start;
      List<Pose> answers = new ArrayList<>();
      for (int sample = 0; sample < count; sample++) {
        run.checkStopped();
        Twist twist = twist(commands.get(sample % commands.size()));
        Twist then = twist(commands.get((sample + 1) % commands.size()));
        answers.add(reference);
        int answered = Math.max(0, sample - 2);
        long begin = System.nanoTime();
        for (WheelTracker tracker : trackers) {
          tracker.next(reference, twist, then, answered, answers.get(answered));
        }
        each.add((System.nanoTime() - begin) / 1e6);
        reference = reference.advanced(twist, WheelCommand.SAMPLE);
      }
      all = percentiles(each);
    }
    List<Double> one = each.stream().map(ms -> ms / robots).toList();
    return new Samples(robots, percentiles(one), all);
  }

  private static Twist twist(WheelCommand command) {
    return new Twist(command.v(), 0, command.w());
  }

  private static Pose start() {
    PublishedCurve curve = PublishedCurve.EQUATION_9;
    return new Pose(curve.position(0).x(), curve.position(0).y(), curve.velocity(0).angle());
  }

  private static WheelSchedule schedule() {
    PublishedCurve curve = PublishedCurve.EQUATION_9;
    return WheelSchedule.of(
        curve.velocity(0).angle(), List.of(curve), curve.velocity(curve.end()).angle(), PLANNED);
  }

  /** Of a whole path: its speeds, and its wheel commands. */
  private static Percentiles schedules(Run run) {
    List<Double> each = new ArrayList<>();
    for (int i = 0; i < 2 * REPLANS; i++) {
      run.checkStopped();
      long begin = System.nanoTime();
      schedule();
      each.add((System.nanoTime() - begin) / 1e6);
    }
    return percentiles(each.subList(REPLANS, each.size()));
  }

  /** Of each look ahead of the robot of floor 1 that led to planning, over many drives. */
  private static Percentiles replans(CsmFloor floor, DrivenLine line, Run run) {
    List<Double> each = new ArrayList<>();
    for (int i = 0; i < 2 * REPLANS; i++) {
      run.checkStopped();
      DynamicDrive drive = new DynamicDrive(floor, line, floor.moving(), run, run.seedOf(i));
      List<Double> times = drive.drive().planningMilliseconds();
      each.addAll(i < REPLANS ? List.of() : times); // the first ones warm up
    }
    return percentiles(each);
  }

  private static Percentiles percentiles(List<Double> values) {
    return new Percentiles(values.stream().mapToDouble(Double::doubleValue).toArray());
  }

  private static List<Figure> figures(Samples samples, Percentiles replans) {
    double ours = samples.one().percentile(0.5);
    List<Figure> figures = new ArrayList<>();
    figures.add(atMost("computing a sample of one robot", SAMPLE_OF_PAPER, ours));
    figures.add(atMost("computing a sample, third robot of table II", THIRD_ROBOT_STATIC, ours));
    figures.add(
        Figure.notComparable("sending a packet", Value.of(SEND, "ms"), Value.NONE, NETWORK));
    figures.add(
        Figure.notComparable("receiving a packet", Value.of(RECEIVE, "ms"), Value.NONE, NETWORK));
    figures.add(atMost("replanning for a moving obstacle", REPLAN, replans.percentile(0.5)));
    double network = SEND + RECEIVE;
    figures.add(
        sum(
            "table II, three robots",
            22.89,
            2 * SAMPLE_OF_PAPER + THIRD_ROBOT_STATIC + 3 * network));
    figures.add(
        sum("table III, one of three replans", 27.207, 3 * (SAMPLE_OF_PAPER + network) + REPLAN));
    figures.add(
        sum("table IV, two robots replan", 24.134, 2 * (SAMPLE_OF_PAPER + network + REPLAN)));
    figures.add(
        atMost(
                "a sample of %d robots".formatted(Math.round(samples.robots())),
                LIMIT,
                samples.all().percentile(0.99))
            .because(
                "Published is the sample itself, in which the paper has three robots; ours is"
                    + " the 99th percentile, without a network."));
    return figures;
  }

  private static Figure atMost(String name, double published, double measured) {
    return Figure.atMost(name, published, rounded(measured), "ms").because(TIME);
  }

  private static Figure sum(String name, double published, double sum) {
    return Figure.near(name, published, rounded(sum), 1e-4, "ms")
        .because("Measured: the sum of the table's own rows.");
  }

  private static Table times(Samples samples, Percentiles schedules, Percentiles replans) {
    return new Table(
        "times",
        "Computed here (ms)",
        List.of("what", "median", "99th percentile", "most"),
        List.of(
            row("a sample of one robot, of many", samples.one()),
            row("a sample of %d robots".formatted(Math.round(samples.robots())), samples.all()),
            row("the wheel schedule of a whole path", schedules),
            row("replanning for a moving obstacle", replans)));
  }

  private static List<String> row(String what, Percentiles times) {
    return List.of(
        what, text(times.percentile(0.5)), text(times.percentile(0.99)), text(times.max()));
  }

  private static Table budget(Samples samples, Percentiles replans) {
    double network = SEND + RECEIVE;
    double ours = samples.one().percentile(0.5);
    return new Table(
        "budget",
        "Sums with the paper's network (ms of 30)",
        List.of("scenario", "published", "with our computing"),
        List.of(
            List.of("three robots", "22.89", text(3 * (ours + network))),
            List.of(
                "three robots, one replans",
                "27.207",
                text(3 * (ours + network) + replans.percentile(0.5))),
            List.of(
                "two robots, both replan",
                "24.134",
                text(2 * (ours + network + replans.percentile(0.5)))),
            List.of(
                "robots that fit, one after the other",
                Long.toString((long) (LIMIT / (SAMPLE_OF_PAPER + network))),
                Long.toString((long) (LIMIT / (ours + network))))));
  }

  private static String text(double value) {
    return String.format(Locale.ROOT, "%.4f", value);
  }

  private static double rounded(double value) {
    return Math.round(value * 1e6) / 1e6;
  }
}
