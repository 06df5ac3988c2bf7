package org.toqa.web.page;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.microsoft.playwright.Browser;
import com.microsoft.playwright.Locator;
import com.microsoft.playwright.Page;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.geometry.Pose;
import org.toqa.mission.TaskState;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;

/** What people order robots and tasks to do, in a real browser. */
class OrdersInBrowserTest extends PagesInBrowser {
  @Test
  void aRobotIsHeldAndGoesOnAndIsSentHome() {
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "robots/r2");
    Locator state = page.locator(".heading .state");
    assertThat(state).hasText("Idle");

    click(button(page, "Hold"));
    assertThat(state).hasText("On hold");
    assertEquals(RobotState.HOLDING, robot("r2").state());
    assertThat(button(page, "Hold")).hasCount(0);

    click(button(page, "Resume"));
    assertThat(state).hasText("Idle");
    assertEquals(RobotState.IDLE, robot("r2").state());

    click(button(page, "Send home"));
    assertThat(state).hasText("Driving");
    assertEquals(RobotState.DRIVING, robot("r2").state());
  }

  @Test
  void aClerkMayOrderNoRobot() {
    Page page = loggedIn(WebTestServer.CLERK, DESK, "robots/r2");

    assertThat(page.locator(".heading .state")).hasText("Idle");
    for (String order : List.of("Hold", "Resume", "Send home")) {
      assertThat(button(page, order)).hasCount(0);
    }
  }

  @Test
  void aTaskIsHeldAndGoesOn() {
    try (TestClient clerk = TestClient.signedIn(server.root(), WebTestServer.CLERK)) {
      clerk.post(
          "tasks/new",
          Map.of("name", "x", "load", "1", "startStation", "Dock A", "goalStation", "Shelf 3"));
    }
    server.fleet().changeTask(1, TaskState.CARRYING, List.of("r1"), "r1 carries the load.");
    Page page = loggedIn(WebTestServer.CLERK, DESK, "tasks/1");
    Locator held = page.locator("#live .notice").getByText("On hold", exactly());
    assertThat(page.locator("[aria-current=step]")).hasText("Carrying");
    assertThat(held).hasCount(0);

    click(button(page, "Hold"));
    assertThat(held).isVisible();
    assertTrue(server.fleet().task(1).orElseThrow().held());

    click(button(page, "Resume"));
    assertThat(held).hasCount(0);
    assertThat(button(page, "Hold")).isVisible();
    assertFalse(server.fleet().task(1).orElseThrow().held());
  }

  /** No other page has it. */
  @Test
  void whereARobotStandsIsSaidOnThePageOfTheApi() {
    assertEquals(RobotState.NOT_LOCALISED, robot("r4").state());
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "api");
    page.locator(".opblock-tag").getByText("Robots", exactly()).click();
    Locator locate =
        page.locator(".opblock-post")
            .filter(new Locator.FilterOptions().setHasText("/api/v1/robots/{name}/locate"));
    locate.locator(".opblock-summary-control").click();
    locate.getByText("Try it out").click();
    locate.locator(".parameters input").first().fill("r4");
    locate.locator("textarea").fill("{\"x\": 9.3, \"y\": 2.5, \"theta\": 1}");
    locate.getByText("Execute", exactly()).click();

    assertThat(locate.locator(".live-responses-table tbody .response-col_status"))
        .containsText("200");
    assertEquals(new Pose(9.3, 2.5, 1), robot("r4").telemetry().pose());
    assertEquals(RobotState.IDLE, robot("r4").state());
    page.navigate(server.root() + "robots/r4");
    assertThat(page.locator("[data-live-pose]")).containsText("9.30");
  }

  @Test
  void anOrderOfPiecesIsFollowedCancelledAndOrderedAgainOnItsPage() {
    Page page = loggedIn(WebTestServer.CLERK, DESK, "tasks/new");
    fillTask(page);
    page.locator("#pieces").fill("3");
    assertFits(page, "new-order", DESK, PHONE);
    click(button(page, "Create task"));
    Locator progress = page.locator("#progress");
    assertThat(progress).hasText("0 of 3 carried");

    server.fleet().changeTask(1, TaskState.DONE, List.of("r1"), "r1 has parked.");
    assertThat(progress).hasText("1 of 3 carried");
    Locator state = page.locator(".heading .state");
    assertThat(state).hasText("In progress");
    assertFits(page, "order", DESK, PHONE, DARK_PHONE);

    page.navigate(server.root() + "tasks");
    Locator second = page.locator("tr", new Page.LocatorOptions().setHasText("Piece 2 of 3"));
    assertThat(second).containsText("1 of 3 carried");
    assertFits(page, "tasks-of-order", DESK, PHONE);
    page.navigate(server.root() + "tasks/2");
    assertThat(page.locator("dl")).containsText("Piece 2 of 3 · 1 of 3 carried");
    page.getByText("Piece 2 of 3").click();
    click(button(page, "Hold order"));
    assertThat(page.locator("#held")).hasText("On hold: 2 of 2 that are not carried yet");
    assertFits(page, "order-held", DESK, PHONE);
    page.locator("#priority").selectOption("10");
    click(button(page, "Change priority"));
    assertThat(page.locator("#priority")).hasValue("10");
    assertEquals(10, server.fleet().task(3).orElseThrow().task().priority());
    click(button(page, "Resume order"));
    assertThat(page.locator("#held")).hasCount(0);
    page.locator("summary", new Page.LocatorOptions().setHasText("Cancel order")).click();
    click(button(page, "Confirm cancellation"));
    assertThat(state).hasText("Ended, not all carried");
    assertEquals(TaskState.CANCELLED, server.fleet().task(2).orElseThrow().state());

    click(button(page, "Order again what was not carried"));
    assertThat(state).hasText("In progress");
    assertThat(page.locator("tbody tr")).hasCount(3);
  }

  @Test
  void aDriveWithoutALoadIsOrderedAndFollowed() {
    Page page = loggedIn(WebTestServer.CLERK, DESK, "tasks/new");
    page.locator("#kind").selectOption("drive");
    assertThat(page.locator("#load")).isHidden();
    assertThat(page.locator("#startStation")).isHidden();
    page.locator("#name").fill("Look");
    page.locator("#goalStation").selectOption("Shelf 3");
    page.locator("details.stops summary").click();
    page.locator("select[name=goalWait]").selectOption("person");
    page.locator("select[name=stopStation]").first().selectOption("Dock A");
    page.locator("select[name=stopStation]").nth(1).selectOption("charge");
    page.locator("select[name=stopWait]").nth(1).selectOption("80%");
    assertThat(page.locator("#preview")).isVisible();
    assertFits(page, "new-drive", DESK, PHONE, DARK_PHONE);
    click(button(page, "Create task"));

    assertThat(page.locator("ol.stops li")).hasCount(3);
    assertThat(page.locator("ol.stops li").last())
        .containsText("A charger of its choice charges to 80 %");
    assertThat(page.locator("dl")).containsText("None: a drive without a load");
    server.fleet().changeTask(1, TaskState.TO_OBJECT, List.of("r1"), "r1 drives.");
    assertThat(page.locator("[aria-current=step]").first()).hasText("Driving");
    assertFits(page, "drive", DESK, PHONE);
    page.navigate(server.root() + "tasks");
    assertThat(page.locator("tbody tr").first()).containsText("Shelf 3 – A charger of its choice");
    assertThat(page.locator("tbody .state").first()).hasText("Driving");
    page.navigate(server.root() + "tasks/1");
    page.getByText("Duplicate task").click();
    assertThat(page.locator("#kind")).hasValue("drive");
    click(button(page, "Create task"));
    assertThat(page.locator("h1")).hasText("Look");
    assertEquals(
        server.fleet().task(1).orElseThrow().task().stops(),
        server.fleet().task(2).orElseThrow().task().stops());
  }

  /** A clerk makes it of a task's form and uses it; a manager makes it everybody's, in Arabic. */
  @Test
  void aTaskIsSavedAsATemplateAndOrderedFromIt() {
    Page page = loggedIn(WebTestServer.CLERK, DESK, "tasks/new");
    fillTask(page);
    click(button(page, "Save as template…"));
    page.locator("#name").fill("Bolts to a shelf");
    page.locator("[name='ask.start']").selectOption("suggest");
    page.locator("[name='ask.goal']").selectOption("always");
    page.locator("[name='ask.load']").selectOption("always");
    page.locator("[name='as.load']").fill("from");
    assertFits(page, "template-new", DESK, PHONE, DARK_PHONE);
    click(button(page, "Save template"));
    assertThat(page.locator("[name='as.start'][aria-invalid]")).hasCount(1);
    page.locator("[name='as.load']").fill("kg");
    click(button(page, "Save template"));
    assertThat(page.locator("tbody tr")).hasCount(1);
    assertThat(page.locator("tbody tr")).containsText("from → to");
    assertFits(page, "templates", DESK, PHONE);

    page.navigate(server.root() + "tasks/new");
    page.getByText("Bolts to a shelf").click();
    click(button(page, "Create task"));
    assertThat(page.locator("[aria-invalid=true]")).hasCount(2);
    page.locator("[name='values.kg']").fill("2.5");
    page.locator("[name='values.toStation']").selectOption("Shelf 3");
    assertThat(page.locator("#preview")).isVisible();
    assertFits(page, "template", DESK, PHONE, DARK_PHONE);
    click(button(page, "Create task"));
    assertThat(page.locator("h1")).hasText("Bolts");
    assertEquals(2.5, server.fleet().task(1).orElseThrow().task().load());

    Page manager =
        loggedIn(
            WebTestServer.MANAGER,
            new Browser.NewContextOptions().setViewportSize(390, 844).setLocale("ar"),
            "templates");
    manager.locator("tbody a[href$='/edit']").click();
    manager.locator("[name=shared]").check();
    assertFits(manager, "template-edit-ar", DESK, PHONE);
    manager.locator("form.template .choices button").click();
    assertThat(manager.locator("tbody tr")).containsText("للجميع");
    assertFits(manager, "templates-ar", DESK, PHONE);
    page.navigate(server.root() + "templates");
    assertThat(page.locator("tbody a[href$='/edit']")).hasCount(0);
    page.locator("tbody a[role=button]").click();
    page.locator("#when").selectOption("weekly");
    page.getByText("Monday").click();
    page.locator("#time").fill("08:00");
    page.locator("[name='values.kg']").fill("1");
    page.locator("[name='values.toStation']").selectOption("Shelf 3");
    click(button(page, "Create task"));
    assertThat(page.locator("tbody tr")).containsText("From template Bolts to a shelf");
    manager.navigate(server.root() + "templates");
    manager.locator("tbody summary").click();
    manager.locator("tbody button.danger").click();
    assertThat(manager.locator("main .notice.bad")).containsText("1");
  }

  @Test
  void aLoadGoesOnFromStopToStopInArabic() {
    Page page =
        loggedIn(
            WebTestServer.CLERK,
            new Browser.NewContextOptions().setViewportSize(390, 844).setLocale("ar"),
            "tasks/new");
    fillTask(page);
    page.locator("details.stops summary").click();
    page.locator("select[name=stopStation]").first().selectOption("Dock A");
    assertFits(page, "new-order-ar", DESK, PHONE);
    page.locator("form.task button:not([formaction])").click();
    assertThat(page.locator("tbody tr")).hasCount(2);

    server.fleet().changeTask(1, TaskState.CANCELLED, List.of(), "It was cancelled.");

    assertThat(page.locator("#live .notice.bad")).hasCount(1);
    assertThat(page.locator(".heading .state")).hasText("متوقف");
    assertFits(page, "order-ar", DESK, PHONE);
  }

  /**
   * He orders a tour and sees to it, gives up another task, looks at what is his, and goes home.
   */
  @ParameterizedTest
  @CsvSource({"en, true", "ar, false"})
  void aClerksDay(String language, boolean byKeyboard) {
    Day day = dayOf(WebTestServer.CLERK, language, byKeyboard);
    Page page = day.page();
    order(day, "Drums");
    day.press("details.stops:has([name=stopStation]) summary");
    day.choose("select[name=goalWait]", "person");
    day.choose("select[name=stopStation]", "Dock A");
    day.choose("select[name=stopWait]", "300");
    day.choose("#carriedBy", "one");
    assertFits(page, "new-tour-" + language, byKeyboard ? DESK : PHONE);
    day.press("form.task > .choices button:not([formaction])");
    Locator stops = page.locator("ol.stops li");
    assertThat(stops).hasCount(3);

    server.fleet().changeTask(1, TaskState.CARRYING, List.of("r1"), "r1 carries the load.");
    day.go("map");
    assertThat(page.locator("#tasks a")).containsText("Drums");
    day.press("#tasks a");
    day.press("#actions form[action$='/hold'] button");
    assertThat(page.locator("#actions form[action$='/resume']")).isVisible();
    day.press("#actions form[action$='/resume'] button");
    assertThat(page.locator("#actions form[action$='/hold']")).isVisible();
    server.fleet().waitAtStop(1, 1);
    day.press("#live form[action$='/go-on'] button");
    assertThat(page.locator("#live form[action$='/go-on']")).hasCount(0);
    server.fleet().loseRobotOf(1);
    assertFits(page, "clerk-question-" + language, byKeyboard ? DESK : PHONE);
    day.press("#actions button[name=answer][value=wait]");
    assertThat(page.locator("#actions button[name=answer][value=wait]")).hasCount(0);

    order(day, "Bolts");
    day.press("form.task > .choices button:not([formaction])");
    assertThat(page.locator("h1")).hasText("Bolts");
    day.press("#actions details:has(form[action$='/cancel']) summary");
    day.press("#actions form[action$='/cancel'] button.danger");
    assertThat(page.locator("#actions form[action$='/cancel']")).hasCount(0);
    day.go("tasks");
    day.press("main details summary");
    day.write(".filter [name=user]", WebTestServer.CLERK);
    day.press(".filter button");
    assertThat(page.locator("tbody tr")).hasCount(2);
    assertFits(page, "clerk-list-" + language, byKeyboard ? DESK : PHONE);
    day.logOut();
  }

  private static void order(Day day, String name) {
    day.go("tasks");
    day.press("main a[href$='/tasks/new']");
    day.write("#name", name);
    day.write("#load", "2.5");
    day.choose("#startStation", "Dock A");
    day.choose("#goalStation", "Shelf 3");
  }

  private static void fillTask(Page page) {
    page.locator("#name").fill("Bolts");
    page.locator("#load").fill("2");
    page.locator("#startStation").selectOption("Dock A");
    page.locator("#goalStation").selectOption("Shelf 3");
  }

  private RobotView robot(String name) {
    return server.fleet().latest().robots().stream()
        .filter(robot -> robot.name().equals(name))
        .findFirst()
        .orElseThrow();
  }
}
