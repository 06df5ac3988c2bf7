package org.toqa.web.route;

import static org.toqa.web.access.Permission.ADMINISTER;
import static org.toqa.web.access.Permission.ANONYMOUS;
import static org.toqa.web.access.Permission.MANAGE;
import static org.toqa.web.access.Permission.OPERATE;
import static org.toqa.web.access.Permission.ORDER;
import static org.toqa.web.access.Permission.PAUSE;
import static org.toqa.web.access.Permission.SIGNED_IN;
import static org.toqa.web.access.Permission.VIEW;
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
import org.toqa.web.api.CamerasResource;
import org.toqa.web.api.ExplorationResource;
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
import org.toqa.web.api.ManualDriveResource;
import org.toqa.web.api.MapResource;
import org.toqa.web.api.MetricsResource;
import org.toqa.web.api.NetworkResource;
import org.toqa.web.api.NoticesResource;
import org.toqa.web.api.OpenApiResource;
import org.toqa.web.api.OrderResource;
import org.toqa.web.api.OrdersResource;
import org.toqa.web.api.PasswordResetResource;
import org.toqa.web.api.PathResource;
import org.toqa.web.api.ProblemHandler;
import org.toqa.web.api.QueryCheck;
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
import org.toqa.web.api.SupervisionResource;
import org.toqa.web.api.TaskPreviewResource;
import org.toqa.web.api.TaskResource;
import org.toqa.web.api.TasksResource;
import org.toqa.web.api.TemplatesResource;
import org.toqa.web.api.TrackResource;
import org.toqa.web.api.TracksResource;
import org.toqa.web.api.UserResource;
import org.toqa.web.api.UsersResource;
import org.toqa.web.api.WebhooksResource;
import org.toqa.web.live.EventsResource;
import org.toqa.web.page.ApiDocumentPage;
import org.toqa.web.page.CamerasPage;
import org.toqa.web.page.ControlPage;
import org.toqa.web.page.EditTaskPage;
import org.toqa.web.page.ExplorationPage;
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
import org.toqa.web.page.NetworkPage;
import org.toqa.web.page.NewTaskPage;
import org.toqa.web.page.NoticesPage;
import org.toqa.web.page.OrderPage;
import org.toqa.web.page.ReadingForms;
import org.toqa.web.page.ResetPasswordPage;
import org.toqa.web.page.RobotPage;
import org.toqa.web.page.RobotsPage;
import org.toqa.web.page.SchedulesPage;
import org.toqa.web.page.SettingsPage;
import org.toqa.web.page.SitesPage;
import org.toqa.web.page.StatisticsPage;
import org.toqa.web.page.SupervisionPage;
import org.toqa.web.page.TaskPage;
import org.toqa.web.page.TasksPage;
import org.toqa.web.page.TemplateEditPage;
import org.toqa.web.page.TemplatePage;
import org.toqa.web.page.TemplatesPage;
import org.toqa.web.page.UserPage;
import org.toqa.web.page.UsersPage;
import org.toqa.web.page.WebhooksPage;

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
          get("/map", VIEW, MapPage::show),
          get("/tasks", VIEW, TasksPage::show),
          get("/tasks/new", ORDER, NewTaskPage::show),
          post("/tasks/new", ORDER, NewTaskPage::submit),
          get("/tasks/import", ORDER, ImportPage::show),
          post("/tasks/import", ORDER, ImportPage::submit).with(MULTIPART),
          get("/tasks/{id}", VIEW, TaskPage::show),
          get("/tasks/{id}/edit", ORDER, EditTaskPage::show),
          post("/tasks/{id}/edit", ORDER, EditTaskPage::submit),
          post("/tasks/{id}/delete", ORDER, TaskPage::delete),
          post("/tasks/{id}/follow", VIEW, TaskPage::follow),
          post("/tasks/{id}/unfollow", VIEW, TaskPage::unfollow),
          post("/tasks/{id}/cancel", ORDER, TaskPage::cancel),
          post("/tasks/{id}/hold", ORDER, TaskPage::hold),
          post("/tasks/{id}/resume", ORDER, TaskPage::resume),
          post("/tasks/{id}/go-on", ORDER, TaskPage::goOn),
          post("/tasks/{id}/priority", ORDER, TaskPage::prioritise),
          post("/tasks/{id}/answer", ORDER, TaskPage::answer),
          post("/tasks/{id}/load-moved", ORDER, TaskPage::moveLoad),
          post("/tasks/{id}/load-removed", ORDER, TaskPage::removeLoad),
          get("/loads", VIEW, LoadsPage::show),
          get("/orders/{id}", VIEW, OrderPage::show),
          post("/orders/{id}/cancel", ORDER, OrderPage::cancel),
          post("/orders/{id}/hold", ORDER, OrderPage::hold),
          post("/orders/{id}/resume", ORDER, OrderPage::resume),
          post("/orders/{id}/priority", ORDER, OrderPage::prioritise),
          post("/orders/{id}/retry", ORDER, OrderPage::retry),
          get("/schedules", VIEW, SchedulesPage::show),
          post("/schedules/{id}/pause", ORDER, SchedulesPage::pause),
          post("/schedules/{id}/resume", ORDER, SchedulesPage::resume),
          post("/schedules/{id}/delete", ORDER, SchedulesPage::delete),
          get("/templates", VIEW, TemplatesPage::show),
          post("/templates", ORDER, TemplateEditPage::add),
          get("/templates/new", ORDER, TemplateEditPage::showNew),
          post("/templates/new", ORDER, TemplateEditPage::ofForm),
          get("/templates/{id}", ORDER, TemplatePage::show),
          post("/templates/{id}", ORDER, TemplatePage::submit),
          get("/templates/{id}/edit", ORDER, TemplateEditPage::show),
          post("/templates/{id}/edit", ORDER, TemplateEditPage::replace),
          post("/templates/{id}/delete", ORDER, TemplatesPage::delete),
          get("/robots", VIEW, RobotsPage::show),
          post("/robots", MANAGE, RobotsPage::add),
          get("/robots/{name}", VIEW, RobotPage::show),
          get("/robots/{name}/control", VIEW, ControlPage::show),
          post("/robots/{name}/locate", OPERATE, RobotPage::locate),
          post("/robots/{name}/move", MANAGE, RobotPage::move),
          post("/robots/{name}/out-of-service", OPERATE, RobotPage::takeOutOfService),
          post("/robots/{name}/in-service", OPERATE, RobotPage::putInService),
          post("/robots/{name}/hold", OPERATE, RobotPage::hold).with(URGENT),
          post("/robots/{name}/resume", OPERATE, RobotPage::resume),
          post("/robots/{name}/clear", OPERATE, RobotPage::clear),
          post("/robots/{name}/home", OPERATE, RobotPage::sendHome),
          post("/robots/{name}/pair", MANAGE, RobotPage::pair),
          post("/robots/{name}/change", MANAGE, RobotPage::change),
          post("/robots/{name}/limits", MANAGE, ReadingForms::setLimits),
          post("/robots/{name}/mqtt-password", MANAGE, ReadingForms::makePassword),
          post("/robots/{name}/remove", MANAGE, RobotPage::remove),
          post("/fleet/pause", PAUSE, FleetForms::pause).with(URGENT),
          post("/fleet/resume", OPERATE, FleetForms::resume),
          get("/floors", VIEW, FloorsPage::show),
          post("/floors", MANAGE, FloorsPage::add).with(MULTIPART),
          get("/floors/{floor}/edit", MANAGE, FloorEditorPage::show),
          get("/floors/{floor}/exploration", MANAGE, ExplorationPage::show),
          post("/floors/{floor}/exploration", MANAGE, ExplorationPage::start),
          post("/floors/{floor}/exploration/stop", MANAGE, ExplorationPage::stop),
          post("/floors/{floor}/exploration/draw", MANAGE, ExplorationPage::draw),
          post("/floors/{floor}/delete", MANAGE, FloorsPage::remove),
          post("/floors/{floor}/seen/{id}/draw", MANAGE, FloorsPage::drawSeen),
          post("/floors/{floor}/seen/{id}/dismiss", MANAGE, FloorsPage::dismissSeen),
          post("/floors/{floor}/hold", OPERATE, FloorForms::hold).with(URGENT),
          post("/floors/{floor}/resume", OPERATE, FloorForms::resume),
          post("/floors/{floor}/allocator", MANAGE, FloorForms::allocator),
          get("/floors/{floor}/supervision", VIEW, SupervisionPage::show),
          post("/floors/{floor}/supervision", MANAGE, SupervisionPage::start),
          post("/floors/{floor}/supervision/stop", MANAGE, SupervisionPage::stop),
          post("/floors/{floor}/supervision/look", OPERATE, SupervisionPage::lookAgain),
          post(
              "/floors/{floor}/supervision/boxes/{box}/leave-out",
              OPERATE,
              SupervisionPage::leaveOut),
          get("/cameras", VIEW, CamerasPage::show),
          post("/cameras", MANAGE, CamerasPage::add),
          post("/cameras/{id}/change", MANAGE, CamerasPage::change),
          post("/cameras/{id}/delete", MANAGE, CamerasPage::delete),
          get("/network", VIEW, NetworkPage::show),
          post("/network", MANAGE, NetworkPage::add),
          post("/network/{id}/change", MANAGE, NetworkPage::change),
          post("/network/{id}/delete", MANAGE, NetworkPage::delete),
          get("/notices", VIEW, NoticesPage::show),
          post("/notices/seen", VIEW, NoticesPage::see),
          get("/notices/settings", VIEW, NoticesPage::showSettings),
          post("/notices/settings", VIEW, NoticesPage::saveSettings),
          get("/notices/webhooks", MANAGE, WebhooksPage::show),
          post("/notices/webhooks", MANAGE, WebhooksPage::add),
          post("/notices/webhooks/{id}/change", MANAGE, WebhooksPage::change),
          post("/notices/webhooks/{id}/secret", MANAGE, WebhooksPage::renewSecret),
          post("/notices/webhooks/{id}/test", MANAGE, WebhooksPage::test),
          post("/notices/webhooks/{id}/delete", MANAGE, WebhooksPage::delete),
          get("/users", SIGNED_IN, UsersPage::show),
          post("/users", MANAGE, UsersPage::add).with(EVERY_SITE),
          get("/users/{id}", SIGNED_IN, UserPage::show),
          post("/users/{id}/change", MANAGE, UserPage::change).with(EVERY_SITE),
          post("/users/{id}/password", SIGNED_IN, UserPage::changePassword).with(EVERY_SITE),
          post("/users/{id}/email", SIGNED_IN, UserPage::changeEmail).with(EVERY_SITE),
          post("/users/{id}/tokens", SIGNED_IN, UserPage::createToken),
          post("/users/{id}/sessions/{session}/end", SIGNED_IN, UserPage::endSession)
              .with(EVERY_SITE),
          post("/users/{id}/reset-link", MANAGE, UserPage::createLink).with(EVERY_SITE),
          post("/users/{id}/delete", MANAGE, UserPage::delete).with(EVERY_SITE),
          get("/sites", ADMINISTER, SitesPage::show).with(OWN_SITE),
          post("/sites", ADMINISTER, SitesPage::add).with(OWN_SITE),
          post("/sites/{site}/visit", ADMINISTER, SitesPage::visit).with(OWN_SITE),
          post("/sites/{site}/delete", ADMINISTER, SitesPage::remove).with(OWN_SITE),
          get("/settings", MANAGE, SettingsPage::show),
          post("/settings/log-level", ADMINISTER, SettingsPage::changeLogLevel).with(OWN_SITE),
          get("/statistics", VIEW, StatisticsPage::show),
          get("/laboratory", MANAGE, LaboratoryPage::show),
          post("/laboratory", MANAGE, LaboratoryPage::start),
          get("/laboratory/compare", MANAGE, LaboratoryPage::compare),
          get("/laboratory/runs/{id}", MANAGE, LabRunPage::show),
          post("/laboratory/runs/{id}/stop", MANAGE, LabRunPage::stop),
          post("/laboratory/runs/{id}/delete", MANAGE, LabRunPage::delete),
          get("/history", VIEW, HistoryPage::show),
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
          get("/api/v1/metrics", VIEW, MetricsResource::get),
          get("/api/v1/map", VIEW, MapResource::get),
          get("/api/v1/path", VIEW, PathResource::get),
          get("/api/v1/events", VIEW, EventsResource::stream),
          get("/api/v1/tasks", VIEW, TasksResource::list),
          post("/api/v1/tasks", ORDER, TasksResource::add),
          post("/api/v1/tasks/preview", ORDER, TaskPreviewResource::preview),
          post("/api/v1/tasks/import", ORDER, ImportResource::importTable),
          get("/api/v1/tasks/import/example.csv", VIEW, ImportResource::example),
          get("/api/v1/tasks/{id}", VIEW, TaskResource::get),
          put("/api/v1/tasks/{id}", ORDER, TaskResource::edit),
          delete("/api/v1/tasks/{id}", ORDER, TaskResource::delete),
          post("/api/v1/tasks/{id}/follow", VIEW, TaskResource::follow),
          post("/api/v1/tasks/{id}/unfollow", VIEW, TaskResource::unfollow),
          post("/api/v1/tasks/{id}/cancel", ORDER, TaskResource::cancel),
          post("/api/v1/tasks/{id}/hold", ORDER, TaskResource::hold),
          post("/api/v1/tasks/{id}/resume", ORDER, TaskResource::resume),
          post("/api/v1/tasks/{id}/go-on", ORDER, TaskResource::goOn),
          post("/api/v1/tasks/{id}/priority", ORDER, TaskResource::prioritise),
          post("/api/v1/tasks/{id}/answer", ORDER, TaskResource::answer),
          post("/api/v1/tasks/{id}/load-moved", ORDER, TaskResource::moveLoad),
          post("/api/v1/tasks/{id}/load-removed", ORDER, TaskResource::removeLoad),
          get("/api/v1/loads", VIEW, LoadsResource::list),
          get("/api/v1/orders", VIEW, OrdersResource::list),
          post("/api/v1/orders", ORDER, OrdersResource::add),
          get("/api/v1/orders/{id}", VIEW, OrderResource::get),
          post("/api/v1/orders/{id}/cancel", ORDER, OrderResource::cancel),
          post("/api/v1/orders/{id}/hold", ORDER, OrderResource::hold),
          post("/api/v1/orders/{id}/resume", ORDER, OrderResource::resume),
          post("/api/v1/orders/{id}/priority", ORDER, OrderResource::prioritise),
          post("/api/v1/orders/{id}/retry", ORDER, OrderResource::retry),
          get("/api/v1/schedules", VIEW, SchedulesResource::list),
          post("/api/v1/schedules", ORDER, SchedulesResource::add),
          get("/api/v1/schedules/{id}", VIEW, ScheduleResource::get),
          delete("/api/v1/schedules/{id}", ORDER, ScheduleResource::delete),
          post("/api/v1/schedules/{id}/pause", ORDER, ScheduleResource::pause),
          post("/api/v1/schedules/{id}/resume", ORDER, ScheduleResource::resume),
          get("/api/v1/templates", VIEW, TemplatesResource::list),
          post("/api/v1/templates", ORDER, TemplatesResource::add),
          get("/api/v1/templates/{id}", VIEW, TemplatesResource::get),
          put("/api/v1/templates/{id}", ORDER, TemplatesResource::replace),
          delete("/api/v1/templates/{id}", ORDER, TemplatesResource::delete),
          get("/api/v1/robots", VIEW, RobotsResource::list),
          post("/api/v1/robots", MANAGE, RobotsResource::add),
          get("/api/v1/robots/{name}", VIEW, RobotResource::get),
          put("/api/v1/robots/{name}", MANAGE, RobotResource::change),
          delete("/api/v1/robots/{name}", MANAGE, RobotResource::remove),
          post("/api/v1/robots/{name}/locate", OPERATE, RobotResource::locate),
          post("/api/v1/robots/{name}/move", MANAGE, RobotResource::move),
          post("/api/v1/robots/{name}/out-of-service", OPERATE, RobotResource::takeOutOfService),
          post("/api/v1/robots/{name}/in-service", OPERATE, RobotResource::putInService),
          post("/api/v1/robots/{name}/hold", OPERATE, RobotResource::hold).with(URGENT),
          post("/api/v1/robots/{name}/resume", OPERATE, RobotResource::resume),
          post("/api/v1/robots/{name}/clear", OPERATE, RobotResource::clear),
          post("/api/v1/robots/{name}/home", OPERATE, RobotResource::sendHome),
          post("/api/v1/robots/{name}/pair", MANAGE, RobotResource::pair),
          post("/api/v1/robots/{name}/drive", OPERATE, ManualDriveResource::drive).with(URGENT),
          delete("/api/v1/robots/{name}/drive", OPERATE, ManualDriveResource::end).with(URGENT),
          get("/api/v1/cameras", VIEW, CamerasResource::list),
          post("/api/v1/cameras", MANAGE, CamerasResource::add),
          put("/api/v1/cameras/{id}", MANAGE, CamerasResource::change),
          delete("/api/v1/cameras/{id}", MANAGE, CamerasResource::delete),
          get("/api/v1/cameras/{id}/picture", VIEW, CamerasResource::picture),
          get("/api/v1/network", VIEW, NetworkResource::get),
          post("/api/v1/network/devices", MANAGE, NetworkResource::add),
          put("/api/v1/network/devices/{id}", MANAGE, NetworkResource::change),
          delete("/api/v1/network/devices/{id}", MANAGE, NetworkResource::delete),
          get("/api/v1/notices", VIEW, NoticesResource::list),
          get("/api/v1/notices/news", VIEW, NoticesResource::news),
          post("/api/v1/notices/seen", VIEW, NoticesResource::seeAll),
          get("/api/v1/notices/settings", VIEW, NoticesResource::settings),
          put("/api/v1/notices/settings", VIEW, NoticesResource::changeSettings),
          post("/api/v1/notices/{id}/seen", VIEW, NoticesResource::see),
          get("/api/v1/webhooks", MANAGE, WebhooksResource::list),
          post("/api/v1/webhooks", MANAGE, WebhooksResource::add),
          put("/api/v1/webhooks/{id}", MANAGE, WebhooksResource::change),
          delete("/api/v1/webhooks/{id}", MANAGE, WebhooksResource::delete),
          post("/api/v1/webhooks/{id}/secret", MANAGE, WebhooksResource::renewSecret),
          post("/api/v1/webhooks/{id}/test", MANAGE, WebhooksResource::test),
          get("/api/v1/users", SIGNED_IN, UsersResource::list),
          post("/api/v1/users", MANAGE, UsersResource::add).with(EVERY_SITE),
          get("/api/v1/users/{id}", SIGNED_IN, UserResource::get),
          put("/api/v1/users/{id}", MANAGE, UserResource::change).with(EVERY_SITE),
          delete("/api/v1/users/{id}", MANAGE, UserResource::delete).with(EVERY_SITE),
          post("/api/v1/users/{id}/password", SIGNED_IN, UserResource::changePassword)
              .with(EVERY_SITE),
          post("/api/v1/users/{id}/email", SIGNED_IN, UserResource::changeEmail).with(EVERY_SITE),
          get("/api/v1/users/{id}/sessions", SIGNED_IN, UserResource::sessions),
          delete("/api/v1/users/{id}/sessions/{session}", SIGNED_IN, UserResource::endSession)
              .with(EVERY_SITE),
          post("/api/v1/users/{id}/tokens", SIGNED_IN, UserResource::createToken),
          post("/api/v1/users/{id}/reset-link", MANAGE, UserResource::createLink).with(EVERY_SITE),
          get("/api/v1/sites", ADMINISTER, SitesResource::list).with(OWN_SITE),
          post("/api/v1/sites", ADMINISTER, SitesResource::add).with(OWN_SITE),
          delete("/api/v1/sites/{site}", ADMINISTER, SitesResource::remove).with(OWN_SITE),
          get("/api/v1/tracks", VIEW, TracksResource::get),
          get("/api/v1/tracks/{name}", VIEW, TrackResource::get),
          get("/api/v1/robots/{name}/battery", VIEW, BatteryResource::get),
          get("/api/v1/robots/{name}/readings", VIEW, ReadingsResource::get),
          put("/api/v1/robots/{name}/limits/{reading}", MANAGE, ReadingsResource::setLimits),
          post("/api/v1/robots/{name}/mqtt-password", MANAGE, ReadingsResource::makePassword),
          get("/api/v1/history", VIEW, HistoryResource::get),
          get("/api/v1/statistics", VIEW, StatisticsResource::get),
          get("/api/v1/statistics/series.csv", VIEW, StatisticsCsvResource::series),
          get("/api/v1/statistics/robots.csv", VIEW, StatisticsCsvResource::robots),
          get("/api/v1/laboratory/experiments", MANAGE, LabExperimentsResource::list),
          get("/api/v1/laboratory/runs", MANAGE, LabRunsResource::list),
          post("/api/v1/laboratory/runs", MANAGE, LabRunsResource::start),
          get("/api/v1/laboratory/runs/{id}", MANAGE, LabRunResource::get),
          delete("/api/v1/laboratory/runs/{id}", MANAGE, LabRunResource::delete),
          post("/api/v1/laboratory/runs/{id}/stop", MANAGE, LabRunResource::stop),
          get("/api/v1/laboratory/runs/{id}/report", MANAGE, LabRunResource::report),
          get("/api/v1/laboratory/runs/{id}/figures.csv", MANAGE, LabRunResource::figures),
          get("/api/v1/laboratory/runs/{id}/tables/{name}", MANAGE, LabRunResource::table),
          get("/api/v1/laboratory/runs/{id}/drawings", MANAGE, LabRunResource::drawings),
          get("/api/v1/laboratory/runs/{id}/drawings/{name}", MANAGE, LabRunResource::drawing),
          get("/api/v1/laboratory/runs/{id}/scenes/{name}", MANAGE, LabRunResource::motion),
          get("/api/v1/fleet", VIEW, FleetResource::get),
          post("/api/v1/fleet/pause", PAUSE, FleetResource::pause).with(URGENT),
          post("/api/v1/fleet/resume", OPERATE, FleetResource::resume),
          get("/api/v1/floors", VIEW, FloorsResource::list),
          post("/api/v1/floors", MANAGE, FloorsResource::add),
          post("/api/v1/floors/read", MANAGE, FloorFilesResource::read),
          get("/api/v1/floors/{floor}", VIEW, FloorResource::get),
          delete("/api/v1/floors/{floor}", MANAGE, FloorResource::remove),
          get("/api/v1/floors/{floor}/export", VIEW, FloorFilesResource::export),
          get("/api/v1/floors/{floor}/draft", VIEW, FloorDraftResource::get),
          put("/api/v1/floors/{floor}/draft", MANAGE, FloorDraftResource::save),
          delete("/api/v1/floors/{floor}/draft", MANAGE, FloorDraftResource::discard),
          post("/api/v1/floors/{floor}/draft/check", MANAGE, FloorDraftResource::check),
          post("/api/v1/floors/{floor}/draft/publish", MANAGE, FloorDraftResource::publish),
          get("/api/v1/floors/{floor}/seen", VIEW, SeenPlacesResource::list),
          post("/api/v1/floors/{floor}/seen/{id}/draw", MANAGE, SeenPlacesResource::draw),
          post("/api/v1/floors/{floor}/seen/{id}/dismiss", MANAGE, SeenPlacesResource::dismiss),
          post("/api/v1/floors/{floor}/hold", OPERATE, FloorResource::hold).with(URGENT),
          post("/api/v1/floors/{floor}/resume", OPERATE, FloorResource::resume),
          post("/api/v1/floors/{floor}/allocator", MANAGE, FloorResource::allocator),
          get("/api/v1/floors/{floor}/supervision", VIEW, SupervisionResource::get),
          post("/api/v1/floors/{floor}/supervision", MANAGE, SupervisionResource::start),
          post("/api/v1/floors/{floor}/supervision/stop", MANAGE, SupervisionResource::stop),
          post("/api/v1/floors/{floor}/supervision/look", OPERATE, SupervisionResource::lookAgain),
          post(
              "/api/v1/floors/{floor}/supervision/boxes/{box}/leave-out",
              OPERATE,
              SupervisionResource::leaveOut),
          get("/api/v1/floors/{floor}/exploration", MANAGE, ExplorationResource::get),
          post("/api/v1/floors/{floor}/exploration", MANAGE, ExplorationResource::start),
          post("/api/v1/floors/{floor}/exploration/stop", MANAGE, ExplorationResource::stop),
          post("/api/v1/floors/{floor}/exploration/draw", MANAGE, ExplorationResource::draw));

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
    return new Route(
        method, path, permission, scope(method, path), answering(method, path, handler), Set.of());
  }

  private static Handler answering(String method, String path, Handler handler) {
    if (!RequestPath.isApi(path)) {
      return handler;
    }
    return new ProblemHandler(method.equals("GET") ? new QueryCheck(path, handler) : handler);
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
    return Stream.of("tasks", "orders", "schedules", "templates")
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
