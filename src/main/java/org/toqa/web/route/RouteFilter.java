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
import org.toqa.accounts.Scope;
import org.toqa.accounts.Session;
import org.toqa.web.ErrorResponse;
import org.toqa.web.RequestPath;
import org.toqa.web.Services;
import org.toqa.web.Sites;
import org.toqa.web.access.Caller;
import org.toqa.web.access.CsrfToken;
import org.toqa.web.access.Permission;
import org.toqa.web.access.VisitedSite;

/**
 * Finds the route of every request in the table of {@link Routes}, and refuses what it does not
 * permit.
 *
 * <ol>
 *   <li>No route at that path: 404. None with that method: 405; a form's address that is read leads
 *       to the form's page.
 *   <li>No manager yet: to the first start, or 503.
 *   <li>An administrator who looks at another site: from here on the request concerns that site,
 *       and he may read there, and help with its users. Nobody else may look there: 403.
 *   <li>A caller who is not signed in, where one must be: to the login, or 401. One who has not the
 *       route's permission, or whose token has not the route's scope: 403.
 *   <li>A write without the session's CSRF token: 403.
 * </ol>
 */
public final class RouteFilter extends HttpFilter {
  /** The name under which views find that of the other site that is looked at. */
  private static final String VISITED = "visitedSite";

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
      if (isRead(request) && !RequestPath.isApi(path)) {
        redirectToPage(path, request, response);
        return;
      }
      response.setHeader("Allow", match.get().allowedMethods());
      ErrorResponse.sendText(
          request, response, 405, "problem.method", match.get().allowedMethods());
      return;
    }
    RequestPath.storeParameters(request, match.get().parameters());
    RouterServlet.storeRoute(request, route.get());
    if (checkSite(route.get(), request, response)
        && checkPermission(route.get(), path, request, response)) {
      chain.doFilter(request, response);
    }
  }

  private static boolean isRead(HttpServletRequest request) {
    return request.getMethod().equals("GET") || request.getMethod().equals("HEAD");
  }

  /** Who opens the address of a form, which was shown again there, is sent to the form's page. */
  private static void redirectToPage(
      String path, HttpServletRequest request, HttpServletResponse response) throws IOException {
    String page = path;
    while (!page.isEmpty() && !Routes.isPage(page)) {
      page = page.substring(0, page.lastIndexOf('/'));
    }
    response.sendRedirect(
        request.getContextPath() + (page.isEmpty() ? "/" : page), HttpServletResponse.SC_SEE_OTHER);
  }

  /** Whether the request may concern the site that it names; from here on it does. */
  private static boolean checkSite(
      Route route, HttpServletRequest request, HttpServletResponse response) throws IOException {
    Optional<Caller> caller = Caller.find(request);
    Optional<String> named = VisitedSite.named(request);
    if (caller.isEmpty()
        || route.has(Route.Option.OWN_SITE)
        || route.permission() == Permission.ANONYMOUS) {
      return true;
    }
    if (!caller.get().isAdministrator()) {
      if (named.isPresent() && !named.get().equalsIgnoreCase(caller.get().site().name())) {
        ErrorResponse.sendText(request, response, 403, "problem.administratorsOnly");
        return false;
      }
      return true;
    }
    Sites sites = Sites.of(request.getServletContext());
    Optional<Services> visited =
        named.isPresent()
            ? sites.find(named.get())
            : VisitedSite.kept(request).flatMap(sites::find);
    if (named.isPresent() && visited.isEmpty()) {
      ErrorResponse.sendText(request, response, 404, "problem.noSuchSite");
      return false;
    }
    if (visited.isEmpty() || visited.get().site().equals(caller.get().site())) {
      return true;
    }
    if (!isRead(request) && !route.has(Route.Option.EVERY_SITE)) {
      ErrorResponse.sendText(
          request, response, 403, "problem.visitor", visited.get().site().name());
      return false;
    }
    visited.get().storeIn(request);
    request.setAttribute(VISITED, visited.get().site().name());
    caller.get().asVisitor().storeIn(request);
    return true;
  }

  private static boolean checkPermission(
      Route route, String path, HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    if (route.has(Route.Option.BEFORE_FIRST_START)) {
      return checkCsrf(route, request, response);
    }
    if (!Services.of(request).accounts().hasManager()) {
      if (route.isApi()) {
        ErrorResponse.sendText(request, response, 503, "problem.noManager");
      } else {
        response.sendRedirect(
            request.getContextPath() + "/first-start", HttpServletResponse.SC_SEE_OTHER);
      }
      return false;
    }
    if (route.permission() != Permission.ANONYMOUS) {
      Optional<Caller> caller = Caller.find(request);
      if (caller.isEmpty()) {
        requestLogin(route, path, request, response);
        return false;
      }
      if (!caller.get().has(route.permission())) {
        ErrorResponse.sendText(request, response, 403, route.permission().refusalKey());
        return false;
      }
      Session session = caller.get().session();
      if (!isOpenFor(session, route)) {
        Scope scope = route.scope();
        ErrorResponse.sendText(
            request,
            response,
            403,
            scope == null ? "problem.pagesInBrowser" : "problem.scope",
            scope == null ? "" : scope.word());
        return false;
      }
    }
    return checkCsrf(route, request, response);
  }

  /** A token opens what it was made for, a login of a program everything but forms. */
  private static boolean isOpenFor(Session session, Route route) {
    return switch (session.kind()) {
      case BROWSER -> true;
      case API -> route.isApi() || route.method().equals("GET");
      case TOKEN ->
          route.scope() == null ? route.isApi() : session.scopes().contains(route.scope());
    };
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
