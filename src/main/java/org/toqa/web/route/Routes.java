package org.toqa.web.route;

import static org.toqa.web.access.Permission.ANONYMOUS;
import static org.toqa.web.access.Permission.MANAGER;
import static org.toqa.web.access.Permission.PUBLIC;
import static org.toqa.web.access.Permission.SIGNED_IN;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Every route of the server and who may use it. What is not in this list is not found. */
public final class Routes {
  /** A path with a fixed segment stands before one that would also take it as a parameter. */
  private static final List<Route> ALL =
      List.of(
          new Route("GET", "/assets/*", PUBLIC),
          new Route("GET", "/language/{language}", PUBLIC),
          new Route("GET", "/first-start", PUBLIC),
          new Route("POST", "/first-start", PUBLIC),
          new Route("GET", "/", ANONYMOUS),
          new Route("POST", "/", ANONYMOUS),
          new Route("POST", "/logout", SIGNED_IN),
          new Route("GET", "/forgotten", ANONYMOUS),
          new Route("POST", "/forgotten", ANONYMOUS),
          new Route("GET", "/reset", ANONYMOUS),
          new Route("POST", "/reset", ANONYMOUS),
          new Route("GET", "/map", SIGNED_IN),
          new Route("GET", "/tasks", SIGNED_IN),
          new Route("GET", "/tasks/new", SIGNED_IN),
          new Route("POST", "/tasks/new", SIGNED_IN),
          new Route("GET", "/tasks/import", SIGNED_IN),
          new Route("POST", "/tasks/import", SIGNED_IN),
          new Route("GET", "/tasks/{id}", SIGNED_IN),
          new Route("POST", "/tasks/{id}/cancel", SIGNED_IN),
          new Route("POST", "/tasks/{id}/hold", SIGNED_IN),
          new Route("POST", "/tasks/{id}/resume", SIGNED_IN),
          new Route("POST", "/tasks/{id}/priority", SIGNED_IN),
          new Route("POST", "/tasks/{id}/answer", SIGNED_IN),
          new Route("GET", "/schedules", SIGNED_IN),
          new Route("POST", "/schedules/{id}/pause", SIGNED_IN),
          new Route("POST", "/schedules/{id}/resume", SIGNED_IN),
          new Route("POST", "/schedules/{id}/delete", SIGNED_IN),
          new Route("GET", "/robots", SIGNED_IN),
          new Route("POST", "/robots", MANAGER),
          new Route("GET", "/robots/{name}", SIGNED_IN),
          new Route("POST", "/robots/{name}/locate", MANAGER),
          new Route("POST", "/robots/{name}/out-of-service", MANAGER),
          new Route("POST", "/robots/{name}/in-service", MANAGER),
          new Route("POST", "/robots/{name}/hold", MANAGER),
          new Route("POST", "/robots/{name}/resume", MANAGER),
          new Route("POST", "/robots/{name}/home", MANAGER),
          new Route("POST", "/robots/{name}/pair", MANAGER),
          new Route("POST", "/robots/{name}/change", MANAGER),
          new Route("POST", "/robots/{name}/remove", MANAGER),
          new Route("POST", "/fleet/pause", SIGNED_IN),
          new Route("POST", "/fleet/resume", MANAGER),
          new Route("POST", "/floors/{floor}/hold", MANAGER),
          new Route("POST", "/floors/{floor}/resume", MANAGER),
          new Route("GET", "/users", SIGNED_IN),
          new Route("POST", "/users", MANAGER),
          new Route("GET", "/users/{id}", SIGNED_IN),
          new Route("POST", "/users/{id}/change", MANAGER),
          new Route("POST", "/users/{id}/password", SIGNED_IN),
          new Route("POST", "/users/{id}/email", SIGNED_IN),
          new Route("POST", "/users/{id}/tokens", SIGNED_IN),
          new Route("POST", "/users/{id}/sessions/{session}/end", SIGNED_IN),
          new Route("POST", "/users/{id}/reset-link", MANAGER),
          new Route("POST", "/users/{id}/delete", MANAGER),
          new Route("GET", "/statistics", SIGNED_IN),
          new Route("GET", "/history", SIGNED_IN),
          new Route("GET", "/api", SIGNED_IN),
          new Route("GET", "/api/v1/health", PUBLIC),
          new Route("POST", "/api/v1/session", ANONYMOUS),
          new Route("DELETE", "/api/v1/session", SIGNED_IN),
          new Route("POST", "/api/v1/forgotten-password", ANONYMOUS),
          new Route("POST", "/api/v1/reset-password", ANONYMOUS),
          new Route("GET", "/api/v1/openapi.json", SIGNED_IN),
          new Route("GET", "/api/v1/metrics", SIGNED_IN),
          new Route("GET", "/api/v1/map", SIGNED_IN),
          new Route("GET", "/api/v1/events", SIGNED_IN),
          new Route("GET", "/api/v1/tasks", SIGNED_IN),
          new Route("POST", "/api/v1/tasks", SIGNED_IN),
          new Route("POST", "/api/v1/tasks/preview", SIGNED_IN),
          new Route("POST", "/api/v1/tasks/import", SIGNED_IN),
          new Route("GET", "/api/v1/tasks/import/example.csv", SIGNED_IN),
          new Route("GET", "/api/v1/tasks/{id}", SIGNED_IN),
          new Route("POST", "/api/v1/tasks/{id}/cancel", SIGNED_IN),
          new Route("POST", "/api/v1/tasks/{id}/hold", SIGNED_IN),
          new Route("POST", "/api/v1/tasks/{id}/resume", SIGNED_IN),
          new Route("POST", "/api/v1/tasks/{id}/priority", SIGNED_IN),
          new Route("POST", "/api/v1/tasks/{id}/answer", SIGNED_IN),
          new Route("GET", "/api/v1/schedules", SIGNED_IN),
          new Route("POST", "/api/v1/schedules", SIGNED_IN),
          new Route("GET", "/api/v1/schedules/{id}", SIGNED_IN),
          new Route("DELETE", "/api/v1/schedules/{id}", SIGNED_IN),
          new Route("POST", "/api/v1/schedules/{id}/pause", SIGNED_IN),
          new Route("POST", "/api/v1/schedules/{id}/resume", SIGNED_IN),
          new Route("GET", "/api/v1/robots", SIGNED_IN),
          new Route("POST", "/api/v1/robots", MANAGER),
          new Route("GET", "/api/v1/robots/{name}", SIGNED_IN),
          new Route("PUT", "/api/v1/robots/{name}", MANAGER),
          new Route("DELETE", "/api/v1/robots/{name}", MANAGER),
          new Route("POST", "/api/v1/robots/{name}/locate", MANAGER),
          new Route("POST", "/api/v1/robots/{name}/out-of-service", MANAGER),
          new Route("POST", "/api/v1/robots/{name}/in-service", MANAGER),
          new Route("POST", "/api/v1/robots/{name}/hold", MANAGER),
          new Route("POST", "/api/v1/robots/{name}/resume", MANAGER),
          new Route("POST", "/api/v1/robots/{name}/home", MANAGER),
          new Route("POST", "/api/v1/robots/{name}/pair", MANAGER),
          new Route("GET", "/api/v1/users", SIGNED_IN),
          new Route("POST", "/api/v1/users", MANAGER),
          new Route("GET", "/api/v1/users/{id}", SIGNED_IN),
          new Route("PUT", "/api/v1/users/{id}", MANAGER),
          new Route("DELETE", "/api/v1/users/{id}", MANAGER),
          new Route("POST", "/api/v1/users/{id}/password", SIGNED_IN),
          new Route("POST", "/api/v1/users/{id}/email", SIGNED_IN),
          new Route("GET", "/api/v1/users/{id}/sessions", SIGNED_IN),
          new Route("DELETE", "/api/v1/users/{id}/sessions/{session}", SIGNED_IN),
          new Route("POST", "/api/v1/users/{id}/tokens", SIGNED_IN),
          new Route("POST", "/api/v1/users/{id}/reset-link", MANAGER),
          new Route("GET", "/api/v1/tracks", SIGNED_IN),
          new Route("GET", "/api/v1/tracks/{name}", SIGNED_IN),
          new Route("GET", "/api/v1/history", SIGNED_IN),
          new Route("GET", "/api/v1/statistics", SIGNED_IN),
          new Route("GET", "/api/v1/statistics/series.csv", SIGNED_IN),
          new Route("GET", "/api/v1/statistics/robots.csv", SIGNED_IN),
          new Route("GET", "/api/v1/fleet", SIGNED_IN),
          new Route("POST", "/api/v1/fleet/pause", SIGNED_IN),
          new Route("POST", "/api/v1/fleet/resume", MANAGER),
          new Route("POST", "/api/v1/floors/{floor}/hold", MANAGER),
          new Route("POST", "/api/v1/floors/{floor}/resume", MANAGER));

  private Routes() {}

  /**
   * What is found at a path.
   *
   * @param routes one for each method that is answered there
   * @param parameters what stands in the path for each segment in braces
   */
  public record Match(List<Route> routes, Map<String, String> parameters) {

    /** The route for that method; HEAD goes where GET goes. */
    public Optional<Route> route(String method) {
      String wanted = method.equals("HEAD") ? "GET" : method;
      return routes.stream().filter(route -> route.method().equals(wanted)).findFirst();
    }

    /** The methods that are answered here, as the header Allow names them. */
    public String allowedMethods() {
      List<String> methods = new ArrayList<>();
      for (Route route : routes) {
        methods.add(route.method());
        if (route.method().equals("GET")) {
          methods.add("HEAD");
        }
      }
      return String.join(", ", methods);
    }
  }

  public static List<Route> all() {
    return ALL;
  }

  public static Optional<Match> find(String path) {
    return ALL.stream()
        .filter(route -> route.match(path).isPresent())
        .findFirst()
        .map(
            first ->
                new Match(
                    ALL.stream().filter(route -> route.path().equals(first.path())).toList(),
                    first.match(path).orElseThrow()));
  }

  /** Whether a page is there that a browser may be sent back to. */
  static boolean isPage(String path) {
    return find(path)
        .flatMap(match -> match.route("GET"))
        .filter(route -> !route.isApi() && route.permission() != PUBLIC)
        .isPresent();
  }
}
