package org.toqa.web.api;

import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import tools.jackson.core.StreamReadFeature;
import tools.jackson.databind.json.JsonMapper;

/** Reads and writes JSON, strictly. */
final class Json {
  static final JsonMapper MAPPER =
      JsonMapper.builder().enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION).build();

  private Json() {}

  static void send(HttpServletResponse response, int status, Object body) throws IOException {
    send(response, status, "application/json", body);
  }

  static void send(HttpServletResponse response, int status, String mediaType, Object body)
      throws IOException {
    byte[] bytes = MAPPER.writeValueAsBytes(body);
    response.setStatus(status);
    response.setContentType(mediaType);
    response.setContentLength(bytes.length);
    response.getOutputStream().write(bytes);
  }
}
