package org.toqa.lab.fouragents;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.SplittableRandom;
import org.toqa.avoidance.fouragents.FourAgentsSettings;
import org.toqa.lab.drawing.Drawing;
import org.toqa.lab.experiment.Experiment;
import org.toqa.lab.experiment.Figure;
import org.toqa.lab.experiment.Parameter;
import org.toqa.lab.experiment.Report;
import org.toqa.lab.experiment.Run;
import org.toqa.lab.experiment.Table;
import org.toqa.lab.experiment.Value;
import org.toqa.lab.experiment.Verdict;

/** {@code four-agents-generated}: how far the paper's claim of safety holds in scenes at random. */
public final class GeneratedScenes implements Experiment {
  /** Scenes in a run: ten runs are the thousand. */
  private static final int SCENES = 100;

  /** Scenes of each variant in the run that shows how sensitive the result is. */
  private static final int SENSITIVITY_SCENES = 100;

  /** After so many scenes a run tells how far it is. */
  private static final int TOLD = 20;

  /** What making a scene, with its shortest path, takes: a part of a drive. */
  private static final double MAKING = 0.7;

  @Override
  public String name() {
    return "four-agents-generated";
  }

  @Override
  public String title() {
    return "Four agents in one robot: 100 generated scenes a run";
  }

  @Override
  public String source() {
    return "Ayedi, Boujelben, Rekik 2018: \"reach the final destination safely\"";
  }

  @Override
  public List<Parameter> parameters() {
    return AvoidanceParameters.ALL;
  }

  /** A scene with how it was driven. */
  private record Drive(SceneGenerator.Solvable solvable, SceneDrive.Result result) {
    boolean isReached() {
      return result.isReached();
    }

    boolean isContactFree() {
      return result.end() != SceneDrive.End.CONTACT;
    }
  }

  @Override
  public Report run(Run run) {
    int scenes = SCENES * run.runs();
    List<SceneGenerator.Solvable> solvable = new ArrayList<>();
    SceneGenerator generator = generator();
    for (int i = 0; i < scenes; i++) {
      if (i % TOLD == 0) {
        run.progress(MAKING * i / work(scenes), "scene %d of %d is made".formatted(i + 1, scenes));
      }
      run.checkStopped();
      solvable.add(
          generator.next("scene-" + (i + 1), new SplittableRandom(run.seed() * 1_000_003 + i)));
    }
    List<Drive> drives = drive(solvable, run);
    List<Figure> figures = new ArrayList<>();
    figures.add(
        rate("target reached without contact", drives, drives.stream().filter(Drive::isReached)));
    figures.add(rate("no contact", drives, drives.stream().filter(Drive::isContactFree)));
    List<List<String>> rows = new ArrayList<>();
    for (int moving = 0; moving <= 3; moving++) {
      int count = moving;
      rows.add(
          row(
              Integer.toString(moving),
              drives.stream().filter(d -> d.solvable().scene().moving().size() == count).toList()));
    }
    rows.add(row("all", drives));
    return new Report(
        figures,
        List.of(
            new Table(
                "generated",
                "By the number of moving obstacles; medians and 95th percentiles of those that"
                    + " arrived",
                List.of(
                    "moving",
                    "scenes",
                    "arrived",
                    "contacts",
                    "hit while it stood",
                    "late",
                    "time (s)",
                    "time, 95 % (s)",
                    "length by shortest",
                    "length, 95 %"),
                rows),
            sensitivity(solvable, run)),
        failures(drives),
        List.of(
            "Every scene has a path for the robot with its margin. Obstacles move at up to half"
                + " the robot's speed and yield to nobody. A robot that is hit while it stands"
                + " counts apart; late is who has not arrived after 180 s."));
  }

  private static SceneGenerator generator() {
    FourAgentsSettings chosen = SceneDrive.khepera();
    return new SceneGenerator(chosen.body().radius(), chosen.margin(), chosen.body().wheelSpeed());
  }

  /** What a run with so many scenes takes, in drives. */
  private static double work(int scenes) {
    return (MAKING + 1) * scenes + (VARIANTS.size() + 1) * Math.min(SENSITIVITY_SCENES, scenes);
  }

  private static List<Drive> drive(List<SceneGenerator.Solvable> scenes, Run run) {
    int count = scenes.size();
    List<Drive> drives = new ArrayList<>();
    for (int i = 0; i < count; i += TOLD) {
      run.progress(
          (MAKING * count + i) / work(count), "scene %d of %d is driven".formatted(i + 1, count));
      drives.addAll(drive(scenes, i, Math.min(i + TOLD, count), run));
    }
    return drives;
  }

  private static List<Drive> drive(
      List<SceneGenerator.Solvable> scenes, int begin, int end, Run run) {
    FourAgentsSettings settings = AvoidanceParameters.settings(run);
    List<Drive> drives = new ArrayList<>();
    for (int i = begin; i < end; i++) {
      run.checkStopped();
      SplittableRandom random = new SplittableRandom(run.seed() * 7_000_003 + i);
      double noise = run.value(AvoidanceParameters.NOISE);
      drives.add(
          new Drive(
              scenes.get(i), new SceneDrive(scenes.get(i).scene(), settings, noise, random).run()));
    }
    return drives;
  }

  private static Figure rate(
      String name, List<Drive> drives, java.util.stream.Stream<Drive> those) {
    long count = those.count();
    return new Figure(
        name,
        Value.of("always"),
        Value.of(count + " of " + drives.size()),
        Value.of(drives.size() + " of " + drives.size()),
        count == drives.size() ? Verdict.REPRODUCED : Verdict.REFUTED,
        count == drives.size() ? "" : "A reactive law does not solve every scene.");
  }

  private static List<String> row(String name, List<Drive> drives) {
    List<Drive> arrived = drives.stream().filter(Drive::isReached).toList();
    return List.of(
        name,
        Integer.toString(drives.size()),
        Integer.toString(arrived.size()),
        count(drives, SceneDrive.End.CONTACT),
        count(drives, SceneDrive.End.HIT_STANDING),
        count(drives, SceneDrive.End.LATE),
        Medians.text(Medians.of(arrived, d -> d.result().seconds()), 1),
        Medians.text(Medians.percentile(arrived, d -> d.result().seconds(), 0.95), 1),
        Medians.text(Medians.of(arrived, GeneratedScenes::ratio), 3),
        Medians.text(Medians.percentile(arrived, GeneratedScenes::ratio, 0.95), 3));
  }

  private static double ratio(Drive drive) {
    double left = drive.result().track().getLast().distanceTo(drive.solvable().scene().target());
    return (drive.result().metres() + left) / drive.solvable().shortest();
  }

  private static String count(List<Drive> drives, SceneDrive.End end) {
    return Long.toString(drives.stream().filter(d -> d.result().end() == end).count());
  }

  private record Variant(Parameter parameter, double value) {}

  private static final List<Variant> VARIANTS =
      List.of(
          new Variant(AvoidanceParameters.MARGIN, 0.01),
          new Variant(AvoidanceParameters.MARGIN, 0.04),
          new Variant(AvoidanceParameters.DANGER, 0.03),
          new Variant(AvoidanceParameters.DANGER, 0.08),
          new Variant(AvoidanceParameters.APPROACH, 0),
          new Variant(AvoidanceParameters.APPROACH, 0.04),
          new Variant(AvoidanceParameters.HYSTERESIS, 0),
          new Variant(AvoidanceParameters.HYSTERESIS, 0.2),
          new Variant(AvoidanceParameters.NOISE, 0),
          new Variant(AvoidanceParameters.NOISE, 0.05));

  /** One parameter at a time, on the first scenes. */
  private static Table sensitivity(List<SceneGenerator.Solvable> scenes, Run run) {
    List<SceneGenerator.Solvable> some =
        scenes.subList(0, Math.min(SENSITIVITY_SCENES, scenes.size()));
    List<List<String>> rows = new ArrayList<>();
    rows.add(sensitivityRow("as chosen", drive(some, 0, some.size(), run)));
    for (int i = 0; i < VARIANTS.size(); i++) {
      Variant variant = VARIANTS.get(i);
      String name = "%s %s".formatted(variant.parameter().name(), Medians.text(variant.value(), 2));
      double left = (double) (VARIANTS.size() - i) * some.size();
      run.progress(1 - left / work(scenes.size()), name);
      Run changed = run.with(variant.parameter(), variant.value());
      rows.add(sensitivityRow(name, drive(some, 0, some.size(), changed)));
    }
    return new Table(
        "sensitivity",
        "How much depends on what was chosen: the first scenes, with one parameter changed",
        List.of("parameter", "arrived", "contacts", "hit while it stood", "late"),
        rows);
  }

  private static List<String> sensitivityRow(String name, List<Drive> drives) {
    return List.of(
        name,
        String.format(
            Locale.ROOT,
            "%d of %d",
            drives.stream().filter(Drive::isReached).count(),
            drives.size()),
        count(drives, SceneDrive.End.CONTACT),
        count(drives, SceneDrive.End.HIT_STANDING),
        count(drives, SceneDrive.End.LATE));
  }

  /** One of each kind of failure, where there is one. */
  private static List<Drawing> failures(List<Drive> drives) {
    List<Drawing> pictures = new ArrayList<>();
    for (SceneDrive.End end : SceneDrive.End.values()) {
      Optional<Drive> first = drives.stream().filter(d -> d.result().end() == end).findFirst();
      first.ifPresent(d -> pictures.add(PublishedScenes.picture(d.solvable().scene(), d.result())));
    }
    return pictures;
  }
}
