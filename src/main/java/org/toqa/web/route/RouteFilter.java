package org.toqa.web.route;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpFilter;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.toqa.accounts.Session;
import org.toqa.web.ErrorResponse;
import org.toqa.web.RequestPath;
import org.toqa.web.Services;
import org.toqa.web.access.Caller;
import org.toqa.web.access.CsrfToken;
import org.toqa.web.access.Permission;

/**
 * Stands before everything and lets through who may pass, by the list of {@link Routes}.
 *
 * <ol>
 *   <li>No door there: 404. Not with that method: 405.
 *   <li>No manager yet: everything but the first start is closed.
 *   <li>A stranger where users go: to the login, or 401. A clerk where managers go: 403.
 *   <li>A write without the session's token: 403.
 * </ol>
 */
public final class RouteFilter extends HttpFilter {

  @Override
  protected void doFilter(
      HttpServletRequest request, HttpServletResponse response, FilterChain chain)
      throws IOException, ServletException {
    String path = RequestPath.of(request);
    Optional<Routes.Match> match = Routes.find(path);
    if (match.isEmpty()) {
      ErrorResponse.sendText(request, response, 404, "problem.noSuchPage");
      return;
    }
    Optional<Route> route = match.get().route(request.getMethod());
    if (route.isEmpty()) {
      response.setHeader("Allow", match.get().allowedMethods());
      ErrorResponse.sendText(
          request, response, 405, "problem.method", match.get().allowedMethods());
      return;
    }
    RequestPath.storeParameters(request, match.get().parameters());
    if (checkPermission(route.get(), path, request, response)) {
      chain.doFilter(request, response);
    }
  }

  private static boolean checkPermission(
      Route route, String path, HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    if (route.permission() == Permission.PUBLIC) {
      return checkCsrf(route, request, response);
    }
    if (!Services.of(request.getServletContext()).accounts().hasManager()) {
      if (route.isApi()) {
        ErrorResponse.sendText(request, response, 503, "problem.noManager");
      } else {
        response.sendRedirect(
            request.getContextPath() + "/first-start", HttpServletResponse.SC_SEE_OTHER);
      }
      return false;
    }
    Optional<Caller> caller = Caller.find(request);
    boolean needsCaller =
        route.permission() == Permission.SIGNED_IN || route.permission() == Permission.MANAGER;
    if (needsCaller && caller.isEmpty()) {
      requestLogin(route, path, request, response);
      return false;
    }
    if (route.permission() == Permission.MANAGER && !caller.orElseThrow().isManager()) {
      ErrorResponse.sendText(request, response, 403, "problem.managersOnly");
      return false;
    }
    return checkCsrf(route, request, response);
  }

  private static boolean checkCsrf(
      Route route, HttpServletRequest request, HttpServletResponse response) throws IOException {
    if (route.method().equals("GET") || hasValidCsrfToken(route, request)) {
      return true;
    }
    ErrorResponse.sendText(
        request, response, 403, route.isApi() ? "problem.csrfHeader" : "problem.csrfForm");
    return false;
  }

  private static boolean hasValidCsrfToken(Route route, HttpServletRequest request) {
    if (!route.isApi()) {
      return CsrfToken.isValid(request, request.getParameter(CsrfToken.FIELD));
    }
    boolean bySession =
        Caller.find(request)
            .filter(caller -> caller.session().kind() == Session.Kind.BROWSER)
            .isPresent();
    return route.permission() == Permission.ANONYMOUS
        || !bySession
        || CsrfToken.isValid(request, request.getHeader(CsrfToken.HEADER));
  }

  private static void requestLogin(
      Route route, String path, HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    if (route.isApi()) {
      response.setHeader("WWW-Authenticate", "Bearer");
      ErrorResponse.sendText(request, response, 401, "problem.login");
    } else {
      String next =
          route.method().equals("GET")
              ? "?next=" + URLEncoder.encode(path, StandardCharsets.UTF_8)
              : "";
      response.sendRedirect(
          request.getContextPath() + "/" + next, HttpServletResponse.SC_SEE_OTHER);
    }
  }
}
