package org.toqa.web.page;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static java.util.Objects.requireNonNull;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import com.microsoft.playwright.Browser;
import com.microsoft.playwright.CDPSession;
import com.microsoft.playwright.Mouse;
import com.microsoft.playwright.Page;
import com.microsoft.playwright.options.BoundingBox;
import com.microsoft.playwright.options.ColorScheme;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.toqa.fleet.RobotState;
import org.toqa.fleet.RobotView;
import org.toqa.geometry.Pose;
import org.toqa.mission.TaskState;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;
import org.toqa.web.page.MapPicture.Seen;

/**
 * What is seen on the screen where the map is: loads and their shapes, and where they are after the
 * map was moved by a mouse, its buttons, keys or fingers. The load is 1.5 m x 0.6 m and lies at (4,
 * 3).
 */
class MapPictureInBrowserTest extends PagesInBrowser {
  @Override
  List<RobotView> robots() {
    return List.of();
  }

  @Test
  void aLoadIsSeenInItsShapeWhereItIs() {
    Page page = loggedIn(1280, 900, ColorScheme.LIGHT);
    MapPicture map = new MapPicture(page);
    assertThat(page.locator("#age")).containsText("Live");
    map.awaitNoLoad();

    addLoad();
    map.awaitLoad(map.whole(4, 3, 1.5, 0.6));

    server.fleet().setRobots(driving("r1", new Pose(8, 4, Math.PI / 2), 1));
    server.fleet().changeTask(1, TaskState.CARRYING, List.of("r1"), "r1 carries the load.");
    map.awaitLoad(map.whole(8, 4, 0.6, 1.5)); // on it, turned as it is
    picture(page, "map-load-carried");

    server
        .fleet()
        .setRobots(
            driving("r1", new Pose(8, 4, 0), 1),
            robot("r2", RobotState.DRIVING, new Pose(10, 3, 0)));
    server.fleet().changeTask(1, TaskState.CARRYING, List.of("r1", "r2"), "Both carry the load.");
    map.awaitLoad(map.whole(9, 3.5, 1.5, 0.6)); // between both
    picture(page, "map-load-carried-together");

    page.emulateMedia(new Page.EmulateMediaOptions().setColorScheme(ColorScheme.DARK));
    map.awaitLoad(map.whole(9, 3.5, 1.5, 0.6));

    server.fleet().changeTask(1, TaskState.DONE, List.of("r1", "r2"), "r1 has parked.");
    map.awaitNoLoad();
  }

  @Test
  void theMapIsMovedByTheMouse() {
    addLoad();
    Page page = loggedIn(1280, 900, ColorScheme.LIGHT);
    MapPicture map = new MapPicture(page);
    Seen whole = map.whole(4, 3, 1.5, 0.6);
    map.awaitLoad(whole);
    BoundingBox box = map.box();

    page.mouse().move(box.x + 300, box.y + 100);
    page.mouse().down();
    page.mouse().move(box.x + 380, box.y + 160, new Mouse.MoveOptions().setSteps(4));
    page.mouse().up();
    map.awaitLoad(whole.movedBy(80, 60));
    page.mouse().move(box.x + 300, box.y + 100); // no button is down
    map.awaitLoad(whole.movedBy(80, 60));

    page.locator("#zoom-fit").click();
    map.awaitLoad(whole);
    page.mouse().move(box.x + whole.x() - 40, box.y + whole.y());
    page.mouse().wheel(0, -400);
    map.awaitLoad(whole.magnified(Math.exp(0.6), whole.x() - 40, whole.y()));
    assertThat(page.locator("#following")).isHidden();
  }

  @Test
  void theMapIsMovedByItsButtonsAndByKeys() {
    addLoad();
    Page page = loggedIn(1280, 900, ColorScheme.LIGHT);
    MapPicture map = new MapPicture(page);
    Seen whole = map.whole(4, 3, 1.5, 0.6);
    double middleX = map.box().width / 2;
    double middleY = map.box().height / 2;
    map.awaitLoad(whole);

    page.locator("#zoom-in").click();
    map.awaitLoad(whole.magnified(1.4, middleX, middleY));
    page.locator("#zoom-out").click();
    page.locator("#zoom-out").click();
    map.awaitLoad(whole.magnified(1 / 1.4, middleX, middleY));
    page.locator("#zoom-fit").click();
    map.awaitLoad(whole);

    page.locator("#map").press("ArrowLeft");
    map.awaitLoad(whole.movedBy(60, 0));
    page.locator("#map").press("ArrowUp");
    map.awaitLoad(whole.movedBy(60, 60));
    page.locator("#map").press("ArrowRight");
    page.locator("#map").press("ArrowDown");
    map.awaitLoad(whole);
    page.locator("#map").press("+");
    map.awaitLoad(whole.magnified(1.3, middleX, middleY));
    page.locator("#map").press("-");
    page.locator("#map").press("-");
    map.awaitLoad(whole.magnified(1 / 1.3, middleX, middleY));
    page.locator("#map").press("0");
    map.awaitLoad(whole);
  }

  @Test
  void theMapIsMovedByFingers() {
    addLoad();
    Page page =
        loggedIn(
            WebTestServer.MANAGER,
            new Browser.NewContextOptions().setViewportSize(390, 844).setHasTouch(true),
            "map");
    MapPicture map = new MapPicture(page);
    Seen whole = map.whole(4, 3, 1.5, 0.6);
    map.awaitLoad(whole);
    CDPSession fingers = page.context().newCDPSession(page);
    double x = whole.x();
    double y = whole.y();

    touch(fingers, map, "touchStart", 150, 60);
    for (int step = 1; step <= 4; step++) {
      touch(fingers, map, "touchMove", 150 + 10 * step, 60 + 5 * step);
    }
    touch(fingers, map, "touchEnd");
    map.awaitLoad(whole.movedBy(40, 20));
    page.locator("#zoom-fit").click(); // on a busy machine a tap is a long press
    map.awaitLoad(whole);

    touch(fingers, map, "touchStart", x - 30, y, x + 30, y);
    for (int step = 1; step <= 10; step++) {
      touch(fingers, map, "touchMove", x - 30 - 3 * step, y, x + 30 + 3 * step, y);
    }
    touch(fingers, map, "touchEnd");
    map.awaitLoad(whole.magnified(2, x, y));
    assertThat(page.locator("#following")).isHidden(); // that was no tap
    assertEquals(1.0, ((Number) page.evaluate("visualViewport.scale")).doubleValue());
    assertEquals(0.0, ((Number) page.evaluate("scrollY")).doubleValue());

    page.locator("#zoom-fit").click(); // on a busy machine a tap is a long press
    map.awaitLoad(whole);
    touch(fingers, map, "touchStart", x, y);
    touch(fingers, map, "touchEnd");
    assertThat(page.locator("#following")).containsText("Box of bolts");
  }

  private static void touch(CDPSession fingers, MapPicture map, String type, double... at) {
    JsonArray points = new JsonArray();
    for (int i = 0; i < at.length; i += 2) {
      JsonObject point = new JsonObject();
      point.addProperty("x", map.box().x + at[i]);
      point.addProperty("y", map.box().y + at[i + 1]);
      point.addProperty("id", i);
      points.add(point);
    }
    JsonObject event = new JsonObject();
    event.addProperty("type", type);
    event.add("touchPoints", points);
    fingers.send("Input.dispatchTouchEvent", event);
  }

  private void addLoad() {
    Map<String, String> task =
        Map.ofEntries(
            Map.entry("name", "Box of bolts"),
            Map.entry("load", "2.5"),
            Map.entry("length", "1.5"),
            Map.entry("width", "0.6"),
            Map.entry("startX", "4"),
            Map.entry("startY", "3"),
            Map.entry("goalX", "9"),
            Map.entry("goalY", "1.05"));
    try (TestClient clerk = TestClient.signedIn(server.root(), WebTestServer.CLERK)) {
      assertEquals(303, clerk.post("tasks/new", task).statusCode());
    }
    requireNonNull(server.fleet().task(1).orElseThrow().task().size());
  }
}
