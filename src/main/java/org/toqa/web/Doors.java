package org.toqa.web;

import static org.toqa.web.Right.ANYBODY;
import static org.toqa.web.Right.MANAGER;
import static org.toqa.web.Right.STRANGER;
import static org.toqa.web.Right.USER;

import jakarta.servlet.ServletRequest;
import jakarta.servlet.http.HttpServletRequest;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/** Every door of the server and who may pass it. What is not in this list is closed. */
public final class Doors {
  private static final String PARAMETERS = Doors.class.getName();
  private static final String NUMBER = "[1-9][0-9]{0,17}";

  /** A path with a fixed segment stands before one that would also take it as a parameter. */
  private static final List<Door> ALL =
      List.of(
          new Door("GET", "/assets/*", ANYBODY),
          new Door("GET", "/language/{language}", ANYBODY),
          new Door("GET", "/first-start", ANYBODY),
          new Door("POST", "/first-start", ANYBODY),
          new Door("GET", "/", STRANGER),
          new Door("POST", "/", STRANGER),
          new Door("POST", "/logout", USER),
          new Door("GET", "/forgotten", STRANGER),
          new Door("POST", "/forgotten", STRANGER),
          new Door("GET", "/reset", STRANGER),
          new Door("POST", "/reset", STRANGER),
          new Door("GET", "/map", USER),
          new Door("GET", "/tasks", USER),
          new Door("GET", "/tasks/new", USER),
          new Door("POST", "/tasks/new", USER),
          new Door("GET", "/tasks/import", USER),
          new Door("POST", "/tasks/import", USER),
          new Door("GET", "/tasks/{id}", USER),
          new Door("POST", "/tasks/{id}/cancel", USER),
          new Door("POST", "/tasks/{id}/hold", USER),
          new Door("POST", "/tasks/{id}/resume", USER),
          new Door("POST", "/tasks/{id}/priority", USER),
          new Door("POST", "/tasks/{id}/answer", USER),
          new Door("GET", "/schedules", USER),
          new Door("POST", "/schedules/{id}/pause", USER),
          new Door("POST", "/schedules/{id}/resume", USER),
          new Door("POST", "/schedules/{id}/delete", USER),
          new Door("GET", "/robots", USER),
          new Door("POST", "/robots", MANAGER),
          new Door("GET", "/robots/{name}", USER),
          new Door("POST", "/robots/{name}/locate", MANAGER),
          new Door("POST", "/robots/{name}/out-of-service", MANAGER),
          new Door("POST", "/robots/{name}/in-service", MANAGER),
          new Door("POST", "/robots/{name}/hold", MANAGER),
          new Door("POST", "/robots/{name}/resume", MANAGER),
          new Door("POST", "/robots/{name}/home", MANAGER),
          new Door("POST", "/robots/{name}/pair", MANAGER),
          new Door("POST", "/robots/{name}/change", MANAGER),
          new Door("POST", "/robots/{name}/remove", MANAGER),
          new Door("POST", "/fleet/pause", USER),
          new Door("POST", "/fleet/resume", MANAGER),
          new Door("POST", "/floors/{floor}/hold", MANAGER),
          new Door("POST", "/floors/{floor}/resume", MANAGER),
          new Door("GET", "/users", USER),
          new Door("POST", "/users", MANAGER),
          new Door("GET", "/users/{id}", USER),
          new Door("POST", "/users/{id}/change", MANAGER),
          new Door("POST", "/users/{id}/password", USER),
          new Door("POST", "/users/{id}/email", USER),
          new Door("POST", "/users/{id}/tokens", USER),
          new Door("POST", "/users/{id}/sessions/{session}/end", USER),
          new Door("POST", "/users/{id}/reset-link", MANAGER),
          new Door("POST", "/users/{id}/delete", MANAGER),
          new Door("GET", "/statistics", USER),
          new Door("GET", "/history", USER),
          new Door("GET", "/api", USER),
          new Door("GET", "/api/v1/health", ANYBODY),
          new Door("POST", "/api/v1/session", STRANGER),
          new Door("DELETE", "/api/v1/session", USER),
          new Door("POST", "/api/v1/forgotten-password", STRANGER),
          new Door("POST", "/api/v1/reset-password", STRANGER),
          new Door("GET", "/api/v1/openapi.json", USER),
          new Door("GET", "/api/v1/metrics", USER),
          new Door("GET", "/api/v1/map", USER),
          new Door("GET", "/api/v1/events", USER),
          new Door("GET", "/api/v1/tasks", USER),
          new Door("POST", "/api/v1/tasks", USER),
          new Door("POST", "/api/v1/tasks/preview", USER),
          new Door("POST", "/api/v1/tasks/import", USER),
          new Door("GET", "/api/v1/tasks/import/example.csv", USER),
          new Door("GET", "/api/v1/tasks/{id}", USER),
          new Door("POST", "/api/v1/tasks/{id}/cancel", USER),
          new Door("POST", "/api/v1/tasks/{id}/hold", USER),
          new Door("POST", "/api/v1/tasks/{id}/resume", USER),
          new Door("POST", "/api/v1/tasks/{id}/priority", USER),
          new Door("POST", "/api/v1/tasks/{id}/answer", USER),
          new Door("GET", "/api/v1/schedules", USER),
          new Door("POST", "/api/v1/schedules", USER),
          new Door("GET", "/api/v1/schedules/{id}", USER),
          new Door("DELETE", "/api/v1/schedules/{id}", USER),
          new Door("POST", "/api/v1/schedules/{id}/pause", USER),
          new Door("POST", "/api/v1/schedules/{id}/resume", USER),
          new Door("GET", "/api/v1/robots", USER),
          new Door("POST", "/api/v1/robots", MANAGER),
          new Door("GET", "/api/v1/robots/{name}", USER),
          new Door("PUT", "/api/v1/robots/{name}", MANAGER),
          new Door("DELETE", "/api/v1/robots/{name}", MANAGER),
          new Door("POST", "/api/v1/robots/{name}/locate", MANAGER),
          new Door("POST", "/api/v1/robots/{name}/out-of-service", MANAGER),
          new Door("POST", "/api/v1/robots/{name}/in-service", MANAGER),
          new Door("POST", "/api/v1/robots/{name}/hold", MANAGER),
          new Door("POST", "/api/v1/robots/{name}/resume", MANAGER),
          new Door("POST", "/api/v1/robots/{name}/home", MANAGER),
          new Door("POST", "/api/v1/robots/{name}/pair", MANAGER),
          new Door("GET", "/api/v1/users", USER),
          new Door("POST", "/api/v1/users", MANAGER),
          new Door("GET", "/api/v1/users/{id}", USER),
          new Door("PUT", "/api/v1/users/{id}", MANAGER),
          new Door("DELETE", "/api/v1/users/{id}", MANAGER),
          new Door("POST", "/api/v1/users/{id}/password", USER),
          new Door("POST", "/api/v1/users/{id}/email", USER),
          new Door("GET", "/api/v1/users/{id}/sessions", USER),
          new Door("DELETE", "/api/v1/users/{id}/sessions/{session}", USER),
          new Door("POST", "/api/v1/users/{id}/tokens", USER),
          new Door("POST", "/api/v1/users/{id}/reset-link", MANAGER),
          new Door("GET", "/api/v1/tracks", USER),
          new Door("GET", "/api/v1/tracks/{name}", USER),
          new Door("GET", "/api/v1/history", USER),
          new Door("GET", "/api/v1/statistics", USER),
          new Door("GET", "/api/v1/statistics/series.csv", USER),
          new Door("GET", "/api/v1/statistics/robots.csv", USER),
          new Door("GET", "/api/v1/fleet", USER),
          new Door("POST", "/api/v1/fleet/pause", USER),
          new Door("POST", "/api/v1/fleet/resume", MANAGER),
          new Door("POST", "/api/v1/floors/{floor}/hold", MANAGER),
          new Door("POST", "/api/v1/floors/{floor}/resume", MANAGER));

  private Doors() {}

  /**
   * What is found at a path.
   *
   * @param doors one for each method that is answered there
   * @param parameters what stands in the path for each segment in braces
   */
  public record Place(List<Door> doors, Map<String, String> parameters) {

    /** The door for that method; HEAD goes where GET goes. */
    public Optional<Door> door(String method) {
      String wanted = method.equals("HEAD") ? "GET" : method;
      return doors.stream().filter(door -> door.method().equals(wanted)).findFirst();
    }

    /** The methods that are answered here, as the header Allow names them. */
    public String allow() {
      List<String> methods = new ArrayList<>();
      for (Door door : doors) {
        methods.add(door.method());
        if (door.method().equals("GET")) {
          methods.add("HEAD");
        }
      }
      return String.join(", ", methods);
    }
  }

  public static List<Door> all() {
    return ALL;
  }

  public static Optional<Place> at(String path) {
    return ALL.stream()
        .filter(door -> door.match(path).isPresent())
        .findFirst()
        .map(
            first ->
                new Place(
                    ALL.stream().filter(door -> door.path().equals(first.path())).toList(),
                    first.match(path).orElseThrow()));
  }

  public static void keepParameters(ServletRequest request, Place place) {
    request.setAttribute(PARAMETERS, place.parameters());
  }

  /** The path that the request asks for, from the application's root. */
  public static String pathOf(HttpServletRequest request) {
    String rest = request.getPathInfo();
    return rest == null ? request.getServletPath() : request.getServletPath() + rest;
  }

  /** The part of the request's path that stands for {@code {name}}. */
  public static String parameter(ServletRequest request, String name) {
    Map<?, ?> parameters = (Map<?, ?>) request.getAttribute(PARAMETERS);
    return (String) Objects.requireNonNull(parameters.get(name), name);
  }

  public static boolean hasParameter(ServletRequest request, String name) {
    return ((Map<?, ?>) request.getAttribute(PARAMETERS)).containsKey(name);
  }

  /** The number in the path that stands for {@code {name}}, or 0, which nothing has. */
  public static long number(ServletRequest request, String name) {
    String given = parameter(request, name);
    return given.matches(NUMBER) ? Long.parseLong(given) : 0;
  }

  /** Where the browser found these pages, without a slash at its end. */
  public static String site(HttpServletRequest request) {
    String url = request.getRequestURL().toString();
    return url.substring(0, url.length() - request.getRequestURI().length())
        + request.getContextPath();
  }

  /** What the request asks of the thing in its path: the path's last segment. */
  public static String lastSegment(HttpServletRequest request) {
    String path = Objects.requireNonNull(request.getPathInfo());
    return path.substring(path.lastIndexOf('/') + 1);
  }
}
