package org.toqa.endtoend;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.microsoft.playwright.Page;
import com.microsoft.playwright.assertions.LocatorAssertions.HasTextOptions;
import com.microsoft.playwright.options.AriaRole;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.BrowserTest;
import org.toqa.testbed.MapCanvas;

/** A manager draws a floor from nothing, adds a robot to it, and has a load carried. */
class DrawnFloorIT extends BrowserTest {
  private static final double WIDTH = 12;
  private static final double HEIGHT = 6;
  private static final double SPEED = 10;

  @TempDir private Path folder;

  @Test
  void aLoadIsCarriedOnAFloorThatWasDrawnInTheBrowser() throws Exception {
    Page page = page();
    try (RunningAgent agent = new RunningAgent(folder, "carl", 10.05, 1.05, SPEED);
        RunningServer server =
            new RunningServer(folder, "--simulate", "1", "--speed", String.valueOf(SPEED))) {
      page.navigate(server.root().toString());
      page.getByLabel("Name").fill(RunningServer.MANAGER);
      page.getByLabel("Password").fill(RunningServer.PASSWORD);
      page.locator("main button").click();

      page.navigate(server.root().resolve("floors").toString());
      page.locator("#name").fill("Workshop");
      page.locator("#width").fill("12");
      page.locator("#height").fill("6");
      page.locator("#resolution").fill("0.3");
      click(page, "Add floor");
      page.locator("tbody tr").nth(1).getByText("Edit").click();
      draw(page);

      page.navigate(server.root().resolve("robots").toString());
      page.locator("#floor").last().selectOption("Workshop");
      page.locator("#name").fill(agent.name());
      page.locator("#host").fill("127.0.0.1");
      page.locator("#port").fill(String.valueOf(agent.port()));
      page.locator("#maxLoad").fill("5");
      page.locator("#code").fill(agent.restartForPairing());
      page.locator("main form button").last().click();
      assertThat(page.locator("h1")).hasText("Robot carl");

      page.navigate(server.root().resolve("tasks/new").toString());
      page.locator("#floor").selectOption("Workshop");
      page.getByLabel("Task name").fill("First crate");
      page.getByLabel("Load (kg)").fill("2");
      MapCanvas map = MapCanvas.ofMap(page, WIDTH, HEIGHT);
      map.click(1.05, 1.05);
      assertThat(page.locator("#startStation")).hasValue("Dock");
      map.click(10.05, 5.05);
      assertThat(page.locator("#goalStation")).hasValue("Press");
      click(page, "Create task");

      assertThat(page.locator("h1")).hasText("First crate");
      assertThat(page.locator("[aria-current=step]"))
          .hasText("Done", new HasTextOptions().setTimeout(120_000));
    }
    assertEquals(List.of(), complaints());
  }

  /** A wall around, one with a gap in it, two stations and a parking point; it comes in force. */
  private static void draw(Page page) {
    MapCanvas map = MapCanvas.ofEditor(page, WIDTH, HEIGHT);
    assertThat(page.locator("#save-state")).hasText("Nothing changed yet");
    tool(page, "rectangle");
    map.drag(0.15, 0.15, 11.85, 5.85);
    tool(page, "line");
    map.drag(6.15, 5.55, 6.15, 2.25);
    tool(page, "stations");
    map.click(1.05, 1.05);
    name(page, "Dock");
    map.click(10.05, 5.05);
    name(page, "Press");
    tool(page, "parking");
    map.click(10.05, 1.05);
    assertThat(page.locator("#save-state")).hasText("Draft saved");
    page.locator("#publish").click();
    page.locator("#publish-sure").click();
    assertThat(page.locator("#problems-summary")).hasText("Published. The drawing is in force.");
  }

  private static void name(Page page, String name) {
    page.locator("[data-field=name]").fill(name);
    page.locator("[data-field=name]").press("Tab");
  }

  private static void tool(Page page, String tool) {
    page.locator("[data-tool=" + tool + "]").click();
  }

  private static void click(Page page, String button) {
    page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName(button)).click();
  }
}
