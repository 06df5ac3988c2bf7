package org.toqa.endtoend;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.microsoft.playwright.Locator;
import com.microsoft.playwright.Page;
import com.microsoft.playwright.options.AriaRole;
import java.net.URI;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.StreamSupport;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.ApiClient;
import org.toqa.testbed.BrowserTest;
import org.toqa.testbed.ToqaProcess;
import tools.jackson.databind.JsonNode;

/**
 * CSM-MAMRS as a user sees it: three floors, robots over HTTP and MQTT, and their control pages.
 */
@Tag("full")
class BuildingDemoIT extends BrowserTest {
  private static final String ADDRESS = "Toqa is at (\\S+)";
  private static final int TASKS = 4;

  @TempDir private Path folder;

  @Test
  void aRobotIsWatchedStoppedAndWhenAllIsDoneDrivenByHand() throws Exception {
    Page page = page();
    page.setViewportSize(390, 844);
    try (ToqaProcess demo =
        ToqaProcess.program(folder, "demo", "--scenario", "building", "--port", "0")) {
      String root = demo.awaitErr(ADDRESS).group(1);
      page.navigate(root);
      page.getByLabel("Name").fill("demo");
      page.getByLabel("Password").fill("demo-robots");
      page.locator("main button").click();
      assertThat(page.locator("#map")).isVisible();
      page.navigate(root + "robots/r2/control");

      // watched while it works
      assertThat(page.locator(".heading .state")).hasText("Driving");
      assertThat(page.locator("#gauge-left .caption")).hasText("Left wheel");
      assertThat(page.locator("#gauge-left output"))
          .hasText(Pattern.compile("0\\.[0-9]*[1-9] m/s"));
      assertThat(page.locator("#value-crossTrack")).hasText(Pattern.compile("-?[0-9]+ mm"));
      assertThat(page.locator("#ranges li")).hasCount(9);
      assertThat(page.locator("#ranges li").first())
          .hasText(Pattern.compile("Sensor 1\\s*\\d\\.\\d\\d m"));

      // stopped and started
      button(page, "Stop").first().click();
      assertThat(page.locator(".heading .state")).hasText("On hold");
      assertThat(page.locator("#gauge-left output")).hasText("0.00 m/s");
      button(page, "Start").click();
      assertThat(page.locator(".heading .state")).hasText("Driving");

      // no hand while it has a task
      button(page, "Drive by hand").click();
      assertThat(page.locator("#hand-says")).containsText("works on task");
      try (ApiClient api = new ApiClient(URI.create(root), "demo", "demo-robots")) {
        api.awaitSnapshot(
            snapshot -> areAllDone(snapshot.get("tasks")) && isSecondRobotFree(snapshot));
      }

      page.waitForCondition(() -> tryToTurnByHand(page, root));

      demo.terminate();
      // 128 + SIGTERM; a suite in the background hands on that Ctrl-C is ignored
      assertEquals(143, demo.exitCode());
    }
    assertEquals(
        List.of(),
        complaints().stream().filter(c -> !c.startsWith("Failed to load resource")).toList());
  }

  /**
   * Turns it until it is seen to turn, and leaves it. On a busy machine the robot may not answer in
   * time: then it is nobody's, and a person begins again.
   *
   * @return whether it was neither refused nor broken off
   */
  private static boolean tryToTurnByHand(Page page, String root) {
    page.navigate(root + "robots/r2/control");
    assertThat(page.locator("#pose")).hasText(Pattern.compile("\\d"));
    String before = page.locator("#pose").textContent();
    button(page, "Drive by hand").click();
    page.locator("#pad:not([hidden]), #hand-says:not([hidden])").first().waitFor();
    if (page.locator("#pad").isVisible()) {
      button(page, "Turn left").hover();
      page.mouse().down();
      page.waitForCondition(
          () -> isLeft(page) || !page.locator("#pose").textContent().equals(before));
      page.waitForCondition(
          () ->
              isLeft(page)
                  || (page.locator(".heading .state").textContent().equals("Driving")
                      && page.locator("main").textContent().contains("demo drives it by hand")));
      page.mouse().up();
      page.waitForCondition(
          () -> isLeft(page) || page.locator(".heading .state").textContent().equals("Idle"));
    }
    if (isLeft(page)) {
      return false;
    }
    button(page, "Stop driving by hand").click();
    page.navigate(root + "history?robot=r2"); // at once: what was clicked is done all the same
    page.waitForCondition(
        () -> {
          page.reload();
          return page.locator("main").textContent().contains("demo stopped driving r2 by hand");
        });
    return true;
  }

  /** Whether it was refused, or broken off. */
  private static boolean isLeft(Page page) {
    return page.locator("#pad").isHidden();
  }

  private static boolean areAllDone(JsonNode tasks) {
    return tasks.size() == TASKS
        && tasks.valueStream().allMatch(task -> task.get("state").asString().equals("DONE"));
  }

  /** It has parked, and has no task; where it loads it stands idle too. */
  private static boolean isSecondRobotFree(JsonNode snapshot) {
    return StreamSupport.stream(snapshot.get("robots").spliterator(), false)
        .filter(robot -> robot.get("name").asString().equals("r2"))
        .anyMatch(
            robot -> robot.get("state").asString().equals("IDLE") && robot.get("task").isNull());
  }

  private static Locator button(Page page, String name) {
    return page.getByRole(
        AriaRole.BUTTON, new Page.GetByRoleOptions().setName(name).setExact(true));
  }
}
