package org.toqa.web.page;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.microsoft.playwright.Browser;
import com.microsoft.playwright.Locator;
import com.microsoft.playwright.Page;
import com.microsoft.playwright.Route;
import com.microsoft.playwright.options.AriaRole;
import com.microsoft.playwright.options.FilePayload;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.toqa.accounts.Role;
import org.toqa.fleet.CheckRefusedException;
import org.toqa.fleet.ExpectedTimes;
import org.toqa.mission.TaskState;
import org.toqa.web.WebTestServer;
import org.toqa.wording.Phrase;

/** Tasks are given, imported and scheduled in a real browser, over MySQL. */
class TaskPagesInBrowserTest extends PagesInBrowser {
  @Override
  WebTestServer startServer() throws Exception {
    return WebTestServer.startOnMySql();
  }

  @Test
  void aTaskIsAssignedByClickingOnTheMapAndSeenToTheEnd() {
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "tasks/new");
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

  @Test
  void aTaskIsForRobotsWithAnArmInBothLanguages() {
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "tasks/new");
    page.getByLabel("Task name").fill("Samples");
    page.getByLabel("Load (kg)").fill("1");
    page.selectOption("#startStation", "Dock A");
    page.selectOption("#goalStation", "Shelf 3");
    page.getByText("Only certain robots").click();
    page.getByLabel("robots with an arm").check();
    assertFits(page, "new-task-ability", DESK, PHONE);
    page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Create task")).click();

    assertThat(page.locator("h1")).hasText("Samples");
    assertThat(page.locator("main")).containsText("robots with an arm");
    assertThat(page.locator("a[href*='with:']")).hasCount(0);
    page.navigate(page.url() + "/edit");
    assertThat(page.getByLabel("robots with an arm")).isChecked();
    assertThat(page.locator("input[value='with:omni']")).not().isChecked();
    assertThat(page.locator("input[name=onlyRobots]")).hasCount(8); // with six robots
    page.navigate(server.root() + "language/ar");
    page.navigate(server.root() + "tasks/new");
    page.locator("details.only-robots summary").click();
    assertThat(page.getByLabel("الروبوتات ذات الذراع")).isVisible();
    assertFits(page, "ar-new-task-ability", DESK, PHONE);
  }

  @Test
  void whenATaskIsExpectedIsToldOnItsPageInTheListAndBesideTheMap() {
    Page page = pageOfNewTask("2.5");
    String task = page.url();
    ExpectedTimes times =
        new ExpectedTimes(
            Instant.parse("2098-07-01T19:58:00Z"), Instant.parse("2098-07-01T20:00:00Z"), null);
    server.fleet().changeView(1, view -> view.withExpected(times));
    assertThat(page.locator("#expected-pick-up time")).containsText("2:58"); // in Bogota
    assertThat(page.locator("#expected-delivery time")).containsText("3:00");
    assertFits(page, "task-expected", DESK, PHONE);
    page.navigate(server.root() + "tasks");
    assertThat(page.locator("time[datetime='2098-07-01T20:00:00Z']")).containsText("3:00");
    assertFits(page, "tasks-expected", DESK, PHONE);
    page.navigate(server.root() + "map");
    assertThat(page.locator("#tasks")).containsText(Pattern.compile("delivery .*3:00"));
    assertFits(page, "map-expected", DESK, PHONE);

    page.navigate(task);
    ExpectedTimes unknown = new ExpectedTimes(null, null, Phrase.EXPECTED_AFTER_HOLD.with());
    server.fleet().changeView(1, view -> view.withExpected(unknown));
    assertThat(page.locator("#expected-delivery")).containsText("when it is resumed");
    assertThat(page.locator("#expected-pick-up")).hasCount(0);
  }

  @Test
  void anOperatorHoldsTheTaskOfAManagerAndAViewerDoesNot() {
    Page page = pageOfNewTask("2.5");
    String task = page.url();
    server.addUser("Otto", null, Role.OPERATOR);
    server.addUser("Vera", null, Role.VIEWER);
    Page ofOperator = loggedIn("Otto", DESK, "map");
    ofOperator.navigate(task);
    click(button(ofOperator, "Hold"));
    assertThat(button(ofOperator, "Resume")).isVisible();
    Page ofViewer = loggedIn("Vera", DESK, "map");
    ofViewer.navigate(task);
    assertThat(ofViewer.locator("h1")).hasText("Drums");
    assertThat(button(ofViewer, "Resume")).isHidden();
    assertThat(button(ofViewer, "Follow")).isVisible();
  }

  @Test
  void onAPhoneTheMapComesBeforeTheButtonAndTheFirstFaultHasTheFocus() {
    Page page = loggedIn(WebTestServer.MANAGER, PHONE, "tasks/new");
    Locator submit = button(page, "Create task");
    assertTrue(submit.boundingBox().y > page.locator("#map").boundingBox().y);
    assertFits(page, "new-task", PHONE, DARK_PHONE);
    page.getByLabel("Task name").fill("Box of bolts");
    page.getByLabel("Load (kg)").fill("1e3");
    submit.click();
    assertThat(page.locator("#load")).isFocused();
    assertThat(page.locator("#load-help")).containsText("Enter a number");
    page.getByLabel("Load (kg)").fill("2,5");
    submit.click();
    assertThat(page.locator("#startStation")).isFocused();
  }

  @Test
  void aFormThatTheServerDoesNotHearKeepsItsEntries() {
    Page page = pageThatIsLongUnheard("tasks/new");
    page.getByLabel("Task name").fill("Box of bolts");
    page.getByLabel("Load (kg)").fill("2.5");
    page.locator("#startStation").selectOption("Dock A");
    page.context().setOffline(true);

    button(page, "Create task").click();

    Locator said = page.locator("#offline > span:visible");
    assertThat(said).hasCount(1);
    assertThat(said).containsText("Not sent: the server does not answer.");
    assertThat(page.getByLabel("Task name")).hasValue("Box of bolts");
    assertFits(page, "new-task-unsent", DESK, PHONE);

    page.context().setOffline(false);
    button(page, "Create task").click();
    assertThat(page.locator("#goalStation")).isFocused(); // it was sent, and has no goal
  }

  @Test
  void whatStopsRobotsWaitsForNoAnswer() {
    Page page = pageThatIsLongUnheard("tasks/new");
    page.getByLabel("Task name").fill("Box of bolts");
    List<Route> asked = holdQuestions(page);
    button(page, "Create task").click();
    await(page, () -> !asked.isEmpty());

    button(page, "Pause all robots").click();

    assertThat(page.locator("#pause.paused")).isVisible();
  }

  @Test
  void ofTwoFormsTheOneThatWasPressedLastIsSent() {
    Page page = pageThatIsLongUnheard("robots/r1");
    List<Route> asked = holdQuestions(page);
    button(page, "Set position").click();
    page.locator("#change-host").fill("");
    button(page, "Save").click();
    await(page, () -> asked.size() == 2);

    asked.forEach(Route::resume);

    assertThat(page.locator("#change-host")).isFocused(); // for its fault
  }

  @Test
  void aFormIsSentThoughItsRegionIsReplacedMeanwhile() {
    pageOfNewTask("2.5");
    Page page = pageThatIsLongUnheard("tasks/1");
    // it is connected again: else the time for the question is over before it shows what changes
    page.waitForRequest("**/api/v1/events*", () -> page.clock().fastForward(60_000));
    List<Route> asked = holdQuestions(page);
    page.locator("#priority").selectOption("High");
    button(page, "Change priority").click();
    await(page, () -> !asked.isEmpty());
    server.fleet().changeTask(1, TaskState.CARRYING, List.of("r1"), "r1 carries the load.");
    assertThat(page.locator("[aria-current=step]")).hasText("Carrying");
    assertThat(page.locator("#priority")).hasValue("0"); // that of now

    asked.forEach(Route::resume);

    assertThat(page.locator("#priority")).hasValue("10");
  }

  @Test
  void onTheMapItIsSeenThatAFormIsNotSent() {
    server.fleet().holdFloor("hall", "Ann");
    Page page = pageThatIsLongUnheard("map");
    page.locator("#floors summary:visible").click();
    page.context().setOffline(true);
    page.clock().fastForward(60_000);
    assertThat(page.locator("#banner")).isVisible();

    page.locator("#floors details[open] button").click();

    assertThat(page.locator("#offline > span:visible")).containsText("Not sent");
    assertFits(page, "map-unsent", DESK, PHONE);
    page.context().setOffline(false);
    assertThat(page.locator("#offline")).isHidden();
  }

  /** The server was heard when the page came, and not since. */
  private Page pageThatIsLongUnheard(String path) {
    Page page = openPage(new Browser.NewContextOptions());
    page.clock().install();
    page.navigate(server.root().toString());
    logIn(page, WebTestServer.MANAGER);
    page.navigate(server.root() + path);
    page.waitForLoadState();
    page.clock().fastForward(60_000);
    return page;
  }

  /** Questions whether the server is there, which wait until they are resumed. */
  private static List<Route> holdQuestions(Page page) {
    List<Route> asked = new ArrayList<>();
    page.route("**/api/v1/health", asked::add);
    return asked;
  }

  @Test
  void aTaskThatWaitsForWhatWillNotComeNeedsAttentionOnTheMap() {
    Page page = pageOfNewTask("2.5");
    page.navigate(server.root() + "map");
    assertThat(page.locator("#attention li").first()).isVisible();
    assertThat(page.locator("#attention")).not().containsText("Drums");

    server
        .fleet()
        .changeView(
            1,
            task -> task.withWaitReason(Phrase.TOO_HEAVY_FOR_ALL.with(50.0, 2, 10.0)).asBlocked());

    assertThat(page.locator("#attention")).containsText("Drums");
    assertThat(page.locator("#attention")).containsText("50 kg");
    assertFits(page, "map-blocked-task", DESK, PHONE);
  }

  @ParameterizedTest
  @EnumSource(CheckRefusedException.Reason.class)
  void thatAnEstimateIsRefusedIsTold(CheckRefusedException.Reason reason) {
    server.fleet().refuseChecks(reason);
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "tasks/new?start=Dock%20A&goal=Shelf%203");
    page.getByLabel("Task name").fill("Box of bolts");
    page.getByLabel("Load (kg)").fill("2.5");
    page.locator("#startStation").selectOption("Dock A");
    page.locator("#goalStation").selectOption("Shelf 3");

    assertThat(page.locator("#preview")).hasClass(Pattern.compile("wrong"));
    assertThat(page.locator("#preview")).hasText(Pattern.compile(".{20,}"));
    assertFits(page, "new-task-refused-" + reason.name(), DESK, PHONE);
  }

  @Test
  void aTaskThatAsksIsCancelledInOnePlaceAndItsLoadIsSaidToBeGone() {
    Page page = pageOfNewTask("2,5");
    assertThat(page.getByText("2.5 kg")).isVisible();
    server.fleet().changeTask(1, TaskState.CARRYING, List.of("r1"), "r1 carries the load.");
    server.fleet().loseRobotOf(1);
    assertThat(button(page, "Wait for the robot")).isVisible();
    assertThat(button(page, "Cancel task and leave the load")).isHidden();
    assertThat(page.getByText("Set load down here")).hasCount(0);
    click(page.getByText("Cancel task", new Page.GetByTextOptions().setExact(true)));
    assertFits(page, "task-cancel-leaving", DESK, PHONE);
    click(button(page, "Cancel task and leave the load"));

    assertThat(page.getByText("Load location")).isVisible();
    assertFits(page, "task-left-load", DESK, PHONE);
    String again = page.getByRole(AriaRole.LINK, link("Duplicate task")).getAttribute("href");
    assertTrue(again.contains("startX=2.0"), again);
    click(button(page, "Load is not there any more"));
    assertThat(page.getByText("Load location")).hasCount(0);
    assertThat(button(page, "Load is not there any more")).hasCount(0);
  }

  @Test
  void aWaitingTaskIsEditedAndFollowedAndWhenItHasEndedDeleted() {
    Page page = pageOfNewTask("2.5");
    click(button(page, "Follow"));
    assertThat(button(page, "Stop following")).isVisible();
    click(page.getByRole(AriaRole.LINK, link("Edit order")));
    assertThat(page.locator("h1")).hasText("Edit task 1");
    assertThat(page.getByLabel("Load (kg)")).hasValue("2.5");
    assertThat(page.locator("#startStation")).hasValue("Dock A");
    assertThat(page.locator("#when")).hasCount(0);
    assertFits(page, "task-edit", DESK, PHONE);
    page.getByLabel("Load (kg)").fill("4");
    page.getByLabel("Deadline").fill("2098-07-01T15:00");
    click(button(page, "Save changes"));
    assertThat(page.locator("dl")).containsText("4 kg");
    assertThat(page.locator("time[datetime='2098-07-01T20:00:00Z']")).containsText("3:00");
    click(page.getByRole(AriaRole.LINK, link("Edit order")));
    assertThat(page.getByLabel("Deadline")).hasValue("2098-07-01T15:00");
    page.getByLabel("Load (kg)").fill("400");
    click(button(page, "Save changes"));
    assertThat(page.locator("#load-help")).isVisible();
    click(page.getByRole(AriaRole.BUTTON, link("Cancel")));
    assertFits(page, "task-followed", DESK, PHONE);

    server.fleet().changeTask(1, TaskState.DONE, List.of("r1"), "r1 has parked.");
    click(page.getByText("Delete task", new Page.GetByTextOptions().setExact(true)));
    assertFits(page, "task-delete", DESK, PHONE);
    page.navigate(server.root() + "tasks?followed=true");
    assertThat(page.locator("tbody tr")).hasCount(1);
    assertFits(page, "tasks-followed", DESK, PHONE);
    page.navigate(server.root() + "tasks/1");
    click(page.getByText("Delete task", new Page.GetByTextOptions().setExact(true)));
    click(button(page, "Delete task for good"));

    assertThat(page.locator(".notice.good")).hasText("Task 1 was deleted.");
    assertThat(page.locator("tbody tr")).hasCount(0);
  }

  @Test
  void aTableIsImportedAfterItsBadLineIsMended() {
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "tasks");
    click(page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Import")));
    assertThat(page.locator("#zone-name")).hasText("America/Bogota");
    String header = "name;load;start;goal;deadline\n";
    String good = "Box of bolts;2,5;Dock A;Shelf 3;2098-07-01 15:00\n";
    choose(page, header + good + "Box of nuts;heavy;Dock A;\n");
    assertThat(page.locator("main .notice.bad")).containsText("Nothing was imported.");
    assertThat(page.locator("#faults tbody tr")).hasCount(2);
    assertThat(page.locator("#faults tbody tr").first())
        .containsText("Enter a number, such as 2.5");
    assertFits(page, "tasks-import-refused", PHONE, DESK);

    choose(page, header + good + "Box of nuts;1;Dock A;Shelf 3;\n");

    assertThat(page.locator(".notice.good")).hasText("2 tasks were imported.");
    assertFits(page, "tasks-imported", PHONE, DESK);
    click(page.getByRole(AriaRole.LINK, new Page.GetByRoleOptions().setName("Box of bolts")));
    assertThat(page.locator("time[datetime='2098-07-01T20:00:00Z']")).containsText("3:00");
  }

  @Test
  void aTaskIsScheduledForEveryWeekday() {
    Page page = loggedIn(WebTestServer.MANAGER, PHONE, "tasks/new");
    page.getByLabel("Task name").fill("Morning tour");
    page.getByLabel("Load (kg)").fill("2.5");
    page.locator("#startStation").selectOption("Dock A");
    page.locator("#goalStation").selectOption("Shelf 3");
    assertThat(page.locator("#time")).isHidden();
    page.getByLabel("Schedule").selectOption("weekly");
    assertThat(page.locator("#first")).isHidden();
    page.getByLabel("Monday").check();
    page.getByLabel("Friday").check();
    assertFits(page, "schedule-form", DESK, PHONE);
    click(page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Create task")));
    assertThat(page.locator("#time-help")).containsText("Enter a time of day");
    assertThat(page.getByLabel("Monday")).isChecked();
    page.locator("#time").fill("08:00");
    click(page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Create task")));

    assertThat(page.locator(".notice.good")).hasText("The schedule was added.");
    assertThat(page.locator("tbody tr")).containsText("America/Bogota");
    assertFits(page, "schedule-added", DESK, PHONE);
    click(
        page.getByRole(
            AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Pause").setExact(true)));
    assertThat(page.locator("tbody tr")).containsText("Paused");
    click(page.getByText("Delete", new Page.GetByTextOptions().setExact(true)));
    click(button(page, "Confirm deletion"));
    assertThat(page.locator("tbody tr")).hasCount(0);
  }

  private static void choose(Page page, String table) {
    page.getByLabel("CSV file")
        .setInputFiles(
            new FilePayload("tasks.csv", "text/csv", table.getBytes(StandardCharsets.UTF_8)));
    click(page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Import tasks")));
  }

  /**
   * @param load kilograms, as it is typed
   */
  private Page pageOfNewTask(String load) {
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "tasks/new");
    page.getByLabel("Task name").fill("Drums");
    page.getByLabel("Load (kg)").fill(load);
    page.locator("#startStation").selectOption("Dock A");
    page.locator("#goalStation").selectOption("Shelf 3");
    page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Create task")).click();
    assertThat(page.locator("h1")).hasText("Drums");
    return page;
  }
}
