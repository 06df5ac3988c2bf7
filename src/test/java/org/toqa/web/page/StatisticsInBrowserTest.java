package org.toqa.web.page;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.microsoft.playwright.Download;
import com.microsoft.playwright.Locator;
import com.microsoft.playwright.Page;
import com.microsoft.playwright.options.AriaRole;
import com.microsoft.playwright.options.ColorScheme;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.testbed.BrowserTest;
import org.toqa.web.WebTestServer;
import org.toqa.web.WorkHistory;

/** The statistics in a real browser. Pictures go to {@code target/screenshots}, to be looked at. */
class StatisticsInBrowserTest extends BrowserTest {
  private static final Path PICTURES = Path.of("target/screenshots");
  private static final String DAYS = "statistics?from=2026-11-08&to=2026-11-21";

  private WebTestServer server;

  @BeforeEach
  void start() throws Exception {
    server = WebTestServer.startForBrowser();
    page().navigate(server.root().toString());
    page().getByLabel("Name").fill(WebTestServer.CLERK);
    page().getByLabel("Password").fill(WebTestServer.PASSWORD);
    page().locator("main button").click();
    assertThat(page().locator("#map")).isVisible();
  }

  @AfterEach
  void stop() throws Exception {
    server.close();
    assertEquals(
        List.of(),
        complaints().stream().filter(c -> !c.startsWith("Failed to load resource")).toList());
  }

  @ParameterizedTest
  @CsvSource({
    "1280, 800, LIGHT, desktop",
    "1280, 800, DARK, dark",
    "390, 844, LIGHT, phone",
    "390, 844, DARK, dark-phone"
  })
  void chartsAreDrawnAndFitTheirScreen(int width, int height, ColorScheme scheme, String name) {
    WorkHistory.in(server).addDays(Instant.parse("2026-11-21T20:00:00Z"), 14);
    page().setViewportSize(width, height);
    page().emulateMedia(new Page.EmulateMediaOptions().setColorScheme(scheme));
    page().navigate(server.root() + DAYS + "&zone=UTC");

    assertThat(charts()).hasCount(8);
    for (Locator chart : charts().all()) {
      assertThat(chart.locator("details")).not().hasAttribute("open", "");
      assertTrue(isDrawn(chart), chart.textContent());
    }
    page()
        .screenshot(
            new Page.ScreenshotOptions()
                .setPath(PICTURES.resolve(name + "-statistics.png"))
                .setFullPage(true));
    assertFalse((Boolean) page().evaluate("document.documentElement.scrollWidth > innerWidth"));
    charts().last().locator("summary").click();
    charts().last().locator("table").scrollIntoViewIfNeeded();
    page()
        .screenshot(
            new Page.ScreenshotOptions().setPath(PICTURES.resolve(name + "-statistics-table.png")));
    assertFalse((Boolean) page().evaluate("document.documentElement.scrollWidth > innerWidth"));
  }

  @ParameterizedTest
  @CsvSource({"1280, 800, ar-desktop", "390, 844, ar-phone"})
  void inArabicTheChartsRunFromRightToLeft(int width, int height, String name) {
    WorkHistory.in(server).addDays(Instant.parse("2026-11-21T20:00:00Z"), 14);
    page().setViewportSize(width, height);
    page().navigate(server.root() + "language/ar");
    page().navigate(server.root() + DAYS + "&zone=UTC");

    assertThat(page().locator("html")).hasAttribute("dir", "rtl");
    assertThat(charts()).hasCount(8);
    for (Locator chart : charts().all()) {
      assertTrue(isDrawn(chart), chart.textContent());
    }
    page()
        .screenshot(
            new Page.ScreenshotOptions()
                .setPath(PICTURES.resolve(name + "-statistics.png"))
                .setFullPage(true));
    assertFalse((Boolean) page().evaluate("document.documentElement.scrollWidth > innerWidth"));
  }

  @Test
  void daysBeginAtTheReadersOwnMidnight() {
    String zone = (String) page().evaluate("Intl.DateTimeFormat().resolvedOptions().timeZone");

    page().navigate(server.root() + "statistics");
    page().waitForURL(url -> url.contains("zone="));
    assertThat(page().locator("main")).containsText("time zone " + zone);
    page().getByRole(AriaRole.LINK, new Page.GetByRoleOptions().setName("30 days")).click();
    assertThat(page().locator("[aria-current=page]").last()).hasText("30 days");
    assertTrue(page().url().contains("zone="), page().url());
  }

  @Test
  void daysAreChosenAndTheirFileIsSaved() throws Exception {
    WorkHistory.in(server).addHour(Instant.parse("2026-11-20T12:00:00Z"));
    page().navigate(server.root() + "statistics?zone=UTC");
    page().getByLabel("From", new Page.GetByLabelOptions().setExact(true)).fill("2026-11-19");
    page().getByLabel("To", new Page.GetByLabelOptions().setExact(true)).fill("2026-11-21");
    page().getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Apply")).click();

    assertThat(page().locator("main")).containsText("Nov 19, 2026 – Nov 21, 2026");
    assertThat(page().getByLabel("From", new Page.GetByLabelOptions().setExact(true)))
        .hasValue("2026-11-19");
    assertThat(page().locator(".figure").first()).hasText("4");
    Download download =
        page()
            .waitForDownload(
                () ->
                    page()
                        .getByRole(
                            AriaRole.BUTTON,
                            new Page.GetByRoleOptions().setName("Robot utilisation"))
                        .click());
    assertEquals("toqa-robots-2026-11-19-to-2026-11-21.csv", download.suggestedFilename());
    assertEquals(3, Files.readAllLines(download.path()).size());
  }

  @Test
  void aFailureLeadsToItsHistory() {
    WorkHistory.in(server).addHour(Instant.parse("2026-11-20T12:00:00Z"));
    page().navigate(server.root() + DAYS + "&zone=UTC");

    page()
        .getByRole(AriaRole.LINK, new Page.GetByRoleOptions().setName("Robot failed during a task"))
        .click();

    assertThat(page().locator("tbody th")).hasText(new String[] {"Something failed"});
  }

  @Test
  void whatCannotBeIsSaidAtItsField() {
    page().setViewportSize(1280, 800);
    page().navigate(server.root() + "statistics?from=2026-11-21&to=2026-11-20&zone=UTC");

    assertThat(page().getByLabel("To", new Page.GetByLabelOptions().setExact(true)))
        .hasAttribute("aria-invalid", "true");
    assertThat(page().locator("main")).containsText("The last day is before the first.");
    assertThat(charts()).hasCount(0);
    page()
        .screenshot(
            new Page.ScreenshotOptions().setPath(PICTURES.resolve("statistics-refused.png")));
  }

  @Test
  void aPeriodWithoutAnythingSaysSo() {
    page().setViewportSize(1280, 800);
    page().navigate(server.root() + DAYS + "&zone=UTC");

    assertThat(page().locator(".chart .notice")).hasCount(8);
    page()
        .screenshot(new Page.ScreenshotOptions().setPath(PICTURES.resolve("statistics-empty.png")));
  }

  private Locator charts() {
    return page().locator("article.chart:has(canvas)");
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
