package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.supervision.SupervisedBox;
import org.toqa.fleet.supervision.Supervision;
import org.toqa.fleet.supervision.SupervisionOrder;
import org.toqa.fleet.supervision.SupervisionReport;
import org.toqa.fleet.supervision.Supervisor;
import org.toqa.geometry.Vec2;
import org.toqa.web.FleetAnswers;
import org.toqa.web.SupervisionView;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.SupervisionOrderReader;
import org.toqa.wording.Sentence;

/** The supervisor of a floor and the boxes that its workers carry. */
public final class SupervisionResource extends ApiHandler {

  /**
   * @param idleSecondsPerBox null: none was delivered yet
   * @param doing what the supervisor does, or why it does nothing; null: it does not run
   * @param needs what a person must look at, in a sentence; null: nothing
   * @param seenAll whether everything that can be seen of the floor was, while it runs
   */
  private record SupervisionJson(
      String floor,
      String supervisor,
      List<String> workers,
      boolean sequential,
      String user,
      Supervision.State state,
      Instant begunAt,
      @Nullable Instant endedAt,
      @Nullable Double idleSecondsPerBox,
      @Nullable Sentence doing,
      @Nullable Sentence needs,
      boolean seenAll,
      List<BoxJson> boxes) {

    static SupervisionJson of(SupervisionView view) {
      Supervision supervision = view.supervision();
      SupervisionReport report = view.report();
      return new SupervisionJson(
          supervision.floor(),
          supervision.supervisor(),
          supervision.workers(),
          !supervision.overlaps(),
          supervision.user(),
          supervision.state(),
          supervision.begunAt(),
          supervision.endedAt(),
          supervision.idleSecondsPerBox().map(s -> Math.round(10 * s) / 10.0).orElse(null),
          report == null ? null : report.doing(),
          report == null ? null : report.need(),
          report != null && report.hasSeenAll(),
          view.boxes().stream().map(BoxJson::of).toList());
    }
  }

  /**
   * @param place where it was seen last, metres, map frame; null: not yet
   * @param weight kilograms; null: it was not weighed yet
   * @param task null: none carries it
   * @param robots those that are about it
   * @param reason why it waits; null: it does not
   * @param question what a person must answer at its task; null: nothing
   */
  private record BoxJson(
      int box,
      Vec2 target,
      @Nullable Vec2 place,
      @Nullable Double weight,
      @Nullable Long task,
      boolean delivered,
      SupervisionView.BoxState state,
      List<String> robots,
      @Nullable Sentence reason,
      @Nullable Sentence question) {
    static BoxJson of(SupervisionView.Box view) {
      SupervisedBox box = view.box();
      return new BoxJson(
          box.number(),
          box.target(),
          box.place(),
          box.weight(),
          box.task(),
          box.delivered(),
          view.state(),
          view.robots(),
          view.reason(),
          view.question());
    }
  }

  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    String floor = FloorFilesResource.floorOfPath(request).name();
    Supervision supervision =
        services(request)
            .supervisor()
            .latest(floor)
            .orElseThrow(
                () ->
                    Problem.of(404, Texts.of(request).get("problem.supervision.none", floor))
                        .exception());
    send(request, response, 200, supervision);
  }

  public static void start(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    String floor = FloorFilesResource.floorOfPath(request).name();
    SupervisionOrder order =
        readLargeBody(request, fields -> SupervisionOrderReader.read(fields, floor));
    Supervision begun =
        acceptedValue(
            request,
            FleetAnswers.await(
                services(request).supervisor().start(order, Caller.of(request).name())));
    send(request, response, HttpServletResponse.SC_CREATED, begun);
  }

  public static void stop(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    change(request, response, Supervisor::stop);
  }

  public static void lookAgain(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    change(request, response, Supervisor::lookAgain);
  }

  public static void leaveOut(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    int box = SupervisionView.boxOfPath(request);
    change(request, response, (supervisor, floor, user) -> supervisor.leaveOut(floor, box, user));
  }

  @FunctionalInterface
  private interface Change {
    CompletionStage<Answer<Supervision>> send(Supervisor supervisor, String floor, String user);
  }

  private static void change(
      HttpServletRequest request, HttpServletResponse response, Change change) throws IOException {
    String floor = FloorFilesResource.floorOfPath(request).name();
    Supervision changed =
        acceptedValue(
            request,
            FleetAnswers.await(
                change.send(services(request).supervisor(), floor, Caller.of(request).name())));
    send(request, response, 200, changed);
  }

  private static void send(
      HttpServletRequest request, HttpServletResponse response, int status, Supervision supervision)
      throws IOException {
    Json.send(
        request,
        response,
        status,
        SupervisionJson.of(SupervisionView.of(services(request), supervision)));
  }
}
