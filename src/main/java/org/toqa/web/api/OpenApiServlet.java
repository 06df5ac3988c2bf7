package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.io.InputStream;
import java.util.Objects;

/** The API's own description. */
public final class OpenApiServlet extends ApiServlet {
  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    response.setContentType("application/json");
    try (InputStream document =
        Objects.requireNonNull(OpenApiServlet.class.getResourceAsStream("openapi.json"))) {
      document.transferTo(response.getOutputStream());
    }
  }
}
