package org.toqa.web.page;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.microsoft.playwright.Browser;
import com.microsoft.playwright.Locator;
import com.microsoft.playwright.Page;
import com.microsoft.playwright.assertions.LocatorAssertions;
import com.microsoft.playwright.options.ColorScheme;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.FloorView;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.geometry.Pose;
import org.toqa.geometry.Vec2;
import org.toqa.grid.CellRuns;
import org.toqa.link.message.AgentMessage.Fault;
import org.toqa.mission.LoadRecord;
import org.toqa.testbed.Hall;
import org.toqa.testbed.Views;
import org.toqa.web.WebTestServer;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** The live map in a real browser. */
class MapInBrowserTest extends PagesInBrowser {
  @Test
  void theMapShowsARobotMove() {
    Page page = loggedIn(1280, 900, ColorScheme.LIGHT);
    assertThat(page.locator("#age")).containsText("Live");
    assertThat(page.locator("#robots li")).hasCount(6);
    Object before = pictureOf(page);

    move("r1", new Pose(5, 4.6, 0));

    await(page, () -> !pictureOf(page).equals(before));
  }

  @Test
  void aCrowdIsDotsButForThoseThatAPersonMustSeeTo() {
    server
        .fleet()
        .changeRobots(
            before ->
                IntStream.range(0, 160)
                    .mapToObj(
                        i ->
                            robot(
                                "r" + i,
                                i == 7 ? RobotState.ERROR : RobotState.IDLE,
                                new Pose(5 + 0.15 * (i % 16), 2.3 + 0.15 * (i / 16), 0)))
                    .toList());
    Page page = openPage(new Browser.NewContextOptions().setViewportSize(1280, 900));
    page.addInitScript(
        """
        window.drawn = new Set();
        const prototype = CanvasRenderingContext2D.prototype;
        const {clearRect, fillText} = prototype;
        prototype.clearRect = function (...box) {
          window.drawn = new Set();
          clearRect.apply(this, box);
        };
        prototype.fillText = function (words, x, y) {
          window.drawn.add(words.replace(/[\u2068\u2069]/g, ''));
          fillText.call(this, words, x, y);
        };
        """);
    page.navigate(server.root().toString());
    logIn(page, WebTestServer.MANAGER);
    await(page, () -> (Boolean) page.evaluate("window.drawn.has('r7')"));
    assertEquals(
        List.of("r7"), page.evaluate("[...window.drawn].filter((words) => /^r\\d+$/.test(words))"));
    assertFits(page, "map-crowd", DESK, PHONE);

    DESK.show(page);
    for (int i = 0; i < 6; i++) {
      page.locator("#zoom-in").click();
    }
    await(
        page,
        () ->
            (Integer)
                    page.evaluate(
                        "[...window.drawn].filter((words) => /^r\\d+$/.test(words)).length")
                > 1);
  }

  @Test
  void namesOfRobotsThatStandTogetherDoNotCoverEachOther() {
    List<RobotView> robots = server.fleet().latest().robots();
    for (int i = 0; i < robots.size(); i++) {
      move(robots.get(i).name(), new Pose(5 + 0.3 * i, 4.6, 0));
    }
    Page page = openPage(new Browser.NewContextOptions().setViewportSize(390, 844));
    page.addInitScript(
        """
        window.drawn = [];
        const prototype = CanvasRenderingContext2D.prototype;
        const {clearRect, fillText} = prototype;
        prototype.clearRect = function (...box) {
          window.drawn = [];
          clearRect.apply(this, box);
        };
        prototype.fillText = function (words, x, y) {
          if (/r\\d/.test(words)) {
            const half = this.measureText(words).width / 2;
            window.drawn.push({name: words, left: x - half, right: x + half, top: y});
          }
          fillText.call(this, words, x, y);
        };
        """);
    page.navigate(server.root().toString());
    logIn(page, WebTestServer.MANAGER);
    await(page, () -> (Integer) page.evaluate("window.drawn.length") > 2);

    assertEquals(
        List.of(),
        page.evaluate(
            """
            window.drawn.flatMap((a, i) => window.drawn.slice(i + 1)
              .filter((b) => a.left < b.right && b.left < a.right && Math.abs(a.top - b.top) < 14)
              .map((b) => a.name + b.name))
            """));
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
    await(page, () -> !pictureOf(page).equals(before));

    page.getByText("Stop following").click();
    assertThat(following).isHidden();
    map.click(); // in the middle, where the robot is
    assertThat(following).isVisible();
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

  @Test
  void aPathIsMeasuredWithTwoClicks() {
    Page page = loggedIn(1280, 900, ColorScheme.LIGHT);
    assertThat(page.locator("#robots li")).hasCount(6);
    Locator map = page.locator("#map");
    Locator measuring = page.locator("#measuring");
    assertThat(measuring).isHidden();

    page.locator("#measure").click();
    assertThat(measuring).containsText("Click where the path begins.");
    clickMap(page, map, 4.2, 4.6); // robots are not followed meanwhile
    assertThat(measuring).containsText("Click where it ends.");
    assertThat(page.locator("#following")).isHidden();
    Object before = pictureOf(page);
    clickMap(page, map, 8.2, 2.2);
    assertThat(measuring).containsText("4.7 m by the map.");
    await(page, () -> !pictureOf(page).equals(before));
    picture(page, "map-measured");

    clickMap(page, map, 4.2, 4.6);
    assertThat(measuring).containsText("Click where it ends.");
    clickMap(page, map, 0.05, 0.05);
    assertThat(measuring).containsText("is not a free place");
    page.keyboard().press("Escape");
    assertThat(measuring).isHidden();
    clickMap(page, map, 4.2, 4.6);
    assertThat(page.locator("#following")).containsText("Following r1");
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
    await(page, () -> !pictureOf(page).equals(before));
    page.getByText("Legend").click();
    page.locator(".legend").getByText("Standstill").scrollIntoViewIfNeeded();
    picture(page, "map-in-the-way");

    Object crowded = pictureOf(page);
    server
        .fleet()
        .changeFloor(
            Views.floor(
                "hall", null, CellRuns.NONE, Map.of(), List.of(), List.of(), List.of(), null));

    await(page, () -> !pictureOf(page).equals(crowded));
    assertThat(page.locator("#attention")).not().containsText("Standstill");
  }

  @Test
  void aLoadOnTheFloorIsShownAndFollowed() {
    Page page = loggedIn(1280, 900, ColorScheme.LIGHT);
    assertThat(page.locator("#robots li")).hasCount(6);
    Object before = pictureOf(page);

    server
        .fleet()
        .changeFloor(
            new FloorView(
                "hall",
                null,
                CellRuns.NONE,
                Map.of(),
                List.of(),
                List.of(),
                List.of(
                    new FloorView.LeftLoad(
                        77,
                        new LoadRecord(77, Instant.EPOCH),
                        "Drums",
                        5,
                        new Vec2(9, 4),
                        null,
                        Phrase.LEFT_LOAD.with(Sentence.of(new Vec2(9, 4))))),
                null,
                List.of(),
                List.of(),
                List.of(
                    new FloorView.ZoneView("r1", new Vec2(0, 0), new Vec2(6, 8)),
                    new FloorView.ZoneView("r2", new Vec2(6, 0), new Vec2(12, 8))),
                Hall.floor().version(),
                List.of()));

    await(page, () -> !pictureOf(page).equals(before));
    Object withoutMargins = pictureOf(page);
    page.locator("#margins").click();
    await(page, () -> !pictureOf(page).equals(withoutMargins));
    Object withoutZones = pictureOf(page);
    page.locator("#zones").click();
    await(page, () -> !pictureOf(page).equals(withoutZones));
    assertThat(page.locator("#attention")).containsText("Drums");
    assertThat(page.locator("#attention")).containsText("lies on the floor at (9.00, 4.00)");
    assertFits(page, "map-left-load", DESK, PHONE);
    DESK.show(page);
    page.navigate(server.root() + "map?task=77");
    assertThat(page.locator("#following")).containsText("Drums");
  }

  @Test
  void whatIsMostUrgentComesFirst() {
    server.fleet().changeFloor(Hall.crowdedFloor());
    Page page = loggedIn(1280, 900, ColorScheme.LIGHT);

    assertThat(page.locator("#attention strong"))
        .hasText(new String[] {"r5", "Standstill", "r6", "r4", "Charger", "Chargers"});
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
    await(page, () -> !pictureOf(page).equals(all));
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
        .changeFloor(
            Views.floor(
                "hall", null, CellRuns.NONE, Map.of(), List.of(), List.of(), List.of(), null));
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
  void theMapSaysWhenTheServerIsAway() throws Exception {
    Page page = page();
    int port;
    try (WebTestServer passing = WebTestServer.startForBrowser()) {
      port = passing.root().getPort();
      page.navigate(passing.root().toString());
      logIn(page, WebTestServer.MANAGER);
      assertThat(page.locator("#age")).containsText("Live");
      assertThat(page.locator("#banner")).isHidden();
    }

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
}
