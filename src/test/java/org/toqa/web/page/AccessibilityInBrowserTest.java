package org.toqa.web.page;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.deque.html.axecore.playwright.AxeBuilder;
import com.deque.html.axecore.results.AxeResults;
import com.deque.html.axecore.results.CheckedNode;
import com.deque.html.axecore.results.Rule;
import com.microsoft.playwright.Locator;
import com.microsoft.playwright.Page;
import com.microsoft.playwright.options.ColorScheme;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.mission.TaskState;
import org.toqa.testbed.BrowserTest;
import org.toqa.testbed.Hall;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;

/** Every page by the rules of WCAG 2.2, levels A and AA, that axe can check. */
class AccessibilityInBrowserTest extends BrowserTest {
  private static final List<String> RULES =
      List.of("wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa");

  private static final List<String> PAGES =
      List.of(
          "map",
          "tasks",
          "tasks/new",
          "tasks/import",
          "schedules?added=1",
          "tasks?imported=2&state=open&sort=-load",
          "tasks/2",
          "robots",
          "robots/r5",
          "users",
          "users/1",
          "api",
          "statistics?from=2026-11-08&to=2026-11-21&zone=UTC",
          "history",
          "nothing");

  private WebTestServer server;

  @BeforeEach
  void start() throws Exception {
    server = WebTestServer.startForBrowser();
    server.fleet().changeRobots(none -> PagesInBrowser.fleetAtWork());
    try (TestClient clerk = TestClient.signedIn(server.root(), WebTestServer.CLERK)) {
      for (int i = 0; i < 3; i++) {
        clerk.post(
            "tasks/new",
            Map.of("name", "x", "load", "1", "startStation", "Dock A", "goalStation", "Shelf 3"));
      }
      PagesInBrowser.addSchedules(clerk);
    }
    server.fleet().changeTask(2, TaskState.CARRYING, List.of("r1"), "r1 carries the load.");
    server.fleet().changeFloor(Hall.crowdedFloor());
  }

  @AfterEach
  void stop() throws Exception {
    server.close();
  }

  @ParameterizedTest
  @CsvSource({"en, LIGHT, 1280", "en, DARK, 1280", "ar, LIGHT, 390", "ar, DARK, 1280"})
  void nothingIsInAnybodysWay(String language, ColorScheme scheme, int width) {
    page().setViewportSize(width, 900);
    page().emulateMedia(new Page.EmulateMediaOptions().setColorScheme(scheme));
    page().navigate(server.root() + "language/" + language);
    List<String> found = new ArrayList<>();
    page().navigate(server.root().toString());
    look("login", found);
    page().navigate(server.root() + "forgotten");
    look("forgotten", found);
    page().navigate(server.root().toString());
    page().locator("#name").fill(WebTestServer.MANAGER);
    page().locator("#password").fill(WebTestServer.PASSWORD);
    page().locator("main button").click();
    assertThat(page().locator("#map")).isVisible();
    for (String path : PAGES) {
      page().navigate(server.root() + path);
      if (path.equals("map")) {
        assertThat(page().locator("#robots li")).hasCount(6);
      }
      if (path.equals("api")) {
        assertThat(page().locator(".opblock").first()).isVisible();
      }
      look(path, found);
    }
    meetRival();
    look("users/1/change", found);

    assertEquals(List.of(), found, () -> String.join("\n", found));
  }

  /** Another manager changes the user whose form is open here, before it is sent. */
  private void meetRival() {
    page().navigate(server.root() + "users/1");
    Locator form = page().locator("form[action$='/change']");
    form.locator("[name=disabled]").check();
    try (TestClient other = TestClient.signedIn(server.root(), WebTestServer.MANAGER)) {
      other.post("users/1/change", Map.of("role", "MANAGER"));
    }
    form.locator("button").click();
    assertThat(page().locator("#role-help")).isVisible();
  }

  @Test
  void whatIsInSomebodysWayIsFound() {
    page().navigate(server.root().toString());
    page()
        .evaluate(
            "document.body.insertAdjacentHTML('beforeend', '<img src=\"/assets/toqa.svg\">')");
    List<String> found = new ArrayList<>();
    look("login", found);

    assertEquals(1, found.size(), found::toString);
    assertTrue(found.getFirst().startsWith("login: image-alt "), found::toString);
  }

  @Test
  void textOfTheColourOfItsGroundIsFound() {
    page().navigate(server.root().toString());
    page()
        .evaluate(
            "document.querySelector('main p, main label').style ="
                + " 'color: #fff; background: #fff'");
    List<String> found = new ArrayList<>();
    look("login", found);

    assertEquals(1, found.size(), found::toString);
    assertTrue(found.getFirst().startsWith("login: color-contrast "), found::toString);
  }

  private void look(String path, List<String> found) {
    AxeResults results = new AxeBuilder(page()).withTags(RULES).analyze();
    for (Rule rule : results.getViolations()) {
      rule.getNodes().forEach(node -> found.add(sentence(path, rule, node)));
    }
    for (Rule rule : results.getIncomplete()) {
      rule.getNodes().stream()
          .filter(AccessibilityInBrowserTest::isOfTheColourOfItsGround)
          .forEach(node -> found.add(sentence(path, rule, node)));
    }
  }

  /** Of such text axe says only that it does not know whether it shall be seen. */
  private static boolean isOfTheColourOfItsGround(CheckedNode node) {
    return node.getAny().stream()
        .anyMatch(check -> String.valueOf(check.getData()).contains("equalRatio"));
  }

  private static String sentence(String path, Rule rule, CheckedNode node) {
    return path + ": " + rule.getId() + " " + node.getHtml() + " " + rule.getHelp();
  }
}
