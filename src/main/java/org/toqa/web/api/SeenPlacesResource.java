package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.time.Instant;
import java.util.List;
import org.toqa.fleet.FloorDraft;
import org.toqa.fleet.history.SeenPlaces.Offer;
import org.toqa.geometry.Vec2;
import org.toqa.grid.FloorMap;
import org.toqa.web.RequestPath;
import org.toqa.web.access.Caller;
import org.toqa.web.input.SeenPlaceCommands;

/** What many robots have seen for long on a floor and its map does not show. */
public final class SeenPlacesResource extends ApiHandler {
  /**
   * @param cells the middles of its cells, metres, map frame
   */
  private record OfferJson(
      String id, List<Vec2> cells, List<String> robots, Instant since, Instant last) {
    static OfferJson of(Offer offer) {
      return new OfferJson(offer.id(), offer.cells(), offer.robots(), offer.since(), offer.last());
    }
  }

  public static void list(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    FloorMap floor = FloorFilesResource.floorOfPath(request);
    Json.send(
        request,
        response,
        200,
        services(request).seenPlaces().offers(floor).stream().map(OfferJson::of).toList());
  }

  public static void draw(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    FloorDraft draft =
        acceptedValue(
            request,
            new SeenPlaceCommands(services(request))
                .draw(
                    RequestPath.parameter(request, "floor"),
                    RequestPath.parameter(request, "id"),
                    Caller.of(request).name()));
    Json.send(request, response, 200, DraftRevisionJson.of(draft));
  }

  public static void dismiss(HttpServletRequest request, HttpServletResponse response) {
    acceptedValue(
        request,
        new SeenPlaceCommands(services(request))
            .dismiss(
                RequestPath.parameter(request, "floor"), RequestPath.parameter(request, "id")));
    response.setStatus(HttpServletResponse.SC_NO_CONTENT);
  }
}
