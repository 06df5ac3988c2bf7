package org.toqa.web.input;

import java.time.DateTimeException;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.OffsetDateTime;
import java.time.ZoneId;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskOrder.StopOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.web.Texts;

/**
 * The fields in one line of a table.
 *
 * @param cells by their column
 * @param hasDecimalComma whether a number may have a decimal comma
 * @param zone of moments that name none
 */
record CsvFields(
    Map<String, String> cells,
    boolean hasDecimalComma,
    ZoneId zone,
    Texts texts,
    FieldErrors errors)
    implements Fields {

  /** The column of further stops. */
  private static final String STOPS = "stops";

  @Override
  public @Nullable String text(String column) {
    String given = cells.getOrDefault(column, "").strip();
    return given.isEmpty() ? null : given;
  }

  /** With blanks, commas or semicolons between. */
  @Override
  public List<String> choices(String column) {
    String given = text(column);
    return given == null ? List.of() : List.of(given.split("[\\s,;]+"));
  }

  @Override
  public @Nullable Double number(String column) {
    String given = text(column);
    if (given == null) {
      return null;
    }
    Optional<Double> number = decimal(given);
    if (number.isEmpty()) {
      errors.add(
          column,
          column.equals("priority")
              ? texts.get("error.priority.range", InputRules.MAX_PRIORITY)
              : texts.get("error.notANumber"));
    }
    return number.orElse(null);
  }

  private Optional<Double> decimal(String given) {
    return Digits.number(hasDecimalComma ? given.replace(',', '.') : given);
  }

  /** With its offset from UTC, or in the table's time zone. */
  @Override
  public @Nullable Instant moment(String column, String errorKey) {
    String given = text(column);
    if (given == null) {
      return null;
    }
    String moment = Digits.latin(given).replaceFirst("(?<=\\d) +(?=\\d)", "T");
    try {
      return moment.matches(".*(Z|[+-]\\d\\d:\\d\\d)")
          ? OffsetDateTime.parse(moment).toInstant()
          : LocalDateTime.parse(moment).atZone(zone).toInstant();
    } catch (DateTimeException e) {
      errors.add(column, texts.get("error.import.deadline"));
      return null;
    }
  }

  /** The name of a station in one column, or coordinates in two more. */
  @Override
  public Where place(String end) {
    String station = text(end);
    String x = end + "X";
    String y = end + "Y";
    boolean hasPoint = text(x) != null || text(y) != null;
    if (station == null && hasPoint) {
      return new Where.Point(
          new Vec2(rules().coordinate(x, number(x)), rules().coordinate(y, number(y))));
    }
    if (station == null) {
      errors.add(end, texts.get("error.import.place.missing", end));
    } else if (hasPoint) {
      errors.add(end, texts.get("error.import.place", end));
    }
    return new Where.Station(station == null ? "" : station);
  }

  /** All further stops are in one column. */
  @Override
  public String path(String name) {
    return name.equals("stop") ? STOPS : name;
  }

  @Override
  public boolean hasPlace(String end) {
    return Stream.of("", "X", "Y").anyMatch(column -> text(end + column) != null);
  }

  /**
   * The further stops in their column, with bars between; each a station or two coordinates, and
   * after a colon what is waited for there.
   */
  @Override
  public List<StopOrder> stops(String name, int max) {
    String given = text(STOPS);
    if (given == null) {
      return List.of();
    }
    List<StopOrder> stops =
        Stream.of(given.split("\\|"))
            .map(String::strip)
            .filter(stop -> !stop.isEmpty())
            .map(this::stop)
            .toList();
    if (stops.size() > max) {
      errors.add(STOPS, texts.get("error.stops.many", max));
      return List.of();
    }
    return stops;
  }

  private StopOrder stop(String given) {
    int colon = given.lastIndexOf(':');
    return colon < 0
        ? new StopOrder(where(given), false, null)
        : stop(STOPS, where(given.substring(0, colon).strip()), given.substring(colon + 1).strip());
  }

  private Where where(String given) {
    List<Optional<Double>> numbers = Stream.of(given.split("\\s+")).map(this::decimal).toList();
    return numbers.size() == 2 && numbers.stream().allMatch(Optional::isPresent)
        ? new Where.Point(
            new Vec2(
                rules().coordinate(STOPS, numbers.getFirst().orElseThrow()),
                rules().coordinate(STOPS, numbers.getLast().orElseThrow())))
        : StopWords.place(given);
  }

  @Override
  public StopOrder stopAt(String name, Where where) {
    String column = name + "Wait";
    return stop(column, where, text(column));
  }

  private StopOrder stop(String column, Where where, @Nullable String wait) {
    return StopWords.stop(this, column, where, wait, this::decimal);
  }

  /** The sides have columns of their own. */
  @Override
  public @Nullable LoadSize size(String name) {
    if (text("length") == null && text("width") == null) {
      return null;
    }
    FieldErrors ofSize = new FieldErrors();
    LoadSize size = new InputRules(texts, ofSize).size(name, number("length"), number("width"));
    ofSize
        .sentences()
        .forEach((field, sentence) -> errors.add(field.replace(name + ".", ""), sentence));
    return size;
  }
}
