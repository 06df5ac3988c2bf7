package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.ZoneId;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskView;
import org.toqa.grid.Place;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.LineFault;
import org.toqa.web.input.LineFaults;
import org.toqa.web.input.TaskImport;

/** Many tasks at once, as a table from a spreadsheet; and an example of one. */
public final class ImportResource extends ApiHandler {

  /** An example that could be sent as it is, where the floor has stations. */
  public static void example(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    List<Place> stations = services(request).fleet().floors().getFirst().stations();
    CsvWriter csv =
        new CsvWriter(List.of("name", "load", "start", "goal", "goalX", "goalY", "priority"));
    Optional<Place> start = stations.stream().findFirst();
    if (start.isPresent()) {
      Place goal = stations.getLast();
      csv.addLine("Box of bolts", 2.5, start.get().name(), goal.name(), null, null, 0);
      csv.addLine(
          "Empty box",
          0.5,
          goal.name(),
          null,
          start.get().position().x(),
          start.get().position().y(),
          10);
    }
    csv.send(response, "toqa-tasks.csv");
  }

  public static void importTable(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Texts texts = Texts.of(request);
    byte[] table = table(request, texts);
    ZoneId zone =
        TaskImport.zone(request.getParameter("zone"))
            .orElseThrow(() -> Problem.of(422, texts.get("error.statistics.zone")).exception());
    List<TaskView> tasks =
        switch (new TaskImport(services(request), texts, TemplatesResource.usable(request))
            .run(table, zone, Caller.of(request).account(), IdempotencyKey.of(request))) {
          case TaskImport.Outcome.Imported(List<TaskView> imported) -> imported;
          case TaskImport.Outcome.Faulty(LineFaults faults) ->
              throw Problem.of(faults, sentence(faults, texts)).exception();
          case TaskImport.Outcome.KeyReused() ->
              throw Problem.of(422, texts.get("problem.idempotencyKey.used")).exception();
        };
    Json.send(
        request,
        response,
        HttpServletResponse.SC_CREATED,
        tasks.stream().map(TaskJson::of).toList());
  }

  private static byte[] table(HttpServletRequest request, Texts texts) throws IOException {
    if (!isCsv(request.getContentType())) {
      throw Problem.of(415, texts.get("problem.notCsv")).exception();
    }
    byte[] table = request.getInputStream().readNBytes(TaskImport.MAX_BYTES + 1);
    if (table.length > TaskImport.MAX_BYTES) {
      throw Problem.of(413, texts.get("problem.bodySize", TaskImport.MAX_BYTES / 1024)).exception();
    }
    return table;
  }

  /** In UTF-8, if it says in what. */
  private static boolean isCsv(@Nullable String contentType) {
    String type = contentType == null ? "" : contentType.toLowerCase(Locale.ROOT);
    return type.matches("\\s*text/csv\\s*(;.*)?")
        && (!type.contains("charset=") || type.matches(".*charset=\"?utf-8\"?.*"));
  }

  private static String sentence(LineFaults faults, Texts texts) {
    String sentences =
        faults.first().stream()
            .map(fault -> sentence(fault, texts))
            .collect(Collectors.joining(" "));
    String rest = faults.more() == 0 ? "" : " " + texts.get("import.more", faults.more());
    return texts.get("import.faulty") + " " + sentences + rest;
  }

  private static String sentence(LineFault fault, Texts texts) {
    return fault.column() == null
        ? texts.get("import.fault", fault.line(), fault.sentence())
        : texts.get("import.fault.column", fault.line(), fault.column(), fault.sentence());
  }
}
