package org.toqa.web.page;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static java.util.Objects.requireNonNull;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.microsoft.playwright.Locator;
import com.microsoft.playwright.Page;
import com.microsoft.playwright.Route;
import com.microsoft.playwright.options.AriaRole;
import com.microsoft.playwright.options.BoundingBox;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.accounts.Role;
import org.toqa.arm.ArmStep;
import org.toqa.arm.JointAngles;
import org.toqa.fleet.ManualOrder;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.RobotView.Readings;
import org.toqa.fleet.RobotView.Telemetry;
import org.toqa.geometry.Pose;
import org.toqa.grid.CellRuns;
import org.toqa.link.message.AgentMessage.ArmState;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.notices.Condition;
import org.toqa.notices.Notice;
import org.toqa.notices.NoticeKind;
import org.toqa.notices.NoticeStore.Change;
import org.toqa.testbed.Hall;
import org.toqa.testbed.Views;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;
import org.toqa.wording.Phrase;

/** What managers do with robots and users, in a real browser. */
class ManagerPagesInBrowserTest extends PagesInBrowser {
  @Test
  void aRobotIsTakenOutOfServiceOnItsPage() {
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "robots/r2");
    page.getByText("Take out of service").click();
    assertThat(page.locator("#service")).containsText("make sure that the robot is not there");
    page.getByText("Confirm out of service").click();

    assertThat(page.locator(".heading .state")).hasText("Out of service");
    assertThat(page.getByText("Confirm release")).hasCount(0);
    server
        .fleet()
        .changeFloor(
            Views.floor(
                "hall",
                null,
                CellRuns.NONE,
                Map.of("r2", new CellRuns(List.of(687, 1))),
                List.of(),
                List.of(),
                List.of(),
                null));
    page.getByText("Release its place").click();
    assertThat(page.getByText("Confirm release")).isVisible();
    picture(page, "robot-out-of-service");
    page.getByText("Put back in service").click();
    assertThat(page.locator(".heading .state")).hasText("Idle");
  }

  @Test
  void aSupervisorIsStartedWatchedHelpedAndStopped() {
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "floors");

    assertEquals(List.of(), new SupervisionWalk(server, page).walk());
  }

  /** He adds a user, plans a task, changes the map, pauses the fleet and looks at what there is. */
  @ParameterizedTest
  @CsvSource({"en, true", "ar, false"})
  void aManagersDay(String language, boolean byKeyboard) {
    Screen screen = byKeyboard ? DESK : PHONE;
    Day day = dayOf(WebTestServer.MANAGER, language, byKeyboard);
    Page page = day.page();
    day.go("users");
    day.write("#name", "Nina-" + language);
    day.write("#password", WebTestServer.PASSWORD);
    day.choose("#role", "OPERATOR");
    day.press("main article form button");
    assertThat(page.locator(".notice.good")).isVisible();
    assertThat(page.locator("tbody")).containsText("Nina-" + language);

    day.go("tasks");
    day.press("main a[href$='/tasks/new']");
    day.write("#name", "Morning tour");
    day.write("#load", "2.5");
    day.choose("#startStation", "Dock A");
    day.choose("#goalStation", "Shelf 3");
    day.choose("#when", "weekly");
    day.press("[name=weekday][value=MONDAY]");
    day.write("#time", byKeyboard ? "0800AM" : "08:00");
    day.press("form.task > .choices button:not([formaction])");
    assertThat(page.locator("tbody tr")).containsText("Morning tour");
    assertThat(page.locator("tbody tr")).containsText("08:00");

    changeMap(day);
    assertFits(page, "manager-map-" + language, screen);

    day.press("#pause form[action$='/pause'] button");
    assertThat(page.locator("#pause.paused")).isVisible();
    day.press("#pause summary");
    day.press("#pause form[action$='/resume'] button");
    assertThat(page.locator("#pause.paused")).hasCount(0);

    Condition refused =
        new Condition(
            NoticeKind.SCHEDULE_REFUSED,
            language,
            "hall",
            null,
            null,
            null,
            Phrase.SCHEDULE_REFUSED.with(1, "Max", Phrase.NO_SUCH_FLOOR.with("attic")));
    Notice notice = new Notice(0, UUID.randomUUID(), refused, Instant.now(), null);
    server.notices().add(List.of(new Change(notice, false, List.of())), Instant.now(), _ -> false);
    day.press(".bell");
    assertThat(page.locator("tbody tr").first()).containsText("attic");
    day.press("tbody form[action$='/seen'] button");
    assertThat(page.locator("tbody form[action$='/seen']")).hasCount(0);
    assertFits(page, "manager-notices-" + language, screen);
    day.go("statistics");
    assertThat(page.locator("h1")).isVisible();
    day.go("settings");
    assertThat(page.locator("#logLevel")).isVisible();
    day.logOut();
  }

  /** Draws something, and publishes it. */
  private static void changeMap(Day day) {
    Page page = day.page();
    day.go("floors");
    day.press("main a[href$='/edit']");
    assertThat(page.locator("#things li")).hasCount(6);
    day.press("[data-tool=parking]");
    if (day.hand() instanceof Hand.Keyboard keyboard) {
      keyboard.reach(page.locator("#map"));
      page.keyboard().press("ArrowRight");
      page.keyboard().press("Shift+ArrowRight");
      page.keyboard().press("Enter");
    } else {
      clickMap(page, page.locator("#map"), 8.25, 3.15);
    }
    assertThat(page.locator("#things li")).hasCount(7);
    day.press("#publish");
    day.press("#publish-sure");
    assertThat(page.locator("#publishing")).isHidden();
    assertThat(page.locator("#problems-summary")).isVisible();
  }

  @ParameterizedTest
  @ValueSource(strings = {"en", "ar"})
  void hundredsOfRobotsAreSearchedPageByPageAndTheAddressKeepsIt(String language) {
    server
        .fleet()
        .changeRobots(
            _ ->
                IntStream.rangeClosed(1, 120)
                    .mapToObj(
                        n ->
                            robot(
                                "cart-" + n,
                                n % 40 == 0 ? RobotState.LOST : RobotState.IDLE,
                                new Pose(2, 2, 0)))
                    .toList());
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "language/" + language);
    page.navigate(server.root() + "robots");
    assertThat(page.locator("tbody tr")).hasCount(50);
    page.locator("a[rel=next]").click();
    page.locator("a[rel=next]").click();
    assertThat(page.locator("tbody tr")).hasCount(20);
    assertFits(page, "robots-many-" + language, DESK, PHONE);

    page.locator("main details summary").first().click();
    page.locator("input[name=text]").fill("CART-8");
    page.locator(".filter button").click();
    assertThat(page.locator("tbody tr")).hasCount(11); // 8 and 80 to 89
    page.locator("select[name=state]").selectOption("LOST");
    page.locator(".filter button").click();
    assertThat(page.locator("tbody th")).hasText("cart-80");
    page.reload();
    assertThat(page.locator("tbody th")).hasText("cart-80");
    page.navigate(server.root() + "robots?state=FLYING");
    assertThat(page.locator("select[name=state]")).isFocused();
    assertFits(page, "robots-refused-" + language, DESK, PHONE);
  }

  @ParameterizedTest
  @ValueSource(strings = {"en", "ar"})
  void anOperatorKeepsRobotsGoingAndAViewerLooks(String language) {
    server.addUser("Otto-" + language, null, Role.OPERATOR);
    server.addUser("Vera-" + language, null, Role.VIEWER);
    Page page = loggedIn("Otto-" + language, DESK, "language/" + language);
    page.navigate(server.root() + "robots/r2");
    assertThat(page.locator("#service details")).hasCount(1);
    assertThat(page.locator("#change")).hasCount(0);
    click(page.locator("#service summary"));
    click(page.locator("#service button.danger"));
    assertThat(page.locator("#service details")).hasCount(0);
    click(page.locator("#service button"));
    assertThat(page.locator("#service details")).hasCount(1);
    server
        .fleet()
        .changeFloor(
            Views.floor(
                "hall", null, CellRuns.NONE, Map.of(), List.of(), List.of(), List.of(), null));
    page.navigate(server.root() + "map");
    assertThat(page.locator("#floors button")).hasCount(1);
    assertFits(page, "operator-" + language, DESK, PHONE);

    page = loggedIn("Vera-" + language, DESK, "language/" + language);
    page.navigate(server.root() + "robots/r2");
    assertThat(page.locator("h1")).isVisible();
    assertThat(page.locator("main form")).hasCount(0);
    for (String path : List.of("tasks", "map", "schedules", "loads", "floors", "robots")) {
      page.navigate(server.root() + path);
      assertThat(page.locator("#pause button")).hasCount(0);
      assertThat(page.locator("main form[method=post]")).hasCount(0);
      assertThat(page.locator("a[href$='/tasks/new']")).hasCount(0);
    }
    assertFits(page, "viewer-" + language, DESK, PHONE);
  }

  @Test
  void whatIsSeldomWantedIsInAMenuThatTheKeyboardOpensAndCloses() {
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "tasks");
    Locator more = page.locator(".more summary");
    more.focus();
    page.keyboard().press("Enter");
    for (String entry : List.of("History", "Schedules", "Loads", "Import tasks", "API")) {
      assertThat(page.locator(".more").getByText(entry, exactly())).isVisible();
    }
    Locator last = page.locator(".more li").last();
    assertThat(last).isInViewport();
    assertThat(page.locator(".more").getByText("Statistics")).isHidden();
    assertFits(page, "menu", PHONE);
    assertThat(page.locator(".more").getByText("Statistics")).isInViewport();
    assertThat(last).isInViewport();
    page.keyboard().press("Escape");
    assertThat(page.locator(".more").getByText("History")).isHidden();
    assertThat(more).isFocused();
    page.keyboard().press("Enter");
    page.keyboard().press("Tab");
    page.keyboard().press("Tab");
    page.keyboard().press("Tab");
    page.keyboard().press("Enter");
    assertThat(page.locator("h1")).hasText("History");
  }

  @Test
  void aManagerDisablesAUserAndIsNotDisabledHimself() {
    server.addUser("Dora", null, Role.CLERK);
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "users");
    click(page.getByRole(AriaRole.LINK, link("Dora")));
    page.getByLabel("Disabled").check();
    assertFits(page, "users-change", PHONE, DESK);
    click(page.locator("main").getByText("Save", exactly()).last());
    assertThat(page.getByRole(AriaRole.STATUS)).containsText("The user was changed.");
    assertThat(page.locator(".heading")).containsText("Clerk, disabled");

    click(page.getByText("All users"));
    click(page.getByRole(AriaRole.LINK, link("Max")));
    page.getByLabel("Disabled").check();
    click(page.locator("main").getByText("Save", exactly()).last());
    assertThat(page.locator("main").getByRole(AriaRole.ALERT))
        .containsText("This is the last manager.");
    assertFits(page, "users-refused", PHONE, DESK);
  }

  @Test
  void aManagerSaysWhatBecomesOfADeletedUsersTasks() {
    server.addUser("Gina", null, Role.CLERK);
    try (TestClient gina = TestClient.signedIn(server.root(), "Gina")) {
      gina.postJson(
          "api/v1/tasks",
          "{\"name\":\"box\",\"load\":1,\"start\":{\"station\":\"Dock A\"},"
              + "\"goal\":{\"x\":9,\"y\":1.05}}");
    }
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "users");
    click(page.getByRole(AriaRole.LINK, link("Gina")));
    click(page.getByText("Delete user"));
    assertThat(page.getByLabel("1 open tasks")).hasValue("handOver");
    assertFits(page, "user-delete", DARK, PHONE, DESK);
    page.getByLabel("Hand over to").selectOption("Clara");
    click(page.getByText("Confirm deletion"));

    assertThat(page.getByRole(AriaRole.STATUS)).containsText("The user was deleted.");
    page.navigate(server.root() + "tasks");
    assertThat(page.locator("tbody")).containsText("Clara");
  }

  @Test
  void aManagerMakesATokenAndALinkAndEndsASession() {
    server.addUser("Eve", null, Role.CLERK);
    endSessions();
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "map");
    TestClient.signedIn(server.root(), WebTestServer.MANAGER).close();
    page.navigate(server.root() + "users");
    click(page.getByRole(AriaRole.LINK, link("Max")));
    page.getByLabel("Token name").fill("Night shift");
    click(page.getByText("Create token"));
    assertThat(page.locator("#scopes-help")).isVisible();
    assertFits(page, "user-token-refused", DARK, PHONE, DESK);
    page.getByLabel("Read metrics").check();
    page.locator("#token-password").fill(WebTestServer.PASSWORD);
    click(page.getByText("Create token"));
    assertThat(page.locator(".secret")).hasText(Pattern.compile("[A-Za-z0-9_-]{43}"));
    assertThat(page.locator("tbody tr")).hasCount(3);
    assertFits(page, "user-token", DARK, PHONE, DESK);
    Locator other =
        page.locator("tbody tr")
            .filter(new Locator.FilterOptions().setHasText("Browser").setHasNotText("current"));
    click(other.getByText("End", exactly()));
    click(other.getByText("Confirm the end"));
    assertThat(page.locator("tbody tr")).hasCount(2);
    assertThat(page.getByRole(AriaRole.STATUS)).containsText("The session has ended.");

    click(page.getByText("All users"));
    assertThat(page.getByRole(AriaRole.LINK, link("Eve"))).isVisible();
    assertFits(page, "users", DARK, PHONE, DESK);
    click(page.getByRole(AriaRole.LINK, link("Eve")));
    click(page.getByText("Create password link"));
    String reset = page.locator(".secret").textContent();
    assertFits(page, "user-link", DARK, PHONE, DESK);
    page.context().clearCookies();
    page.navigate(server.root() + reset.substring(reset.indexOf("reset?")));
    assertFits(page, "reset", DARK, PHONE, DESK);
    page.getByLabel("New password").fill("a sentence of my own");
    click(page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Reset password")));
    assertThat(page.getByRole(AriaRole.STATUS)).containsText("Your password was reset.");
    page.getByLabel("Name").fill("Eve");
    page.getByLabel("Password", new Page.GetByLabelOptions().setExact(true))
        .fill("a sentence of my own");
    click(page.getByRole(AriaRole.BUTTON).filter(new Locator.FilterOptions().setHasText("Log in")));
    assertThat(page.locator("#age")).containsText("Live");
  }

  @Test
  void aManagerChangesARobotAndRemovesIt() {
    Page page = loggedIn(WebTestServer.MANAGER, PHONE, "robots/r1");
    Locator form = page.locator("#change");
    form.getByLabel("Address").fill("not a host");
    click(form.getByText("Save", exactly()));
    assertThat(page.locator("#change-host-help")).isVisible();
    form.getByLabel("Address").fill("10.0.0.8");
    click(form.getByText("Save", exactly()));
    assertThat(page.locator("dl").first()).containsText("10.0.0.8:");

    click(page.getByText("Take out of service"));
    click(page.locator("#service button.danger"));
    assertThat(page.locator(".heading .state")).hasText("Out of service");
    click(form.getByText("Remove robot"));
    form.scrollIntoViewIfNeeded();
    assertFits(page, "robot-change", PHONE, DESK);
    click(form.getByText("Confirm removal"));
    assertThat(page.getByRole(AriaRole.STATUS)).containsText("The robot was removed.");
    assertThat(page.locator("main")).not().containsText("r1");
  }

  @ParameterizedTest
  @ValueSource(strings = {"en", "ar"})
  void whatAnotherManagerHasStoredMeanwhileStandsBesideTheEntries(String language) {
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "language/" + language);
    page.navigate(server.root() + "robots/r2");
    Locator form = page.locator("#change");
    form.locator("#change-port").fill("7400");
    form.locator("#parking").selectOption("P2");
    try (TestClient other = TestClient.signedIn(server.root(), WebTestServer.MANAGER)) {
      Map<String, String> stored =
          Map.of("host", "10.0.0.9", "port", "7300", "maxLoad", "5", "parking", "P3");
      assertEquals(303, other.post("robots/r2/change", stored).statusCode());
    }
    click(form.locator("button").first());

    assertThat(page.locator("main > [role=alert]")).isVisible();
    for (Screen screen : List.of(PHONE, DESK)) {
      screen.show(page);
      assertThat(form.locator("#change-host-help")).containsText("10.0.0.9");
      assertThat(form.locator("#change-port-help")).containsText("7300");
      assertThat(form.locator("#parking-help")).containsText("P3");
      assertThat(form.locator("#maxLoad-help")).hasCount(0);
      assertThat(page.locator("#pair #port")).hasValue("7300");
      assertThat(page.locator("#pair [aria-invalid]")).hasCount(0);
      assertThat(form.locator("#change-port")).hasValue("7400");
      assertThat(form.locator("#parking")).hasValue("P2");
      form.scrollIntoViewIfNeeded();
      assertFits(page, "robot-rivals-" + language, screen);
    }
    click(form.locator("button").first());
    assertThat(page.locator("main > [role=alert]")).hasCount(0);
    assertThat(page.locator("dl").first()).containsText(":7400");
    assertThat(page.locator("dl").first()).containsText("P2");
  }

  @Test
  void aRobotIsDrivenByHandAsLongAsAButtonOrAKeyIsPressed() {
    Page page = loggedIn(WebTestServer.MANAGER, PHONE, "robots/r2/control");
    int begun = server.fleet().manualOrders().size();
    button(page, "Drive by hand").click();
    Locator forward = button(page, "Forward");
    assertFits(page, "control-hand", DARK_PHONE, PHONE);
    int before = server.fleet().manualOrders().size();
    assertStaysUnderTheThumb(page, forward);
    forward.hover();
    page.mouse().down();
    assertThat(forward).hasClass(Pattern.compile("\\bpressed\\b"));
    page.waitForCondition(() -> server.fleet().manualOrders().size() > before + 3);
    assertEquals(ManualOrder.MAX_SPEED, lastManualOrder().speed());
    page.mouse().up();
    page.waitForCondition(() -> lastManualOrder().isStop());

    page.keyboard().down("ArrowUp");
    page.keyboard().down("ArrowLeft");
    page.waitForCondition(() -> lastManualOrder().turnRate() > 0 && lastManualOrder().speed() > 0);
    page.keyboard().up("ArrowUp");
    page.keyboard().up("ArrowLeft");
    page.waitForCondition(() -> lastManualOrder().isStop());

    page.keyboard().down("ArrowDown");
    page.waitForCondition(() -> lastManualOrder().speed() < 0);
    page.evaluate("dispatchEvent(new Event('blur'))"); // another window is before it
    page.waitForCondition(() -> lastManualOrder().isStop());
    List<Long> numbers =
        server.fleet().manualOrders().stream().skip(begun).map(ManualOrder::number).toList();
    assertEquals(numbers.stream().distinct().toList(), numbers);

    button(page, "Stop driving by hand").click();
    assertThat(button(page, "Drive by hand")).isVisible();
    page.waitForCondition(() -> driver("r2") == null);
  }

  /** Though the line is lost, which is said above it. */
  private static void assertStaysUnderTheThumb(Page page, Locator button) {
    BoundingBox place = button.boundingBox();
    page.evaluate("document.querySelector('#connection').hidden = false");
    assertThat(page.locator("#connection")).isVisible();
    assertEquals(place.y, button.boundingBox().y);
    page.evaluate("document.querySelector('#connection').hidden = true");
  }

  private ManualOrder lastManualOrder() {
    return server.fleet().manualOrders().getLast();
  }

  private @Nullable String driver(String robot) {
    return server.fleet().snapshots().latest().robots().stream()
        .filter(r -> r.name().equals(robot))
        .findFirst()
        .orElseThrow()
        .work()
        .driver();
  }

  @Test
  void aRobotIsStoppedAndStartedOnItsControlPageWhichSaysWhoDrivesIt() {
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "robots/r2/control");
    button(page, "Stop").first().click();
    assertThat(page.locator(".heading .state")).hasText("On hold");
    button(page, "Start").click();
    assertThat(page.locator(".heading .state")).hasText("Idle");
    var _ = server.fleet().driveByHand("r2", new ManualOrder(null, 1, 0, 0), "Ana");
    assertThat(page.locator("#driver")).hasText("Ana drives r2 by hand.");
    assertThat(button(page, "Drive by hand")).isDisabled();
    page.navigate(server.root() + "robots/r1/control");
    assertThat(page.locator("#value-crossTrack")).hasText("12 mm");
    assertThat(page.locator("#value-heading")).hasText("-1.7°"); // -0.03 rad
    assertFits(page, "control", DARK, PHONE, DESK);
    assertEquals(
        "0 0 359 180",
        page.evaluate(
            """
            async () => {
              const {headingDegrees} = await import('/assets/js/shared/angles.js');
              const format = new Intl.NumberFormat('en').format;
              return [-0.001, 6.283, -0.0175, -3.1416].map((theta) => format(headingDegrees(theta))).join(' ');
            }
            """));
  }

  @Test
  void anArmIsShownOnTheControlPageAsItMoves() {
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "robots/r2/control");
    assertThat(page.locator("#arm")).isHidden();
    showArm(new ArmState(new JointAngles(0, Math.PI / 2), null, 7L, ArmStep.REACH));
    Locator facts = page.locator("#arm dd");
    String[] reaching = {
      "0°", "90°", "0.35 m ahead, 0.25 m to the left", "nothing", "reaches for the place"
    };
    assertThat(facts).hasText(reaching);
    // 0.3 m and 0.25 m from the shoulder 0.05 m ahead: 0.6 m are 95 of the picture
    assertThat(page.locator("#arm .links"))
        .hasAttribute("points", "0,-7.92 0,-55.42 -39.58,-55.42");
    showArm(new ArmState(new JointAngles(-Math.PI / 2, 0), 1.25, null, null));
    String[] holding = {
      "-90°", "0°", "0.05 m ahead, -0.55 m to the left", "1.25 kg", "does nothing"
    };
    assertThat(facts).hasText(holding);
    assertFits(page, "control-arm", DARK, PHONE, DESK);
  }

  private void showArm(ArmState arm) {
    Readings readings = new Readings(0.0, 0.0, List.of(), null, null, arm, null);
    server
        .fleet()
        .changeRobots(
            robots ->
                robots.stream()
                    .map(robot -> robot.name().equals("r2") ? withArm(robot, readings) : robot)
                    .toList());
  }

  private static RobotView withArm(RobotView robot, Readings readings) {
    Telemetry heard = robot.telemetry();
    return Hall.withArm(robot)
        .withTelemetry(
            new Telemetry(heard.pose(), heard.battery(), readings, List.of(), heard.lastSeen()));
  }

  @Test
  void whatWasDoneIsNotToldAgainAfterAReload() {
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "users?done=added");
    assertThat(page.getByRole(AriaRole.STATUS)).isVisible();
    assertThat(page).hasURL(server.root() + "users");
    page.reload();
    assertThat(page.locator("h1")).isVisible();
    assertThat(page.getByRole(AriaRole.STATUS)).hasCount(0);
  }

  @ParameterizedTest
  @ValueSource(strings = {"en", "ar"})
  void aStopIsClearedOnTheRobotsPage(String language) {
    RobotView robot = robot("r2", RobotState.ERROR, new Pose(2.25, 0.75, Math.PI / 2));
    List<Fault> stops =
        List.of(
            new Fault("STOP_EDGE", "Words of the robot.", true),
            new Fault("STOP_SWITCH", "Words of the robot.", true));
    server.fleet().changeRobots(_ -> List.of(withErrors(robot, stops)));
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "language/" + language);
    page.navigate(server.root() + "robots/r2");
    Locator card = page.locator("#stop");
    card.scrollIntoViewIfNeeded();
    assertFits(page, "robot-stop-" + language, PHONE, DESK);
    click(card.locator("summary"));
    card.scrollIntoViewIfNeeded();
    assertFits(page, "robot-stop-sure-" + language, PHONE, DESK);

    click(card.locator("button.danger"));

    assertThat(page.locator("#stop")).isHidden();
    picture(page, "robot-stop-cleared-" + language);
  }

  private static RobotView withErrors(RobotView robot, List<Fault> errors) {
    return robot.withTelemetry(robot.telemetry().withErrors(errors));
  }

  @Test
  void theApiIsTriedOutOnItsPage() {
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "api");
    page.locator(".opblock-tag").getByText("Floors and fleet", exactly()).click();
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
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "tasks");
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

  @Test
  void aPartThatTheServerCouldNotGiveIsAskedForAgain() {
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "tasks");
    AtomicInteger asked = new AtomicInteger();
    page.route(
        server.root() + "robots/r1",
        route -> {
          if (!route.request().resourceType().equals("fetch")) {
            route.resume();
            return;
          }
          switch (asked.incrementAndGet()) {
            case 1 ->
                route.fulfill(
                    new Route.FulfillOptions()
                        .setStatus(503)
                        .setContentType("text/html")
                        .setBody("<style>body {color: black}</style><p>Not now"));
            case 2 -> route.abort();
            default -> {
              String anew = route.fetch().text().replace("id=\"live\"", "id=\"live\" data-anew");
              route.fulfill(new Route.FulfillOptions().setBody(anew).setContentType("text/html"));
            }
          }
        });

    page.navigate(server.root() + "robots/r1");

    assertThat(page.locator("#live[data-anew]")).isVisible();
  }
}
