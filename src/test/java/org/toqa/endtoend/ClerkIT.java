package org.toqa.endtoend;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.microsoft.playwright.Locator;
import com.microsoft.playwright.Page;
import com.microsoft.playwright.assertions.LocatorAssertions.HasTextOptions;
import com.microsoft.playwright.options.AriaRole;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.testbed.BrowserTest;
import org.toqa.testbed.MapCanvas;
import org.toqa.testbed.RealMySql;

/**
 * What a clerk does: logs in, clicks start and goal on the map, and watches the load get there; at
 * a desktop with H2, on a phone with MySQL.
 */
class ClerkIT extends BrowserTest {
  private static final double WIDTH = 20.1; // the lab: 67 x 40 cells of 0.30 m
  private static final double HEIGHT = 12.0;

  @TempDir private Path folder;

  @ParameterizedTest
  @CsvSource({"1280, 900, false", "390, 844, true"})
  void aTaskIsAssignedOnTheMapAndSeenToItsEnd(int width, int height, boolean isMySql)
      throws Exception {
    Page page = page();
    page.setViewportSize(width, height);
    List<String> options = new ArrayList<>(List.of("--simulate", "3", "--speed", "5"));
    if (isMySql) {
      Path config = folder.resolve("server.yaml");
      Files.writeString(config, "database:\n  url: \"" + RealMySql.newDatabase() + "\"\n");
      options.addAll(List.of("--config", config.toString()));
    }
    try (RunningServer server = new RunningServer(folder, options.toArray(String[]::new))) {
      page.navigate(server.root().toString());
      page.getByLabel("Name").fill(RunningServer.MANAGER);
      page.getByLabel("Password").fill(RunningServer.PASSWORD);
      page.locator("main button").click();
      assertThat(page.locator("#robots li")).hasCount(3);

      page.navigate(server.root().resolve("tasks/new").toString());
      page.getByLabel("Task name").fill("Box of bolts");
      page.getByLabel("Load (kg)").fill("2.5");
      MapCanvas map = MapCanvas.ofMap(page, WIDTH, HEIGHT);
      map.click(11.55, 1.05); // the station Goods-out
      assertThat(page.locator("#startStation")).hasValue("Goods-out");
      map.click(9.45, 2.85); // a free place
      page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Create task")).click();

      assertThat(page.locator("h1")).hasText("Box of bolts");
      long task = Long.parseLong(page.url().replaceAll(".*/", ""));
      server.await("tasks/" + task, t -> t.get("robots").size() == 1);
      // else it has done it all before a busy machine's browser shows it
      server.awaitAccepted("tasks/" + task + "/hold", Map.of());
      String robot = server.task(task).get("robots").get(0).asString();
      page.navigate(server.root().resolve("map").toString());
      Locator entry =
          page.locator("#robots li").filter(new Locator.FilterOptions().setHasText(robot));
      assertThat(entry).containsText("is on hold");
      server.awaitAccepted("tasks/" + task + "/resume", Map.of());
      assertThat(entry)
          .containsText(Pattern.compile("Driving to the load|Carrying the load|Driving home"));
      Object before = page.evaluate("document.querySelector('#map').toDataURL()");
      page.waitForFunction("old => document.querySelector('#map').toDataURL() !== old", before);

      page.navigate(server.root().resolve("tasks/" + task).toString());
      assertThat(page.locator("[aria-current=step]"))
          .hasText("Done", new HasTextOptions().setTimeout(120_000));
    }
    assertEquals(List.of(), complaints());
  }
}
