package org.toqa.web.input;

import java.time.Instant;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.PartsOrder;
import org.toqa.web.Texts;

/**
 * Orders in a table: its first line names the columns, in any order, and each other line is one
 * order. Where semicolons separate, a number may have a decimal comma, since spreadsheets that
 * write the one write the other.
 */
final class TaskOrderTable {
  static final int MAX_ORDERS = 500;

  private static final List<String> COLUMNS =
      List.of(
          "template",
          "name",
          "kind",
          "load",
          "pieces",
          "start",
          "startX",
          "startY",
          "goal",
          "goalX",
          "goalY",
          "startWait",
          "goalWait",
          "stops",
          "carriedBy",
          "floor",
          "priority",
          "deadline",
          "onlyRobots",
          "length",
          "width");

  /** Columns by which the others are read. */
  private static final Set<String> LEADING = Set.of("kind", TemplateFiller.TEMPLATE);

  private final CsvTable table;
  private final ZoneId zone;
  private final Instant now;
  private final Texts texts;
  private final TemplateFiller templates;
  private final LineFaults faults = new LineFaults();
  private final List<Row> rows = new ArrayList<>();

  /** Columns of which the first line says nothing good; that is told once, and not line by line. */
  private final Set<String> faultyColumns = new HashSet<>();

  /**
   * An order and its line; one of a single piece is an ordinary task.
   *
   * @param ofTemplate null: it was made from no template
   * @param faulty columns that cannot be read; what the order has of them means nothing
   */
  record Row(long line, PartsOrder order, @Nullable OrderedTask ofTemplate, Set<String> faulty) {
    /** Whether that field of the order comes from columns that can be read. */
    boolean isReadable(@Nullable String field) {
      return (field == null || ofTemplate != null) // whose columns are not those of an order
          ? faulty.isEmpty()
          : faulty.stream().noneMatch(column -> column.startsWith(field));
    }
  }

  private TaskOrderTable(
      CsvTable table, ZoneId zone, Instant now, TemplateFiller templates, Texts texts) {
    this.table = table;
    this.templates = templates;
    this.zone = zone;
    this.now = now;
    this.texts = texts;
  }

  /**
   * @param zone of deadlines that name none
   * @param templates those that may be used
   */
  static TaskOrderTable read(
      byte[] file, ZoneId zone, Instant now, TemplateFiller templates, Texts texts) {
    TaskOrderTable orders = new TaskOrderTable(CsvTable.read(file), zone, now, templates, texts);
    orders.read();
    return orders;
  }

  /** Those of the lines whose cells are as many as their columns. */
  List<Row> rows() {
    return rows;
  }

  LineFaults faults() {
    return faults;
  }

  private void read() {
    table
        .flaw()
        .ifPresent(flaw -> addFault(flaw.line(), "error.import.flaw." + flaw.kind().name()));
    if (table.lines().isEmpty()) {
      if (faults.isEmpty()) {
        addFault(1, "error.import.empty");
      }
      return;
    }
    CsvTable.Line first = table.lines().getFirst();
    List<String> header = first.cells().stream().map(this::column).toList();
    checkHeader(first.number(), header);
    if (header.stream().anyMatch(this::isKnown) // else that line is none of columns
        && Collections.disjoint(faultyColumns, LEADING)) {
      read(header, table.lines().subList(1, table.lines().size()));
    }
  }

  private boolean isKnown(String column) {
    return COLUMNS.contains(column) && !faultyColumns.contains(column);
  }

  private void read(List<String> header, List<CsvTable.Line> lines) {
    if (lines.size() > MAX_ORDERS) {
      addFault(lines.get(MAX_ORDERS).number(), "error.import.long", MAX_ORDERS, lines.size());
    } else if (lines.isEmpty() && faults.isEmpty()) {
      addFault(1, "error.import.empty");
    } else {
      lines.forEach(line -> read(header, line));
      checkCount();
    }
  }

  private void checkCount() {
    int tasks = 0;
    for (Row row : rows) {
      tasks += row.order().tasks().size();
      if (tasks > MAX_ORDERS) {
        int all = rows.stream().mapToInt(each -> each.order().tasks().size()).sum();
        addFault(row.line(), "error.import.long", MAX_ORDERS, all);
        return;
      }
    }
  }

  private void read(List<String> header, CsvTable.Line line) {
    if (line.cells().size() > header.size()) {
      addFault(line.number(), "error.import.cells", line.cells().size(), header.size());
      return;
    }
    Map<String, String> cells = new TreeMap<>(String.CASE_INSENSITIVE_ORDER);
    for (int i = 0; i < line.cells().size(); i++) {
      if (!faultyColumns.contains(header.get(i))) {
        cells.put(header.get(i), line.cells().get(i));
      }
    }
    FieldErrors errors = new FieldErrors();
    CsvFields fields = new CsvFields(cells, table.separator() == ';', zone, texts, errors);
    OrderedTask ofTemplate =
        fields.has(TemplateFiller.TEMPLATE) ? templates.readEntered(fields, now) : null;
    PartsOrder order =
        ofTemplate == null ? readWithoutTemplate(fields) : PartsOrder.of(ofTemplate.order());
    Set<String> unreadable = new HashSet<>(errors.sentences().keySet());
    unreadable.addAll(faultyColumns);
    rows.add(new Row(line.number(), order, ofTemplate, unreadable));
    errors.sentences().entrySet().stream()
        .filter(error -> !faultyColumns.contains(error.getKey()))
        .map(error -> new LineFault(line.number(), error.getKey(), error.getValue()))
        .forEach(faults::add);
  }

  /** Columns of parameters are for lines with a template. */
  private PartsOrder readWithoutTemplate(CsvFields fields) {
    fields.cells().keySet().stream()
        .filter(column -> !COLUMNS.contains(column) && fields.has(column))
        .forEach(
            column ->
                fields.errors().add(column, texts.get("error.import.template.missing", column)));
    return TaskOrderReader.readEnteredParts(fields, now);
  }

  /** A column as this class writes it; one that it does not know stays as it is. */
  private String column(String given) {
    String name = given.strip();
    return Stream.concat(COLUMNS.stream(), templates.columns().stream())
        .filter(name::equalsIgnoreCase)
        .findFirst()
        .orElse(name);
  }

  private void checkHeader(long line, List<String> header) {
    FieldErrors errors = new FieldErrors();
    boolean hasTemplates = header.contains(TemplateFiller.TEMPLATE);
    for (String column : header) {
      if (!COLUMNS.contains(column) && !(hasTemplates && templates.columns().contains(column))) {
        errors.add(
            column, texts.get("error.import.column.unknown", column, String.join(", ", COLUMNS)));
      } else if (header.indexOf(column) != header.lastIndexOf(column)) {
        errors.add(column, texts.get("error.import.column.twice", column));
      }
    }
    if (!hasTemplates) { // else what must be there is told line by line
      checkRequired(header, errors);
    }
    faultyColumns.addAll(errors.sentences().keySet());
    Stream.of("start", "goal")
        .map(end -> List.of(end, end + "X", end + "Y")) // of which none says all without the others
        .filter(end -> !Collections.disjoint(faultyColumns, end))
        .forEach(faultyColumns::addAll);
    faults.addAll(line, errors);
  }

  private void checkRequired(List<String> header, FieldErrors errors) {
    boolean hasDrives = header.contains("kind");
    (hasDrives ? Stream.of("name") : Stream.of("name", "load"))
        .filter(column -> !header.contains(column))
        .forEach(column -> errors.add(column, texts.get("error.import.column.missing", column)));
    (hasDrives ? Stream.of("goal") : Stream.of("start", "goal"))
        .filter(end -> !header.contains(end))
        .filter(end -> !(header.contains(end + "X") && header.contains(end + "Y")))
        .forEach(end -> errors.add(end, texts.get("error.import.column.place", end)));
  }

  private void addFault(long line, String key, Object... values) {
    faults.add(new LineFault(line, null, texts.get(key, values)));
  }
}
