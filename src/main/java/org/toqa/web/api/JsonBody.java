package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import java.io.IOException;
import org.toqa.web.Texts;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.JsonFields;
import tools.jackson.core.JacksonException;
import tools.jackson.core.TokenStreamLocation;
import tools.jackson.core.exc.StreamConstraintsException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ObjectNode;

/** The JSON object that a request has as its body. */
final class JsonBody {
  private static final int MAX_BYTES = 64 * 1024;

  private JsonBody() {}

  /**
   * Reads the body.
   *
   * @throws Problem.ProblemException when it is not one JSON object of acceptable size
   */
  static JsonFields read(HttpServletRequest request, FieldErrors errors) throws IOException {
    return read(request, errors, MAX_BYTES);
  }

  /**
   * Reads a body that may be larger than others.
   *
   * @throws Problem.ProblemException when it is not one JSON object of acceptable size
   */
  static JsonFields read(HttpServletRequest request, FieldErrors errors, int maxBytes)
      throws IOException {
    Texts texts = Texts.of(request);
    String mediaType = request.getContentType();
    if (mediaType == null
        || !mediaType.split(";", 2)[0].strip().equalsIgnoreCase("application/json")) {
      throw Problem.of(415, texts.get("problem.mediaType")).exception();
    }
    byte[] body = request.getInputStream().readNBytes(maxBytes + 1);
    if (body.length > maxBytes) {
      throw Problem.of(413, texts.get("problem.bodySize", maxBytes / 1024)).exception();
    }
    if (!(parse(body, texts) instanceof ObjectNode root)) {
      throw Problem.of(400, texts.get("problem.notAnObject")).exception();
    }
    return JsonFields.of(root, texts, errors);
  }

  /** Whether the request has a body at all. */
  static boolean isIn(HttpServletRequest request) {
    return request.getContentLengthLong() != 0
        && (request.getContentLengthLong() > 0 || request.getHeader("Transfer-Encoding") != null);
  }

  private static JsonNode parse(byte[] body, Texts texts) {
    try {
      return Json.MAPPER.readTree(body);
    } catch (StreamConstraintsException e) {
      throw Problem.of(400, texts.get("problem.jsonLimits")).exception();
    } catch (JacksonException e) {
      TokenStreamLocation where = e.getLocation();
      throw Problem.of(400, texts.get("problem.notJson", where.getLineNr(), where.getColumnNr()))
          .exception();
    }
  }
}
