package org.toqa.web.access;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpFilter;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.toqa.store.Session;
import org.toqa.web.Door;
import org.toqa.web.Doors;
import org.toqa.web.Right;
import org.toqa.web.Services;

/**
 * Stands before everything and lets through who may pass, by the list of {@link Doors}.
 *
 * <ol>
 *   <li>No door there: 404. Not with that method: 405.
 *   <li>No manager yet: everything but the first start is closed.
 *   <li>A stranger where users go: to the login, or 401. A clerk where managers go: 403.
 *   <li>A write without the session's token: 403.
 * </ol>
 */
public final class DoorFilter extends HttpFilter {

  @Override
  protected void doFilter(
      HttpServletRequest request, HttpServletResponse response, FilterChain chain)
      throws IOException, ServletException {
    String path = Doors.pathOf(request);
    Optional<Doors.Place> place = Doors.at(path);
    if (place.isEmpty()) {
      Refusal.send(request, response, 404, "problem.noSuchPage");
      return;
    }
    Optional<Door> door = place.get().door(request.getMethod());
    if (door.isEmpty()) {
      response.setHeader("Allow", place.get().allow());
      Refusal.send(request, response, 405, "problem.method", place.get().allow());
      return;
    }
    Doors.keepParameters(request, place.get());
    if (mayPass(door.get(), path, request, response)) {
      chain.doFilter(request, response);
    }
  }

  private static boolean mayPass(
      Door door, String path, HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    if (door.right() == Right.ANYBODY) {
      return isOwnPageOrRead(door, request, response);
    }
    if (!Services.from(request.getServletContext()).accounts().hasManager()) {
      if (door.isApi()) {
        Refusal.send(request, response, 503, "problem.noManager");
      } else {
        response.sendRedirect(
            request.getContextPath() + "/first-start", HttpServletResponse.SC_SEE_OTHER);
      }
      return false;
    }
    Optional<Caller> caller = Caller.ifKnown(request);
    boolean forUsers = door.right() == Right.USER || door.right() == Right.MANAGER;
    if (forUsers && caller.isEmpty()) {
      askToLogIn(door, path, request, response);
      return false;
    }
    if (door.right() == Right.MANAGER && !caller.orElseThrow().isManager()) {
      Refusal.send(request, response, 403, "problem.managersOnly");
      return false;
    }
    return isOwnPageOrRead(door, request, response);
  }

  private static boolean isOwnPageOrRead(
      Door door, HttpServletRequest request, HttpServletResponse response) throws IOException {
    if (door.method().equals("GET") || comesFromOwnPage(door, request)) {
      return true;
    }
    Refusal.send(request, response, 403, door.isApi() ? "problem.csrfHeader" : "problem.csrfForm");
    return false;
  }

  private static boolean comesFromOwnPage(Door door, HttpServletRequest request) {
    if (!door.isApi()) {
      return CsrfToken.matches(request, request.getParameter(CsrfToken.FIELD));
    }
    boolean bySession =
        Caller.ifKnown(request)
            .filter(caller -> caller.session().kind() == Session.Kind.BROWSER)
            .isPresent();
    return door.right() == Right.STRANGER
        || !bySession
        || CsrfToken.matches(request, request.getHeader(CsrfToken.HEADER));
  }

  private static void askToLogIn(
      Door door, String path, HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    if (door.isApi()) {
      response.setHeader("WWW-Authenticate", "Bearer");
      Refusal.send(request, response, 401, "problem.login");
    } else {
      String next =
          door.method().equals("GET")
              ? "?next=" + URLEncoder.encode(path, StandardCharsets.UTF_8)
              : "";
      response.sendRedirect(
          request.getContextPath() + "/" + next, HttpServletResponse.SC_SEE_OTHER);
    }
  }
}
