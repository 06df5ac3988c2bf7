package org.toqa.web.page;

import jakarta.servlet.http.HttpServletRequest;
import java.time.DateTimeException;
import java.time.Instant;
import java.time.LocalDateTime;
import java.time.ZoneId;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskOrder.StopOrder;
import org.toqa.fleet.TaskOrder.Where;
import org.toqa.geometry.Vec2;
import org.toqa.mission.ArmHandling;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.web.Texts;
import org.toqa.web.input.Digits;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.Fields;
import org.toqa.web.input.InputRules;
import org.toqa.web.input.StopWords;

/** The fields of a form that somebody sent. */
final class FormFields implements Fields {
  /** What may stand between numbers in a line; a comma within a number has no space after it. */
  private static final Pattern BETWEEN_NUMBERS = Pattern.compile("[:;\\s]+|[,،](?=\\s)");

  /** Characters of a line that is wrong. */
  private static final int LONGEST_QUOTE = 40;

  private final HttpServletRequest request;
  private final FieldErrors errors;

  FormFields(HttpServletRequest request, FieldErrors errors) {
    this.request = request;
    this.errors = errors;
  }

  @Override
  public @Nullable String text(String name) {
    String given = request.getParameter(name);
    return given == null || given.isBlank() ? null : given;
  }

  @Override
  public List<String> choices(String name) {
    String[] given = request.getParameterValues(name);
    return given == null ? List.of() : List.of(given);
  }

  @Override
  public @Nullable Double number(String name) {
    return number(name, name);
  }

  /**
   * @param shownAt the field that gets the sentence
   */
  private @Nullable Double number(String name, String shownAt) {
    String given = text(name);
    if (given == null) {
      return null;
    }
    Optional<Double> number = Digits.enteredNumber(given);
    if (number.isEmpty()) {
      errors.add(shownAt, Texts.of(request).get("error.notANumber"));
    }
    return number.orElse(null);
  }

  /** A date and a time of day in the time zone that the field {@code zone} names, or in UTC. */
  @Override
  public @Nullable Instant moment(String name, String errorKey) {
    String given = text(name);
    if (given == null) {
      return null;
    }
    String zone = text("zone");
    try {
      return LocalDateTime.parse(Digits.latin(given))
          .atZone(ZoneId.of(zone == null ? "UTC" : zone))
          .toInstant();
    } catch (DateTimeException e) {
      errors.add(name, Texts.of(request).get("error.notATime"));
      return null;
    }
  }

  /** A station goes before coordinates. */
  @Override
  public Where place(String name) {
    String station = text(name + "Station");
    if (station != null) {
      return new Where.Station(station);
    }
    InputRules rules = rules();
    return new Where.Point(
        new Vec2(
            rules.coordinate(name, number(name + "X", name)),
            rules.coordinate(name, number(name + "Y", name))));
  }

  @Override
  public boolean hasPlace(String name) {
    return Stream.of("Station", "X", "Y").anyMatch(field -> text(name + field) != null);
  }

  /** Stations; one that was not chosen counts for nothing. */
  @Override
  public List<Where> places(String name, int max) {
    List<Where> stations =
        choices(name + "Station").stream()
            .filter(station -> !station.isBlank())
            .<Where>map(Where.Station::new)
            .toList();
    if (stations.size() > max) {
      errors.add(name, texts().get("error.stops.many", max));
      return List.of();
    }
    return stations;
  }

  /** Stations with what is chosen beside each of them; without a station it counts for nothing. */
  @Override
  public List<StopOrder> stops(String name, int max) {
    List<Where> places = places(name, max);
    if (places.isEmpty()) {
      return List.of();
    }
    List<String> stations = choices(name + "Station");
    List<String> waits = choices(name + "Wait");
    return IntStream.range(0, stations.size())
        .filter(i -> !stations.get(i).isBlank())
        .mapToObj(
            i ->
                stop(
                    name,
                    placeOfStop(name, stations.get(i)),
                    i < waits.size() ? waits.get(i) : null))
        .toList();
  }

  /** A station, a charger, or two coordinates with a blank between. */
  private Where placeOfStop(String field, String given) {
    List<Optional<Double>> numbers =
        BETWEEN_NUMBERS.splitAsStream(given.strip()).map(Digits::enteredNumber).toList();
    return numbers.size() == 2 && numbers.stream().allMatch(Optional::isPresent)
        ? new Where.Point(
            new Vec2(
                rules().coordinate(field, numbers.getFirst().orElseThrow()),
                rules().coordinate(field, numbers.getLast().orElseThrow())))
        : StopWords.place(given);
  }

  @Override
  public StopOrder stopAt(String name, Where where) {
    return stop(name, where, text(name + "Wait"));
  }

  private StopOrder stop(String field, Where where, @Nullable String wait) {
    return StopWords.stop(this, field, where, wait, Digits::enteredNumber);
  }

  @Override
  public @Nullable LoadSize size(String name) {
    boolean isGiven = text("length") != null || text("width") != null;
    return isGiven ? rules().size(name, number("length", name), number("width", name)) : null;
  }

  @Override
  public @Nullable ArmHandling arm(String name) {
    boolean isGiven =
        Stream.of("pickX", "pickY", "placeX", "placeY").anyMatch(field -> text(field) != null);
    return isGiven ? new ArmHandling(point("pick", name), point("place", name)) : null;
  }

  /** A box a line: its number, x and y. */
  @Override
  public Map<Integer, Vec2> boxTargets(String name, int max) {
    String given = text(name);
    List<String> lines =
        given == null ? List.of() : given.lines().filter(line -> !line.isBlank()).toList();
    if (lines.size() > max) {
      errors.add(name, texts().get("error.supervision.many", max));
      return Map.of();
    }
    Map<Integer, Vec2> targets = new TreeMap<>();
    for (String line : lines) {
      List<Optional<Double>> numbers =
          BETWEEN_NUMBERS
              .splitAsStream(line.strip())
              .filter(part -> !part.isEmpty())
              .map(Digits::enteredNumber)
              .toList();
      if (numbers.size() != 3 || numbers.stream().anyMatch(Optional::isEmpty)) {
        errors.add(name, texts().get("error.supervision.line", shortened(line)));
        return Map.of();
      }
      int number = rules().boxNumber(name, numbers.getFirst().orElseThrow(), targets.keySet());
      targets.put(
          number,
          new Vec2(
              rules().coordinateOfPose(name, numbers.get(1).orElseThrow()),
              rules().coordinateOfPose(name, numbers.get(2).orElseThrow())));
    }
    return targets;
  }

  private static String shortened(String line) {
    return line.length() > LONGEST_QUOTE ? line.substring(0, LONGEST_QUOTE) + "…" : line.strip();
  }

  private Vec2 point(String name, String arm) {
    String shownAt = arm + "." + name;
    return new Vec2(
        rules().coordinateOfPose(shownAt, number(name + "X", shownAt)),
        rules().coordinateOfPose(shownAt, number(name + "Y", shownAt)));
  }

  @Override
  public Texts texts() {
    return Texts.of(request);
  }

  @Override
  public FieldErrors errors() {
    return errors;
  }
}
