package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.math.BigDecimal;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.toqa.lab.experiment.Figure;
import org.toqa.lab.experiment.Table;
import org.toqa.lab.experiment.Value;
import org.toqa.lab.record.KeptDrawing;
import org.toqa.lab.record.KeptReport;
import org.toqa.lab.record.LabRun;
import org.toqa.lab.record.Laboratory;
import org.toqa.lab.record.ReportJson;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;

/** One run of the laboratory, what it has given, and the commands to it. */
public final class LabRunResource extends ApiHandler {
  private static final List<String> FIGURES =
      List.of("name", "published", "measured", "bound", "verdict", "reason");

  private static final Pattern NUMBER = Pattern.compile("-?[0-9]{1,15}(\\.[0-9]{1,15})?");

  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Json.send(request, response, 200, LabRunJson.of(run(request), laboratory(request)));
  }

  public static void stop(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    LabRun run = run(request);
    if (!laboratory(request).stop(run.id())) {
      throw conflict(request, "problem.laboratory.over");
    }
    get(request, response);
  }

  public static void delete(HttpServletRequest request, HttpServletResponse response) {
    LabRun run = run(request);
    if (!laboratory(request).store().delete(run.id())) {
      throw conflict(request, "problem.laboratory.runs");
    }
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  private static Problem.ProblemException conflict(HttpServletRequest request, String key) {
    return Problem.of(409, Texts.of(request).get(key)).exception();
  }

  public static void report(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    LabRun run = run(request);
    send(response, "application/json", fileName(run, "json"), reportText(request, run) + "\n");
  }

  public static void figures(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    LabRun run = run(request);
    CsvWriter csv = new CsvWriter(FIGURES);
    for (Figure figure : report(request, run).figures()) {
      csv.addLine(
          figure.name(),
          text(figure.published()),
          text(figure.measured()),
          text(figure.bound()),
          figure.verdict().word(),
          figure.reason());
    }
    csv.send(response, fileName(run, "figures.csv"));
  }

  private static @Nullable String text(Value value) {
    return value instanceof Value.None ? null : value.text();
  }

  /** A number as one, which no spreadsheet takes for a formula. */
  private static Object cell(String text) {
    return NUMBER.matcher(text).matches() ? new BigDecimal(text) : text;
  }

  public static void table(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    LabRun run = run(request);
    String name = RequestPath.parameter(request, "name");
    Table table =
        report(request, run).tables().stream()
            .filter(one -> one.name().equals(name))
            .findFirst()
            .orElseThrow(() -> notFound(request, "problem.laboratory.noSuchPart"));
    CsvWriter csv = new CsvWriter(table.columns());
    table.rows().forEach(row -> csv.addLine(row.stream().map(LabRunResource::cell).toArray()));
    csv.send(response, fileName(run, table.name() + ".csv"));
  }

  public static void drawings(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Json.send(request, response, 200, laboratory(request).store().drawings(run(request).id()));
  }

  public static void drawing(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    LabRun run = run(request);
    KeptDrawing drawing = drawing(request, run);
    send(response, "image/svg+xml", fileName(run, drawing.name() + ".svg"), drawing.svg());
  }

  /** How the bodies of a scene move. */
  public static void motion(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    LabRun run = run(request);
    KeptDrawing drawing = drawing(request, run);
    String motion = drawing.motion();
    if (motion == null) {
      throw notFound(request, "problem.laboratory.noSuchPart");
    }
    send(response, "application/json", fileName(run, drawing.name() + ".json"), motion);
  }

  private static KeptDrawing drawing(HttpServletRequest request, LabRun run) {
    return laboratory(request)
        .store()
        .drawing(run.id(), RequestPath.parameter(request, "name"))
        .orElseThrow(() -> notFound(request, "problem.laboratory.noSuchPart"));
  }

  private static KeptReport report(HttpServletRequest request, LabRun run) {
    return ReportJson.read(reportText(request, run));
  }

  private static String reportText(HttpServletRequest request, LabRun run) {
    return laboratory(request)
        .store()
        .report(run.id())
        .orElseThrow(() -> notFound(request, "problem.laboratory.noReport"));
  }

  private static LabRun run(HttpServletRequest request) {
    return laboratory(request)
        .store()
        .run(RequestPath.number(request, "id"))
        .orElseThrow(() -> notFound(request, "problem.laboratory.noSuchRun"));
  }

  private static Problem.ProblemException notFound(HttpServletRequest request, String key) {
    return Problem.of(404, Texts.of(request).get(key)).exception();
  }

  private static Laboratory laboratory(HttpServletRequest request) {
    return services(request).laboratory();
  }

  private static String fileName(LabRun run, String ending) {
    return "toqa-%s-%d%s%s"
        .formatted(run.order().experiment(), run.id(), ending.equals("json") ? "." : "-", ending);
  }

  private static void send(
      HttpServletResponse response, String mediaType, String fileName, String content)
      throws IOException {
    byte[] bytes = content.getBytes(StandardCharsets.UTF_8);
    response.setContentType(mediaType);
    response.setCharacterEncoding("UTF-8");
    response.setHeader("Content-Disposition", "inline; filename=\"" + fileName + "\"");
    response.setContentLength(bytes.length);
    response.getOutputStream().write(bytes);
  }
}
