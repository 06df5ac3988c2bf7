package org.toqa.lab.record;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.toqa.lab.experiment.Experiment;
import org.toqa.lab.experiment.Figure;
import org.toqa.lab.experiment.Parameter;
import org.toqa.lab.experiment.Report;
import org.toqa.lab.experiment.Run;
import org.toqa.lab.experiment.Table;
import org.toqa.lab.experiment.Value;
import org.toqa.lab.experiment.Verdict;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** A report as a program reads it, and as it is kept. */
public final class ReportJson {
  private ReportJson() {}

  /** On one line. */
  public static String text(Experiment experiment, Run run, Report report) {
    ObjectNode json = JsonMapper.shared().createObjectNode();
    json.put("experiment", experiment.name());
    json.put("seed", run.seed());
    json.put("runs", run.runs());
    ObjectNode parameters = json.putObject("parameters");
    for (Parameter parameter : experiment.parameters()) {
      parameters.put(parameter.name(), run.value(parameter));
    }
    ArrayNode figures = json.putArray("figures");
    report.figures().forEach(figure -> put(figures.addObject(), figure));
    ArrayNode tables = json.putArray("tables");
    report.tables().forEach(table -> put(tables.addObject(), table));
    ArrayNode notes = json.putArray("notes");
    report.notes().forEach(notes::add);
    return JsonMapper.shared().writeValueAsString(json);
  }

  /** What there is, on one line. */
  public static String list(List<Experiment> experiments) {
    ArrayNode json = JsonMapper.shared().createArrayNode();
    for (Experiment experiment : experiments) {
      json.addObject()
          .put("name", experiment.name())
          .put("title", experiment.title())
          .put("source", experiment.source());
    }
    return JsonMapper.shared().writeValueAsString(json);
  }

  private static void put(ObjectNode json, Figure figure) {
    json.put("name", figure.name());
    put(json, "published", figure.published());
    put(json, "measured", figure.measured());
    put(json, "bound", figure.bound());
    json.put("unit", unit(figure));
    json.put("verdict", figure.verdict().word());
    json.put("reason", figure.reason());
  }

  private static void put(ObjectNode json, String key, Value value) {
    switch (value) {
      case Value.Quantity quantity when Double.isFinite(quantity.number()) ->
          json.put(key, quantity.number());
      case Value.Quantity quantity -> json.put(key, quantity.text());
      case Value.Words words -> json.put(key, words.text());
      case Value.None _ -> json.putNull(key);
    }
  }

  private static String unit(Figure figure) {
    for (Value value : List.of(figure.published(), figure.measured(), figure.bound())) {
      if (value instanceof Value.Quantity quantity) {
        return quantity.unit();
      }
    }
    return "";
  }

  private static void put(ObjectNode json, Table table) {
    json.put("name", table.name());
    json.put("title", table.title());
    ArrayNode columns = json.putArray("columns");
    table.columns().forEach(columns::add);
    ArrayNode rows = json.putArray("rows");
    for (List<String> row : table.rows()) {
      ArrayNode cells = rows.addArray();
      row.forEach(cells::add);
    }
  }

  /**
   * What {@link #text} wrote.
   *
   * @throws IllegalArgumentException it has not written that
   */
  public static KeptReport read(String text) {
    JsonNode json = JsonMapper.shared().readTree(text);
    Map<String, Double> parameters = new LinkedHashMap<>();
    json.path("parameters")
        .properties()
        .forEach(entry -> parameters.put(entry.getKey(), entry.getValue().doubleValue()));
    return new KeptReport(
        parameters,
        json.path("figures").valueStream().map(ReportJson::figure).toList(),
        json.path("tables").valueStream().map(ReportJson::table).toList(),
        texts(json.path("notes")));
  }

  private static Figure figure(JsonNode json) {
    String unit = json.path("unit").stringValue("");
    return new Figure(
        json.path("name").stringValue(""),
        value(json.path("published"), unit),
        value(json.path("measured"), unit),
        value(json.path("bound"), unit),
        Verdict.ofWord(json.path("verdict").stringValue("")),
        json.path("reason").stringValue(""));
  }

  private static Value value(JsonNode json, String unit) {
    if (json.isNumber()) {
      return Value.of(json.doubleValue(), unit);
    }
    return json.isString() ? Value.of(json.stringValue()) : Value.NONE;
  }

  private static Table table(JsonNode json) {
    return new Table(
        json.path("name").stringValue(""),
        json.path("title").stringValue(""),
        texts(json.path("columns")),
        json.path("rows").valueStream().map(ReportJson::texts).toList());
  }

  private static List<String> texts(JsonNode json) {
    return json.valueStream().map(text -> text.stringValue("")).toList();
  }
}
