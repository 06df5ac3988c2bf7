package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import jakarta.servlet.http.Part;
import java.io.IOException;
import java.io.InputStream;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.toqa.fleet.Answer;
import org.toqa.fleet.Fleet;
import org.toqa.fleet.history.SeenPlaces.Offer;
import org.toqa.grid.FloorMap;
import org.toqa.grid.MapFormatException;
import org.toqa.grid.MapLimits;
import org.toqa.web.FleetAnswers;
import org.toqa.web.FloorSummary;
import org.toqa.web.RequestPath;
import org.toqa.web.Services;
import org.toqa.web.Texts;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.Fields;
import org.toqa.web.input.FloorFiles;
import org.toqa.web.input.FloorOrder;
import org.toqa.web.input.FloorOrderReader;
import org.toqa.web.input.SeenPlaceCommands;

/** All floors; managers add some and delete some. */
public final class FloorsPage extends PageHandler {
  private static final String FILE = "file";

  /**
   * What robots saw, as the page shows it.
   *
   * @param x of its middle, metres
   * @param y of its middle, metres
   */
  public record Seen(String id, double x, double y, String robots, Instant since, Instant last) {
    static Seen of(Offer offer) {
      return new Seen(
          offer.id(),
          offer.centre().x(),
          offer.centre().y(),
          String.join(", ", offer.robots()),
          offer.since(),
          offer.last());
    }
  }

  /**
   * A floor as the page shows it.
   *
   * @param width metres
   * @param height metres
   */
  public record Entry(FloorSummary summary, double width, double height, List<Seen> seen) {
    static Entry of(FloorMap floor, Services services) {
      double resolution = floor.grid().resolution();
      return new Entry(
          FloorSummary.of(floor, services),
          floor.grid().width() * resolution,
          floor.grid().height() * resolution,
          services.seenPlaces().offers(floor).stream().map(Seen::of).toList());
    }

    /** The floor's name in addresses. */
    public String segment() {
      return RequestPath.segment(summary.name());
    }
  }

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    addEntries(request);
    show(request, response, "floors");
  }

  private static void addEntries(HttpServletRequest request) {
    Fleet fleet = services(request).fleet();
    request.setAttribute(
        "entries",
        fleet.floors().stream().map(floor -> Entry.of(floor, services(request))).toList());
  }

  public static void add(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    Map<String, byte[]> files = files(request, errors);
    Optional<FloorMap> added =
        errors.isEmpty()
            ? readForm(request, errors, fields -> readOrder(fields, files))
                .flatMap(order -> add(order, request, errors))
            : Optional.empty();
    if (added.isPresent()) {
      redirect(request, response, "/floors?done=added");
    } else {
      addEntries(request);
      showAgain(request, response, "floors", errors);
    }
  }

  private static Optional<FloorMap> add(
      FloorOrder order, HttpServletRequest request, FieldErrors errors) {
    return acceptedValue(
        request,
        FleetAnswers.await(
            services(request)
                .fleet()
                .floorEditing()
                .addFloor(order.name(), order.drawing(), Caller.of(request).name())),
        errors);
  }

  private static FloorOrder readOrder(Fields fields, Map<String, byte[]> files) {
    if (files.isEmpty()) {
      return FloorOrderReader.readEmpty(fields);
    }
    String name = FloorOrderReader.readName(fields);
    Double given = fields.number("resolution");
    double resolution = given == null ? FloorFiles.USUAL_RESOLUTION : given;
    if (!(resolution >= MapLimits.FINEST && resolution <= MapLimits.COARSEST)) {
      fields.errors().add("resolution", fields.texts().get("error.drawing.resolution"));
    }
    if (fields.errors().isEmpty()) {
      try {
        return new FloorOrder(name, FloorFiles.read(files, resolution, FloorFiles.USUAL_THRESHOLD));
      } catch (MapFormatException e) {
        fields.errors().add(FILE, String.valueOf(e.getMessage()));
      }
    }
    return FloorOrderReader.readEmpty(fields);
  }

  /** Those that were chosen, by their names. */
  private static Map<String, byte[]> files(HttpServletRequest request, FieldErrors errors)
      throws ServletException, IOException {
    String mediaType = request.getContentType();
    if (mediaType == null || !mediaType.startsWith("multipart/form-data")) {
      return Map.of();
    }
    Map<String, byte[]> files = new LinkedHashMap<>();
    int left = FloorFiles.MAX_BYTES;
    for (Part part : request.getParts()) {
      String name = part.getSubmittedFileName();
      if (part.getName().equals(FILE) && name != null && !name.isBlank()) {
        try (InputStream content = part.getInputStream()) {
          byte[] bytes = content.readNBytes(left + 1);
          left -= bytes.length;
          files.put(
              name.substring(Math.max(name.lastIndexOf('/'), name.lastIndexOf('\\')) + 1), bytes);
        }
      }
      if (left < 0) {
        errors.add(
            FILE, Texts.of(request).get("error.floor.fileLarge", FloorFiles.MAX_BYTES / 1024));
        return Map.of();
      }
    }
    return files;
  }

  /** Draws what robots saw into the draft, and shows it there. */
  public static void drawSeen(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    String floor = RequestPath.parameter(request, "floor");
    showUnlessDone(
        new SeenPlaceCommands(services(request))
            .draw(floor, RequestPath.parameter(request, "id"), Caller.of(request).name()),
        "/floors/" + RequestPath.segment(floor) + "/edit",
        request,
        response);
  }

  public static void dismissSeen(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    showUnlessDone(
        new SeenPlaceCommands(services(request))
            .dismiss(RequestPath.parameter(request, "floor"), RequestPath.parameter(request, "id")),
        "/floors?done=dismissed",
        request,
        response);
  }

  /**
   * @param next where the browser goes when it is done
   */
  private static void showUnlessDone(
      Answer<?> answer, String next, HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    if (answer instanceof Answer.Unknown<?>) {
      sendNotFound(request, response, "floors.seen.gone");
      return;
    }
    FieldErrors errors = new FieldErrors();
    if (acceptedValue(request, answer, errors).isPresent()) {
      redirect(request, response, next);
      return;
    }
    addEntries(request);
    request.setAttribute("refusals", List.copyOf(errors.sentences().values()));
    showConflict(request, response, "floors", new FieldErrors());
  }

  public static void remove(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    String floor = RequestPath.parameter(request, "floor");
    Answer<String> answer =
        FleetAnswers.await(
            services(request).fleet().floorEditing().removeFloor(floor, Caller.of(request).name()));
    if (answer instanceof Answer.Unknown<String>) {
      sendNotFound(request, response, "floors.gone");
      return;
    }
    FieldErrors errors = new FieldErrors();
    if (acceptedValue(request, answer, errors).isPresent()) {
      redirect(request, response, "/floors?done=removed");
      return;
    }
    addEntries(request);
    request.setAttribute("refusals", List.copyOf(errors.sentences().values()));
    showConflict(request, response, "floors", new FieldErrors());
  }
}
