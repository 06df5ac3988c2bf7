package org.toqa.app.lab;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.toqa.app.command.Arguments;
import org.toqa.app.command.CommandOutput;
import org.toqa.app.command.SeedOption;
import org.toqa.app.command.StopSignal;
import org.toqa.lab.Experiments;
import org.toqa.lab.experiment.Experiment;
import org.toqa.lab.experiment.Parameter;
import org.toqa.lab.experiment.Report;
import org.toqa.lab.experiment.Run;
import org.toqa.lab.experiment.RunStoppedException;
import org.toqa.lab.record.ReportJson;
import org.toqa.yaml.Spelling;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code toqa lab}: published experiments, done again. */
@Command(
    name = "lab",
    description = "List the published experiments, or do one again and compare its figures.",
    footer = {
      "",
      "Without NAME the experiments are listed, one a line. With NAME one is done: its",
      "progress goes to standard error, its table to standard output. The same seed,",
      "runs and parameters give the same figures, but for times of this machine.",
      "",
      "JSON: experiment, seed, runs, parameters, figures (name, published, measured,",
      "bound, unit, verdict, reason), tables and notes. A figure is a number, a text,",
      "or null where there is none; bound is the true optimum or the best possible.",
      "The verdict is reproduced, refuted, or not comparable where an input is not",
      "published.",
      "",
      "--out writes NAME.json, NAME-figures.csv, a .csv file for each table and an",
      ".svg file for each drawing; for a scene that moves also how, as .json."
    })
public final class LabCommand implements Callable<Integer> {
  /** As of a program that was ended by Ctrl-C. */
  private static final int STOPPED = 130;

  @Spec private CommandSpec spec = CommandSpec.create();

  @Parameters(
      arity = "0..1",
      paramLabel = "NAME",
      description = "Experiment to do (default: list them).")
  private @Nullable String name;

  @Mixin private SeedOption seed = new SeedOption();

  @Option(
      names = "--runs",
      defaultValue = "1",
      paramLabel = "N",
      description =
          "How often what depends on chance is repeated, each time with the next seed (default:"
              + " ${DEFAULT-VALUE}).")
  private int runs;

  @Option(
      names = "--set",
      paramLabel = "PARAMETER=VALUE",
      description = "Set a parameter of the experiment, instead of what it has in its table.")
  private Map<String, Double> values = new LinkedHashMap<>();

  @Option(names = "--json", description = "Print JSON.")
  private boolean json;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      description = "Write tables and drawings into this folder, which is made.")
  private @Nullable Path folder;

  @Option(
      names = ServerPipe.OPTION,
      hidden = true,
      description = "Is a server's child: tells it everything, and ends with it.")
  private boolean isChild;

  @Override
  public Integer call() throws IOException {
    Arguments arguments = new Arguments(spec);
    if (name == null) {
      return list(arguments);
    }
    String asked = name;
    Experiment experiment =
        Experiments.named(asked)
            .orElseThrow(() -> arguments.invalid(unknown("experiment", asked, names())));
    arguments.requireBetween("--runs", runs, 1, Run.MOST_RUNS);
    checkValues(arguments, experiment);
    @Nullable ReportFiles files = folder == null ? null : ReportFiles.in(folder, arguments);
    if (isChild) {
      return ServerPipe.open(new CommandOutput(spec)).run(experiment, seed.value(), runs, values);
    }
    try (StopSignal stop = new StopSignal()) {
      Progress progress = new Progress(experiment.name(), new CommandOutput(spec));
      Run run = new Run(seed.value(), runs, values, progress, stop::isRequested);
      Report report = experiment.run(run);
      if (files != null) {
        files.write(experiment, run, report);
      }
      new CommandOutput(spec)
          .print(
              json
                  ? ReportJson.text(experiment, run, report)
                  : ReportText.of(experiment, run, report));
      return ExitCode.OK;
    } catch (RunStoppedException e) {
      new CommandOutput(spec).printError(String.valueOf(e.getMessage()));
      return STOPPED;
    }
  }

  private int list(Arguments arguments) {
    if (folder != null || !values.isEmpty()) {
      throw arguments.invalid("--out and --set need the NAME of an experiment");
    }
    CommandOutput output = new CommandOutput(spec);
    if (json) {
      output.print(ReportJson.list(Experiments.all()));
    } else {
      int width = names().stream().mapToInt(String::length).max().orElse(0);
      output.print(
          Experiments.all().stream()
              .map(
                  one ->
                      "  " + one.name() + " ".repeat(width - one.name().length() + 2) + one.title())
              .collect(Collectors.joining("\n")));
    }
    return ExitCode.OK;
  }

  private static List<String> names() {
    return Experiments.all().stream().map(Experiment::name).toList();
  }

  private void checkValues(Arguments arguments, Experiment experiment) {
    Map<String, Parameter> known =
        experiment.parameters().stream().collect(Collectors.toMap(Parameter::name, one -> one));
    values.forEach(
        (key, value) -> {
          Parameter parameter = known.get(key);
          if (parameter == null) {
            throw arguments.invalid(unknown("parameter", key, List.copyOf(known.keySet())));
          }
          if (!parameter.allows(value)) {
            throw arguments.invalid(
                "--set %s=%s: it must be from %s to %s"
                    .formatted(key, value, parameter.least(), parameter.most()));
          }
        });
  }

  private static String unknown(String kind, String written, List<String> known) {
    String sentence = "\"%s\" is no %s".formatted(written, kind);
    if (known.isEmpty()) {
      return sentence;
    }
    SortedSet<String> words = new TreeSet<>(known);
    return sentence
        + Spelling.near(written, words)
            .map(near -> "; the nearest is " + near)
            .orElseGet(() -> "; there are: " + String.join(", ", words));
  }
}
