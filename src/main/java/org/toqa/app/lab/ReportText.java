package org.toqa.app.lab;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.toqa.lab.experiment.Experiment;
import org.toqa.lab.experiment.Figure;
import org.toqa.lab.experiment.Parameter;
import org.toqa.lab.experiment.Report;
import org.toqa.lab.experiment.Run;
import org.toqa.lab.experiment.Table;
import org.toqa.lab.experiment.Value;

/** A report as a person reads it. */
final class ReportText {
  private final StringBuilder text = new StringBuilder();

  private ReportText() {}

  static String of(Experiment experiment, Run run, Report report) {
    return new ReportText().render(experiment, run, report);
  }

  private String render(Experiment experiment, Run run, Report report) {
    line(experiment.title());
    line(experiment.source());
    line("seed %d, runs %d".formatted(run.seed(), run.runs()));
    if (!experiment.parameters().isEmpty()) {
      table(
          List.of("parameter", "value", "meaning"),
          experiment.parameters().stream().map(one -> row(one, run)).toList());
    }
    if (!report.figures().isEmpty()) {
      table(
          List.of("figure", "published", "measured", "best possible", "verdict"),
          report.figures().stream().map(ReportText::row).toList());
    }
    for (Table one : report.tables()) {
      line("");
      line(one.title());
      table(one.columns(), one.rows());
    }
    List<String> notes = new ArrayList<>();
    Map<String, List<String>> byReason = new LinkedHashMap<>();
    report.figures().stream()
        .filter(figure -> !figure.reason().isEmpty())
        .forEach(
            figure ->
                byReason
                    .computeIfAbsent(figure.reason(), reason -> new ArrayList<>())
                    .add(figure.name()));
    byReason.forEach((reason, names) -> notes.add(String.join("; ", names) + ". " + reason));
    notes.addAll(report.notes());
    if (!notes.isEmpty()) {
      line("");
      notes.forEach(note -> line("- " + note));
    }
    return text.toString().stripTrailing();
  }

  private static List<String> row(Parameter parameter, Run run) {
    return List.of(
        parameter.name(),
        Value.of(run.value(parameter), parameter.unit()).text(),
        parameter.meaning());
  }

  private static List<String> row(Figure figure) {
    return List.of(
        figure.name(),
        figure.published().text(),
        figure.measured().text(),
        figure.bound().text(),
        figure.verdict().word());
  }

  private void line(String written) {
    text.append(written).append('\n');
  }

  private void table(List<String> heads, List<List<String>> rows) {
    int[] widths =
        IntStream.range(0, heads.size())
            .map(
                i ->
                    Math.max(
                        heads.get(i).length(),
                        rows.stream().mapToInt(row -> row.get(i).length()).max().orElse(0)))
            .toArray();
    line("");
    line(padded(heads, widths));
    rows.forEach(row -> line(padded(row, widths)));
  }

  private static String padded(List<String> cells, int[] widths) {
    StringBuilder row = new StringBuilder();
    for (int i = 0; i < cells.size(); i++) {
      row.append("  ").append(cells.get(i)).append(" ".repeat(widths[i] - cells.get(i).length()));
    }
    return row.toString().stripTrailing();
  }
}
