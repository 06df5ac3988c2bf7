package org.toqa.web.page;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.microsoft.playwright.Locator;
import com.microsoft.playwright.Page;
import com.microsoft.playwright.options.AriaRole;
import java.time.Duration;
import java.util.List;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.history.TrackPoint;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.testbed.Hall;
import org.toqa.web.WebTestServer;
import org.toqa.wording.Sentence;

/**
 * What has happened, and where a robot was, in a real browser and over MySQL. Pictures go to {@code
 * target/screenshots}, to be looked at.
 */
class HistoryInBrowserTest extends PagesInBrowser {
  @Override
  WebTestServer startServer() throws Exception {
    return WebTestServer.startOnMySql();
  }

  @Override
  List<RobotView> robots() {
    return List.of(
        Hall.robot("r1", RobotState.IDLE, new Pose(2, 1, 0), "127.0.0.1", 7275),
        Hall.robot("r2", RobotState.IDLE, new Pose(4, 1, 0), "127.0.0.1", 7276));
  }

  @BeforeEach
  void storeRobots() {
    robots().forEach(robot -> server.store().saveRobot(robot.record()));
  }

  @Test
  void theHistoryIsFilteredByItsForm() {
    server
        .store()
        .addEvents(
            List.of(
                event(0, "robot.held", null, "r1", "Max", "Max put r1 on hold"),
                event(1, "robot.held", null, "r2", "Max", "Max put r2 on hold"),
                event(2, "task.assigned", 7L, "r1", "toqa", "r1 is nearest"),
                event(3, "fleet.paused", null, null, "Ann", "Ann paused all robots")));
    openHistory();
    assertThat(sentences())
        .hasText(
            new String[] {
              "Ann paused all robots", "r1 is nearest", "Max put r2 on hold", "Max put r1 on hold"
            });

    select("robot").selectOption("r1");
    show();
    assertThat(sentences()).hasText(new String[] {"r1 is nearest", "Max put r1 on hold"});

    select("kind").selectOption("task");
    show();
    assertThat(sentences()).hasText(new String[] {"r1 is nearest"});
    assertThat(select("robot")).hasValue("r1");
    picture(page(), "history-filtered");
    assertThat(page().locator("tbody a")).hasText(new String[] {"r1", "7"});

    select("robot").selectOption("");
    select("kind").selectOption("");
    page().getByLabel("User (or toqa)").fill("Ann");
    page().getByLabel("From (UTC)").fill("2026-11-21");
    page().getByLabel("To (UTC)").fill("2026-11-21");
    show();
    assertThat(sentences()).hasText(new String[] {"Ann paused all robots"});
    assertEquals(List.of(), complaints());
  }

  @Test
  void nothingOfTheKindIsSaid() {
    server
        .store()
        .addEvents(List.of(event(0, "robot.held", null, "r1", "Max", "Max put r1 on hold")));
    openHistory();
    assertThat(sentences()).hasCount(1);

    page().getByLabel("From (UTC)").fill("2027-01-01");
    show();

    assertThat(sentences()).hasCount(0);
    assertThat(page().getByText("No matching events.")).isVisible();
    assertThat(page().getByLabel("From (UTC)")).hasValue("2027-01-01");
    picture(page(), "history-empty");
  }

  @Test
  void olderPagesKeepTheFilter() {
    server
        .store()
        .addEvents(
            IntStream.range(0, 250)
                .mapToObj(
                    i -> event(i, "robot.held", null, i < 40 ? "r2" : "r1", "Max", "event " + i))
                .toList());
    openHistory();
    select("robot").selectOption("r1");
    show();

    assertThat(sentences()).hasCount(100);
    assertThat(sentences().first()).hasText("event 249");
    assertThat(linkTo("Newest")).hasCount(0);
    linkTo("Older").click();
    assertThat(sentences().first()).hasText("event 149");
    linkTo("Older").click();
    assertThat(sentences()).hasCount(10); // 250 - 40 of r2 - two pages of 100
    assertThat(sentences().last()).hasText("event 40");
    assertThat(linkTo("Older")).hasCount(0);
    picture(page(), "history-last-page");
    linkTo("Newest").click();
    assertThat(sentences().first()).hasText("event 249");
    assertThat(select("robot")).hasValue("r1");
  }

  @Test
  void aTaskThatIsNoNumberIsSaidAtItsField() {
    server
        .store()
        .addEvents(List.of(event(0, "robot.held", null, "r1", "Max", "Max put r1 on hold")));
    openHistory();

    page().getByLabel("Task no.").fill("seven");
    show();

    Locator field = page().locator("input[name=task]");
    assertThat(field).hasAttribute("aria-invalid", "true");
    assertThat(field).hasValue("seven");
    assertThat(page().getByText("Enter the number of a task or an event.")).isVisible();
    assertThat(sentences()).hasCount(0);
    picture(page(), "history-refused");
    field.fill("");
    show();
    assertThat(sentences()).hasCount(1);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          from=yesterday | Enter a day such as 2026-11-21
          kind=A         | A kind is a word such as task
          before=-1      | Enter the number of a task or an event.
          """)
  void aBadAddressIsSaidInASentence(String query, String sentence) {
    open("history?" + query);

    assertThat(page().locator("main")).containsText(sentence);
    assertThat(page().locator("h1")).hasText("History");
  }

  @Test
  void theTrackOfARobotIsDrawnOnItsPage() {
    open("robots/r1");
    Locator none = page().getByText("No track for this time.");
    assertThat(none).isVisible();
    Object empty = canvas();
    server
        .store()
        .saveRobot(RobotRecord.direct("r1", "hall", "127.0.0.1", 7275, 5, null, false, null));
    server
        .tracks()
        .add(
            List.of(
                at(Duration.ofHours(-5), 9, 5), // too old to be shown
                at(Duration.ofHours(-1), 2, 1),
                at(Duration.ofMinutes(-50), 8, 1),
                at(Duration.ofMinutes(-40), 8, 5)));

    page().reload();

    assertThat(none).isHidden();
    await(page(), () -> !canvas().equals(empty));
    page().locator("#track").scrollIntoViewIfNeeded();
    picture(page(), "robot-track");
    page().navigate(server.root() + "robots/r2");
    assertThat(none).isVisible();
    assertEquals(List.of(), complaints());
  }

  @Test
  void theHistoryOfARobotIsReachedFromItsPageAndFitsAPhone() {
    server
        .store()
        .addEvents(
            List.of(
                event(0, "robot.held", null, "r1", "Max", "Max put r1 on hold"),
                event(1, "robot.held", null, "r2", "Max", "Max put r2 on hold")));
    open("robots/r1");
    click(linkTo("Show history"));

    assertThat(sentences()).hasText(new String[] {"Max put r1 on hold"});
    assertFits(page(), "history", PHONE);
  }

  /** Logged in. */
  private void open(String path) {
    loggedIn(WebTestServer.CLERK, DESK, path);
  }

  private void openHistory() {
    open("history");
    page().locator("main summary").click();
  }

  private void show() {
    page()
        .getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Apply").setExact(true))
        .click();
  }

  private Locator select(String name) {
    return page().locator("select[name=" + name + "]");
  }

  private Locator sentences() {
    return page().locator("tbody th");
  }

  private Locator linkTo(String name) {
    return page().getByRole(AriaRole.LINK, link(name));
  }

  private Object canvas() {
    return page().evaluate("document.querySelector('#track').toDataURL()");
  }

  private static EventRecord event(
      int second,
      String kind,
      @Nullable Long task,
      @Nullable String robot,
      String who,
      String text) {
    return new EventRecord(
        Hall.START.plusSeconds(second), kind, task, robot, who, Sentence.verbatim(text));
  }

  private static TrackPoint at(Duration ago, double x, double y) {
    return new TrackPoint("r1", Hall.START.plus(ago), new Vec2(x, y));
  }
}
