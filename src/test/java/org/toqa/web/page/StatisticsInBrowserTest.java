package org.toqa.web.page;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.microsoft.playwright.Download;
import com.microsoft.playwright.Locator;
import com.microsoft.playwright.Page;
import com.microsoft.playwright.options.AriaRole;
import java.nio.file.Files;
import java.time.Instant;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.testbed.Hall;
import org.toqa.web.WebTestServer;
import org.toqa.web.WorkHistory;

/** The statistics in a real browser. Pictures go to {@code target/screenshots}, to be looked at. */
class StatisticsInBrowserTest extends PagesInBrowser {
  private static final String DAYS = "statistics?from=2026-11-08&to=2026-11-21";

  @ParameterizedTest
  @ValueSource(strings = {"en", "ar"})
  void chartsAreDrawnAndFitTheirScreen(String language) {
    WorkHistory.in(server).addDays(Instant.parse("2026-11-21T20:00:00Z"), 14);
    Page page = loggedIn(WebTestServer.CLERK, DESK, "language/" + language);
    for (Screen screen : List.of(DESK, DARK, PHONE, DARK_PHONE)) {
      screen.show(page);
      page.navigate(server.root() + DAYS + "&zone=UTC");

      assertThat(page.locator("html")).hasAttribute("dir", language.equals("ar") ? "rtl" : "ltr");
      assertThat(charts(page)).hasCount(8);
      for (Locator chart : charts(page).all()) {
        assertThat(chart.locator("details")).not().hasAttribute("open", "");
        assertTrue(isDrawn(chart), chart.textContent());
      }
      assertFits(page, language + "-statistics", screen);
      charts(page).last().locator("summary").click();
      charts(page).last().locator("table").scrollIntoViewIfNeeded();
      assertFits(page, language + "-statistics-table", screen);
    }
  }

  @Test
  void daysBeginAtTheReadersOwnMidnight() {
    Page page = loggedIn(WebTestServer.CLERK, DESK, "tasks");
    String zone = (String) page.evaluate("Intl.DateTimeFormat().resolvedOptions().timeZone");

    page.navigate(server.root() + "statistics");
    page.waitForURL(url -> url.contains("zone="));
    assertThat(page.locator("main")).containsText("time zone " + zone);
    page.getByRole(AriaRole.LINK, new Page.GetByRoleOptions().setName("30 days")).click();
    assertThat(page.locator("[aria-current=page]").last()).hasText("30 days");
    assertTrue(page.url().contains("zone="), page.url());
  }

  @Test
  void aFloorWithTooFewChargersIsNamed() {
    server.fleet().changeFloor(Hall.crowdedFloor());
    Page page = loggedIn(WebTestServer.CLERK, DESK, "statistics");
    assertThat(page.locator("main .notice.bad")).containsText("4 would do");
    page.navigate(server.root() + "map");
    assertThat(page.locator("#attention")).containsText("4 would do");
  }

  @Test
  void daysAreChosenAndTheirFileIsSaved() throws Exception {
    WorkHistory.in(server).addHour(Instant.parse("2026-11-20T12:00:00Z"));
    Page page = loggedIn(WebTestServer.CLERK, DESK, "statistics?zone=UTC");
    page.getByLabel("From", new Page.GetByLabelOptions().setExact(true)).fill("2026-11-19");
    page.getByLabel("To", new Page.GetByLabelOptions().setExact(true)).fill("2026-11-21");
    page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Apply")).click();

    assertThat(page.locator("main")).containsText("Nov 19, 2026 – Nov 21, 2026");
    assertThat(page.getByLabel("From", new Page.GetByLabelOptions().setExact(true)))
        .hasValue("2026-11-19");
    assertThat(page.locator(".figure").first()).hasText("4");
    Download download =
        page.waitForDownload(
            () ->
                page.getByRole(
                        AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Robot utilisation"))
                    .click());
    assertEquals("toqa-robots-2026-11-19-to-2026-11-21.csv", download.suggestedFilename());
    assertEquals(3, Files.readAllLines(download.path()).size());
  }

  @Test
  void aFailureLeadsToItsHistory() {
    WorkHistory.in(server).addHour(Instant.parse("2026-11-20T12:00:00Z"));
    Page page = loggedIn(WebTestServer.CLERK, DESK, DAYS + "&zone=UTC");

    page.getByRole(AriaRole.LINK, new Page.GetByRoleOptions().setName("Robot failed during a task"))
        .click();

    assertThat(page.locator("tbody th")).hasText(new String[] {"Something failed"});
  }

  @Test
  void whatCannotBeIsSaidAtItsField() {
    Page page =
        loggedIn(WebTestServer.CLERK, DESK, "statistics?from=2026-11-21&to=2026-11-20&zone=UTC");

    assertThat(page.getByLabel("To", new Page.GetByLabelOptions().setExact(true)))
        .hasAttribute("aria-invalid", "true");
    assertThat(page.locator("main")).containsText("The last day is before the first.");
    assertThat(charts(page)).hasCount(0);
    picture(page, "statistics-refused");
  }

  @Test
  void aPeriodWithoutAnythingSaysSo() {
    Page page = loggedIn(WebTestServer.CLERK, DESK, DAYS + "&zone=UTC");

    assertThat(page.locator(".chart .notice")).hasCount(10);
    picture(page, "statistics-empty");
  }

  private static Locator charts(Page page) {
    return page.locator("article.chart:has(canvas)");
  }

  /** Whether there is anything but the ground in its canvas. */
  private static boolean isDrawn(Locator chart) {
    return (Boolean)
        chart
            .locator("canvas")
            .evaluate(
                "canvas => canvas.width > 100 && canvas.getContext('2d')"
                    + ".getImageData(0, 0, canvas.width, canvas.height).data.some((v) => v > 0)");
  }
}
