package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import java.io.IOException;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.grid.FloorMap;
import org.toqa.mission.Question;
import org.toqa.web.Services;
import org.toqa.web.Texts;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.Fields;
import org.toqa.web.input.FloorQueryReader;
import org.toqa.web.input.JsonFields;
import org.toqa.web.input.Version;
import org.toqa.wording.Sentence;

/** What the handlers of the API have in common. */
public abstract class ApiHandler {
  /** Such a number fits into a long. */
  private static final int MOST_DIGITS = 18;

  public static Services services(HttpServletRequest request) {
    return Services.of(request);
  }

  /**
   * @throws Problem.ProblemException when there are errors
   */
  static void throwIfAny(FieldErrors errors) {
    if (!errors.isEmpty()) {
      throw Problem.of(errors).exception();
    }
  }

  /**
   * Reads the request's body.
   *
   * @throws Problem.ProblemException when it is no JSON object, or with a sentence for each field
   *     that is wrong
   */
  static <T> T readBody(HttpServletRequest request, Function<Fields, T> reader) throws IOException {
    FieldErrors errors = new FieldErrors();
    T read = reader.apply(JsonBody.read(request, errors));
    throwIfAny(errors);
    return read;
  }

  /**
   * Reads a body that may have a drawing of a floor.
   *
   * @throws Problem.ProblemException as {@link #readBody}
   */
  static <T> T readLargeBody(HttpServletRequest request, Function<JsonFields, T> reader)
      throws IOException {
    FieldErrors errors = new FieldErrors();
    T read = reader.apply(JsonBody.read(request, errors, DrawingReader.MAX_BYTES));
    throwIfAny(errors);
    return read;
  }

  /**
   * @throws Problem.ProblemException when the caller means another version than this
   */
  static void requireVersion(Version version, HttpServletRequest request) {
    String ifMatch = request.getHeader("If-Match");
    if (ifMatch != null && !version.isAmong(ifMatch)) {
      throw changedMeanwhile(request);
    }
  }

  static Problem.ProblemException changedMeanwhile(HttpServletRequest request) {
    return Problem.of(412, Texts.of(request).get("problem.changedMeanwhile")).exception();
  }

  /**
   * @throws Problem.ProblemException when the fleet says no
   */
  static <T> T acceptedValue(HttpServletRequest request, Answer<T> answer) {
    Texts texts = Texts.of(request);
    return switch (answer) {
      case Answer.Accepted<T>(T value) -> value;
      case Answer.Rejected<T>(String field, Sentence sentence) -> {
        if (field == null) {
          throw Problem.of(422, texts.text(sentence)).exception();
        }
        FieldErrors errors = new FieldErrors();
        errors.add(field, texts.text(sentence));
        throw Problem.of(errors).exception();
      }
      case Answer.Conflict<T>(Sentence sentence, Question needs) ->
          throw Problem.conflict(texts.text(sentence), needs).exception();
      case Answer.Outdated<T>() -> throw changedMeanwhile(request);
      case Answer.Unknown<T>(Sentence sentence) ->
          throw Problem.of(404, texts.text(sentence)).exception();
    };
  }

  /** The floor that the query names; the first one where it names none. */
  static FloorMap floor(HttpServletRequest request) {
    List<FloorMap> floors = services(request).fleet().floors();
    String wanted = request.getParameter("floor");
    return floors.stream()
        .filter(floor -> wanted == null || floor.name().equals(wanted))
        .findFirst()
        .orElseThrow(() -> noSuchFloor(request, floors));
  }

  /**
   * The floor of which a list is wanted; all where the query names none.
   *
   * @throws Problem.ProblemException there is no such floor
   */
  static FloorQueryReader wantedFloor(HttpServletRequest request) {
    FieldErrors errors = new FieldErrors();
    FloorQueryReader reader =
        new FloorQueryReader(request, errors, services(request).fleet().floors());
    throwIfAny(errors);
    return reader;
  }

  /** The name of that floor; null: all are wanted. */
  public static @Nullable String wantedFloorName(HttpServletRequest request) {
    return wantedFloor(request).floor();
  }

  private static Problem.ProblemException noSuchFloor(
      HttpServletRequest request, List<FloorMap> floors) {
    String names = floors.stream().map(FloorMap::name).collect(Collectors.joining(", "));
    return Problem.of(404, Texts.of(request).get("problem.noSuchFloor", names)).exception();
  }

  /** A whole number from the query, at least {@code least}; a larger one than most is lowered. */
  static int queryNumber(HttpServletRequest request, String name, int fallback, int min, int max) {
    String given = request.getParameter(name);
    if (given == null) {
      return fallback;
    }
    String digits = given.matches("[0-9]+") ? given.replaceFirst("^0+(?=.)", "") : "-1";
    long number = digits.length() > MOST_DIGITS ? max : Long.parseLong(digits);
    if (number < min) {
      throw Problem.of(400, Texts.of(request).get("problem.queryNumber", name, min)).exception();
    }
    return (int) Math.min(number, max);
  }
}
