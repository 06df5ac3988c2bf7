package org.toqa.lab.cmct;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import org.toqa.geometry.Vec2;
import org.toqa.grid.Cell;
import org.toqa.lab.cmct.PlannerSamples.Sum;
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

/** CMCT-PP beside A* with the same moves, A* from cell to cell and the exact shortest path. */
public final class CmctPlanning implements Experiment {
  static final String SOURCE =
      "CMCT (A Cooperative Multi-Robot Control Using Ad Hoc Wireless Network; Elsonbaty, Rizk,"
          + " Elksas, Salem)";

  private static final Parameter SCENES =
      new Parameter("scenes", 50, 1, 10_000, "", "stores of each kind in a run");

  private static final Parameter DENSITY =
      new Parameter("density", 0.15, 0, 0.5, "", "share of occupied cells, where there are any");

  private static final Parameter SPEED =
      new Parameter("speed", 1, 0.1, 100, "m/s", "of the driving robot");

  /** Of its text to figure 8. */
  private static final int TASKS_OF_TEXT = 4;

  /** Straight line over octile path at 22.5 degrees, where it is least. */
  private static final double LEAST_OF_OCTILE = Math.cos(Math.PI / 8);

  private static final String SAME_MOVES =
      "A* is optimal: with the same moves nothing can be shorter.";

  @Override
  public String name() {
    return "cmct-planner";
  }

  @Override
  public String title() {
    return "CMCT-PP beside A* and the exact shortest path, 1 to 10 tasks";
  }

  @Override
  public String source() {
    return SOURCE + ": figures 7 to 11";
  }

  @Override
  public List<Parameter> parameters() {
    return List.of(SCENES, DENSITY, SPEED);
  }

  @Override
  public Report run(Run run) {
    int scenes = (int) Math.round(run.value(SCENES));
    run.progress(0, "stores without obstacles");
    PlannerSamples.of(Run.of(run.seed(), 1), Math.min(scenes, 10), run.value(DENSITY)); // warm up
    PlannerSamples free = PlannerSamples.of(run, scenes, 0);
    run.progress(0.4, "stores with obstacles");
    PlannerSamples crowded = PlannerSamples.of(run, scenes, run.value(DENSITY));
    run.progress(0.95, "the rule as it is printed");
    List<Figure> figures = new ArrayList<>();
    addTimes(figures, run, free, "figure 8, without obstacles");
    addDistances(figures, free, "figure 9, without obstacles");
    figures.add(shorterThanOctile(free));
    addTimes(figures, run, crowded, "figure 10, with obstacles");
    addDistances(figures, crowded, "figure 11, with obstacles");
    addGrowth(figures, free, crowded);
    addMemory(figures, free, crowded);
    addPrintedRule(figures, free);
    return new Report(
        figures,
        List.of(
            distances("distance-free", "Distance without obstacles (m)", free),
            distances("distance-obstacles", "Distance with obstacles (m)", crowded),
            efforts("effort-free", "Planning without obstacles (points, µs)", free),
            efforts("effort-obstacles", "Planning with obstacles (points, µs)", crowded)),
        drawings(free, crowded),
        List.of(
            "The paper's stores, places and speed are not published; ours are of chance, "
                + free.scenes().size()
                + " of each kind, mean and standard deviation over them.",
            "CMCT-PP and A* with the same moves go by tenths of each way; the other two from the"
                + " middle of a cell of 10 m to that of the next one.",
            "Microseconds are of this machine; everything else is not."));
  }

  private static void addTimes(
      List<Figure> figures, Run run, PlannerSamples samples, String figure) {
    boolean isFree = figure.startsWith("figure 8");
    String at = figure + ": at 4 tasks, ";
    double speed = run.value(SPEED);
    String open = "Neither speed nor places are published, nor whether planning is in the time.";
    if (isFree) {
      figures.add(
          Figure.notComparable(
              at + "time of CMCT-PP",
              Value.of(7, "s"),
              Value.of(
                  rounded(
                      mean(samples, PlannerMethod.CMCT, TASKS_OF_TEXT, s -> s.metres() / speed)),
                  "s"),
              open));
      figures.add(
          Figure.notComparable(
              at + "time of A*",
              Value.of(14, "s"),
              Value.of(
                  rounded(
                      mean(samples, PlannerMethod.A_STAR, TASKS_OF_TEXT, s -> s.metres() / speed)),
                  "s"),
              open));
    }
    Spread driving =
        ratio(samples, PlannerMethod.A_STAR, PlannerMethod.CMCT, TASKS_OF_TEXT, Sum::metres);
    figures.add(
        new Figure(
            at + "driving time of A* over CMCT-PP",
            Value.of(2, ""),
            Value.of(rounded(driving.mean()), ""),
            Value.of(1, ""),
            driving.mean() >= 2 ? Verdict.REPRODUCED : Verdict.REFUTED,
            SAME_MOVES));
    double planning =
        mean(samples, PlannerMethod.A_STAR, TASKS_OF_TEXT, Sum::micros)
            / mean(samples, PlannerMethod.CMCT, TASKS_OF_TEXT, Sum::micros);
    figures.add(
        new Figure(
            at + "planning time of A* over CMCT-PP",
            Value.of(2, ""),
            Value.of(rounded(planning), ""),
            Value.NONE,
            planning >= 2 ? Verdict.REPRODUCED : Verdict.REFUTED,
            "Times of this machine, twice or more; at the robot's speed they are no part of the"
                + " time of a task that anybody would notice."));
  }

  private static void addDistances(List<Figure> figures, PlannerSamples samples, String figure) {
    Spread same =
        ratio(samples, PlannerMethod.CMCT, PlannerMethod.A_STAR, PlannerSamples.TASKS, Sum::metres);
    Spread best =
        Spread.ofRatios(
            samples.shortest(PlannerSamples.TASKS),
            samples.values(PlannerMethod.A_STAR, PlannerSamples.TASKS, Sum::metres));
    figures.add(
        new Figure(
            figure + ": distance of CMCT-PP over A*, same moves",
            Value.of(0.5, ""),
            Value.of(rounded(same.mean()), ""),
            Value.of(rounded(best.mean()), ""),
            same.mean() <= 0.5 ? Verdict.REPRODUCED : Verdict.REFUTED,
            SAME_MOVES));
    Spread octile =
        ratio(
            samples,
            PlannerMethod.CMCT,
            PlannerMethod.A_STAR_CELLS,
            PlannerSamples.TASKS,
            Sum::metres);
    boolean isFree = figure.startsWith("figure 9");
    Spread bestOctile =
        Spread.ofRatios(
            samples.shortest(PlannerSamples.TASKS),
            samples.values(PlannerMethod.A_STAR_CELLS, PlannerSamples.TASKS, Sum::metres));
    figures.add(
        new Figure(
            figure + ": distance of CMCT-PP over A*, cell to cell",
            Value.of(0.5, ""),
            Value.of(rounded(octile.mean()), ""),
            Value.of(rounded(isFree ? LEAST_OF_OCTILE : bestOctile.mean()), ""),
            octile.mean() <= 0.5 ? Verdict.REPRODUCED : Verdict.REFUTED,
            isFree
                ? "The straight line is at most 7.6 percent shorter than eight moves from cell to"
                    + " cell, at 22.5 degrees."
                : "The best possible is the exact shortest path."));
  }

  private static Figure shorterThanOctile(PlannerSamples free) {
    double[] ours = free.values(PlannerMethod.CMCT, PlannerSamples.TASKS, Sum::metres);
    double[] octile = free.values(PlannerMethod.A_STAR_CELLS, PlannerSamples.TASKS, Sum::metres);
    int shorter = 0;
    int longer = 0;
    for (int i = 0; i < ours.length; i++) {
      shorter += ours[i] < octile[i] - 1e-9 ? 1 : 0;
      longer += ours[i] > octile[i] + 1e-9 ? 1 : 0;
    }
    return new Figure(
        "figure 9: CMCT-PP finds shorter paths than A* from cell to cell",
        Value.of("yes"),
        Value.of(
            "shorter in %d stores of %d, longer in %d".formatted(shorter, ours.length, longer)),
        Value.NONE,
        longer == 0 && shorter > ours.length / 2 ? Verdict.REPRODUCED : Verdict.REFUTED,
        "Without obstacles it is the straight line.");
  }

  private static void addGrowth(List<Figure> figures, PlannerSamples free, PlannerSamples crowded) {
    for (PlannerMethod method : List.of(PlannerMethod.CMCT, PlannerMethod.A_STAR)) {
      // over the straight line, since the places of the two kinds of stores are not the same
      double with =
          Spread.ofRatios(
                  crowded.values(method, PlannerSamples.TASKS, Sum::metres), straight(crowded))
              .mean();
      double without =
          Spread.ofRatios(free.values(method, PlannerSamples.TASKS, Sum::metres), straight(free))
              .mean();
      figures.add(
          new Figure(
              "figures 10, 11: time and distance of " + method.title() + " grow with obstacles",
              Value.of("yes"),
              Value.of("by %.1f %%".formatted(100 * (with / without - 1))),
              Value.NONE,
              with > without ? Verdict.REPRODUCED : Verdict.REFUTED,
              "Over the straight line; at one speed, time as distance."));
    }
    boolean rises = true;
    for (int tasks = 2; tasks <= PlannerSamples.TASKS; tasks++) {
      for (PlannerSamples samples : List.of(free, crowded)) {
        rises &=
            mean(samples, PlannerMethod.CMCT, tasks, Sum::metres)
                > mean(samples, PlannerMethod.CMCT, tasks - 1, Sum::metres);
      }
    }
    figures.add(
        new Figure(
            "figures 8 to 11: time and distance grow with the number of tasks",
            Value.of("yes"),
            Value.of(rises ? "yes" : "no"),
            Value.NONE,
            rises ? Verdict.REPRODUCED : Verdict.REFUTED,
            ""));
  }

  private static double[] straight(PlannerSamples samples) {
    return samples.scenes().stream()
        .mapToDouble(
            scene -> Vec2.lengthOf(scene.places().stream().map(scene.grid()::centre).toList()))
        .toArray();
  }

  private static void addMemory(List<Figure> figures, PlannerSamples free, PlannerSamples crowded) {
    double kept = most(free, crowded, PlannerMethod.CMCT);
    figures.add(
        new Figure(
            "points that CMCT-PP keeps in lists, at most",
            Value.of(0, ""),
            Value.of(kept, ""),
            Value.NONE,
            kept == 0 ? Verdict.REPRODUCED : Verdict.REFUTED,
            "A* with the same moves: "
                + Math.round(most(free, crowded, PlannerMethod.A_STAR))
                + "."));
    double visited =
        mean(crowded, PlannerMethod.A_STAR, PlannerSamples.TASKS, Sum::visited)
            / mean(crowded, PlannerMethod.CMCT, PlannerSamples.TASKS, Sum::visited);
    figures.add(
        new Figure(
            "CMCT-PP needs less processing than A*",
            Value.of("yes"),
            Value.of("A* visits %.2f times as many points".formatted(visited)),
            Value.NONE,
            visited > 1.1 ? Verdict.REPRODUCED : Verdict.REFUTED,
            "With obstacles and the same moves; points along obstacles count for both ways round."
                + " What it saves are the lists, so each point costs less time."));
    figures.add(
        new Figure(
            "A* does not guarantee the accurate total distance",
            Value.of("yes"),
            Value.of("no"),
            Value.NONE,
            Verdict.REFUTED,
            "Its total is the length of its path, and no path with its moves is shorter."));
  }

  private static double most(PlannerSamples free, PlannerSamples crowded, PlannerMethod method) {
    return Math.max(
        Arrays.stream(free.values(method, PlannerSamples.TASKS, Sum::kept)).max().orElse(0),
        Arrays.stream(crowded.values(method, PlannerSamples.TASKS, Sum::kept)).max().orElse(0));
  }

  private static void addPrintedRule(List<Figure> figures, PlannerSamples free) {
    int ways = 0;
    int arrived = 0;
    List<Double> totals = new ArrayList<>();
    for (StoreScene scene : free.scenes()) {
      for (int i = 1; i < scene.places().size(); i++) {
        Cell from = scene.places().get(i - 1);
        Cell to = scene.places().get(i);
        Vec2 way =
            new Vec2(Math.abs(to.column() - from.column()), Math.abs(to.row() - from.row()))
                .times(StoreScene.CELL);
        if (way.x() > 0 && way.y() > 0) {
          ways++;
          arrived += PrintedRule.of(way, false).arrives() ? 1 : 0;
          PrintedRule smallest = PrintedRule.of(way, true);
          if (smallest.arrives()) {
            totals.add(smallest.total() / smallest.length());
          }
        }
      }
    }
    figures.add(
        new Figure(
            "figure 7: the rule as printed (largest distance) arrives",
            Value.of("yes"),
            Value.of(arrived + " of " + ways),
            Value.NONE,
            arrived == ways ? Verdict.REPRODUCED : Verdict.REFUTED,
            "It goes away from its target; with the smallest distance it arrives."));
    double total = totals.stream().mapToDouble(Double::doubleValue).average().orElse(Double.NaN);
    figures.add(
        new Figure(
            "figure 7: total distance D_t over the path's length",
            Value.of(1, ""),
            Value.of(rounded(total), ""),
            Value.NONE,
            Math.abs(total - 1) < 0.01 ? Verdict.REPRODUCED : Verdict.REFUTED,
            "As printed, D_t adds what remains after each step, not the step; ours adds the step."));
  }

  private static Table distances(String name, String title, PlannerSamples samples) {
    List<String> columns = new ArrayList<>(List.of("tasks"));
    for (PlannerMethod method : PlannerMethod.values()) {
      columns.add(method.title());
    }
    columns.add("exact shortest");
    columns.add("CMCT-PP over shortest");
    List<List<String>> rows = new ArrayList<>();
    for (int tasks = 1; tasks <= PlannerSamples.TASKS; tasks++) {
      List<String> row = new ArrayList<>(List.of(Integer.toString(tasks)));
      for (PlannerMethod method : PlannerMethod.values()) {
        row.add(Spread.of(samples.values(method, tasks, Sum::metres)).text(0));
      }
      row.add(Spread.of(samples.shortest(tasks)).text(0));
      row.add(
          Spread.ofRatios(
                  samples.values(PlannerMethod.CMCT, tasks, Sum::metres), samples.shortest(tasks))
              .text(3));
      rows.add(row);
    }
    return new Table(name, title, columns, rows);
  }

  private static Table efforts(String name, String title, PlannerSamples samples) {
    List<String> columns = new ArrayList<>(List.of("tasks"));
    for (PlannerMethod method : PlannerMethod.values()) {
      columns.add(method.title() + ": visited");
      columns.add("µs");
    }
    List<List<String>> rows = new ArrayList<>();
    for (int tasks = 1; tasks <= PlannerSamples.TASKS; tasks++) {
      List<String> row = new ArrayList<>(List.of(Integer.toString(tasks)));
      for (PlannerMethod method : PlannerMethod.values()) {
        row.add(Spread.of(samples.values(method, tasks, Sum::visited)).text(0));
        row.add(String.format(Locale.ROOT, "%.0f", mean(samples, method, tasks, Sum::micros)));
      }
      rows.add(row);
    }
    return new Table(name, title, columns, rows);
  }

  private static List<Drawing> drawings(PlannerSamples free, PlannerSamples crowded) {
    return List.of(
        chart("figure-8", "Planning time without obstacles", "µs", free, Sum::micros, false),
        chart("figure-9", "Distance without obstacles", "m", free, Sum::metres, true),
        chart("figure-10", "Planning time with obstacles", "µs", crowded, Sum::micros, false),
        chart("figure-11", "Distance with obstacles", "m", crowded, Sum::metres, true),
        chart("visited", "Points visited with obstacles", "points", crowded, Sum::visited, false),
        scene(crowded.scenes().getFirst()));
  }

  private static Chart chart(
      String name,
      String title,
      String unit,
      PlannerSamples samples,
      ToDoubleFunction<Sum> value,
      boolean hasShortest) {
    List<Chart.Series> series = new ArrayList<>();
    for (PlannerMethod method : PlannerMethod.values()) {
      List<Chart.Point> points = new ArrayList<>();
      for (int tasks = 1; tasks <= PlannerSamples.TASKS; tasks++) {
        points.add(new Chart.Point(tasks, mean(samples, method, tasks, value)));
      }
      series.add(new Chart.Series(method.title(), points));
    }
    if (hasShortest) {
      List<Chart.Point> points = new ArrayList<>();
      for (int tasks = 1; tasks <= PlannerSamples.TASKS; tasks++) {
        points.add(new Chart.Point(tasks, Spread.of(samples.shortest(tasks)).mean()));
      }
      series.add(new Chart.Series("exact shortest", points));
    }
    return new Chart(name, title + ", mean of the stores", "tasks", unit, series);
  }

  private static Scene scene(StoreScene store) {
    List<Scene.Mark> marks = new ArrayList<>(StoreMarks.walls(store.grid()));
    for (int i = 1; i <= 6; i++) {
      Cell from = store.places().get(i - 1);
      Cell to = store.places().get(i);
      boolean isFirst = i == 1;
      marks.add(
          new Scene.Line(
              PlannerMethod.A_STAR_CELLS.plan(store.grid(), from, to).points(),
              Colour.ORANGE,
              true,
              isFirst ? PlannerMethod.A_STAR_CELLS.title() : ""));
      marks.add(
          new Scene.Line(
              PlannerMethod.CMCT.plan(store.grid(), from, to).points(),
              Colour.BLUE,
              false,
              isFirst ? PlannerMethod.CMCT.title() : ""));
    }
    return new Scene(
        "store",
        "The first store with obstacles, three tasks; 100 x 100 m",
        Vec2.ZERO,
        new Vec2(100, 100),
        marks);
  }

  private static double mean(
      PlannerSamples samples, PlannerMethod method, int tasks, ToDoubleFunction<Sum> value) {
    return Spread.of(samples.values(method, tasks, value)).mean();
  }

  private static Spread ratio(
      PlannerSamples samples,
      PlannerMethod method,
      PlannerMethod by,
      int tasks,
      ToDoubleFunction<Sum> value) {
    return Spread.ofRatios(samples.values(method, tasks, value), samples.values(by, tasks, value));
  }

  private static double rounded(double value) {
    return Math.round(value * 1e4) / 1e4;
  }
}
