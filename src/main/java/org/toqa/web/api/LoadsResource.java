package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.LoadView;
import org.toqa.mission.TaskPlace;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.web.Loads;

/** The loads that the fleet knows of, and where each is. */
public final class LoadsResource extends ApiHandler {

  /**
   * A load on the wire.
   *
   * @param weight kilograms
   * @param place null while robots have it
   * @param robot the first of those that have it
   * @param left whether its task has ended and left it on the floor
   */
  private record LoadJson(
      long id,
      String name,
      String floor,
      double weight,
      @Nullable LoadSize size,
      TaskJson.@Nullable PlaceJson place,
      @Nullable String robot,
      List<String> robots,
      long task,
      boolean left,
      @Nullable Long fetchedBy,
      Instant since) {
    static LoadJson of(LoadView load) {
      TaskPlace place = load.place();
      return new LoadJson(
          load.id(),
          load.name(),
          load.floor(),
          load.weight(),
          load.size(),
          place == null ? null : TaskJson.PlaceJson.of(place),
          load.robots().stream().findFirst().orElse(null),
          load.robots(),
          load.task(),
          load.isLeft(),
          load.fetchedBy(),
          load.load().since());
    }
  }

  public static void list(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    List<LoadView> loads =
        wantedFloor(request).filter(new Loads(services(request)).all(), LoadView::floor);
    Json.send(request, response, 200, loads.stream().map(LoadJson::of).toList());
  }
}
