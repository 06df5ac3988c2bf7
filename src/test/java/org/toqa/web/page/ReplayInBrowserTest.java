package org.toqa.web.page;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.microsoft.playwright.APIResponse;
import com.microsoft.playwright.Locator;
import com.microsoft.playwright.Page;
import com.microsoft.playwright.Route;
import com.microsoft.playwright.options.AriaRole;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.fleet.EventRecord;
import org.toqa.fleet.RobotRecord;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.fleet.history.LoadPlace;
import org.toqa.fleet.history.PlannedPath;
import org.toqa.fleet.history.TrackPoint;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.mission.TransportTask.LoadSize;
import org.toqa.testbed.Hall;
import org.toqa.web.WebTestServer;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/**
 * Going back in time on the map. In the minute before its end r1 drove from (2, 1) to (10, 1), r2
 * stood, and of r3 nothing is known; half a minute before it r1 took over the load of task 7.
 * Pictures go to {@code target/screenshots}, to be looked at.
 */
class ReplayInBrowserTest extends PagesInBrowser {

  @Override
  List<RobotView> robots() {
    return List.of(
        Hall.robot("r1", RobotState.IDLE, new Pose(10, 1, 0), "127.0.0.1", 7275),
        Hall.robot("r2", RobotState.IDLE, new Pose(4, 2, 0), "127.0.0.1", 7276),
        Hall.robot("r3", RobotState.IDLE, new Pose(6, 3, 0), "127.0.0.1", 7277));
  }

  @BeforeEach
  void drive() {
    for (String robot : List.of("r1", "r2")) {
      server
          .store()
          .saveRobot(RobotRecord.direct(robot, "hall", "127.0.0.1", 7275, 5, null, false, null));
    }
    Instant end = server.fleet().latest().at().minusSeconds(75); // what is younger is not shown
    server
        .tracks()
        .add(
            List.of(
                new TrackPoint("r2", end.minusSeconds(7200), new Vec2(4, 2)),
                new TrackPoint("r1", end.minusSeconds(60), new Vec2(2, 1)),
                new TrackPoint("r1", end, new Vec2(10, 1))));
    Instant pickedUp = end.minusSeconds(30);
    server
        .scenes()
        .save(
            List.of(
                new LoadPlace(
                    7,
                    7,
                    "hall",
                    end.minusSeconds(3600),
                    pickedUp,
                    new Vec2(6.5, 4.5),
                    List.of(),
                    new LoadSize(1, 0.6)),
                new LoadPlace(
                    7, 7, "hall", pickedUp, null, null, List.of("r1"), new LoadSize(1, 0.6))),
            List.of(
                new PlannedPath(
                    "r1",
                    "hall",
                    pickedUp,
                    null,
                    List.of(new Vec2(6, 1), new Vec2(10, 1), new Vec2(10, 5)))));
    server
        .store()
        .addEvents(
            List.of(
                new EventRecord(
                    end.minusSeconds(55),
                    "task.started",
                    7L,
                    "r1",
                    "toqa",
                    Sentence.verbatim("r1 drives off")),
                new EventRecord(
                    end.minusSeconds(5),
                    "robot.held",
                    null,
                    "r1",
                    "Max",
                    Phrase.ROBOT_PUT_ON_HOLD.with("Max", "r1"))));
  }

  @Test
  void aRobotThatWasRemovedIsStillShown() {
    server.fleet().changeRobots(all -> all.stream().filter(r -> !r.name().equals("r1")).toList());
    openMap("map");
    assertThat(page().locator("#robots li")).hasCount(2);
    lookBack();

    assertThat(thenRobots()).hasText(new String[] {"r2", "r1"});
  }

  @Test
  void loadsAndPathsAreThoseOfTheTime() {
    openMap("map");
    page()
        .evaluate(
            "Object.assign(document.querySelector('#map').style, {filter: 'none', border: 0})");
    MapPicture map = new MapPicture(page());
    assertThat(page().locator("#robots li")).hasCount(3);
    lookBack();
    assertThat(page().locator("#replay-loads")).containsText("Task 7On r1");
    map.awaitLoad(map.whole(10, 1, 1, 0.6));
    Object withPath = pictureOf(page());
    picture(page(), "replay-loads");
    for (int i = 0; i < 4; i++) {
      button("−10 s").click();
    }
    assertThat(page().locator("#replay-loads")).containsText("Task 7At (6.50, 4.50)");
    map.awaitLoad(map.whole(6.5, 4.5, 1, 0.6));

    button("Back to live").click();
    page()
        .route(
            "**/api/v1/tracks?*",
            route -> {
              APIResponse answer = route.fetch();
              String body = answer.text().replaceFirst("\"paths\":.*", "\"paths\":[]}");
              route.fulfill(new Route.FulfillOptions().setResponse(answer).setBody(body));
            });
    lookBack();
    map.awaitLoad(map.whole(10, 1, 1, 0.6));
    assertNotEquals(withPath, pictureOf(page()));
  }

  /** The path crosses itself at (3, 0); points that are left, and the robot's own before them. */
  @ParameterizedTest
  @CsvSource({"1,0,0,4", "3,0,0,4", "3,0,1.5708,1", "3,1,1.5708,1", "5,1,1.5708,3"})
  void theRestOfAPathBeginsWhereTheRobotIs(double x, double y, double theta, int left) {
    openMap("robots");
    Object ahead =
        page()
            .evaluate(
                """
                async (pose) => {
                  const {remainingPath} = await import('/assets/js/replay/remaining-path.js');
                  const path = [[0, 0], [5, 0], [5, 3], [3, -1], [3, 3]];
                  return remainingPath(path, pose).length - 1;
                }
                """,
                Map.of("x", x, "y", y, "theta", theta));
    assertEquals(left, ahead);
  }

  @Test
  void aReaderGoesBackAndComesBack() {
    openMap("map");
    assertThat(page().locator("#robots li")).hasCount(3);
    lookBack();
    assertThat(page().getByText("You are viewing a replay, not live data.")).isVisible();
    assertThat(page().locator("#age")).hasText("Replay");
    assertThat(thenRobots()).hasText(new String[] {"r1", "r2"}); // of r3 nothing is known
    assertThat(page().locator("#tasks")).isHidden();
    Object end = canvas();

    for (int i = 0; i < 3; i++) {
      slider().press("ArrowLeft"); // 10 s each: r1 is at (6, 1)
    }

    assertThat(entry("r1")).containsText("Driving");
    assertThat(entry("r1")).containsText("Task 7: r1 drives off");
    assertThat(entry("r2")).containsText("Standing");
    assertThat(events()).hasText(new String[] {"r1 drives off"});
    Object then = canvas();
    assertNotEquals(end, then);
    picture(page(), "replay");
    server.fleet().changeRobots(robots -> robots.subList(1, 3));
    server.fleet().setAlert("The battery of the lamp is low.");
    assertThat(page().locator("#alerts")).containsText("The battery of the lamp is low.");
    assertThat(page().locator("#banner")).isHidden();
    assertThat(page().locator("#replay-banner")).isHidden(); // less urgent
    button("Show 1 more").click();
    assertThat(page().locator("#replay-banner")).isVisible();
    button("Show only the most urgent").click();
    assertThat(page().locator("#replay-banner")).isHidden();
    assertThat(events()).hasText(new String[] {"r1 drives off"});

    button("Back to live").click();

    assertThat(page().locator("#age")).containsText("Live");
    assertThat(page().locator("#robots strong")).hasText(new String[] {"r2", "r3"});
    assertThat(page().locator("#replay-lists")).isHidden();
    assertThat(button("Replay")).isFocused();
    assertEquals(List.of(), complaints());
  }

  @Test
  void itPlaysUpToNow() {
    openMap("map");
    assertThat(page().locator("#robots li")).hasCount(3);
    lookBack();
    button("−10 s").click();
    button("−10 s").click();
    assertThat(events()).hasText(new String[] {"r1 drives off"});
    page().getByLabel("Speed").selectOption("60×");

    button("Play").click();

    assertThat(events()).hasText(new String[] {"Max put r1 on hold", "r1 drives off"});
    assertThat(button("Play")).isDisabled();
    assertEquals(slider().getAttribute("max"), slider().inputValue());
    button("−10 s").click();
    assertThat(button("Play")).isEnabled();
    page().getByLabel("Speed").selectOption("1×"); // so that nobody is too slow to see it
    button("Play").click();
    assertThat(button("Pause")).isVisible();
  }

  @Test
  void theSliderIsReadAsATimeAndReachesAsFarAsIsChosen() {
    openMap("map");
    assertThat(page().locator("#robots li")).hasCount(3);
    lookBack();
    String atTheEnd = slider().getAttribute("aria-valuetext");
    assertEquals(page().locator("#replay-moment").textContent(), atTheEnd);
    page().getByLabel("Time range").selectOption("Last 1 h");

    slider().press("Home");

    assertNotEquals(atTheEnd, slider().getAttribute("aria-valuetext"));
    assertEquals(
        3_600_000L,
        Long.parseLong(slider().getAttribute("max")) - Long.parseLong(slider().inputValue()));
    assertThat(thenRobots()).hasText(new String[] {"r2"}); // r1 was not yet seen
    page().getByLabel("Time range").selectOption("Last 4 h");
    slider().press("Home");
    assertThat(page().getByText("No robot data for this time.")).isVisible();
  }

  @Test
  void whatCannotBeLoadedIsSaid() {
    openMap("map");
    assertThat(page().locator("#robots li")).hasCount(3);
    page().route("**/api/v1/tracks?*", route -> route.abort());
    button("Replay").click();
    Locator sentence = page().getByText("The replay could not be loaded.");
    assertThat(sentence).isVisible();
    button("Back to live").click();
    assertThat(sentence).isHidden();
    button("Replay").click();
    assertThat(sentence).isVisible();

    page().unroute("**/api/v1/tracks?*");
    slider().press("ArrowLeft");

    assertThat(sentence).isHidden();
    assertThat(entry("r1")).containsText("Driving");
  }

  @ParameterizedTest
  @ValueSource(strings = {"en", "ar"})
  void aReplayIsForEverybody(String language) {
    openMap("language/" + language);
    page().navigate(server.root() + "map");
    assertThat(page().locator("#robots li")).hasCount(3);
    click(page().locator("#replay-open"));
    assertThat(thenRobots()).hasCount(2);
    slider().press("PageDown");
    click(page().locator("#replay-back"));
    assertThat(thenRobots()).hasCount(1);
    slider().press("End");
    click(page().locator("#replay-back"));
    assertThat(thenRobots()).hasCount(2);

    assertFits(page(), "replay-" + language, DARK_PHONE, PHONE);
    assertEquals(List.of(), Accessibility.faults(page(), "phone"));
    assertFits(page(), "replay-" + language, DARK);
    assertEquals(List.of(), Accessibility.faultsOfColours(page(), "dark"));
    assertFits(page(), "replay-" + language, DESK);
    assertEquals(List.of(), Accessibility.faults(page(), "desk"));
    assertTrue(complaints().isEmpty(), complaints()::toString);
  }

  private void openMap(String path) {
    loggedIn(WebTestServer.CLERK, DESK, path);
  }

  private void lookBack() {
    button("Replay").click();
    assertThat(thenRobots().first()).isVisible();
  }

  private Locator button(String name) {
    return page()
        .getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName(name).setExact(true));
  }

  private Locator slider() {
    return page().locator("#replay-time");
  }

  private Locator thenRobots() {
    return page().locator("#replay-robots strong");
  }

  private Locator entry(String robot) {
    return page()
        .locator("#replay-robots li")
        .filter(new Locator.FilterOptions().setHasText(robot))
        .first();
  }

  private Locator events() {
    return page().locator("#replay-events p:first-child");
  }

  private Object canvas() {
    return page().evaluate("document.querySelector('#map').toDataURL()");
  }
}
