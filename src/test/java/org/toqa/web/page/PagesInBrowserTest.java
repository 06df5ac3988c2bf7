package org.toqa.web.page;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertFalse;

import com.microsoft.playwright.Page;
import com.microsoft.playwright.options.ColorScheme;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.mission.TaskState;
import org.toqa.testbed.Hall;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;

/** Every page fits its screen. Pictures of them go to {@code target/screenshots}. */
class PagesInBrowserTest extends PagesInBrowser {
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
            "users/1",
            "users/2",
            "history",
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
  }

  @ParameterizedTest
  @CsvSource({"1280, 900, LIGHT, desktop", "1280, 900, DARK, dark", "390, 844, LIGHT, phone"})
  void everyPageOfAVisitorFitsItsScreen(int width, int height, ColorScheme scheme, String name)
      throws Exception {
    Page page = loggedIn(width, height, scheme);
    page.navigate(server.root() + "users/1");
    page.locator("form[action$=reset-link] button").click();
    String secret = page.locator("code.secret").textContent().replaceFirst(".*secret=", "");
    picture(page, name + "-reset-link");
    page.context().clearCookies();
    try (WebTestServer empty = WebTestServer.startEmpty(0)) {
      Map<String, String> addresses =
          Map.of(
              "first-start", empty.root().toString(),
              "login", server.root().toString(),
              "forgotten", server.root() + "forgotten",
              "reset", server.root() + "reset?secret=" + secret,
              "reset-over", server.root() + "reset?secret=none");
      addresses.forEach(
          (picture, address) -> {
            page.navigate(address);
            assertThat(page.locator("h1")).isVisible();
            picture(page, name + "-" + picture);
            assertFits(page);
          });
    }
  }
}
