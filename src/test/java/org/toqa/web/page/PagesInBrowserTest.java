package org.toqa.web.page;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.microsoft.playwright.Locator;
import com.microsoft.playwright.Page;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.mission.TaskState;
import org.toqa.testbed.Hall;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;

/**
 * One walk over all pages in each language: every page fits the screens of a desk and of a phone,
 * bright and dark, and is in nobody's way. Pictures of them go to {@code target/screenshots}.
 */
class PagesInBrowserTest extends PagesInBrowser {
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
          "floors",
          "floors/hall/edit",
          "robots/r5",
          "robots/r1/control",
          "users",
          "users/1",
          "users/2",
          "api",
          "statistics?from=2026-11-08&to=2026-11-21&zone=UTC",
          "statistics",
          "history",
          "laboratory",
          "cameras",
          "network",
          "notices",
          "notices/settings",
          "notices/webhooks",
          "nothing");

  private final List<String> found = new ArrayList<>();

  /** At pages in the dark, in the language that is walked now. */
  private int looks;

  @ParameterizedTest
  @CsvSource({"en, Live, All robots are paused", "ar, مباشر, كل الروبوتات موقوفة مؤقتًا"})
  void everyPageFitsItsScreenAndIsInNobodysWay(String language, String live, String paused) {
    found.clear();
    looks = 0;
    addTasks();
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "language/" + language);
    assertThat(page.locator("html")).hasAttribute("lang", language);
    for (String path : PAGES) {
      page.navigate(server.root() + path);
      if (path.equals("api")) {
        page.locator(".opblock-tag").first().click();
        assertThat(page.locator(".opblock").first()).isVisible();
      }
      if (path.startsWith("tasks?")) {
        assertThat(page.locator("tbody")).containsText("Box <b class=raw>of</b> bolts (2)");
      }
      if (path.equals("map")) {
        assertThat(page.locator("#age")).containsText(live);
        assertThat(page.locator("#robots li")).hasCount(6);
      }
      look(page, language, path);
    }
    meetRival(page);
    look(page, language, "users/1/change");
    page.navigate(server.root() + "tasks/new");
    click(page.locator("form.task button:not([formaction])").last());
    assertThat(page.locator("[aria-invalid=true]").first()).isVisible();
    look(page, language, "tasks/new-refused");
    click(page.locator("#pause button"));
    assertThat(page.locator("#pause")).containsText(paused);
    look(page, language, "paused");

    assertEquals(List.of(), found, () -> String.join("\n", found));
  }

  @ParameterizedTest
  @ValueSource(strings = {"en", "ar"})
  void everyPageOfAVisitorFitsItsScreenAndIsInNobodysWay(String language) throws Exception {
    found.clear();
    looks = 0;
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "users/1");
    click(page.locator("form[action$=reset-link] button"));
    String secret = page.locator("code.secret").textContent().replaceFirst(".*secret=", "");
    assertFits(page, "reset-link", DESK, DARK, PHONE);
    page.context().clearCookies();
    try (WebTestServer empty = WebTestServer.startEmpty(0)) {
      Map<String, String> addresses = new LinkedHashMap<>();
      addresses.put("first-start", empty.root().toString());
      addresses.put("login", server.root().toString());
      addresses.put("forgotten", server.root() + "forgotten");
      addresses.put("reset", server.root() + "reset?secret=" + secret);
      addresses.put("reset-over", server.root() + "reset?secret=none");
      page.navigate(server.root() + "language/" + language);
      addresses.forEach(
          (name, address) -> {
            page.navigate(address);
            assertThat(page.locator("html")).hasAttribute("lang", language);
            assertThat(page.locator("h1")).isVisible();
            look(page, language, name);
          });
    }
    assertEquals(List.of(), found, () -> String.join("\n", found));
  }

  @Test
  void whatIsInSomebodysWayIsFound() {
    page().navigate(server.root().toString());
    page()
        .evaluate(
            "document.body.insertAdjacentHTML('beforeend', '<img src=\"/assets/toqa.svg\">')");
    List<String> faults = Accessibility.faults(page(), "login");

    assertEquals(1, faults.size(), faults::toString);
    assertTrue(faults.getFirst().startsWith("login: image-alt "), faults::toString);
  }

  @Test
  void textOfTheColourOfItsGroundIsFound() {
    page().navigate(server.root().toString());
    page()
        .evaluate(
            "document.querySelector('main p, main label').style ="
                + " 'color: #fff; background: #fff'");
    for (List<String> faults :
        List.of(
            Accessibility.faults(page(), "login"),
            Accessibility.faultsOfColours(page(), "login"))) {
      assertEquals(1, faults.size(), faults::toString);
      assertTrue(faults.getFirst().startsWith("login: color-contrast "), faults::toString);
    }
  }

  /**
   * On all screens; all rules once in each language, in Arabic on a phone, and those of colours in
   * the dark, which are the same in both languages: in one of them, unless the walk is a whole one.
   */
  private void look(Page page, String language, String path) {
    page.waitForLoadState();
    assertThat(page.locator(".raw")).hasCount(0); // what people write is text, never mark-up
    String name = language + "-" + path.replaceAll("[^a-z0-9]+", "-");
    boolean english = language.equals("en");
    for (Screen screen :
        english ? List.of(PHONE, DARK, DESK) : List.of(DESK, DARK_PHONE, DARK, PHONE)) {
      assertFits(page, name, screen);
      if (screen.equals(DARK) && (IS_WHOLE_WALK || english == (++looks % 2 == 0))) {
        found.addAll(Accessibility.faultsOfColours(page, name + " in the dark"));
      }
      if (screen.equals(english ? DESK : PHONE)) {
        found.addAll(Accessibility.faults(page, name));
      }
    }
  }

  private void addTasks() {
    try (TestClient clerk = TestClient.signedIn(server.root(), WebTestServer.CLERK)) {
      for (String task :
          List.of(
              "Box <b class=raw>of</b> bolts (2)",
              "Pallet of gear wheels for line 4",
              "منصة تروس للخط 4")) {
        clerk.post(
            "tasks/new",
            Map.of(
                "name", task,
                "load", "2.5",
                "startStation", "Dock A",
                "goalX", "9",
                "goalY", "1.05"));
      }
      addSchedules(clerk);
    }
    server.fleet().changeTask(2, TaskState.CARRYING, List.of("r1", "r2"), "r1 carries the load.");
    server.fleet().changeTask(3, TaskState.DONE, List.of("r2"), "r2 has parked.");
    server.fleet().setAlert("The lamp of <i class=raw>hall</i> is weak.");
    server.fleet().changeFloor(Hall.crowdedFloor());
  }

  /** Another manager changes the user whose form is open here, before it is sent. */
  private void meetRival(Page page) {
    page.navigate(server.root() + "users/1");
    Locator form = page.locator("form[action$='/change']");
    String role = form.locator("[name=role]").inputValue();
    form.locator("[name=disabled]").check();
    try (TestClient other = TestClient.signedIn(server.root(), WebTestServer.MANAGER)) {
      other.post("users/1/change", Map.of("role", role.equals("MANAGER") ? "CLERK" : "MANAGER"));
    }
    form.locator("button").click();
    assertThat(page.locator("#role-help")).isVisible();
  }
}
