package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.Answer;
import org.toqa.fleet.Hold;
import org.toqa.grid.FloorMap;
import org.toqa.web.FleetAnswers;
import org.toqa.web.FloorSummary;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.Fields;
import org.toqa.wording.Phrase;

/** A floor, and commands to it. */
public final class FloorResource extends ApiHandler {

  /** The fields are those of {@link FloorSummary}. */
  private record DrawnFloorJson(
      String name,
      String site,
      FloorSummary.State state,
      int robots,
      int openTasks,
      DrawingJson drawing) {}

  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    FloorMap floor = FloorFilesResource.floorOfPath(request);
    FloorSummary now = FloorSummary.of(floor, services(request));
    Json.send(
        request,
        response,
        200,
        new DrawnFloorJson(
            now.name(),
            now.site(),
            now.state(),
            now.robots(),
            now.openTasks(),
            DrawingJson.of(floor.drawing())));
  }

  public static void remove(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    String floor = RequestPath.parameter(request, "floor");
    acceptedValue(
        request,
        FleetAnswers.await(
            services(request)
                .fleet()
                .floorEditing()
                .removeFloor(floor, Caller.of(request).name())));
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }

  /**
   * @param hold null while its robots may drive
   */
  private record FloorHoldJson(String floor, @Nullable HoldJson hold) {}

  public static void hold(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    String floor = RequestPath.parameter(request, "floor");
    send(
        request,
        response,
        floor,
        services(request).fleet().holdFloor(floor, Caller.of(request).name()));
  }

  public static void resume(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    String floor = RequestPath.parameter(request, "floor");
    send(
        request,
        response,
        floor,
        services(request).fleet().resumeFloor(floor, Caller.of(request).name()));
  }

  /**
   * @param allocator null: that of the configuration
   */
  private record FloorAllocatorJson(String floor, @Nullable String allocator) {}

  public static void allocator(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    String floor = RequestPath.parameter(request, "floor");
    if (services(request).fleet().floors().stream().noneMatch(f -> f.name().equals(floor))) {
      throw Problem.of(404, Texts.of(request).text(Phrase.NO_SUCH_FLOOR.with(floor))).exception();
    }
    Optional<String> allocator = readBody(request, FloorResource::readAllocator);
    Optional<String> chosen =
        acceptedValue(
            request,
            FleetAnswers.await(
                services(request)
                    .fleet()
                    .chooseAllocator(floor, allocator, Caller.of(request).name())));
    Json.send(request, response, 200, new FloorAllocatorJson(floor, chosen.orElse(null)));
  }

  private static Optional<String> readAllocator(Fields fields) {
    Optional<String> allocator = Optional.ofNullable(fields.text("allocator"));
    fields.refuseUnknown();
    return allocator;
  }

  private static void send(
      HttpServletRequest request,
      HttpServletResponse response,
      String floor,
      CompletionStage<Answer<Optional<Hold>>> answer)
      throws IOException {
    Hold hold = acceptedValue(request, FleetAnswers.await(answer)).orElse(null);
    Json.send(request, response, 200, new FloorHoldJson(floor, HoldJson.of(hold)));
  }
}
