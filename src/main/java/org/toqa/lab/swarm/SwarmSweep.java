package org.toqa.lab.swarm;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
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

    /** Of those that arrived; NaN where none did. */
    double medianSteps() {
      double[] steps =
          results.stream()
              .filter(SwarmDrive.Result::isReached)
              .mapToDouble(SwarmDrive.Result::steps)
              .toArray();
      return steps.length == 0 ? Double.NaN : new Percentiles(steps).percentile(0.5);
    }
  }

  @Override
  public Report run(Run run) {
    SwarmSetup setup = SwarmSetup.of(run);
    List<Cell> cells = new ArrayList<>();
    for (String name : MAPS) {
      SwarmMap map = SwarmMap.named(name);
      for (int turn : TURNS) {
        run.progress(
            0.8 * cells.size() / (MAPS.size() * TURNS.length * (double) SPEEDS),
            "%s map, w = %d".formatted(name, turn));
        for (int i = 1; i <= SPEEDS; i++) {
          cells.add(cell(map, turn, i / 10.0, setup, 0.001, 0.01, run));
        }
      }
    }
    List<Figure> figures = new ArrayList<>(energy());
    figures.addAll(thresholds(cells));
    figures.addAll(claims(cells));
    run.progress(0.8, "with and without epsilon");
    figures.addAll(epsilon(cells, setup, run));
    run.progress(0.9, "sensitivity");
    return new Report(
        figures,
        List.of(bySpeed(cells, setup), sensitivity(run)),
        drawings(cells, setup, run),
        List.of(
            MAPS_ARE_LOST,
            "The bound of the steps is the exact shortest path of the rigid swarm, which may turn"
                + " on the spot, at the speed v, less the target's radius."));
  }

  private static Cell cell(
      SwarmMap map,
      int turn,
      double speed,
      SwarmSetup setup,
      double epsilonSeen,
      double epsilonFree,
      Run run) {
    SwarmLaw law = new SwarmLaw(Math.toRadians(turn), epsilonSeen, epsilonFree);
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
    double complex1 = spread(of(cells, "complex", 1));
    double complex20 = spread(of(cells, "complex", 20));
    figures.add(
        new Figure(
            "complex: change of the losses from speed to speed, w = 1 and w = 20",
            Value.of("more variable with larger w"),
            Value.of(text(complex1, 2) + ", " + text(complex20, 2)),
            Value.NONE,
            complex20 > complex1 ? Verdict.REPRODUCED : Verdict.REFUTED,
            "The mean difference between neighbouring speeds, robots. A swarm that goes round for ever"
                + " loses none."));
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

  /** On the complex map at low speeds. */
  private static List<Figure> epsilon(List<Cell> cells, SwarmSetup setup, Run run) {
    SwarmMap map = SwarmMap.named("complex");
    int arrivedWith = 0;
    int arrivedWithout = 0;
    double lostWith = 0;
    double lostWithout = 0;
    int drives = 0;
    for (int turn : TURNS) {
      for (int i = 1; i <= 10; i++) {
        Cell with = of(cells, "complex", turn).get(i - 1);
        Cell without = cell(map, turn, i / 10.0, setup, 0, 0, run);
        drives += with.results().size();
        arrivedWith += (int) Math.rint(with.reached() * with.results().size());
        arrivedWithout += (int) Math.rint(without.reached() * without.results().size());
        lostWith += with.meanLost() / (10 * TURNS.length);
        lostWithout += without.meanLost() / (10 * TURNS.length);
      }
    }
    return List.of(
        new Figure(
            "complex, v to 1: swarms that arrive with epsilon, and without",
            Value.of("all with it"),
            Value.of("%d and %d of %d".formatted(arrivedWith, arrivedWithout, drives)),
            Value.of(drives + " of " + drives),
            arrivedWith == drives ? Verdict.REPRODUCED : Verdict.REFUTED,
            "The paper: epsilon guarantees that the swarm comes out of all loops. Here within a way"
                + " of six times the straight line."),
        new Figure(
            "complex, v to 1: robots lost with epsilon, and without",
            Value.of("the same"),
            Value.of(text(lostWith, 2) + ", " + text(lostWithout, 2)),
            Value.of(0, ""),
            Math.abs(lostWith - lostWithout) < 0.5 ? Verdict.REPRODUCED : Verdict.REFUTED,
            "The mean of nine; the same within half a robot."));
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
    List<List<String>> rows = new ArrayList<>();
    rows.add(sensitivityRow("as chosen", run));
    rows.add(sensitivityRow("lidar-range 80", run.with(SwarmSetup.LIDAR_RANGE, 80)));
    rows.add(sensitivityRow("lidar-range 160", run.with(SwarmSetup.LIDAR_RANGE, 160)));
    rows.add(sensitivityRow("outward 10", run.with(SwarmSetup.OUTWARD, 10)));
    rows.add(sensitivityRow("outward 30", run.with(SwarmSetup.OUTWARD, 30)));
    rows.add(sensitivityRow("view 20", run.with(SwarmSetup.VIEW, 20)));
    rows.add(sensitivityRow("view 45", run.with(SwarmSetup.VIEW, 45)));
    rows.add(sensitivityRow("apart 60", run.with(SwarmSetup.APART, 60)));
    rows.add(sensitivityRow("robot-radius 10", run.with(SwarmSetup.ROBOT_RADIUS, 10)));
    rows.add(sensitivityRow("target-radius 30", run.with(SwarmSetup.TARGET_RADIUS, 30)));
    return new Table(
        "sensitivity",
        "How much depends on what was chosen: w = 1, speeds 0.5, 1.0 ... 5.5",
        List.of("parameter", "simple: all arrive", "none from", "complex: all arrive", "none from"),
        rows);
  }

  private static List<String> sensitivityRow(String name, Run run) {
    SwarmSetup setup = SwarmSetup.of(run);
    List<String> row = new ArrayList<>(List.of(name));
    for (String map : MAPS) {
      SwarmMap one = SwarmMap.named(map);
      List<Cell> cells = new ArrayList<>();
      for (int i = 1; i <= 11; i++) {
        cells.add(cell(one, 1, i / 2.0, setup, 0.001, 0.01, run));
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
            new Chart.Series(
                "w = " + turn,
                those.stream()
                    .map(c -> new Chart.Point(c.speed(), Math.log10(c.medianSteps())))
                    .toList()));
        lost.add(
            new Chart.Series(
                "w = " + turn,
                those.stream().map(c -> new Chart.Point(c.speed(), c.meanLost())).toList()));
      }
      String on = ", " + name + " map";
      drawings.add(
          new Chart(
              "steps-" + name,
              "Steps to the target (figure 11)" + on,
              "v (m/s)",
              "log10 of the median steps of those that arrived; a gap where none did",
              steps));
      drawings.add(
          new Chart(
              "lost-" + name,
              "Robots lost of " + ROBOTS + " (figure 12)" + on,
              "v (m/s)",
              "robots",
              lost));
      drawings.add(picture(SwarmMap.named(name), setup, run));
    }
    return drawings;
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
      Cell cell = cell(map, 1, speeds[i], setup, 0.001, 0.01, run);
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
