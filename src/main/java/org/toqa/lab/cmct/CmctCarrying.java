package org.toqa.lab.cmct;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import org.toqa.geometry.Vec2;
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
import org.toqa.planning.JumpPointSearch;
import org.toqa.planning.PathPlanner;
import org.toqa.planning.cmct.CmctPlanner;

/** A supervisor and two workers beside two workers that see and choose for themselves. */
public final class CmctCarrying implements Experiment {
  private static final Parameter SCENES =
      new Parameter("scenes", 3, 1, 1000, "", "stores in a run");

  private static final Parameter BOXES = new Parameter("boxes", 10, 1, 30, "", "in a store");

  private static final Parameter HEAVY =
      new Parameter("heavy", 0.2, 0, 1, "", "share of boxes over the threshold");

  private static final Parameter DENSITY =
      new Parameter("density", 0.15, 0, 0.25, "", "share of occupied cells");

  /** Seconds after which nobody waits any longer. */
  private static final double LONGEST = 50_000;

  private static final int STEPS_A_CHECK = 200;

  /** Who carries, and by which planner. */
  private enum Team {
    CMCT("CMCT, CMCT-PP", true, true, true),
    CMCT_WAITING("CMCT without overlap, CMCT-PP", true, false, true),
    CMOMMT("without supervisor, CMCT-PP", false, true, true),
    CMCT_A_STAR("CMCT, A*", true, true, false),
    CMOMMT_A_STAR("without supervisor, A*", false, true, false);

    private final String title;
    private final boolean isSupervised;
    private final boolean overlaps;
    private final boolean isGreedy;

    Team(String title, boolean isSupervised, boolean overlaps, boolean isGreedy) {
      this.title = title;
      this.isSupervised = isSupervised;
      this.overlaps = overlaps;
      this.isGreedy = isGreedy;
    }

    CarryingSetup setup(Run run) {
      PathPlanner planner = isGreedy ? new CmctPlanner() : new JumpPointSearch();
      return CarryingSetup.of(run, isSupervised, overlaps, planner);
    }
  }

  @Override
  public String name() {
    return "cmct-system";
  }

  @Override
  public String title() {
    return "a supervisor and two workers beside workers without one, with and without overlap";
  }

  @Override
  public String source() {
    return CmctPlanning.SOURCE + ": figures 12 and 13";
  }

  @Override
  public List<Parameter> parameters() {
    List<Parameter> all = new ArrayList<>(List.of(SCENES, BOXES, HEAVY, DENSITY));
    all.addAll(CarryingSetup.PARAMETERS);
    return all;
  }

  @Override
  public Report run(Run run) {
    Map<Team, List<CarryingWorld>> worlds = new EnumMap<>(Team.class);
    for (Team team : Team.values()) {
      worlds.put(team, new ArrayList<>());
    }
    List<CarryingScene> scenes = scenes(run);
    for (int i = 0; i < scenes.size(); i++) {
      run.progress((double) i / scenes.size(), "store " + (i + 1) + " of " + scenes.size());
      for (Team team : Team.values()) {
        of(worlds, team).add(carry(run, scenes.get(i), team.setup(run)));
      }
    }
    List<Figure> figures = new ArrayList<>();
    figures.add(faster("figure 12: CMCT takes less time, by CMCT-PP", worlds, true));
    figures.add(faster("figure 13: CMCT takes less time, by A*", worlds, false));
    figures.add(always(worlds));
    figures.add(slowerByAStar("CMCT", worlds, Team.CMCT, Team.CMCT_A_STAR));
    figures.add(slowerByAStar("CMOMMT", worlds, Team.CMOMMT, Team.CMOMMT_A_STAR));
    addOverlap(figures, worlds);
    addSafety(figures, worlds, scenes);
    return new Report(
        figures,
        List.of(teams(worlds, run)),
        drawings(scenes, worlds),
        List.of(
            "Stores, boxes, speeds, cameras and batteries are not published; ours are of chance or"
                + " in the table of parameters, chosen before the first result. Spread: standard"
                + " deviation over "
                + scenes.size()
                + " stores.",
            "Without a supervisor there are the two workers, each with cameras of its own and the"
                + " same range; they tell each other what they go for, and who is called to a heavy"
                + " box is told the way.",
            "Idle are workers that have no box to go for while some are not delivered; waiting are"
                + " those beside a heavy box.",
            "Boxes are no obstacles to driving, and cells that nobody has seen are not driven on."));
  }

  private static List<CarryingScene> scenes(Run run) {
    List<CarryingScene> scenes = new ArrayList<>();
    for (int i = 0; i < run.runs(); i++) {
      SplittableRandom random = new SplittableRandom(run.seedOf(i));
      for (int scene = 0; scene < Math.round(run.value(SCENES)); scene++) {
        scenes.add(
            CarryingScene.of(
                run.value(DENSITY),
                (int) Math.round(run.value(BOXES)),
                run.value(HEAVY),
                run.value(CarryingSetup.THRESHOLD),
                random));
      }
    }
    return scenes;
  }

  private static CarryingWorld carry(Run run, CarryingScene scene, CarryingSetup setup) {
    CarryingWorld world = new CarryingWorld(scene, setup);
    for (int step = 0; !world.isDone() && world.time() < LONGEST; step++) {
      if (step % STEPS_A_CHECK == 0) {
        run.checkStopped();
      }
      world.step();
    }
    return world;
  }

  private static Figure faster(
      String name, Map<Team, List<CarryingWorld>> worlds, boolean isGreedy) {
    double[] with =
        values(worlds, isGreedy ? Team.CMCT : Team.CMCT_A_STAR, CarryingWorld::lastDelivery);
    double[] without =
        values(worlds, isGreedy ? Team.CMOMMT : Team.CMOMMT_A_STAR, CarryingWorld::lastDelivery);
    Spread ratio = Spread.ofRatios(with, without);
    return new Figure(
        name,
        Value.of("yes"),
        Value.of("%s of the time without supervisor".formatted(ratio.text(2))),
        Value.NONE,
        ratio.mean() < 1 ? Verdict.REPRODUCED : Verdict.REFUTED,
        "Until the last box is at its target, mean of the stores; three robots against two.");
  }

  private static Figure always(Map<Team, List<CarryingWorld>> worlds) {
    double[] with = values(worlds, Team.CMCT, CarryingWorld::lastDelivery);
    double[] without = values(worlds, Team.CMOMMT, CarryingWorld::lastDelivery);
    int better = 0;
    for (int i = 0; i < with.length; i++) {
      better += with[i] < without[i] ? 1 : 0;
    }
    return new Figure(
        "CMCT always achieves better time than CMOMMT",
        Value.of("always"),
        Value.of("in %d of %d stores".formatted(better, with.length)),
        Value.NONE,
        better == with.length ? Verdict.REPRODUCED : Verdict.REFUTED,
        "By CMCT-PP.");
  }

  private static Figure slowerByAStar(
      String name, Map<Team, List<CarryingWorld>> worlds, Team greedy, Team optimal) {
    Spread ratio =
        Spread.ofRatios(
            values(worlds, optimal, CarryingWorld::lastDelivery),
            values(worlds, greedy, CarryingWorld::lastDelivery));
    return new Figure(
        "figures 12, 13: %s takes more time by A* than by CMCT-PP".formatted(name),
        Value.of("yes"),
        Value.of("%s of the time by CMCT-PP".formatted(ratio.text(2))),
        Value.NONE,
        ratio.mean() > 1.01 ? Verdict.REPRODUCED : Verdict.REFUTED,
        "More than one percent would count. With the same moves no path of A* is longer; which box"
            + " is found first changes with every path, and so does the time.");
  }

  private static void addOverlap(List<Figure> figures, Map<Team, List<CarryingWorld>> worlds) {
    double boxes = of(worlds, Team.CMCT).getFirst().boxes();
    Spread with = Spread.of(values(worlds, Team.CMCT, world -> world.idle() / boxes));
    Spread without = Spread.of(values(worlds, Team.CMCT_WAITING, world -> world.idle() / boxes));
    figures.add(
        new Figure(
            "idle seconds a box, next box found while the first is carried",
            Value.of("less"),
            Value.of("%s s, without overlap %s s".formatted(with.text(0), without.text(0))),
            Value.NONE,
            with.mean() < without.mean() ? Verdict.REPRODUCED : Verdict.REFUTED,
            "Of both workers together; looking for boxes and making them out is in it."));
    Spread time =
        Spread.ofRatios(
            values(worlds, Team.CMCT, CarryingWorld::lastDelivery),
            values(worlds, Team.CMCT_WAITING, CarryingWorld::lastDelivery));
    figures.add(
        new Figure(
            "time with overlap over time without",
            Value.of("less than 1"),
            Value.of(time.text(2)),
            Value.NONE,
            time.mean() < 1 ? Verdict.REPRODUCED : Verdict.REFUTED,
            ""));
  }

  private static void addSafety(
      List<Figure> figures, Map<Team, List<CarryingWorld>> worlds, List<CarryingScene> scenes) {
    double nearest = Double.POSITIVE_INFINITY;
    int done = 0;
    int all = 0;
    for (Team team : Team.values()) {
      for (int i = 0; i < scenes.size(); i++) {
        CarryingWorld world = of(worlds, team).get(i);
        nearest = Math.min(nearest, world.nearest());
        all++;
        boolean isComplete =
            world.isDone()
                && world.isEachAtTarget()
                && world.deliveries().values().stream().allMatch(times -> times == 1);
        done += isComplete ? 1 : 0;
      }
    }
    figures.add(
        new Figure(
            "robots are kept from colliding: nearest edges",
            Value.of("no contact"),
            Value.of(nearest, "m"),
            Value.NONE,
            nearest > 0 ? Verdict.REPRODUCED : Verdict.REFUTED,
            "In all stores, with and without supervisor, of the simulated bodies."));
    figures.add(
        new Figure(
            "every box is at its target once, until no box is left",
            Value.of("yes"),
            Value.of("in %d of %d".formatted(done, all)),
            Value.NONE,
            done == all ? Verdict.REPRODUCED : Verdict.REFUTED,
            ""));
  }

  private static Table teams(Map<Team, List<CarryingWorld>> worlds, Run run) {
    double boxes = Math.round(run.value(BOXES));
    List<List<String>> rows = new ArrayList<>();
    for (Team team : Team.values()) {
      rows.add(
          List.of(
              team.title,
              Spread.of(values(worlds, team, CarryingWorld::lastDelivery)).text(0),
              Spread.of(values(worlds, team, world -> world.driven(true))).text(0),
              Spread.of(values(worlds, team, world -> world.driven(false))).text(0),
              Spread.of(values(worlds, team, world -> world.idle() / boxes)).text(1),
              Spread.of(values(worlds, team, world -> world.waiting() / boxes)).text(1),
              Spread.of(values(worlds, team, CarryingWorld::stops)).text(1)));
    }
    return new Table(
        "teams",
        "Until the last box is at its target (s, m)",
        List.of(
            "team",
            "time",
            "driven by workers",
            "by the supervisor",
            "idle s a box",
            "waiting s a box",
            "stops for others"),
        rows);
  }

  private static List<Drawing> drawings(
      List<CarryingScene> scenes, Map<Team, List<CarryingWorld>> worlds) {
    return List.of(
        chart("figure-12", "Time over distance, CMCT-PP", worlds, Team.CMCT, Team.CMOMMT),
        chart("figure-13", "Time over distance, A*", worlds, Team.CMCT_A_STAR, Team.CMOMMT_A_STAR),
        chart("overlap", "Overlap or not, CMCT-PP", worlds, Team.CMCT, Team.CMCT_WAITING),
        scene(scenes.getFirst()));
  }

  /** A point for each box that is delivered, in the first store. */
  private static Chart chart(
      String name, String title, Map<Team, List<CarryingWorld>> worlds, Team one, Team other) {
    List<Chart.Series> series = new ArrayList<>();
    for (Team team : List.of(one, other)) {
      series.add(
          new Chart.Series(
              team.title,
              of(worlds, team).getFirst().log().stream()
                  .map(delivery -> new Chart.Point(delivery.driven(), delivery.time()))
                  .toList()));
    }
    return new Chart(name, title + "; the first store", "m driven by both workers", "s", series);
  }

  private static Scene scene(CarryingScene scene) {
    List<Scene.Mark> marks = new ArrayList<>(StoreMarks.walls(scene.store()));
    for (CarryingScene.Box box : scene.boxes()) {
      marks.add(new Scene.Line(List.of(box.place(), box.target()), Colour.LIGHT, true, ""));
      marks.add(new Scene.Disc(box.place(), 1, Colour.ORANGE));
      marks.add(
          new Scene.Label(
              String.format(Locale.ROOT, "%.1f kg", box.kilograms()),
              box.place().plus(new Vec2(1.5, 0))));
    }
    scene.stations().forEach(at -> marks.add(new Scene.Disc(at, 1, Colour.GREEN)));
    scene.starts().forEach(at -> marks.add(new Scene.Disc(at, 1, Colour.BLUE)));
    marks.add(new Scene.Line(List.of(), Colour.ORANGE, false, "box, with its way to its target"));
    marks.add(new Scene.Line(List.of(), Colour.GREEN, false, "charging station"));
    marks.add(new Scene.Line(List.of(), Colour.BLUE, false, "where a robot begins"));
    return new Scene("store", "The first store, 100 x 100 m", Vec2.ZERO, new Vec2(100, 100), marks);
  }

  private static List<CarryingWorld> of(Map<Team, List<CarryingWorld>> worlds, Team team) {
    return worlds.getOrDefault(team, List.of());
  }

  private static double[] values(
      Map<Team, List<CarryingWorld>> worlds, Team team, ToDoubleFunction<CarryingWorld> value) {
    return of(worlds, team).stream().mapToDouble(value).toArray();
  }
}
