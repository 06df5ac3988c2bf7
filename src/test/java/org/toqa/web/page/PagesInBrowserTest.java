package org.toqa.web.page;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static java.util.Objects.requireNonNull;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import com.microsoft.playwright.Browser;
import com.microsoft.playwright.BrowserContext;
import com.microsoft.playwright.BrowserType;
import com.microsoft.playwright.Locator;
import com.microsoft.playwright.Page;
import com.microsoft.playwright.Playwright;
import com.microsoft.playwright.Route;
import com.microsoft.playwright.assertions.LocatorAssertions;
import com.microsoft.playwright.options.AriaRole;
import com.microsoft.playwright.options.ColorScheme;
import com.microsoft.playwright.options.FilePayload;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicReference;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.fleet.FloorView;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.CellRuns;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.mission.Phase;
import org.toqa.mission.TaskState;
import org.toqa.testbed.Hall;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * The pages in a real browser. Pictures of them go to {@code target/screenshots}, to be looked at.
 */
@Tag("full")
class PagesInBrowserTest {
  private static final Path PICTURES = Path.of("target/screenshots");

  private static Playwright playwright;
  private static Browser browser;

  private WebTestServer server;
  private final List<String> complaints = new ArrayList<>();

  @BeforeAll
  static void openBrowser() {
    playwright =
        Playwright.create(
            new Playwright.CreateOptions().setEnv(Map.of("PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD", "1")));
    browser =
        playwright
            .chromium()
            .launch(
                new BrowserType.LaunchOptions()
                    .setExecutablePath(Path.of("/usr/bin/chromium"))
                    .setArgs(List.of("--no-sandbox", "--disable-gpu")));
  }

  @AfterAll
  static void closeBrowser() {
    browser.close();
    playwright.close();
  }

  @BeforeEach
  void start() throws Exception {
    server = WebTestServer.startForBrowser();
    server.fleet().changeRobots(none -> fleetAtWork());
  }

  @AfterEach
  void stop() throws Exception {
    server.close();
    assertEquals(List.of(), complaints);
  }

  @Test
  void aTaskIsAssignedByClickingOnTheMapAndSeenToTheEnd() {
    Page page = loggedIn(1280, 900, ColorScheme.LIGHT);
    page.navigate(server.root() + "tasks/new");
    page.getByLabel("Task name").fill("Box of bolts");
    page.getByLabel("Load (kg)").fill("2.5");
    page.getByLabel("Deadline").fill("2098-07-01T15:00");
    assertThat(page.locator("#deadline-help")).hasText("Time zone: America/Bogota");
    Locator map = page.locator("#map");
    clickMap(page, map, 1.05, 5.25); // the station Dock A
    assertThat(page.locator("#startStation")).hasValue("Dock A");
    clickMap(page, map, 9, 4.5);
    assertThat(page.locator("#goalX")).hasValue(Pattern.compile("^(8\\.9|9\\.0).*"));
    assertThat(page.locator("#preview"))
        .hasText(
            Pattern.compile(
                "Needs 2 robots together. Estimated assignment: r1, r2 \\(that is"
                    + " sooner\\). Estimated distance of the load: 8.0 m."));
    picture(page, "new-task-picked");
    page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Create task")).click();

    assertThat(page.locator("h1")).hasText("Box of bolts");
    assertThat(page.locator("time[datetime='2098-07-01T20:00:00Z']")).containsText("3:00");
    assertThat(page.locator("[aria-current=step]")).hasText("Queued");
    server.fleet().changeTask(1, TaskState.CARRYING, List.of("r1"), "r1 carries the load.");
    assertThat(page.locator("[aria-current=step]")).hasText("Carrying");
    picture(page, "task-live");
    server.fleet().changeTask(1, TaskState.DONE, List.of("r1"), "r1 has parked.");
    assertThat(page.locator(".history li")).hasCount(3);
    assertThat(page.locator("[aria-current=step]")).hasText("Done");
  }

  @ParameterizedTest
  @CsvSource({"desk, 1280, 900", "phone, 390, 844"})
  void aTableIsImportedAfterItsBadLineIsMended(String name, int width, int height) {
    Page page = loggedIn(width, height, ColorScheme.LIGHT);
    page.navigate(server.root() + "tasks");
    page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Import")).click();
    assertThat(page.locator("#zone-name")).hasText("America/Bogota");
    String header = "name;load;start;goal;deadline\n";
    String good = "Box of bolts;2,5;Dock A;Shelf 3;2098-07-01 15:00\n";
    choose(page, header + good + "Box of nuts;heavy;Dock A;\n");
    assertThat(page.locator("main .notice.bad")).containsText("Nothing was imported.");
    assertThat(page.locator("#faults tbody tr")).hasCount(2);
    assertThat(page.locator("#faults tbody tr").first())
        .containsText("Enter a number, such as 2.5");
    picture(page, name + "-tasks-import-refused");

    choose(page, header + good + "Box of nuts;1;Dock A;Shelf 3;\n");

    assertThat(page.locator(".notice.good")).hasText("2 tasks were imported.");
    picture(page, name + "-tasks-imported");
    page.getByRole(AriaRole.LINK, new Page.GetByRoleOptions().setName("Box of bolts")).click();
    assertThat(page.locator("time[datetime='2098-07-01T20:00:00Z']")).containsText("3:00");
  }

  @ParameterizedTest
  @CsvSource({"desk, 1280, 900", "phone, 390, 844"})
  void aTaskIsScheduledForEveryWeekday(String name, int width, int height) {
    Page page = loggedIn(width, height, ColorScheme.LIGHT);
    page.navigate(server.root() + "tasks/new");
    page.getByLabel("Task name").fill("Morning tour");
    page.getByLabel("Load (kg)").fill("2.5");
    page.locator("#startStation").selectOption("Dock A");
    page.locator("#goalStation").selectOption("Shelf 3");
    assertThat(page.locator("#time")).isHidden();
    page.getByLabel("Schedule").selectOption("weekly");
    assertThat(page.locator("#first")).isHidden();
    page.getByLabel("Monday").check();
    page.getByLabel("Friday").check();
    picture(page, name + "-schedule-form");
    page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Create task")).click();
    assertThat(page.locator("#time-help")).containsText("Enter a time of day");
    assertThat(page.getByLabel("Monday")).isChecked();
    page.locator("#time").fill("08:00");
    page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Create task")).click();

    assertThat(page.locator(".notice.good")).hasText("The schedule was added.");
    assertThat(page.locator("tbody tr")).containsText("America/Bogota");
    picture(page, name + "-schedule-added");
    page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Pause").setExact(true))
        .click();
    assertThat(page.locator("tbody tr")).containsText("Paused");
    page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Delete")).click();
    assertThat(page.locator("tbody tr")).hasCount(0);
  }

  /** One of each kind. */
  static void addSchedules(TestClient visitor) {
    Map<String, String> task =
        Map.of(
            "name", "Morning tour",
            "load", "2.5",
            "startStation", "Dock A",
            "goalStation", "Shelf 3",
            "zone", "Europe/Paris");
    for (Map<String, String> times :
        List.of(
            Map.of("when", "once", "first", "2098-07-01T15:00"),
            Map.of("when", "every", "first", "2098-07-01T15:00", "everyMinutes", "30"),
            Map.of("when", "weekly", "weekday", "MONDAY", "time", "08:00"))) {
      Map<String, String> form = new TreeMap<>(task);
      form.putAll(times);
      visitor.post("tasks/new", form);
    }
  }

  private static void choose(Page page, String table) {
    page.getByLabel("CSV file")
        .setInputFiles(
            new FilePayload("tasks.csv", "text/csv", table.getBytes(StandardCharsets.UTF_8)));
    page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Import tasks")).click();
  }

  @Test
  void theMapShowsARobotMove() {
    Page page = loggedIn(1280, 900, ColorScheme.LIGHT);
    assertThat(page.locator("#age")).containsText("Live");
    assertThat(page.locator("#robots li")).hasCount(6);
    Object before = pictureOf(page);

    move("r1", new Pose(5, 4.6, 0));

    page.waitForCondition(() -> !pictureOf(page).equals(before));
  }

  @Test
  void theMapFollowsARobotUntilItIsMoved() {
    Page page = loggedIn(1280, 900, ColorScheme.LIGHT);
    assertThat(page.locator("#robots li")).hasCount(6);
    Locator map = page.locator("#map");
    Locator following = page.locator("#following");
    clickMap(page, map, 4.2, 4.6);
    assertThat(following).containsText("Following r1");
    Object before = pictureOf(page);
    move("r1", new Pose(8, 2.2, 0));
    page.waitForCondition(() -> !pictureOf(page).equals(before));

    page.getByText("Stop following").click();
    assertThat(following).isHidden();
    map.click(); // in the middle, where the robot is
    assertThat(following).containsText("Following r1");
    picture(page, "map-following");
    map.press("ArrowLeft");
    assertThat(following).isHidden();

    page.navigate(server.root() + "robots/r5");
    page.getByText("Show on map").click();
    assertThat(following).containsText("Following r5");
    following.getByText("r5").click();
    assertThat(page.locator("h1")).hasText("Robot r5");
  }

  private void move(String name, Pose pose) {
    server
        .fleet()
        .changeRobots(
            robots ->
                robots.stream()
                    .map(robot -> robot.name().equals(name) ? driving(name, pose, 3) : robot)
                    .toList());
  }

  @Test
  void theMapShowsWhatIsInTheWay() {
    Page page = loggedIn(1280, 900, ColorScheme.LIGHT);
    assertThat(page.locator("#robots li")).hasCount(6);
    assertThat(page.locator("#attention")).not().containsText("Standstill");
    Object before = pictureOf(page);

    server.fleet().changeFloor(Hall.crowdedFloor());

    assertThat(page.locator("#attention")).containsText("r2, r3 at (2.25, 0.75)");
    assertThat(page.locator("#attention")).containsText("Charger C1 does not charge");
    page.waitForCondition(() -> !pictureOf(page).equals(before));
    page.getByText("Legend").click();
    page.locator(".legend").getByText("Standstill").scrollIntoViewIfNeeded();
    picture(page, "map-in-the-way");

    Object crowded = pictureOf(page);
    server
        .fleet()
        .changeFloor(new FloorView("hall", null, CellRuns.NONE, Map.of(), List.of(), List.of()));

    page.waitForCondition(() -> !pictureOf(page).equals(crowded));
    assertThat(page.locator("#attention")).not().containsText("Standstill");
  }

  @Test
  void whatIsMostUrgentComesFirst() {
    server.fleet().changeFloor(Hall.crowdedFloor());
    Page page = loggedIn(1280, 900, ColorScheme.LIGHT);

    assertThat(page.locator("#attention strong"))
        .hasText(new String[] {"r5", "Standstill", "r6", "r4", "Charger"});
  }

  @Test
  void theRobotsAreNarrowedDownToAState() {
    Page page = loggedIn(1280, 900, ColorScheme.LIGHT);
    assertThat(page.locator("#robots li")).hasCount(6);
    Object all = pictureOf(page);
    Locator driving = page.locator("#counts button").filter(having("Driving"));

    driving.click();

    assertThat(page.locator("#robots strong")).hasText(new String[] {"r1"});
    assertThat(driving).hasAttribute("aria-pressed", "true");
    page.waitForCondition(() -> !pictureOf(page).equals(all));
    picture(page, "map-narrowed");
    page.locator("#counts button").filter(having("On hold")).click();
    assertThat(page.locator("#robots strong")).hasText(new String[] {"r1", "r3"});
    server.fleet().changeRobots(robots -> robots.subList(1, 6));
    assertThat(page.locator("#robots strong")).hasText(new String[] {"r3"});
    assertThat(driving).containsText("0");
    driving.click();
    page.locator("#counts button").filter(having("On hold")).click();
    assertThat(page.locator("#robots li")).hasCount(5);
    assertThat(driving).hasCount(0);
  }

  private static Locator.FilterOptions having(String text) {
    return new Locator.FilterOptions().setHasText(text);
  }

  @Test
  void aFloorIsPutOnHoldOnTheMap() {
    server
        .fleet()
        .changeFloor(new FloorView("hall", null, CellRuns.NONE, Map.of(), List.of(), List.of()));
    for (int width : List.of(1280, 390)) {
      Page page = loggedIn(width, 900, ColorScheme.LIGHT);
      assertThat(page.locator("#floors")).containsText("Floor hall");

      page.getByText("Hold all robots of the floor").click();
      assertThat(page.locator("#floors"))
          .containsText("All robots of this floor are on hold by Max");
      page.getByText("Legend").scrollIntoViewIfNeeded();
      picture(page, "map-floor-on-hold-" + width);

      server.fleet().resumeFloor("hall", "Ann"); // elsewhere: the page follows
      assertThat(page.locator("#floors")).not().containsText("on hold by");
      assertThat(page.getByText("Hold all robots of the floor")).isVisible();
    }
  }

  @Test
  void theMapShowsWhoWasNotLetIn() {
    Page page = loggedIn(1280, 900, ColorScheme.LIGHT);
    assertThat(page.locator("#robots li")).hasCount(6);
    assertThat(page.locator("#attention li")).hasCount(3);
    Fault stranger =
        new Fault(
            "REFUSED", "10.0.0.9 was refused: it is neither this robot's server nor its leader.");

    server
        .fleet()
        .changeRobots(
            robots ->
                robots.stream()
                    .map(
                        r ->
                            switch (r.name()) {
                              case "r2" -> troubled(r, List.of(stranger), null);
                              case "r3" -> troubled(r, List.of(), "r3 has another key.");
                              default -> r;
                            })
                    .toList());

    assertThat(page.locator("#attention li")).hasCount(5);
    assertThat(page.locator("#attention")).containsText("10.0.0.9 was refused");
    assertThat(page.locator("#attention")).containsText("r3 has another key.");
    picture(page, "map-not-let-in");
  }

  @Test
  void aRobotIsTakenOutOfServiceOnItsPage() {
    Page page = loggedIn(1280, 900, ColorScheme.LIGHT);
    page.navigate(server.root() + "robots/r2");
    page.getByText("Take out of service").click();
    assertThat(page.locator("#service")).containsText("make sure that the robot is not there");
    page.getByText("Confirm out of service").click();

    assertThat(page.locator(".heading .state")).hasText("Out of service");
    assertThat(page.getByText("Confirm release")).hasCount(0);
    server
        .fleet()
        .changeFloor(
            new FloorView(
                "hall",
                null,
                CellRuns.NONE,
                Map.of("r2", new CellRuns(List.of(687, 1))),
                List.of(),
                List.of()));
    page.getByText("Release its place").click();
    picture(page, "robot-out-of-service");
    page.getByText("Put back in service").click();
    assertThat(page.locator(".heading .state")).hasText("Idle");
  }

  @ParameterizedTest
  @CsvSource({"1280, 900, desktop", "390, 844, phone"})
  void aManagerDisablesAUserAndIsNotDisabledHimself(int width, int height, String name) {
    Page page = loggedIn(width, height, ColorScheme.LIGHT);
    page.navigate(server.root() + "users");
    page.getByRole(AriaRole.LINK, link("Clara")).click();
    page.getByLabel("Disabled").check();
    picture(page, name + "-users-change");
    page.locator("main").getByText("Save", exactly()).last().click();
    assertThat(page.getByRole(AriaRole.STATUS)).containsText("The user was changed.");
    assertThat(page.locator(".heading")).containsText("Clerk, disabled");

    page.getByText("All users").click();
    page.getByRole(AriaRole.LINK, link("Max")).click();
    page.getByLabel("Disabled").check();
    page.locator("main").getByText("Save", exactly()).last().click();
    assertThat(page.locator("main").getByRole(AriaRole.ALERT))
        .containsText("This is the last manager.");
    picture(page, name + "-users-refused");
  }

  @ParameterizedTest
  @CsvSource({"1280, 900, LIGHT, desktop", "1280, 900, DARK, dark", "390, 844, LIGHT, phone"})
  void aManagerMakesATokenAndALinkAndEndsASession(
      int width, int height, ColorScheme scheme, String name) {
    Page page = loggedIn(width, height, scheme);
    TestClient.signedIn(server.root(), WebTestServer.MANAGER).close();
    page.navigate(server.root() + "users");
    page.getByRole(AriaRole.LINK, link("Max")).click();
    page.getByLabel("Token name").fill("Night shift");
    page.getByText("Create token").click();
    assertThat(page.locator(".secret")).hasText(Pattern.compile("[A-Za-z0-9_-]{43}"));
    assertThat(page.locator("tbody tr")).hasCount(3);
    picture(page, name + "-user-token");
    assertFits(page);
    Locator other =
        page.locator("tbody tr")
            .filter(new Locator.FilterOptions().setHasText("Browser").setHasNotText("current"));
    other.getByText("End", exactly()).click();
    assertThat(page.locator("tbody tr")).hasCount(2);
    assertThat(page.getByRole(AriaRole.STATUS)).containsText("The session has ended.");

    page.getByText("All users").click();
    picture(page, name + "-users");
    page.getByRole(AriaRole.LINK, link("Clara")).click();
    page.getByText("Create password link").click();
    String reset = page.locator(".secret").textContent();
    picture(page, name + "-user-link");
    assertFits(page);
    page.context().clearCookies();
    page.navigate(server.root() + reset.substring(reset.indexOf("reset?")));
    picture(page, name + "-reset");
    page.getByLabel("New password").fill("a sentence of my own");
    page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Reset password")).click();
    assertThat(page.getByRole(AriaRole.STATUS)).containsText("Your password was reset.");
    page.getByLabel("Name").fill("Clara");
    page.getByLabel("Password", new Page.GetByLabelOptions().setExact(true))
        .fill("a sentence of my own");
    page.getByRole(AriaRole.BUTTON)
        .filter(new Locator.FilterOptions().setHasText("Log in"))
        .click();
    assertThat(page.locator("#age")).containsText("Live");
  }

  @ParameterizedTest
  @CsvSource({"1280, 900, desktop", "390, 844, phone"})
  void aManagerChangesARobotAndRemovesIt(int width, int height, String name) {
    Page page = loggedIn(width, height, ColorScheme.LIGHT);
    page.navigate(server.root() + "robots/r1");
    Locator form = page.locator("#change");
    form.getByLabel("Address").fill("not a host");
    form.getByText("Save", exactly()).click();
    assertThat(page.locator("#change-host-help")).isVisible();
    form.getByLabel("Address").fill("10.0.0.8");
    form.getByText("Save", exactly()).click();
    assertThat(page.locator("dl").first()).containsText("10.0.0.8:");

    page.getByText("Take out of service").click();
    page.locator("#service button.danger").click();
    assertThat(page.locator(".heading .state")).hasText("Out of service");
    form.getByText("Remove robot").click();
    form.scrollIntoViewIfNeeded();
    picture(page, name + "-robot-change");
    assertFits(page);
    form.getByText("Confirm removal").click();
    assertThat(page.getByRole(AriaRole.STATUS)).containsText("The robot was removed.");
    assertThat(page.locator("main")).not().containsText("r1");
  }

  @ParameterizedTest
  @CsvSource({"1280, 900, en", "390, 844, en", "1280, 900, ar", "390, 844, ar"})
  void whatAnotherManagerHasStoredMeanwhileStandsBesideTheEntries(
      int width, int height, String language) {
    Page page = loggedIn(width, height, ColorScheme.LIGHT);
    page.navigate(server.root() + "language/" + language);
    page.navigate(server.root() + "robots/r2");
    Locator form = page.locator("#change");
    form.locator("#change-port").fill("7400");
    form.locator("#parking").selectOption("P2");
    try (TestClient other = TestClient.signedIn(server.root(), WebTestServer.MANAGER)) {
      Map<String, String> stored =
          Map.of("host", "10.0.0.9", "port", "7300", "maxLoad", "5", "parking", "P3");
      assertEquals(303, other.post("robots/r2/change", stored).statusCode());
    }
    form.locator("button").first().click();

    assertThat(page.locator("main > [role=alert]")).isVisible();
    assertThat(form.locator("#change-host-help")).containsText("10.0.0.9");
    assertThat(form.locator("#change-port-help")).containsText("7300");
    assertThat(form.locator("#parking-help")).containsText("P3");
    assertThat(form.locator("#maxLoad-help")).hasCount(0);
    assertThat(page.locator("#pair #port")).hasValue("7300");
    assertThat(page.locator("#pair [aria-invalid]")).hasCount(0);
    assertThat(form.locator("#change-port")).hasValue("7400");
    assertThat(form.locator("#parking")).hasValue("P2");
    picture(page, "robot-rivals-top-" + width + language);
    form.scrollIntoViewIfNeeded();
    picture(page, "robot-rivals-" + width + language);
    assertFits(page);
    form.locator("button").first().click();
    assertThat(page.locator("main > [role=alert]")).hasCount(0);
    assertThat(page.locator("dl").first()).containsText(":7400");
    assertThat(page.locator("dl").first()).containsText("P2");
  }

  @Test
  void theApiIsTriedOutOnItsPage() {
    Page page = loggedIn(1280, 900, ColorScheme.LIGHT);
    page.navigate(server.root() + "api");
    Locator pause =
        page.locator(".opblock-post")
            .filter(new Locator.FilterOptions().setHasText("/api/v1/fleet/pause"));
    pause.locator(".opblock-summary-control").click();
    pause.getByText("Try it out").click();
    pause.getByText("Execute", exactly()).click();

    assertThat(pause.locator(".live-responses-table tbody .response-col_status"))
        .containsText("200");
    assertThat(page.locator("#pause")).containsText("All robots are paused");
    picture(page, "api-tried");
  }

  @Test
  void aPartThatComesAnewLeavesOpenWhatTheReaderOpened() {
    Page page = loggedIn(1280, 900, ColorScheme.LIGHT);
    AtomicReference<@Nullable Route> refresh = new AtomicReference<>();
    page.route(
        server.root() + "robots/r1",
        route -> {
          if (!route.request().resourceType().equals("fetch")
              || !refresh.compareAndSet(null, route)) {
            route.resume();
          }
        });
    page.navigate(server.root() + "robots/r1");
    page.waitForCondition(() -> refresh.get() != null);
    Locator summary = page.getByText("Take out of service");
    summary.focus();
    page.keyboard().press("Enter");
    assertThat(page.locator("#service button.danger")).isVisible();

    Route route = requireNonNull(refresh.get());
    String anew = route.fetch().text().replace("id=\"service\"", "id=\"service\" data-anew");
    route.fulfill(new Route.FulfillOptions().setBody(anew).setContentType("text/html"));

    assertThat(page.locator("#service[data-anew] button.danger")).isVisible();
    assertThat(summary).isFocused();
  }

  private static void assertFits(Page page) {
    assertFalse((Boolean) page.evaluate("document.documentElement.scrollWidth > innerWidth"));
  }

  private static Page.GetByRoleOptions link(String name) {
    return new Page.GetByRoleOptions().setName(name).setExact(true);
  }

  private static Locator.GetByTextOptions exactly() {
    return new Locator.GetByTextOptions().setExact(true);
  }

  @Test
  void theMapSaysWhenTheServerIsAway() throws Exception {
    Page page = loggedIn(1280, 900, ColorScheme.LIGHT);
    assertThat(page.locator("#age")).containsText("Live");
    assertThat(page.locator("#banner")).isHidden();
    int port = server.root().getPort();

    server.close();

    assertThat(page.locator("#banner")).containsText("Connection to the server lost.");
    picture(page, "map-away");
    try (WebTestServer _ = WebTestServer.start(port)) {
      // it is found again; its database is another one, without this session
      assertThat(page.locator("#banner"))
          .containsText(
              "Your session has ended.",
              new LocatorAssertions.ContainsTextOptions().setTimeout(20_000));
    }
  }

  @ParameterizedTest
  @CsvSource({"1280, 900, LIGHT, desktop", "1280, 900, DARK, dark", "390, 844, LIGHT, phone"})
  void everyPageFitsItsScreen(int width, int height, ColorScheme scheme, String name) {
    try (TestClient visitor = TestClient.signedIn(server.root(), WebTestServer.CLERK)) {
      for (String task : List.of("Box of bolts", "Pallet of gear wheels for line 4", "Samples")) {
        visitor.post(
            "tasks/new",
            Map.of(
                "name",
                task,
                "load",
                "2.5",
                "startStation",
                "Dock A",
                "goalX",
                "9",
                "goalY",
                "1.05"));
      }
    }
    try (TestClient visitor = TestClient.signedIn(server.root(), WebTestServer.CLERK)) {
      addSchedules(visitor);
    }
    server.fleet().changeTask(2, TaskState.CARRYING, List.of("r1"), "r1 carries the load.");
    server.fleet().changeTask(3, TaskState.DONE, List.of("r2"), "r2 has parked.");
    server.fleet().changeFloor(Hall.crowdedFloor());
    Page page = loggedIn(width, height, scheme);
    assertThat(page.locator("#robots li")).hasCount(6);
    for (String path :
        List.of(
            "map",
            "tasks",
            "tasks/new",
            "tasks/import",
            "schedules",
            "tasks/2",
            "robots",
            "robots/r5",
            "users",
            "statistics",
            "api",
            "nothing")) {
      page.navigate(server.root() + path);
      if (path.equals("api")) {
        assertThat(page.locator(".opblock")).not().hasCount(0);
      }
      if (path.equals("map")) {
        assertThat(page.locator("#age")).containsText("Live");
        assertThat(page.locator("#robots li")).hasCount(6);
      }
      picture(page, name + "-" + path.replace('/', '-'));
      assertFalse(
          (Boolean) page.evaluate("document.documentElement.scrollWidth > innerWidth"),
          path + " is wider than the screen");
    }
    page.navigate(server.root() + "tasks/new");
    page.locator("form button[type=submit], form:not(.top form) button").last().click();
    assertThat(page.locator("[aria-invalid=true], :user-invalid").first()).isVisible();
    page.waitForLoadState();
    picture(page, name + "-tasks-new-refused");
    page.context().clearCookies();
    page.navigate(server.root().toString());
    picture(page, name + "-login");
  }

  private Page loggedIn(int width, int height, ColorScheme scheme) {
    BrowserContext context =
        browser.newContext(
            new Browser.NewContextOptions()
                .setViewportSize(width, height)
                .setColorScheme(scheme)
                .setTimezoneId("America/Bogota"));
    Page page = context.newPage();
    page.setDefaultTimeout(10_000);
    page.onPageError(complaints::add);
    page.onConsoleMessage(
        message -> {
          if (message.type().equals("error")
              && !message.text().startsWith("Failed to load resource")) {
            complaints.add(message.text());
          }
        });
    page.navigate(server.root().toString());
    page.getByLabel("Name").fill(WebTestServer.MANAGER);
    page.getByLabel("Password").fill(WebTestServer.PASSWORD);
    page.locator("main button").click();
    assertThat(page.locator("#map")).isVisible();
    return page;
  }

  /**
   * Clicks where the floor of 12 m x 6 m, fitted into the canvas with its margin, has the point.
   */
  static void clickMap(Page page, Locator map, double x, double y) {
    page.waitForFunction("document.querySelector('#map').width > 300");
    double width = map.boundingBox().width;
    double height = map.boundingBox().height;
    double scale = Math.min((width - 32) / 12, (height - 32) / 6);
    map.click(
        new Locator.ClickOptions()
            .setPosition(width / 2 + (x - 6) * scale, height / 2 - (y - 3) * scale));
  }

  private static Object pictureOf(Page page) {
    return page.evaluate("document.querySelector('#map').toDataURL()");
  }

  private static void picture(Page page, String name) {
    page.screenshot(new Page.ScreenshotOptions().setPath(PICTURES.resolve(name + ".png")));
  }

  static List<RobotView> fleetAtWork() {
    return List.of(
        driving("r1", new Pose(4.2, 4.6, 0.3), 2),
        robot("r2", RobotState.IDLE, new Pose(2.25, 0.75, Math.PI / 2)),
        robot("r3", RobotState.HOLDING, new Pose(7.4, 2.8, Math.PI)),
        robot("r4", RobotState.NOT_LOCALISED, new Pose(10.2, 3.6, -1)),
        robot("r5", RobotState.ERROR, new Pose(8.8, 4.6, 2.3)),
        robot("r6", RobotState.LOST, new Pose(3.4, 2.2, 0)));
  }

  private static RobotView driving(String name, Pose pose, long task) {
    RobotView still = robot(name, RobotState.DRIVING, pose);
    return new RobotView(
        name,
        still.floor(),
        still.state(),
        pose,
        0.84,
        task,
        Phase.TO_GOAL,
        5,
        0.255,
        0.25,
        "127.0.0.1",
        7275,
        "P1",
        true,
        List.of(new Vec2(5.4, 4.6), new Vec2(6.15, 3.15), new Vec2(8, 3.1), new Vec2(9, 1.05)),
        2,
        List.of(),
        Phrase.CARRIES_LOAD.with(task),
        Hall.START,
        false,
        null,
        null,
        null);
  }

  private static RobotView troubled(RobotView still, List<Fault> errors, @Nullable String alert) {
    return new RobotView(
        still.name(),
        still.floor(),
        still.state(),
        still.pose(),
        still.battery(),
        still.task(),
        still.phase(),
        still.maxLoad(),
        still.footprint(),
        still.speed(),
        still.host(),
        still.port(),
        still.parking(),
        still.simulated(),
        still.path(),
        still.released(),
        errors,
        still.doing(),
        still.lastSeen(),
        still.held(),
        still.charger(),
        still.fingerprint(),
        alert == null ? null : Sentence.verbatim(alert));
  }

  private static RobotView robot(String name, RobotState state, Pose pose) {
    RobotView still = Hall.robot(name, state, pose, "127.0.0.1", 7275);
    return state == RobotState.ERROR
        ? new RobotView(
            name,
            still.floor(),
            state,
            pose,
            0.12,
            null,
            Phase.NONE,
            5,
            0.255,
            0.25,
            "127.0.0.1",
            7275,
            "P3",
            true,
            List.of(),
            0,
            List.of(new Fault("BATTERY_LOW", "The battery is nearly empty.")),
            Phrase.HAS_FAULT.with("The battery is nearly empty."),
            Hall.START,
            false,
            null,
            null,
            null)
        : still;
  }
}
