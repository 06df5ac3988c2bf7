package org.toqa.app.lab;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.toqa.app.command.Arguments;
import org.toqa.lab.drawing.Animation;
import org.toqa.lab.drawing.Drawing;
import org.toqa.lab.experiment.Experiment;
import org.toqa.lab.experiment.Figure;
import org.toqa.lab.experiment.Report;
import org.toqa.lab.experiment.Run;
import org.toqa.lab.experiment.Table;
import org.toqa.lab.record.AnimationJson;
import org.toqa.lab.record.ReportJson;
import picocli.CommandLine.ParameterException;

/** A folder in which reports are kept as files. */
record ReportFiles(Path folder) {
  private static final List<String> FIGURES =
      List.of("name", "published", "measured", "bound", "verdict", "reason");

  /**
   * Makes the folder, before a run rather than after it.
   *
   * @throws ParameterException it cannot be made, or not be written to
   */
  static ReportFiles in(Path folder, Arguments arguments) {
    try {
      Files.createDirectories(folder);
    } catch (IOException e) {
      throw arguments.invalid("--out " + folder + ": this folder cannot be made");
    }
    if (!Files.isWritable(folder)) {
      throw arguments.invalid("--out " + folder + ": this folder cannot be written to");
    }
    return new ReportFiles(folder);
  }

  void write(Experiment experiment, Run run, Report report) throws IOException {
    write(experiment.name() + ".json", ReportJson.text(experiment, run, report) + "\n");
    write(
        experiment.name() + "-figures.csv",
        csv(FIGURES, report.figures().stream().map(ReportFiles::row).toList()));
    for (Table table : report.tables()) {
      write(experiment.name() + "-" + table.name() + ".csv", csv(table.columns(), table.rows()));
    }
    for (Drawing drawing : report.drawings()) {
      write(experiment.name() + "-" + drawing.name() + ".svg", drawing.svg());
      if (drawing instanceof Animation animation) {
        write(
            experiment.name() + "-" + drawing.name() + ".json",
            AnimationJson.text(animation) + "\n");
      }
    }
  }

  private void write(String name, String text) throws IOException {
    Files.writeString(folder.resolve(name), text);
  }

  private static List<String> row(Figure figure) {
    return List.of(
        figure.name(),
        figure.published().text(),
        figure.measured().text(),
        figure.bound().text(),
        figure.verdict().word(),
        figure.reason());
  }

  /** RFC 4180, with line feeds. */
  private static String csv(List<String> heads, List<List<String>> rows) {
    return Stream.concat(Stream.of(heads), rows.stream())
        .map(row -> row.stream().map(ReportFiles::quoted).collect(Collectors.joining(",")))
        .collect(Collectors.joining("\n", "", "\n"));
  }

  private static String quoted(String cell) {
    return cell.chars().anyMatch(c -> c == ',' || c == '"' || c == '\n')
        ? '"' + cell.replace("\"", "\"\"") + '"'
        : cell;
  }
}
