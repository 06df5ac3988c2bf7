package org.toqa.web.live;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.geometry.Pose;
import org.toqa.testbed.BrowserTest;
import org.toqa.testbed.Hall;
import org.toqa.web.WebTestServer;

/** What the pages put together from changes is what the server would have sent whole. */
class LiveInBrowserTest extends BrowserTest {
  private static final int CHANGES = 30;

  /** Notes each snapshot by its version, those that come whole and those put together. */
  private static final String WATCH =
      """
      async () => {
        const {subscribe} = await import('/assets/js/shared/event-stream.js');
        window.together = {};
        window.whole = {};
        window.changes = 0;
        subscribe((next) => { window.together[next.version] = JSON.stringify(next); });
        new EventSource('/api/v1/events').addEventListener('snapshot', ({data}) => {
          const next = JSON.parse(data);
          window.whole[next.version] = JSON.stringify(next);
        });
        new EventSource('/api/v1/events?changes=true').addEventListener('change', () => {
          window.changes++;
        });
      }
      """;

  private WebTestServer server;
  private final Random random = new Random(7);

  @BeforeEach
  void start() throws Exception {
    server = WebTestServer.startForBrowser();
  }

  @AfterEach
  void stop() throws Exception {
    server.close();
  }

  @Test
  void changesPutTogetherAreTheWholeSnapshot() {
    page().navigate(server.root().toString());
    page().locator("#name").fill(WebTestServer.MANAGER);
    page().locator("#password").fill(WebTestServer.PASSWORD);
    page().locator("main button").click();
    assertThat(page().locator("#age")).containsText("Live");
    page().evaluate(WATCH);
    awaitBoth(server.fleet().latest().version());

    for (int i = 0; i < CHANGES; i++) {
      change();
      awaitBoth(server.fleet().latest().version());
    }

    assertEquals(
        page().evaluate("() => Object.entries(window.whole)"),
        page().evaluate("() => Object.entries(window.together)"));
    assertTrue((int) page().evaluate("() => window.changes") >= CHANGES / 2);
    assertEquals(List.of(), complaints());
  }

  private void change() {
    switch (random.nextInt(4)) {
      case 0 -> server.fleet().setAlert("Alert " + random.nextInt(3));
      default -> server.fleet().changeRobots(this::changed);
    }
  }

  private List<RobotView> changed(List<RobotView> robots) {
    List<RobotView> next = new ArrayList<>(robots);
    next.removeIf(robot -> random.nextInt(6) == 0);
    String name = "r" + random.nextInt(8);
    next.removeIf(robot -> robot.name().equals(name));
    Pose pose = new Pose(random.nextInt(9) + 1, 2, 0);
    next.add(Hall.robot(name, RobotState.DRIVING, pose, "127.0.0.1", 7275));
    Collections.shuffle(next, random);
    return next;
  }

  private void awaitBoth(long version) {
    await(page(), "!!(window.whole[%1$d] && window.together[%1$d])".formatted(version));
  }
}
