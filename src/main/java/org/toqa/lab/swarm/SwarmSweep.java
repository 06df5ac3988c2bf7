package org.toqa.lab.swarm;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import java.util.stream.DoubleStream;
import org.toqa.formation.swarm.Observers;
import org.toqa.formation.swarm.SwarmLaw;
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
import org.toqa.statistics.Percentiles;

/**
 * {@code virtual-leader}: figures 7, 11 and 12: the energy of the lidars, and steps and losses over
 * the speed v and the turn w a step.
 */
public final class SwarmSweep implements Experiment {
  private static final List<String> MAPS = List.of("simple", "complex");
  private static final int[] TURNS = {1, 5, 10, 20};

  /** Speeds: 0.1 to 5.5 m/s, in tenths. */
  private static final int SPEEDS = 55;

  /** Drives with each speed and turn in a run. */
  private static final int DRIVES = 1;

  private static final int ROBOTS = 9;

  /** After so many speeds a run tells how far it is. */
  private static final int TOLD = 11;

  /** What part of a run the sweep is, and what part the loops; the rest is the sensitivity. */
  private static final double SWEEP_SHARE = 0.4;

  private static final double LOOPS_SHARE = 0.3;

  /** The drives that show whether loops are left: the lowest ten speeds. */
  private static final int LOOP_SPEEDS = 10;

  /** And how long they are at most: at 1 m/s six times as long as the drives of the sweep. */
  private static final int LOOP_STEPS = 60_000;

  private static final String MAPS_ARE_LOST =
      "The maps, the lidars' range and the robots' width are not published; these are ours.";

  @Override
  public String name() {
    return "virtual-leader";
  }

  @Override
  public String title() {
    return "A swarm behind a virtual leader: steps and losses over v and w";
  }

  @Override
  public String source() {
    return "Toibazarov, Baiseitov, Kyzyrkanov, Aljavarneh, Atanov 2023: figures 7, 11 and 12";
  }

  @Override
  public List<Parameter> parameters() {
    return SwarmSetup.PARAMETERS;
  }

  /** All drives with one map, turn and speed. */
  private record Cell(String map, int turn, double speed, List<SwarmDrive.Result> results) {
    double reached() {
      return results.stream().filter(SwarmDrive.Result::isReached).count()
          / (double) results.size();
    }

    double meanLost() {
      return results.stream().mapToInt(SwarmDrive.Result::lost).average().orElse(0);
    }

    int mostLost() {
      return results.stream().mapToInt(SwarmDrive.Result::lost).max().orElse(0);
    }

    int leastLost() {
      return results.stream().mapToInt(SwarmDrive.Result::lost).min().orElse(0);
    }

    boolean isWhole() {
      return reached() == 1 && mostLost() == 0;
    }

    /** Of those that arrived. */
    private DoubleStream steps() {
      return results.stream()
          .filter(SwarmDrive.Result::isReached)
          .mapToDouble(SwarmDrive.Result::steps);
    }

    /** Of those that arrived; NaN where none did. */
    double medianSteps() {
      double[] steps = steps().toArray();
      return steps.length == 0 ? Double.NaN : new Percentiles(steps).percentile(0.5);
    }

    double leastSteps() {
      return steps().min().orElse(Double.NaN);
    }

    double mostSteps() {
      return steps().max().orElse(Double.NaN);
    }
  }

  @Override
  public Report run(Run run) {
    SwarmSetup setup = SwarmSetup.of(run);
    List<Cell> cells = sweep(setup, run);
    List<Figure> figures = new ArrayList<>(energy());
    figures.addAll(thresholds(cells));
    figures.addAll(claims(cells));
    List<LoopCell> loops = loops(setup, run);
    figures.addAll(epsilon(loops));
    return new Report(
        figures,
        List.of(bySpeed(cells, setup), byEpsilon(loops), sensitivity(run)),
        drawings(cells, setup, run),
        List.of(
            MAPS_ARE_LOST,
            "The bound of the steps is the exact shortest path of the rigid swarm, which may turn"
                + " on the spot, at the speed v, less the target's radius."));
  }

  private static List<Cell> sweep(SwarmSetup setup, Run run) {
    List<Cell> cells = new ArrayList<>();
    for (String name : MAPS) {
      SwarmMap map = SwarmMap.named(name);
      for (int turn : TURNS) {
        for (int i = 1; i <= SPEEDS; i++) {
          double speed = i / 10.0;
          if (i % TOLD == 1) {
            run.progress(
                SWEEP_SHARE * cells.size() / (MAPS.size() * TURNS.length * (double) SPEEDS),
                "%s map, w = %d, from v = %s".formatted(name, turn, speed));
          }
          cells.add(cell(map, turn, speed, setup, run));
        }
      }
    }
    return cells;
  }

  private static Cell cell(SwarmMap map, int turn, double speed, SwarmSetup setup, Run run) {
    SwarmLaw law = SwarmLaw.published(Math.toRadians(turn));
    List<SwarmDrive.Result> results = new ArrayList<>();
    for (int i = 0; i < DRIVES * run.runs(); i++) {
      run.checkStopped();
      SplittableRandom random = new SplittableRandom(seed(run, i, turn, speed));
      results.add(new SwarmDrive(map, setup, law, speed, random).run());
    }
    return new Cell(map.name(), turn, speed, results);
  }

  private static long seed(Run run, int drive, int turn, double speed) {
    return run.seedOf(drive) * 1_000_003 + turn * 1009L + (long) (speed * 10);
  }

  private static List<Figure> energy() {
    return List.of(
        Figure.near("lidar energy saved by 4 robots", 25, 100 * Observers.saving(4), 0.001, "%")
            .because("Of the lidars' energy, not of the robots': (N - 3) / N."),
        Figure.near("lidar energy saved by 10 robots", 70, 100 * Observers.saving(10), 0.001, "%"));
  }

  private static List<Cell> of(List<Cell> cells, String map, int turn) {
    return cells.stream().filter(c -> c.map().equals(map) && c.turn() == turn).toList();
  }

  private static List<Figure> thresholds(List<Cell> cells) {
    List<Cell> simple = of(cells, "simple", 1);
    List<Cell> complex = of(cells, "complex", 1);
    return List.of(
        whole("simple, w = 1: all robots arrive", "below 2 m/s", simple),
        limit("simple, w = 1: none arrives from", 3, noneFrom(simple)),
        whole("complex, w = 1: all robots arrive", "below 1 m/s", complex),
        limit("complex, w = 1: none arrives from", 3.4, noneFrom(complex)),
        Figure.notComparable(
            "simple, w = 20: most robots lost",
            Value.of(3, ""),
            Value.of(of(cells, "simple", 20).stream().mapToInt(Cell::mostLost).max().orElse(0), ""),
            MAPS_ARE_LOST));
  }

  private static Figure whole(String name, String published, List<Cell> cells) {
    return Figure.notComparable(
        name, Value.of(published), Value.of(wholeSpeeds(cells)), MAPS_ARE_LOST);
  }

  /** The longest run of speeds at which no robot is lost. */
  private static String wholeSpeeds(List<Cell> cells) {
    int first = 0;
    int longest = 0;
    int begin = 0;
    for (int i = 0; i < cells.size(); i++) {
      begin = cells.get(i).isWhole() ? begin : i + 1;
      if (i + 1 - begin > longest) {
        longest = i + 1 - begin;
        first = begin;
      }
    }
    return longest == 0
        ? "never"
        : "from %s to %s m/s"
            .formatted(
                text(cells.get(first).speed(), 1), text(cells.get(first + longest - 1).speed(), 1));
  }

  private static Figure limit(String name, double published, double measured) {
    return Figure.notComparable(
        name, Value.of(published, "m/s"), Value.of(measured, "m/s"), MAPS_ARE_LOST);
  }

  /** The speed from which on none arrives; beyond the last one where some always do. */
  private static double noneFrom(List<Cell> cells) {
    double from = 5.6;
    for (Cell cell : cells.reversed()) {
      if (cell.reached() > 0) {
        return from;
      }
      from = cell.speed();
    }
    return from;
  }

  /** What the paper says in words, of any map. */
  private static List<Figure> claims(List<Cell> cells) {
    List<Figure> figures = new ArrayList<>();
    List<Cell> reached = of(cells, "simple", 1).stream().filter(c -> c.reached() > 0).toList();
    int rises = 0;
    for (int i = 1; i < reached.size(); i++) {
      rises += reached.get(i).medianSteps() > reached.get(i - 1).medianSteps() ? 1 : 0;
    }
    figures.add(
        new Figure(
            "simple, w = 1: steps rise from one speed to the next",
            Value.of("decrease gradually"),
            Value.of(rises + " of " + Math.max(0, reached.size() - 1)),
            Value.of(0, ""),
            10 * rises <= reached.size() ? Verdict.REPRODUCED : Verdict.REFUTED,
            "Reproduced if at most a tenth rises."));
    double lost1 = meanLost(of(cells, "simple", 1));
    double lost20 = meanLost(of(cells, "simple", 20));
    figures.add(
        new Figure(
            "simple: robots lost with w = 1, and with w = 20",
            Value.of("fewer with larger w"),
            Value.of(text(lost1, 2) + ", " + text(lost20, 2)),
            Value.of(0, ""),
            lost20 < lost1 ? Verdict.REPRODUCED : Verdict.REFUTED,
            "The mean over all speeds."));
    figures.add(
        Figure.notComparable(
            "complex: change of the losses from speed to speed, w = 1 and w = 20",
            Value.of("more variable with larger w"),
            Value.of(
                text(spread(of(cells, "complex", 1)), 2)
                    + ", "
                    + text(spread(of(cells, "complex", 20)), 2)),
            "The complex map is not published. On ours swarms arrive with w = 20 at %d of %d speeds;"
                    .formatted(
                        of(cells, "complex", 20).stream().filter(c -> c.reached() > 0).count(),
                        SPEEDS)
                + " those that do not go round in a pocket and lose none. The mean difference between"
                + " neighbouring speeds, robots."));
    long whole = cells.stream().filter(Cell::isWhole).count();
    figures.add(
        new Figure(
            "guides the robots without collisions (abstract)",
            Value.of("always"),
            Value.of(whole + " of " + cells.size()),
            Value.of(cells.size() + " of " + cells.size()),
            whole == cells.size() ? Verdict.REPRODUCED : Verdict.REFUTED,
            "Of all speeds and turns on both maps; the paper's own figure 12 has losses too."));
    return figures;
  }

  private static double meanLost(List<Cell> cells) {
    return cells.stream().mapToDouble(Cell::meanLost).average().orElse(0);
  }

  private static double spread(List<Cell> cells) {
    double sum = 0;
    for (int i = 1; i < cells.size(); i++) {
      sum += Math.abs(cells.get(i).meanLost() - cells.get(i - 1).meanLost());
    }
    return sum / (cells.size() - 1);
  }

  /** Drives with one turn on the complex map at low speeds, until they arrive or are very long. */
  private record LoopCell(int turn, boolean hasEpsilon, List<SwarmDrive.Result> results) {
    long arrived() {
      return results.stream().filter(SwarmDrive.Result::isReached).count();
    }

    /** Those of which all robots were lost. */
    long lost() {
      return results.stream().filter(result -> result.lost() == ROBOTS).count();
    }

    long goingRound() {
      return results.size() - arrived() - lost();
    }

    /** At the target, of nine, mean. */
    double robotsAtTarget() {
      return results.stream().mapToInt(r -> r.isReached() ? ROBOTS - r.lost() : 0).sum()
          / (double) results.size();
    }

    double meanLost() {
      return results.stream().mapToInt(SwarmDrive.Result::lost).average().orElse(0);
    }
  }

  private static List<LoopCell> loops(SwarmSetup setup, Run run) {
    SwarmMap map = SwarmMap.named("complex");
    List<LoopCell> cells = new ArrayList<>();
    for (int turn : TURNS) {
      for (boolean hasEpsilon : List.of(true, false)) {
        SwarmLaw law =
            hasEpsilon
                ? SwarmLaw.published(Math.toRadians(turn))
                : new SwarmLaw(Math.toRadians(turn), 0, 0);
        run.progress(
            SWEEP_SHARE + LOOPS_SHARE * cells.size() / (2.0 * TURNS.length),
            "loops %s epsilon, w = %d".formatted(hasEpsilon ? "with" : "without", turn));
        List<SwarmDrive.Result> results = new ArrayList<>();
        for (int i = 1; i <= LOOP_SPEEDS; i++) {
          for (int j = 0; j < DRIVES * run.runs(); j++) {
            run.checkStopped();
            SplittableRandom random = new SplittableRandom(seed(run, j, turn, i / 10.0));
            results.add(new SwarmDrive(map, setup, law, i / 10.0, random).run(LOOP_STEPS));
          }
        }
        cells.add(new LoopCell(turn, hasEpsilon, results));
      }
    }
    return cells;
  }

  /** All turns together. */
  private static LoopCell together(List<LoopCell> loops, boolean hasEpsilon) {
    return new LoopCell(
        0,
        hasEpsilon,
        loops.stream()
            .filter(cell -> cell.hasEpsilon() == hasEpsilon)
            .flatMap(cell -> cell.results().stream())
            .toList());
  }

  private static List<Figure> epsilon(List<LoopCell> loops) {
    LoopCell with = together(loops, true);
    LoopCell without = together(loops, false);
    int drives = with.results().size();
    Verdict verdict =
        with.arrived() == drives
            ? Verdict.REPRODUCED
            : with.lost() > 0 ? Verdict.REFUTED : Verdict.NOT_COMPARABLE;
    return List.of(
        new Figure(
            "complex, v to 1: swarms that arrive with epsilon, and without",
            Value.of("all with it, ultimately"),
            Value.of("%d and %d of %d".formatted(with.arrived(), without.arrived(), drives)),
            Value.of(drives + " of " + drives),
            verdict,
            "Within %d steps; the paper names no number. With epsilon %d still went round then, and"
                    .formatted(LOOP_STEPS, with.goingRound())
                + " %d had lost all their robots, which no time makes up for."
                    .formatted(with.lost())),
        new Figure(
            "complex, v to 1: robots that reach the target with epsilon, and without",
            Value.of("as many"),
            Value.of(text(with.robotsAtTarget(), 2) + ", " + text(without.robotsAtTarget(), 2)),
            Value.of(ROBOTS, ""),
            with.robotsAtTarget() >= without.robotsAtTarget()
                ? Verdict.REPRODUCED
                : Verdict.REFUTED,
            "The mean of nine, in the same drives; reproduced if not fewer. Lost are %s with it and"
                    .formatted(text(with.meanLost(), 2))
                + " %s without.".formatted(text(without.meanLost(), 2))));
  }

  private static Table byEpsilon(List<LoopCell> loops) {
    return new Table(
        "epsilon",
        "Complex map, v = 0.1 to 1, %d steps at most".formatted(LOOP_STEPS),
        List.of(
            "w (degrees)",
            "epsilon",
            "drives",
            "arrived",
            "still going round",
            "all lost",
            "robots at the target (mean)",
            "lost (mean)"),
        loops.stream()
            .map(
                cell ->
                    List.of(
                        Integer.toString(cell.turn()),
                        cell.hasEpsilon() ? "as published" : "none",
                        Integer.toString(cell.results().size()),
                        Long.toString(cell.arrived()),
                        Long.toString(cell.goingRound()),
                        Long.toString(cell.lost()),
                        text(cell.robotsAtTarget(), 2),
                        text(cell.meanLost(), 2)))
            .toList());
  }

  private static Table bySpeed(List<Cell> cells, SwarmSetup setup) {
    List<List<String>> rows = new ArrayList<>();
    for (String name : MAPS) {
      double shortest = SwarmMap.named(name).shortest(setup.places(), setup.robotRadius());
      for (int turn : TURNS) {
        for (Cell cell : of(cells, name, turn)) {
          if (Math.rint(cell.speed() * 2) == cell.speed() * 2 || cell.speed() < 0.25) {
            rows.add(
                List.of(
                    name,
                    Integer.toString(turn),
                    text(cell.speed(), 1),
                    text(100 * cell.reached(), 0) + " %",
                    cell.leastLost() + " to " + cell.mostLost(),
                    text(cell.meanLost(), 1),
                    text(cell.medianSteps(), 0),
                    text((shortest - setup.targetRadius()) / cell.speed(), 0)));
          }
        }
      }
    }
    return new Table(
        "sweep",
        "Steps and losses of nine robots",
        List.of(
            "map",
            "w (degrees)",
            "v (m/s)",
            "arrived",
            "lost",
            "mean lost",
            "steps (median)",
            "steps at least"),
        rows);
  }

  /** One parameter at a time: the first limits of both maps with w = 1. */
  private static Table sensitivity(Run run) {
    Map<String, Run> variants = new LinkedHashMap<>();
    variants.put("as chosen", run);
    put(variants, run, SwarmSetup.LIDAR_RANGE, 80, 160);
    put(variants, run, SwarmSetup.OUTWARD, 10, 30);
    put(variants, run, SwarmSetup.VIEW, 20, 45);
    put(variants, run, SwarmSetup.APART, 60);
    put(variants, run, SwarmSetup.ROBOT_RADIUS, 10);
    put(variants, run, SwarmSetup.TARGET_RADIUS, 30);
    List<List<String>> rows = new ArrayList<>();
    variants.forEach(
        (name, variant) -> {
          double begin = SWEEP_SHARE + LOOPS_SHARE;
          run.progress(begin + (1 - begin) * rows.size() / variants.size(), "sensitivity, " + name);
          rows.add(sensitivityRow(name, variant));
        });
    return new Table(
        "sensitivity",
        "How much depends on what was chosen: w = 1, speeds 0.5, 1.0 ... 5.5",
        List.of("parameter", "simple: all arrive", "none from", "complex: all arrive", "none from"),
        rows);
  }

  private static void put(
      Map<String, Run> variants, Run run, Parameter parameter, double... values) {
    for (double value : values) {
      variants.put("%s %d".formatted(parameter.name(), (long) value), run.with(parameter, value));
    }
  }

  private static List<String> sensitivityRow(String name, Run run) {
    SwarmSetup setup = SwarmSetup.of(run);
    List<String> row = new ArrayList<>(List.of(name));
    for (String map : MAPS) {
      SwarmMap one = SwarmMap.named(map);
      List<Cell> cells = new ArrayList<>();
      for (int i = 1; i <= 11; i++) {
        cells.add(cell(one, 1, i / 2.0, setup, run));
      }
      row.add(wholeSpeeds(cells));
      row.add(text(noneFrom(cells), 1));
    }
    return row;
  }

  private static List<Drawing> drawings(List<Cell> cells, SwarmSetup setup, Run run) {
    List<Drawing> drawings = new ArrayList<>();
    List<Chart.Point> saved = new ArrayList<>();
    for (int robots = 1; robots <= 30; robots++) {
      saved.add(new Chart.Point(robots, 100 * Observers.saving(robots)));
    }
    drawings.add(
        new Chart(
            "energy",
            "Energy of the lidars that is saved (figure 7)",
            "robots",
            "%",
            List.of(new Chart.Series("(N - 3) / N", saved))));
    for (String name : MAPS) {
      List<Chart.Series> steps = new ArrayList<>();
      List<Chart.Series> lost = new ArrayList<>();
      for (int turn : TURNS) {
        List<Cell> those = of(cells, name, turn);
        steps.add(
            series(
                turn,
                those,
                cell -> Math.log10(cell.medianSteps()),
                cell -> Math.log10(cell.leastSteps()),
                cell -> Math.log10(cell.mostSteps())));
        lost.add(series(turn, those, Cell::meanLost, Cell::leastLost, Cell::mostLost));
      }
      String on = ", " + name + " map";
      drawings.add(
          new Chart(
              "steps-" + name,
              "Steps to the target (figure 11)" + on,
              "v (m/s)",
              "log10 of the steps of those that arrived: median, fewest to most; a gap where none did",
              steps));
      drawings.add(
          new Chart(
              "lost-" + name,
              "Robots lost of " + ROBOTS + " (figure 12)" + on,
              "v (m/s)",
              "robots: mean, least to most",
              lost));
      drawings.add(picture(SwarmMap.named(name), setup, run));
    }
    return drawings;
  }

  private static Chart.Series series(
      int turn,
      List<Cell> cells,
      ToDoubleFunction<Cell> middle,
      ToDoubleFunction<Cell> least,
      ToDoubleFunction<Cell> most) {
    return new Chart.Series(
        "w = " + turn, points(cells, middle), points(cells, least), points(cells, most));
  }

  private static List<Chart.Point> points(List<Cell> cells, ToDoubleFunction<Cell> value) {
    return cells.stream()
        .map(cell -> new Chart.Point(cell.speed(), value.applyAsDouble(cell)))
        .toList();
  }

  /** Tracks of the virtual leader at some speeds, w = 1 (figures 13 and 14). */
  private static Animation picture(SwarmMap map, SwarmSetup setup, Run run) {
    List<Scene.Mark> marks = new ArrayList<>(map.marks());
    marks.add(new Scene.Disc(SwarmMap.TARGET, setup.targetRadius(), Colour.RED));
    for (Vec2 place : setup.places()) {
      marks.add(new Scene.Disc(SwarmMap.START.plus(place), setup.robotRadius(), Colour.PURPLE));
    }
    double[] speeds = {0.5, 1, 2, 3};
    for (int i = 0; i < speeds.length; i++) {
      Cell cell = cell(map, 1, speeds[i], setup, run);
      SwarmDrive.Result first = cell.results().getFirst();
      marks.add(
          new Scene.Line(
              first.track(),
              Colour.ofLine(i),
              false,
              "v = %s: %d steps, %d lost".formatted(speeds[i], first.steps(), first.lost())));
    }
    Scene ground =
        new Scene(
            "tracks-" + map.name(),
            "The virtual leader, w = 1, " + map.name() + " map",
            Vec2.ZERO,
            map.size(),
            marks);
    SwarmLaw law = SwarmLaw.published(Math.toRadians(1));
    return Animation.of(
        ground,
        SwarmDrive.STEP,
        new SwarmDrive(map, setup, law, 1, new SplittableRandom(seed(run, 0, 1, 1))).bodies());
  }

  static String text(double number, int decimals) {
    return Double.isNaN(number) ? "-" : String.format(Locale.ROOT, "%." + decimals + "f", number);
  }
}
