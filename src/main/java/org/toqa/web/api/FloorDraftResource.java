package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.FloorDraft;
import org.toqa.fleet.FloorEditing;
import org.toqa.fleet.MapProblem;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.FloorMap;
import org.toqa.web.FleetAnswers;
import org.toqa.web.FloorSummary;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.JsonFields;
import org.toqa.wording.Phrase;

/** The draft of a floor: what is to be published. */
public final class FloorDraftResource extends ApiHandler {
  /** Whole numbers that JSON keeps. */
  private static final double MAX_REVISION = 1L << 53;

  private record DraftJson(
      String floor,
      long revision,
      @Nullable String user,
      @Nullable Instant at,
      DrawingJson drawing) {
    static DraftJson of(FloorDraft draft) {
      return new DraftJson(
          draft.floor(),
          draft.revision(),
          draft.user(),
          draft.at(),
          DrawingJson.of(draft.drawing()));
    }
  }

  private record SaveOrder(long revision, FloorDrawing drawing) {}

  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    Json.send(request, response, 200, DraftJson.of(draft(request)));
  }

  public static void save(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    String floor = draft(request).floor();
    SaveOrder order =
        readLargeBody(
            request,
            fields -> {
              SaveOrder read =
                  new SaveOrder(revision(fields), DrawingReader.read(fields.object("drawing")));
              fields.refuseUnknown();
              return read;
            });
    Answer<FloorDraft> answer =
        FleetAnswers.await(
            editing(request)
                .saveDraft(floor, order.drawing(), order.revision(), Caller.of(request).name()));
    Json.send(request, response, 200, DraftRevisionJson.of(currentValue(request, answer)));
  }

  public static void discard(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    String floor = draft(request).floor();
    FieldErrors errors = new FieldErrors();
    Long seen = revision(request, errors);
    throwIfAny(errors);
    String user = Caller.of(request).name();
    var _ =
        currentValue(request, FleetAnswers.await(editing(request).discardDraft(floor, seen, user)));
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  public static void check(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    String floor = draft(request).floor();
    FloorDrawing drawing =
        readLargeBody(
            request,
            fields -> {
              FloorDrawing read = DrawingReader.read(fields.object("drawing"));
              fields.refuseUnknown();
              return read;
            });
    List<MapProblem> problems =
        acceptedValue(
            request,
            FleetAnswers.await(editing(request).check(floor, drawing, Caller.of(request).name())));
    Json.send(request, response, 200, problems.stream().map(MapProblemJson::of).toList());
  }

  public static void publish(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    FloorDraft draft = draft(request);
    long seen =
        readBody(
            request,
            fields -> {
              long revision = revision((JsonFields) fields);
              fields.refuseUnknown();
              return revision;
            });
    String user = Caller.of(request).name();
    Answer<FloorMap> answer =
        FleetAnswers.await(editing(request).publish(draft.floor(), seen, user));
    if (answer instanceof Answer.Conflict<FloorMap>(var sentence, var _)) {
      throw Problem.conflict(
              Texts.of(request).text(sentence), blocking(request, draft.floor(), user))
          .exception();
    }
    FloorMap published = currentValue(request, answer);
    Json.send(request, response, 200, FloorSummary.of(published, services(request)));
  }

  /** Why the draft cannot be published. */
  private static List<MapProblemJson> blocking(
      HttpServletRequest request, String floor, String user) {
    return editing(request)
        .draft(floor)
        .map(
            draft ->
                acceptedValue(
                    request,
                    FleetAnswers.await(editing(request).check(floor, draft.drawing(), user))))
        .orElse(List.of())
        .stream()
        .filter(MapProblem::isBlocking)
        .map(MapProblemJson::of)
        .toList();
  }

  /** Null: none is given. */
  private static @Nullable Long revision(HttpServletRequest request, FieldErrors errors) {
    String given = request.getParameter("revision");
    if (given != null && !given.matches("[0-9]{1,15}")) {
      errors.add("revision", Texts.of(request).get("error.draft.revision"));
      return null;
    }
    return given == null ? null : Long.valueOf(given);
  }

  private static long revision(JsonFields fields) {
    Double given = fields.number("revision");
    if (given == null || given != Math.rint(given) || !(given >= 0 && given <= MAX_REVISION)) {
      fields.errors().add(fields.path("revision"), fields.texts().get("error.draft.revision"));
      return 0;
    }
    return given.longValue();
  }

  /**
   * @throws Problem.ProblemException when the fleet says no, with who has changed the draft
   */
  private static <T> T currentValue(HttpServletRequest request, Answer<T> answer) {
    if (!(answer instanceof Answer.Outdated<T>)) {
      return acceptedValue(request, answer);
    }
    String user = draft(request).user();
    Texts texts = Texts.of(request);
    throw Problem.of(
            412,
            user == null ? texts.get("problem.draftGone") : texts.get("problem.draftChanged", user))
        .exception();
  }

  private static FloorDraft draft(HttpServletRequest request) {
    String floor = RequestPath.parameter(request, "floor");
    return editing(request)
        .draft(floor)
        .orElseThrow(
            () ->
                Problem.of(404, Texts.of(request).text(Phrase.NO_SUCH_FLOOR.with(floor)))
                    .exception());
  }

  private static FloorEditing editing(HttpServletRequest request) {
    return services(request).fleet().floorEditing();
  }
}
