package org.toqa.web.route;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServlet;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Objects;
import org.toqa.web.Handler;

/** Hands each request to the handler of the route that {@link RouteFilter} has found. */
final class RouterServlet extends HttpServlet {
  private static final String HANDLER = RouterServlet.class.getName();

  static void storeRoute(HttpServletRequest request, Route route) {
    request.setAttribute(HANDLER, route.handler());
  }

  @Override
  protected void service(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    ((Handler) Objects.requireNonNull(request.getAttribute(HANDLER))).handle(request, response);
  }
}
