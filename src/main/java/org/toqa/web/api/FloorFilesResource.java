package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.toqa.grid.FloorDrawing;
import org.toqa.grid.FloorMap;
import org.toqa.grid.FloorWriter;
import org.toqa.grid.MapFormatException;
import org.toqa.grid.MapLimits;
import org.toqa.text.CleanText;
import org.toqa.web.RequestPath;
import org.toqa.web.Texts;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.FloorFiles;
import org.toqa.wording.Phrase;

/** Floors as files of other programs, in and out. */
public final class FloorFilesResource extends ApiHandler {
  /** What a file of each media type is called where nobody has said it. */
  private static final Map<String, String> FILES =
      Map.of(
          "application/zip", "map.zip",
          "image/png", "picture.png",
          "text/plain", "floor.map");

  public static void export(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    FloorMap floor = floorOfPath(request);
    String format = Optional.ofNullable(request.getParameter("format")).orElse("ros");
    switch (format) {
      case "ros" ->
          send(
              response,
              "application/zip",
              FloorWriter.fileName(floor.name()) + ".zip",
              FloorWriter.mapServerFiles(floor.name(), floor.drawing()).pack());
      case "movingai" ->
          send(
              response,
              "text/plain;charset=UTF-8",
              FloorWriter.fileName(floor.name()) + ".map",
              FloorWriter.movingAi(floor));
      default -> {
        FieldErrors errors = new FieldErrors();
        errors.add("format", Texts.of(request).get("error.floor.format"));
        throwIfAny(errors);
      }
    }
  }

  /** Its name in ASCII for old programs, and as it is (RFC 6266). */
  private static void send(
      HttpServletResponse response, String mediaType, String fileName, byte[] content)
      throws IOException {
    String encoded = RequestPath.segment(fileName);
    response.setContentType(mediaType);
    response.setHeader(
        "Content-Disposition",
        "attachment; filename=\"%s\"; filename*=UTF-8''%s"
            .formatted(fileName.replaceAll("[^ -~]", "_"), encoded));
    response.setContentLength(content.length);
    response.getOutputStream().write(content);
  }

  static FloorMap floorOfPath(HttpServletRequest request) {
    String name = RequestPath.parameter(request, "floor");
    return services(request).fleet().floors().stream()
        .filter(floor -> floor.name().equals(name))
        .findFirst()
        .orElseThrow(
            () ->
                Problem.of(404, Texts.of(request).text(Phrase.NO_SUCH_FLOOR.with(name)))
                    .exception());
  }

  /** What a file draws; nothing is stored. */
  public static void read(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    String file = file(request);
    FieldErrors errors = new FieldErrors();
    double resolution =
        queryNumber(
            request,
            "resolution",
            FloorFiles.USUAL_RESOLUTION,
            MapLimits.FINEST,
            MapLimits.COARSEST,
            errors);
    double threshold = queryNumber(request, "threshold", FloorFiles.USUAL_THRESHOLD, 0, 1, errors);
    throwIfAny(errors);
    byte[] content = request.getInputStream().readNBytes(FloorFiles.MAX_BYTES + 1);
    if (content.length > FloorFiles.MAX_BYTES) {
      throw Problem.of(413, Texts.of(request).get("problem.bodySize", FloorFiles.MAX_BYTES / 1024))
          .exception();
    }
    Json.send(request, response, 200, DrawingJson.of(read(file, content, resolution, threshold)));
  }

  private static String file(HttpServletRequest request) {
    String given = Optional.ofNullable(request.getContentType()).orElse("");
    String type = given.split(";", 2)[0].strip().toLowerCase(Locale.ROOT);
    String usual =
        Optional.ofNullable(FILES.get(type))
            .orElseThrow(
                () -> Problem.of(415, Texts.of(request).get("problem.notAMap")).exception());
    String ending = usual.substring(usual.lastIndexOf('.'));
    return Optional.ofNullable(request.getParameter("file"))
        .map(CleanText::of)
        .filter(name -> name.toLowerCase(Locale.ROOT).endsWith(ending))
        .orElse(usual);
  }

  private static FloorDrawing read(
      String file, byte[] content, double resolution, double threshold) {
    try {
      return FloorFiles.read(Map.of(file, content), resolution, threshold);
    } catch (MapFormatException e) {
      throw Problem.of(422, String.valueOf(e.getMessage())).exception();
    }
  }

  private static double queryNumber(
      HttpServletRequest request,
      String name,
      double fallback,
      double least,
      double most,
      FieldErrors errors) {
    @Nullable String given = request.getParameter(name);
    if (given == null) {
      return fallback;
    }
    double number = given.matches("[0-9]{1,4}(\\.[0-9]{1,12})?") ? Double.parseDouble(given) : -1;
    if (!(number >= least && number <= most)) {
      errors.add(name, Texts.of(request).get("error.floor.between", name, least, most));
    }
    return number;
  }
}
