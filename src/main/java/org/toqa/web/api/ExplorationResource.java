package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.exploration.ExplorationPicture;
import org.toqa.exploration.SeenGround;
import org.toqa.fleet.exploration.Exploration;
import org.toqa.geometry.Vec2;
import org.toqa.web.FleetAnswers;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.ExplorationReader;
import org.toqa.web.input.ExplorationReader.GroundAndOrder;

/** The exploration of a floor: started, watched, stopped, and made its draft. */
public final class ExplorationResource extends ApiHandler {

  /**
   * @param share of the way that is done, by what is known now
   * @param area square metres that were seen
   * @param positions of the robots that still drive
   * @param track of the virtual leader
   */
  private record ExplorationJson(
      String floor,
      String ground,
      int robots,
      Vec2 start,
      Vec2 target,
      long seed,
      String user,
      Exploration.State state,
      Exploration.Draft draft,
      Instant startedAt,
      @Nullable Instant endedAt,
      double share,
      double seconds,
      double driven,
      double remaining,
      double area,
      List<PositionJson> positions,
      List<Vec2> track,
      SeenJson seen) {

    static ExplorationJson of(Exploration exploration) {
      ExplorationPicture picture = exploration.picture();
      return new ExplorationJson(
          exploration.floor(),
          exploration.ground(),
          exploration.order().robots(),
          exploration.order().start(),
          exploration.order().target(),
          exploration.order().seed(),
          exploration.user(),
          exploration.state(),
          exploration.draft(),
          exploration.startedAt(),
          exploration.endedAt(),
          picture.share(),
          rounded(picture.seconds()),
          rounded(picture.driven()),
          rounded(picture.remaining()),
          rounded(picture.seen().area()),
          picture.robots().stream()
              .map(
                  robot ->
                      new PositionJson(
                          rounded(robot.position().x()),
                          rounded(robot.position().y()),
                          robot.sees()))
              .toList(),
          picture.track().stream().map(at -> new Vec2(rounded(at.x()), rounded(at.y()))).toList(),
          SeenJson.of(picture.seen()));
    }

    private static double rounded(double value) {
      return Math.round(value * 1000) / 1000.0;
    }
  }

  /**
   * @param lidar whether it is on
   */
  private record PositionJson(double x, double y, boolean lidar) {}

  /** Cells as in a map: the first one, how many, and so on by turns. */
  private record SeenJson(
      int width,
      int height,
      double resolution,
      Vec2 origin,
      List<Integer> free,
      List<Integer> occupied) {
    static SeenJson of(SeenGround seen) {
      return new SeenJson(
          seen.width(),
          seen.height(),
          seen.resolution(),
          seen.origin(),
          seen.free().runs(),
          seen.occupied().runs());
    }
  }

  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    String floor = FloorFilesResource.floorOfPath(request).name();
    Exploration exploration =
        services(request)
            .explorer()
            .latest(floor)
            .orElseThrow(
                () ->
                    Problem.of(404, Texts.of(request).get("problem.exploration.none", floor))
                        .exception());
    send(request, response, 200, exploration);
  }

  public static void start(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    String floor = FloorFilesResource.floorOfPath(request).name();
    GroundAndOrder order = readBody(request, ExplorationReader::readJson);
    Exploration begun =
        acceptedValue(
            request,
            services(request)
                .explorer()
                .start(floor, order.ground(), order.order(), Caller.of(request).name()));
    send(request, response, HttpServletResponse.SC_CREATED, begun);
  }

  public static void stop(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    String floor = FloorFilesResource.floorOfPath(request).name();
    Exploration stopped =
        acceptedValue(
            request,
            FleetAnswers.await(
                services(request).explorer().stop(floor, Caller.of(request).name())));
    send(request, response, 200, stopped);
  }

  public static void draw(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    String floor = FloorFilesResource.floorOfPath(request).name();
    Exploration drawn =
        acceptedValue(
            request,
            FleetAnswers.await(
                services(request).explorer().draw(floor, Caller.of(request).name())));
    send(request, response, 200, drawn);
  }

  private static void send(
      HttpServletRequest request, HttpServletResponse response, int status, Exploration exploration)
      throws IOException {
    Json.send(request, response, status, ExplorationJson.of(exploration));
  }
}
