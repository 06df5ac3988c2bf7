package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.supervision.SupervisedBox;
import org.toqa.fleet.supervision.Supervision;
import org.toqa.fleet.supervision.SupervisionOrder;
import org.toqa.fleet.supervision.Supervisor;
import org.toqa.geometry.Vec2;
import org.toqa.web.FleetAnswers;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.wording.Sentence;

/** The supervisor of a floor and the boxes that its workers carry. */
public final class SupervisionResource extends ApiHandler {

  /**
   * @param idleSecondsPerBox null: none was delivered yet
   * @param needs what a person must look at, in a sentence; null: nothing
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
      @Nullable String needs,
      List<BoxJson> boxes) {

    static SupervisionJson of(Supervision supervision, @Nullable String needs) {
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
          needs,
          supervision.boxes().values().stream().map(BoxJson::of).toList());
    }
  }

  /**
   * @param place where it was seen last, metres, map frame; null: not yet
   * @param weight kilograms; null: it was not weighed yet
   * @param task null: none carries it
   */
  private record BoxJson(
      int box,
      Vec2 target,
      @Nullable Vec2 place,
      @Nullable Double weight,
      @Nullable Long task,
      boolean delivered) {
    static BoxJson of(SupervisedBox box) {
      return new BoxJson(
          box.number(), box.target(), box.place(), box.weight(), box.task(), box.delivered());
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
    SupervisionOrder order = readLargeBody(request, fields -> read(fields, floor));
    Supervision begun =
        acceptedValue(
            request,
            FleetAnswers.await(
                services(request).supervisor().start(order, Caller.of(request).name())));
    send(request, response, HttpServletResponse.SC_CREATED, begun);
  }

  public static void stop(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    FloorFilesResource.floorOfPath(request);
    Supervision stopped =
        acceptedValue(
            request,
            FleetAnswers.await(
                services(request)
                    .supervisor()
                    .stop(RequestPath.parameter(request, "floor"), Caller.of(request).name())));
    send(request, response, 200, stopped);
  }

  private static SupervisionOrder read(JsonFields fields, String floor) {
    Texts texts = fields.texts();
    String supervisor =
        fields.rules().robotName(fields.path("supervisor"), fields.text("supervisor"));
    List<String> workers =
        fields.rules().robotNames(fields.path("workers"), fields.choices("workers"));
    if (workers.isEmpty()) {
      fields.errors().add(fields.path("workers"), texts.get("error.supervision.workers"));
    }
    boolean sequential = fields.flag("sequential");
    Map<Integer, Vec2> targets = new TreeMap<>();
    for (JsonFields box : fields.objects("boxes", SupervisionOrder.MAX_BOXES)) {
      Double number = box.number("box");
      Vec2 target = box.point("target");
      box.refuseUnknown();
      if (number == null
          || number != Math.rint(number)
          || !(number >= 1 && number <= Integer.MAX_VALUE)
          || targets.put(number.intValue(), target) != null) {
        fields.errors().add(box.path("box"), texts.get("error.supervision.box"));
      }
    }
    if (targets.isEmpty()) {
      fields.errors().add(fields.path("boxes"), texts.get("error.supervision.boxes"));
    }
    fields.refuseUnknown();
    return new SupervisionOrder(floor, supervisor, workers, !sequential, targets);
  }

  private static void send(
      HttpServletRequest request, HttpServletResponse response, int status, Supervision supervision)
      throws IOException {
    Supervisor supervisor = services(request).supervisor();
    String needs =
        supervisor
            .warning(supervision.floor())
            .map((Sentence need) -> Texts.of(request).text(need))
            .orElse(null);
    Json.send(request, response, status, SupervisionJson.of(supervision, needs));
  }
}
