package org.toqa.web.route;

import static org.toqa.web.access.Permission.ADMINISTRATOR;
import static org.toqa.web.access.Permission.ANONYMOUS;
import static org.toqa.web.access.Permission.CLERK;
import static org.toqa.web.access.Permission.MANAGER;
import static org.toqa.web.access.Permission.SIGNED_IN;
import static org.toqa.web.route.Route.Option.BEFORE_FIRST_START;
import static org.toqa.web.route.Route.Option.EVERY_SITE;
import static org.toqa.web.route.Route.Option.MULTIPART;
import static org.toqa.web.route.Route.Option.OWN_SITE;
import static org.toqa.web.route.Route.Option.URGENT;

import jakarta.servlet.http.HttpServletRequest;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Scope;
import org.toqa.web.Handler;
import org.toqa.web.RequestPath;
import org.toqa.web.access.Permission;
import org.toqa.web.api.BatteryResource;
import org.toqa.web.api.FleetResource;
import org.toqa.web.api.FloorDraftResource;
import org.toqa.web.api.FloorFilesResource;
import org.toqa.web.api.FloorResource;
import org.toqa.web.api.FloorsResource;
import org.toqa.web.api.HealthResource;
import org.toqa.web.api.HistoryResource;
import org.toqa.web.api.ImportResource;
import org.toqa.web.api.LabExperimentsResource;
import org.toqa.web.api.LabRunResource;
import org.toqa.web.api.LabRunsResource;
import org.toqa.web.api.LoadsResource;
import org.toqa.web.api.MapResource;
import org.toqa.web.api.MetricsResource;
import org.toqa.web.api.OpenApiResource;
import org.toqa.web.api.OrderResource;
import org.toqa.web.api.OrdersResource;
import org.toqa.web.api.PasswordResetResource;
import org.toqa.web.api.PathResource;
import org.toqa.web.api.ProblemHandler;
import org.toqa.web.api.ReadingsResource;
import org.toqa.web.api.RobotResource;
import org.toqa.web.api.RobotsResource;
import org.toqa.web.api.ScheduleResource;
import org.toqa.web.api.SchedulesResource;
import org.toqa.web.api.SeenPlacesResource;
import org.toqa.web.api.SessionResource;
import org.toqa.web.api.SitesResource;
import org.toqa.web.api.StatisticsCsvResource;
import org.toqa.web.api.StatisticsResource;
import org.toqa.web.api.TaskPreviewResource;
import org.toqa.web.api.TaskResource;
import org.toqa.web.api.TasksResource;
import org.toqa.web.api.TrackResource;
import org.toqa.web.api.TracksResource;
import org.toqa.web.api.UserResource;
import org.toqa.web.api.UsersResource;
import org.toqa.web.live.EventsResource;
import org.toqa.web.page.ApiDocumentPage;
import org.toqa.web.page.EditTaskPage;
import org.toqa.web.page.FirstStartPage;
import org.toqa.web.page.FleetForms;
import org.toqa.web.page.FloorEditorPage;
import org.toqa.web.page.FloorForms;
import org.toqa.web.page.FloorsPage;
import org.toqa.web.page.ForgottenPasswordPage;
import org.toqa.web.page.HelpPage;
import org.toqa.web.page.HistoryPage;
import org.toqa.web.page.ImportPage;
import org.toqa.web.page.LabRunPage;
import org.toqa.web.page.LaboratoryPage;
import org.toqa.web.page.LanguageSwitch;
import org.toqa.web.page.LoadsPage;
import org.toqa.web.page.LoginPage;
import org.toqa.web.page.LogoutForm;
import org.toqa.web.page.MapPage;
import org.toqa.web.page.NewTaskPage;
import org.toqa.web.page.OrderPage;
import org.toqa.web.page.ReadingForms;
import org.toqa.web.page.ResetPasswordPage;
import org.toqa.web.page.RobotPage;
import org.toqa.web.page.RobotsPage;
import org.toqa.web.page.SchedulesPage;
import org.toqa.web.page.SettingsPage;
import org.toqa.web.page.SitesPage;
import org.toqa.web.page.StatisticsPage;
import org.toqa.web.page.TaskPage;
import org.toqa.web.page.TasksPage;
import org.toqa.web.page.UserPage;
import org.toqa.web.page.UsersPage;

/** Every route of the server and who may use it. What is not in this list is not found. */
public final class Routes {
  /**
   * A path with a fixed segment comes before one that would also take it as a parameter. {@link
   * RouteListener} registers them all.
   */
  private static final List<Route> ALL =
      List.of(
          new Route("GET", "/assets/*", ANONYMOUS, null, null, Set.of(BEFORE_FIRST_START)),
          get("/language/{language}", ANONYMOUS, LanguageSwitch::choose).with(BEFORE_FIRST_START),
          get("/first-start", ANONYMOUS, FirstStartPage::show).with(BEFORE_FIRST_START),
          post("/first-start", ANONYMOUS, FirstStartPage::createManager).with(BEFORE_FIRST_START),
          get("/", ANONYMOUS, LoginPage::show),
          get("/login", ANONYMOUS, LoginPage::show),
          post("/", ANONYMOUS, LoginPage::signIn),
          post("/logout", SIGNED_IN, LogoutForm::signOut).with(OWN_SITE),
          get("/forgotten", ANONYMOUS, ForgottenPasswordPage::show),
          post("/forgotten", ANONYMOUS, ForgottenPasswordPage::sendLink),
          get("/reset", ANONYMOUS, ResetPasswordPage::show),
          post("/reset", ANONYMOUS, ResetPasswordPage::replacePassword),
          get("/map", CLERK, MapPage::show),
          get("/tasks", CLERK, TasksPage::show),
          get("/tasks/new", CLERK, NewTaskPage::show),
          post("/tasks/new", CLERK, NewTaskPage::submit),
          get("/tasks/import", CLERK, ImportPage::show),
          post("/tasks/import", CLERK, ImportPage::submit).with(MULTIPART),
          get("/tasks/{id}", CLERK, TaskPage::show),
          get("/tasks/{id}/edit", CLERK, EditTaskPage::show),
          post("/tasks/{id}/edit", CLERK, EditTaskPage::submit),
          post("/tasks/{id}/delete", CLERK, TaskPage::delete),
          post("/tasks/{id}/follow", CLERK, TaskPage::follow),
          post("/tasks/{id}/unfollow", CLERK, TaskPage::unfollow),
          post("/tasks/{id}/cancel", CLERK, TaskPage::cancel),
          post("/tasks/{id}/hold", CLERK, TaskPage::hold),
          post("/tasks/{id}/resume", CLERK, TaskPage::resume),
          post("/tasks/{id}/go-on", CLERK, TaskPage::goOn),
          post("/tasks/{id}/priority", CLERK, TaskPage::prioritise),
          post("/tasks/{id}/answer", CLERK, TaskPage::answer),
          post("/tasks/{id}/load-moved", CLERK, TaskPage::moveLoad),
          post("/tasks/{id}/load-removed", CLERK, TaskPage::removeLoad),
          get("/loads", CLERK, LoadsPage::show),
          get("/orders/{id}", CLERK, OrderPage::show),
          post("/orders/{id}/cancel", CLERK, OrderPage::cancel),
          post("/orders/{id}/retry", CLERK, OrderPage::retry),
          get("/schedules", CLERK, SchedulesPage::show),
          post("/schedules/{id}/pause", CLERK, SchedulesPage::pause),
          post("/schedules/{id}/resume", CLERK, SchedulesPage::resume),
          post("/schedules/{id}/delete", CLERK, SchedulesPage::delete),
          get("/robots", CLERK, RobotsPage::show),
          post("/robots", MANAGER, RobotsPage::add),
          get("/robots/{name}", CLERK, RobotPage::show),
          post("/robots/{name}/locate", MANAGER, RobotPage::locate),
          post("/robots/{name}/move", MANAGER, RobotPage::move),
          post("/robots/{name}/out-of-service", MANAGER, RobotPage::takeOutOfService),
          post("/robots/{name}/in-service", MANAGER, RobotPage::putInService),
          post("/robots/{name}/hold", MANAGER, RobotPage::hold).with(URGENT),
          post("/robots/{name}/resume", MANAGER, RobotPage::resume),
          post("/robots/{name}/clear", MANAGER, RobotPage::clear),
          post("/robots/{name}/home", MANAGER, RobotPage::sendHome),
          post("/robots/{name}/pair", MANAGER, RobotPage::pair),
          post("/robots/{name}/change", MANAGER, RobotPage::change),
          post("/robots/{name}/limits", MANAGER, ReadingForms::setLimits),
          post("/robots/{name}/mqtt-password", MANAGER, ReadingForms::makePassword),
          post("/robots/{name}/remove", MANAGER, RobotPage::remove),
          post("/fleet/pause", CLERK, FleetForms::pause).with(URGENT),
          post("/fleet/resume", MANAGER, FleetForms::resume),
          get("/floors", CLERK, FloorsPage::show),
          post("/floors", MANAGER, FloorsPage::add).with(MULTIPART),
          get("/floors/{floor}/edit", MANAGER, FloorEditorPage::show),
          post("/floors/{floor}/delete", MANAGER, FloorsPage::remove),
          post("/floors/{floor}/seen/{id}/draw", MANAGER, FloorsPage::drawSeen),
          post("/floors/{floor}/seen/{id}/dismiss", MANAGER, FloorsPage::dismissSeen),
          post("/floors/{floor}/hold", MANAGER, FloorForms::hold).with(URGENT),
          post("/floors/{floor}/resume", MANAGER, FloorForms::resume),
          post("/floors/{floor}/allocator", MANAGER, FloorForms::allocator),
          get("/users", SIGNED_IN, UsersPage::show),
          post("/users", MANAGER, UsersPage::add).with(EVERY_SITE),
          get("/users/{id}", SIGNED_IN, UserPage::show),
          post("/users/{id}/change", MANAGER, UserPage::change).with(EVERY_SITE),
          post("/users/{id}/password", SIGNED_IN, UserPage::changePassword).with(EVERY_SITE),
          post("/users/{id}/email", SIGNED_IN, UserPage::changeEmail).with(EVERY_SITE),
          post("/users/{id}/tokens", SIGNED_IN, UserPage::createToken),
          post("/users/{id}/sessions/{session}/end", SIGNED_IN, UserPage::endSession)
              .with(EVERY_SITE),
          post("/users/{id}/reset-link", MANAGER, UserPage::createLink).with(EVERY_SITE),
          post("/users/{id}/delete", MANAGER, UserPage::delete).with(EVERY_SITE),
          get("/sites", ADMINISTRATOR, SitesPage::show).with(OWN_SITE),
          post("/sites", ADMINISTRATOR, SitesPage::add).with(OWN_SITE),
          post("/sites/{site}/visit", ADMINISTRATOR, SitesPage::visit).with(OWN_SITE),
          post("/sites/{site}/delete", ADMINISTRATOR, SitesPage::remove).with(OWN_SITE),
          get("/settings", MANAGER, SettingsPage::show),
          post("/settings/log-level", ADMINISTRATOR, SettingsPage::changeLogLevel).with(OWN_SITE),
          get("/statistics", CLERK, StatisticsPage::show),
          get("/laboratory", MANAGER, LaboratoryPage::show),
          post("/laboratory", MANAGER, LaboratoryPage::start),
          get("/laboratory/compare", MANAGER, LaboratoryPage::compare),
          get("/laboratory/runs/{id}", MANAGER, LabRunPage::show),
          post("/laboratory/runs/{id}/stop", MANAGER, LabRunPage::stop),
          post("/laboratory/runs/{id}/delete", MANAGER, LabRunPage::delete),
          get("/history", CLERK, HistoryPage::show),
          get("/api", SIGNED_IN, ApiDocumentPage::show),
          get("/help", SIGNED_IN, HelpPage::list),
          get("/help/{topic}", SIGNED_IN, HelpPage::show),
          get("/api/v1/health", ANONYMOUS, HealthResource::get)
              .with(BEFORE_FIRST_START)
              .with(URGENT),
          post("/api/v1/session", ANONYMOUS, SessionResource::begin),
          delete("/api/v1/session", SIGNED_IN, SessionResource::end).with(OWN_SITE),
          post("/api/v1/forgotten-password", ANONYMOUS, PasswordResetResource::sendLink),
          post("/api/v1/reset-password", ANONYMOUS, PasswordResetResource::replacePassword),
          get("/api/v1/openapi.json", SIGNED_IN, OpenApiResource::get),
          get("/api/v1/metrics", CLERK, MetricsResource::get),
          get("/api/v1/map", CLERK, MapResource::get),
          get("/api/v1/path", CLERK, PathResource::get),
          get("/api/v1/events", CLERK, EventsResource::stream),
          get("/api/v1/tasks", CLERK, TasksResource::list),
          post("/api/v1/tasks", CLERK, TasksResource::add),
          post("/api/v1/tasks/preview", CLERK, TaskPreviewResource::preview),
          post("/api/v1/tasks/import", CLERK, ImportResource::importTable),
          get("/api/v1/tasks/import/example.csv", CLERK, ImportResource::example),
          get("/api/v1/tasks/{id}", CLERK, TaskResource::get),
          put("/api/v1/tasks/{id}", CLERK, TaskResource::edit),
          delete("/api/v1/tasks/{id}", CLERK, TaskResource::delete),
          post("/api/v1/tasks/{id}/follow", CLERK, TaskResource::follow),
          post("/api/v1/tasks/{id}/unfollow", CLERK, TaskResource::unfollow),
          post("/api/v1/tasks/{id}/cancel", CLERK, TaskResource::cancel),
          post("/api/v1/tasks/{id}/hold", CLERK, TaskResource::hold),
          post("/api/v1/tasks/{id}/resume", CLERK, TaskResource::resume),
          post("/api/v1/tasks/{id}/go-on", CLERK, TaskResource::goOn),
          post("/api/v1/tasks/{id}/priority", CLERK, TaskResource::prioritise),
          post("/api/v1/tasks/{id}/answer", CLERK, TaskResource::answer),
          post("/api/v1/tasks/{id}/load-moved", CLERK, TaskResource::moveLoad),
          post("/api/v1/tasks/{id}/load-removed", CLERK, TaskResource::removeLoad),
          get("/api/v1/loads", CLERK, LoadsResource::list),
          get("/api/v1/orders", CLERK, OrdersResource::list),
          post("/api/v1/orders", CLERK, OrdersResource::add),
          get("/api/v1/orders/{id}", CLERK, OrderResource::get),
          post("/api/v1/orders/{id}/cancel", CLERK, OrderResource::cancel),
          post("/api/v1/orders/{id}/retry", CLERK, OrderResource::retry),
          get("/api/v1/schedules", CLERK, SchedulesResource::list),
          post("/api/v1/schedules", CLERK, SchedulesResource::add),
          get("/api/v1/schedules/{id}", CLERK, ScheduleResource::get),
          delete("/api/v1/schedules/{id}", CLERK, ScheduleResource::delete),
          post("/api/v1/schedules/{id}/pause", CLERK, ScheduleResource::pause),
          post("/api/v1/schedules/{id}/resume", CLERK, ScheduleResource::resume),
          get("/api/v1/robots", CLERK, RobotsResource::list),
          post("/api/v1/robots", MANAGER, RobotsResource::add),
          get("/api/v1/robots/{name}", CLERK, RobotResource::get),
          put("/api/v1/robots/{name}", MANAGER, RobotResource::change),
          delete("/api/v1/robots/{name}", MANAGER, RobotResource::remove),
          post("/api/v1/robots/{name}/locate", MANAGER, RobotResource::locate),
          post("/api/v1/robots/{name}/move", MANAGER, RobotResource::move),
          post("/api/v1/robots/{name}/out-of-service", MANAGER, RobotResource::takeOutOfService),
          post("/api/v1/robots/{name}/in-service", MANAGER, RobotResource::putInService),
          post("/api/v1/robots/{name}/hold", MANAGER, RobotResource::hold).with(URGENT),
          post("/api/v1/robots/{name}/resume", MANAGER, RobotResource::resume),
          post("/api/v1/robots/{name}/clear", MANAGER, RobotResource::clear),
          post("/api/v1/robots/{name}/home", MANAGER, RobotResource::sendHome),
          post("/api/v1/robots/{name}/pair", MANAGER, RobotResource::pair),
          get("/api/v1/users", SIGNED_IN, UsersResource::list),
          post("/api/v1/users", MANAGER, UsersResource::add).with(EVERY_SITE),
          get("/api/v1/users/{id}", SIGNED_IN, UserResource::get),
          put("/api/v1/users/{id}", MANAGER, UserResource::change).with(EVERY_SITE),
          delete("/api/v1/users/{id}", MANAGER, UserResource::delete).with(EVERY_SITE),
          post("/api/v1/users/{id}/password", SIGNED_IN, UserResource::changePassword)
              .with(EVERY_SITE),
          post("/api/v1/users/{id}/email", SIGNED_IN, UserResource::changeEmail).with(EVERY_SITE),
          get("/api/v1/users/{id}/sessions", SIGNED_IN, UserResource::sessions),
          delete("/api/v1/users/{id}/sessions/{session}", SIGNED_IN, UserResource::endSession)
              .with(EVERY_SITE),
          post("/api/v1/users/{id}/tokens", SIGNED_IN, UserResource::createToken),
          post("/api/v1/users/{id}/reset-link", MANAGER, UserResource::createLink).with(EVERY_SITE),
          get("/api/v1/sites", ADMINISTRATOR, SitesResource::list).with(OWN_SITE),
          post("/api/v1/sites", ADMINISTRATOR, SitesResource::add).with(OWN_SITE),
          delete("/api/v1/sites/{site}", ADMINISTRATOR, SitesResource::remove).with(OWN_SITE),
          get("/api/v1/tracks", CLERK, TracksResource::get),
          get("/api/v1/tracks/{name}", CLERK, TrackResource::get),
          get("/api/v1/robots/{name}/battery", CLERK, BatteryResource::get),
          get("/api/v1/robots/{name}/readings", CLERK, ReadingsResource::get),
          put("/api/v1/robots/{name}/limits/{reading}", MANAGER, ReadingsResource::setLimits),
          post("/api/v1/robots/{name}/mqtt-password", MANAGER, ReadingsResource::makePassword),
          get("/api/v1/history", CLERK, HistoryResource::get),
          get("/api/v1/statistics", CLERK, StatisticsResource::get),
          get("/api/v1/statistics/series.csv", CLERK, StatisticsCsvResource::series),
          get("/api/v1/statistics/robots.csv", CLERK, StatisticsCsvResource::robots),
          get("/api/v1/laboratory/experiments", MANAGER, LabExperimentsResource::list),
          get("/api/v1/laboratory/runs", MANAGER, LabRunsResource::list),
          post("/api/v1/laboratory/runs", MANAGER, LabRunsResource::start),
          get("/api/v1/laboratory/runs/{id}", MANAGER, LabRunResource::get),
          delete("/api/v1/laboratory/runs/{id}", MANAGER, LabRunResource::delete),
          post("/api/v1/laboratory/runs/{id}/stop", MANAGER, LabRunResource::stop),
          get("/api/v1/laboratory/runs/{id}/report", MANAGER, LabRunResource::report),
          get("/api/v1/laboratory/runs/{id}/figures.csv", MANAGER, LabRunResource::figures),
          get("/api/v1/laboratory/runs/{id}/tables/{name}", MANAGER, LabRunResource::table),
          get("/api/v1/laboratory/runs/{id}/drawings", MANAGER, LabRunResource::drawings),
          get("/api/v1/laboratory/runs/{id}/drawings/{name}", MANAGER, LabRunResource::drawing),
          get("/api/v1/laboratory/runs/{id}/scenes/{name}", MANAGER, LabRunResource::motion),
          get("/api/v1/fleet", CLERK, FleetResource::get),
          post("/api/v1/fleet/pause", CLERK, FleetResource::pause).with(URGENT),
          post("/api/v1/fleet/resume", MANAGER, FleetResource::resume),
          get("/api/v1/floors", CLERK, FloorsResource::list),
          post("/api/v1/floors", MANAGER, FloorsResource::add),
          post("/api/v1/floors/read", MANAGER, FloorFilesResource::read),
          get("/api/v1/floors/{floor}", CLERK, FloorResource::get),
          delete("/api/v1/floors/{floor}", MANAGER, FloorResource::remove),
          get("/api/v1/floors/{floor}/export", CLERK, FloorFilesResource::export),
          get("/api/v1/floors/{floor}/draft", CLERK, FloorDraftResource::get),
          put("/api/v1/floors/{floor}/draft", MANAGER, FloorDraftResource::save),
          delete("/api/v1/floors/{floor}/draft", MANAGER, FloorDraftResource::discard),
          post("/api/v1/floors/{floor}/draft/check", MANAGER, FloorDraftResource::check),
          post("/api/v1/floors/{floor}/draft/publish", MANAGER, FloorDraftResource::publish),
          get("/api/v1/floors/{floor}/seen", CLERK, SeenPlacesResource::list),
          post("/api/v1/floors/{floor}/seen/{id}/draw", MANAGER, SeenPlacesResource::draw),
          post("/api/v1/floors/{floor}/seen/{id}/dismiss", MANAGER, SeenPlacesResource::dismiss),
          post("/api/v1/floors/{floor}/hold", MANAGER, FloorResource::hold).with(URGENT),
          post("/api/v1/floors/{floor}/resume", MANAGER, FloorResource::resume),
          post("/api/v1/floors/{floor}/allocator", MANAGER, FloorResource::allocator));

  private Routes() {}

  private static Route get(String path, Permission permission, Handler handler) {
    return route("GET", path, permission, handler);
  }

  private static Route post(String path, Permission permission, Handler handler) {
    return route("POST", path, permission, handler);
  }

  private static Route put(String path, Permission permission, Handler handler) {
    return route("PUT", path, permission, handler);
  }

  private static Route delete(String path, Permission permission, Handler handler) {
    return route("DELETE", path, permission, handler);
  }

  private static Route route(String method, String path, Permission permission, Handler handler) {
    Handler answering = RequestPath.isApi(path) ? new ProblemHandler(handler) : handler;
    return new Route(method, path, permission, scope(method, path), answering, Set.of());
  }

  /** What a token must have for a call; null for pages, and for the end of the token itself. */
  private static @Nullable Scope scope(String method, String path) {
    if (!RequestPath.isApi(path) || path.equals("/api/v1/session")) {
      return null;
    }
    if (path.equals("/api/v1/metrics")) {
      return Scope.METRICS;
    }
    if (path.startsWith("/api/v1/users") || path.startsWith("/api/v1/sites")) {
      return Scope.MANAGE;
    }
    if (method.equals("GET")) {
      return Scope.READ;
    }
    return Stream.of("tasks", "orders", "schedules")
            .anyMatch(subject -> path.startsWith("/api/v1/" + subject))
        ? Scope.TASKS
        : Scope.MANAGE;
  }

  /** Whether what is asked for is held up by nothing else. */
  static boolean isUrgent(HttpServletRequest request) {
    return find(RequestPath.of(request))
        .flatMap(match -> match.route(request.getMethod()))
        .filter(route -> route.has(URGENT))
        .isPresent();
  }

  /**
   * What is found at a path.
   *
   * @param routes one for each method that is answered there
   * @param parameters the value of each segment in braces
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
        .filter(route -> !route.isApi() && !route.has(BEFORE_FIRST_START))
        .isPresent();
  }
}
