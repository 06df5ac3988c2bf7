package org.toqa.web.input;

import java.time.DateTimeException;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.OffsetDateTime;
import java.time.ZoneId;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.web.Texts;

/**
 * Reads the order in one line of a table. An empty cell counts as missing.
 *
 * @param cells by their column
 * @param hasDecimalComma whether a number may have a decimal comma
 * @param zone of deadlines that name none
 */
record TaskOrderRow(
    Map<String, String> cells,
    boolean hasDecimalComma,
    ZoneId zone,
    Instant now,
    Texts texts,
    FieldErrors errors) {

  TaskOrder read() {
    InputRules rules = new InputRules(texts, errors);
    return new TaskOrder(
        rules.taskName("name", text("name")),
        rules.load("load", number("load")),
        where("start", rules),
        where("goal", rules),
        text("floor"),
        rules.priority("priority", number("priority")),
        rules.futureDeadline("deadline", deadline(), now),
        size());
  }

  private Where where(String end, InputRules rules) {
    String station = text(end);
    String x = end + "X";
    String y = end + "Y";
    boolean hasPoint = text(x) != null || text(y) != null;
    if (station == null && hasPoint) {
      return new Where.Point(
          new Vec2(rules.coordinate(x, number(x)), rules.coordinate(y, number(y))));
    }
    if (station == null || hasPoint) {
      errors.add(end, texts.get("error.import.place", end));
    }
    return new Where.Station(station == null ? "" : station);
  }

  private @Nullable Instant deadline() {
    String given = text("deadline");
    if (given == null) {
      return null;
    }
    String moment = Digits.latin(given).replaceFirst("(?<=\\d) +(?=\\d)", "T");
    try {
      return moment.matches(".*(Z|[+-]\\d\\d:\\d\\d)")
          ? OffsetDateTime.parse(moment).toInstant()
          : LocalDateTime.parse(moment).atZone(zone).toInstant();
    } catch (DateTimeException e) {
      errors.add("deadline", texts.get("error.import.deadline"));
      return null;
    }
  }

  /** Both sides, or neither. */
  private @Nullable LoadSize size() {
    if (text("length") == null && text("width") == null) {
      return null;
    }
    FieldErrors ofSize = new FieldErrors();
    LoadSize size = new InputRules(texts, ofSize).size("size", number("length"), number("width"));
    ofSize
        .sentences()
        .forEach((field, sentence) -> errors.add(field.replace("size.", ""), sentence));
    return size;
  }

  private @Nullable Double number(String column) {
    String given = text(column);
    if (given == null) {
      return null;
    }
    Optional<Double> number = Digits.number(hasDecimalComma ? given.replace(',', '.') : given);
    if (number.isEmpty()) {
      errors.add(column, texts.get("error.notANumber"));
    }
    return number.orElse(null);
  }

  private @Nullable String text(String column) {
    String given = cells.getOrDefault(column, "").strip();
    return given.isEmpty() ? null : given;
  }
}
