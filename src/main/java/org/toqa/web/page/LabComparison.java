package org.toqa.web.page;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.toqa.lab.experiment.Figure;
import org.toqa.lab.experiment.Value;
import org.toqa.lab.record.KeptDrawing;
import org.toqa.lab.record.KeptReport;
import org.toqa.lab.record.LabRun;
import org.toqa.lab.record.Laboratory;
import org.toqa.lab.record.ReportJson;

/**
 * Runs side by side.
 *
 * @param parameters those that are not the same in all of them
 * @param figures of any of them
 * @param drawings of any of them
 */
public record LabComparison(
    List<LabRunView> runs,
    List<Row> parameters,
    List<FigureRow> figures,
    List<DrawingRow> drawings) {

  /** A value of each run; empty where one has none. */
  public record Row(String name, List<String> values) {}

  /** The same figure of each run; null where one has none. */
  public record FigureRow(String name, String published, List<@Nullable Figure> figures) {}

  /** The numbers of the runs that have a drawing; null where one has none. */
  public record DrawingRow(String name, String title, List<@Nullable Long> runs) {}

  static LabComparison of(List<LabRun> runs, Laboratory laboratory) {
    List<Optional<KeptReport>> reports =
        runs.stream()
            .map(run -> laboratory.store().report(run.id()).map(ReportJson::read))
            .toList();
    return new LabComparison(
        runs.stream().map(run -> LabRunView.of(run, laboratory)).toList(),
        parameters(reports),
        figures(reports),
        drawings(runs, laboratory));
  }

  private static List<Row> parameters(List<Optional<KeptReport>> reports) {
    Set<String> names = new LinkedHashSet<>();
    reports.forEach(report -> report.ifPresent(one -> names.addAll(one.parameters().keySet())));
    List<Row> rows = new ArrayList<>();
    for (String name : names) {
      List<String> values =
          reports.stream()
              .map(
                  report ->
                      report
                          .map(one -> one.parameters().get(name))
                          .map(value -> Value.of(value, "").text())
                          .orElse(""))
              .toList();
      if (values.stream().distinct().count() > 1) {
        rows.add(new Row(name, values));
      }
    }
    return rows;
  }

  private static List<FigureRow> figures(List<Optional<KeptReport>> reports) {
    Map<String, @Nullable Figure[]> byName = new LinkedHashMap<>();
    for (int i = 0; i < reports.size(); i++) {
      int at = i;
      reports
          .get(i)
          .ifPresent(
              report ->
                  report
                      .figures()
                      .forEach(
                          figure ->
                              byName
                                      .computeIfAbsent(
                                          figure.name(), name -> new Figure[reports.size()])[at] =
                                  figure));
    }
    List<FigureRow> rows = new ArrayList<>();
    byName.forEach(
        (name, figures) -> {
          List<@Nullable Figure> row = new ArrayList<>();
          String published = "";
          for (Figure figure : figures) {
            row.add(figure);
            published = figure == null ? published : figure.published().text();
          }
          rows.add(new FigureRow(name, published, row));
        });
    return rows;
  }

  private static List<DrawingRow> drawings(List<LabRun> runs, Laboratory laboratory) {
    Map<String, String> titles = new LinkedHashMap<>();
    List<Set<String>> names = new ArrayList<>();
    for (LabRun run : runs) {
      Set<String> own = new LinkedHashSet<>();
      for (KeptDrawing.Entry entry : laboratory.store().drawings(run.id())) {
        titles.putIfAbsent(entry.name(), entry.title());
        own.add(entry.name());
      }
      names.add(own);
    }
    List<DrawingRow> rows = new ArrayList<>();
    titles.forEach(
        (name, title) -> {
          List<@Nullable Long> has = new ArrayList<>();
          for (int i = 0; i < runs.size(); i++) {
            has.add(names.get(i).contains(name) ? runs.get(i).id() : null);
          }
          rows.add(new DrawingRow(name, title, has));
        });
    return rows;
  }
}
