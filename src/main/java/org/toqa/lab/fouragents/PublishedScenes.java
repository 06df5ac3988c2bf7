package org.toqa.lab.fouragents;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import org.toqa.avoidance.fouragents.DrivingAgent;
import org.toqa.avoidance.fouragents.FourAgents;
import org.toqa.avoidance.fouragents.FourAgentsSettings;
import org.toqa.avoidance.fouragents.LimitCycle;
import org.toqa.avoidance.fouragents.RangeRing;
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

/** {@code four-agents}: the scenes that the paper shows, and the surfaces of its controllers. */
public final class PublishedScenes implements Experiment {
  /** Drives of each scene in a run, each with noise of its own. */
  private static final int DRIVES = 20;

  private static final List<String> SCENES =
      List.of(
          "static-clockwise",
          "static-counter-clockwise",
          "static-and-moving",
          "cluttered-horizontal",
          "cluttered-vertical",
          "cluttered-both");

  /** 3^8. */
  private static final int RULES_OF_ONE_TABLE = 6561;

  @Override
  public String name() {
    return "four-agents";
  }

  @Override
  public String title() {
    return "Four agents in one robot: the paper's scenes";
  }

  @Override
  public String source() {
    return "Ayedi, Boujelben, Rekik 2018: simulation results";
  }

  @Override
  public List<Parameter> parameters() {
    return AvoidanceParameters.ALL;
  }

  @Override
  public Report run(Run run) {
    FourAgentsSettings settings = AvoidanceParameters.settings(run);
    List<Figure> figures = new ArrayList<>();
    List<Drawing> drawings = new ArrayList<>();
    List<List<String>> rows = new ArrayList<>();
    for (int i = 0; i < SCENES.size(); i++) {
      ObstacleScene scene = ObstacleScene.named(SCENES.get(i));
      run.progress(i / (double) SCENES.size(), scene.name());
      double shortest = scene.shortest(settings.body().radius()).orElseThrow();
      List<SceneDrive.Result> results = drives(scene, settings, run);
      figures.add(figure(scene.name(), results));
      rows.add(row(scene.name(), results, shortest, settings));
      drawings.add(picture(scene, results.getFirst()));
    }
    FourAgents agents = new FourAgents(settings);
    figures.add(
        new Figure(
            "rules of dynamic avoidance",
            Value.of("fewer than one table over eight sensors: " + RULES_OF_ONE_TABLE),
            Value.of(agents.dynamicRules(), ""),
            Value.NONE,
            agents.dynamicRules() < RULES_OF_ONE_TABLE ? Verdict.REPRODUCED : Verdict.REFUTED,
            "The tables themselves are not published; these are ours."));
    figures.add(alternation(run));
    drawings.add(phasePortrait(settings, true));
    drawings.add(phasePortrait(settings, false));
    drawings.add(navigationSurface(agents));
    drawings.add(dynamicSurface(agents, settings));
    return new Report(
        figures,
        List.of(
            new Table(
                "scenes",
                "Drives of each scene: medians of those that arrived",
                List.of(
                    "scene",
                    "arrived",
                    "contacts",
                    "hit while it stood",
                    "time (s)",
                    "at full speed at least (s)",
                    "length (m)",
                    "shortest (m)",
                    "ratio",
                    "nearest (m)",
                    "navigation",
                    "static",
                    "dynamic"),
                rows)),
        drawings,
        List.of(
            "The places of the paper's obstacles are not published; the scenes are ours, of the"
                + " kinds that it shows. What it claims of each is that the target is reached"
                + " without contact.",
            "The shortest path is that of the robot's disc among what stands, at its exact"
                + " length; the shares are of the time in which each agent drove."));
  }

  private static List<SceneDrive.Result> drives(
      ObstacleScene scene, FourAgentsSettings settings, Run run) {
    List<SceneDrive.Result> results = new ArrayList<>();
    for (int i = 0; i < DRIVES * run.runs(); i++) {
      run.checkStopped();
      SplittableRandom random = new SplittableRandom(run.seedOf(i));
      results.add(
          new SceneDrive(scene, settings, run.value(AvoidanceParameters.NOISE), random).run());
    }
    return results;
  }

  private static Figure figure(String name, List<SceneDrive.Result> results) {
    long arrived = results.stream().filter(SceneDrive.Result::isReached).count();
    return new Figure(
        name + ": target reached without contact",
        Value.of("shown once"),
        Value.of(arrived + " of " + results.size()),
        Value.of(results.size() + " of " + results.size()),
        arrived == results.size() ? Verdict.REPRODUCED : Verdict.REFUTED,
        arrived == results.size() ? "" : "Some drives with noise do not arrive, or touch.");
  }

  private static List<String> row(
      String name, List<SceneDrive.Result> results, double shortest, FourAgentsSettings settings) {
    List<SceneDrive.Result> arrived =
        results.stream().filter(SceneDrive.Result::isReached).toList();
    double length = Medians.of(arrived, r -> r.metres() + SceneDrive.THERE);
    return List.of(
        name,
        arrived.size() + " of " + results.size(),
        count(results, SceneDrive.End.CONTACT),
        count(results, SceneDrive.End.HIT_STANDING),
        Medians.text(Medians.of(arrived, SceneDrive.Result::seconds), 1),
        Medians.text(shortest / settings.body().wheelSpeed(), 1),
        Medians.text(length, 3),
        Medians.text(shortest, 3),
        Medians.text(length / shortest, 3),
        Medians.text(Medians.of(arrived, SceneDrive.Result::nearest), 3),
        share(arrived, DrivingAgent.NAVIGATION),
        share(arrived, DrivingAgent.STATIC_AVOIDANCE),
        share(arrived, DrivingAgent.DYNAMIC_AVOIDANCE));
  }

  private static String count(List<SceneDrive.Result> results, SceneDrive.End end) {
    return Long.toString(results.stream().filter(r -> r.end() == end).count());
  }

  private static String share(List<SceneDrive.Result> results, DrivingAgent agent) {
    double share =
        Medians.of(
            results, r -> r.driving().getOrDefault(agent, 0.0) / Math.max(1e-9, r.seconds()));
    return String.format(Locale.ROOT, "%.0f %%", 100 * share);
  }

  /** On the first scene: with a rise outside the circle and hysteresis, and without both. */
  private static Figure alternation(Run run) {
    ObstacleScene scene = ObstacleScene.named(SCENES.getFirst());
    int with = switches(scene, AvoidanceParameters.settings(run), run);
    Run literal = run.with(AvoidanceParameters.APPROACH, 0).with(AvoidanceParameters.HYSTERESIS, 0);
    int without = switches(scene, AvoidanceParameters.settings(literal), run);
    return new Figure(
        "changes of the driving agent round one obstacle",
        Value.of("passes properly from one agent to another"),
        Value.of(with, ""),
        Value.of(2, ""),
        with <= 4 ? Verdict.REPRODUCED : Verdict.REFUTED,
        "With utilities that are 0 on the circle, and no hysteresis, as the text reads, "
            + without
            + " times.");
  }

  private static int switches(ObstacleScene scene, FourAgentsSettings settings, Run run) {
    return new SceneDrive(scene, settings, 0, new SplittableRandom(run.seed())).run().switches();
  }

  /** Where a robot was, and what was there. */
  static Animation picture(ObstacleScene scene, SceneDrive.Result result) {
    List<Scene.Mark> marks = new ArrayList<>();
    scene.standing().forEach(corners -> marks.add(new Scene.Area(corners, Colour.WALL)));
    for (MovingDisc disc : scene.moving()) {
      marks.add(new Scene.Line(List.of(disc.from(), disc.to()), Colour.ORANGE, true, ""));
      marks.add(new Scene.Disc(disc.at(result.seconds()), disc.radius(), Colour.ORANGE));
    }
    marks.add(new Scene.Disc(scene.target(), 0.01, Colour.RED));
    marks.add(new Scene.Disc(scene.start().position(), 0.01, Colour.GREEN));
    marks.add(new Scene.Line(result.track(), Colour.BLUE, false, "the robot's way"));
    return Animation.of(
        new Scene(scene.name(), scene.name(), Vec2.ZERO, scene.size(), marks),
        SceneDrive.TRACK_STEP,
        bodies(scene, result));
  }

  private static List<Animation.Body> bodies(ObstacleScene scene, SceneDrive.Result result) {
    List<Animation.Body> bodies = new ArrayList<>();
    for (MovingDisc disc : scene.moving()) {
      List<Vec2> track = new ArrayList<>();
      for (int i = 0; i < result.track().size(); i++) {
        track.add(disc.at(Math.min(i * SceneDrive.TRACK_STEP, result.seconds())));
      }
      bodies.add(new Animation.Body("moving obstacle", disc.radius(), Colour.ORANGE, track));
    }
    double radius = SceneDrive.khepera().body().radius();
    bodies.add(new Animation.Body("robot", radius, Colour.BLUE, result.track()));
    return bodies;
  }

  private static Scene phasePortrait(FourAgentsSettings settings, boolean clockwise) {
    double radius = 0.1 + settings.body().radius() + settings.margin();
    LimitCycle cycle = new LimitCycle(radius, settings.convergence(), clockwise);
    double edge = 2.5 * radius;
    List<Scene.Mark> marks = new ArrayList<>();
    for (double start : new double[] {0.05, 0.5, 1.7, 2.4}) {
      for (int i = 0; i < 8; i++) {
        Vec2 at = new Vec2(start * radius, 0).rotated(i * Math.PI / 4);
        List<Vec2> line = new ArrayList<>(List.of(at));
        for (int step = 0; step < 250; step++) {
          at = at.plus(cycle.velocity(at).times(0.01));
          line.add(at);
        }
        marks.add(new Scene.Line(line, start < 1 ? Colour.PURPLE : Colour.BLUE, false, ""));
      }
    }
    List<Vec2> circle = new ArrayList<>();
    for (int i = 0; i <= 72; i++) {
      circle.add(new Vec2(radius, 0).rotated(i * Math.PI / 36));
    }
    marks.add(new Scene.Line(circle, Colour.RED, true, "the convergence circle"));
    String way = clockwise ? "clockwise" : "counter-clockwise";
    return new Scene(
        "phase-portrait-" + way,
        "Phase portrait of the limit cycle, " + way,
        new Vec2(-edge, -edge),
        new Vec2(edge, edge),
        marks);
  }

  private static Chart navigationSurface(FourAgents agents) {
    List<Chart.Series> series = new ArrayList<>();
    for (double distance : new double[] {0.05, 0.1, 0.2}) {
      List<Chart.Point> left = new ArrayList<>();
      List<Chart.Point> right = new ArrayList<>();
      for (int degrees = -180; degrees <= 180; degrees += 5) {
        var wheels = agents.towardTarget(distance, Math.toRadians(degrees));
        left.add(new Chart.Point(degrees, wheels.left()));
        right.add(new Chart.Point(degrees, wheels.right()));
      }
      series.add(new Chart.Series("left wheel at " + distance + " m", left));
      series.add(new Chart.Series("right wheel at " + distance + " m", right));
    }
    return new Chart(
        "navigation-surface",
        "Navigation: wheel speeds over the target's angle",
        "angle (degrees)",
        "m/s",
        series);
  }

  private static Chart dynamicSurface(FourAgents agents, FourAgentsSettings settings) {
    List<Chart.Series> series = new ArrayList<>();
    for (double front : new double[] {0.2, 0.5, 1}) {
      List<Chart.Point> left = new ArrayList<>();
      List<Chart.Point> right = new ArrayList<>();
      for (int i = 0; i <= 50; i++) {
        double side = settings.sensorRange() * i / 50;
        List<Double> ranges =
            new ArrayList<>(Collections.nCopies(RangeRing.SIZE, settings.sensorRange()));
        ranges.set(1, side);
        ranges.set(2, front * settings.sensorRange());
        ranges.set(3, front * settings.sensorRange());
        var wheels = agents.awayFrom(ranges);
        left.add(new Chart.Point(side, wheels.left()));
        right.add(new Chart.Point(side, wheels.right()));
      }
      String ahead = Medians.text(front * settings.sensorRange(), 2) + " m ahead";
      series.add(new Chart.Series("left wheel, " + ahead, left));
      series.add(new Chart.Series("right wheel, " + ahead, right));
    }
    return new Chart(
        "dynamic-surface",
        "Dynamic avoidance: wheel speeds over the range at 45 degrees to the left",
        "range (m)",
        "m/s",
        series);
  }
}
