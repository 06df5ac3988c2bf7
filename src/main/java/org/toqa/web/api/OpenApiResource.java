package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.io.InputStream;
import java.util.Objects;

/** The API's own description. */
public final class OpenApiResource extends ApiHandler {
  public static void get(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    response.setContentType("application/json");
    try (InputStream document =
        Objects.requireNonNull(OpenApiResource.class.getResourceAsStream("openapi.json"))) {
      document.transferTo(response.getOutputStream());
    }
  }
}
