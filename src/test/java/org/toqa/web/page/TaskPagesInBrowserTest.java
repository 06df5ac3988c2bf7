package org.toqa.web.page;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;

import com.microsoft.playwright.Locator;
import com.microsoft.playwright.Page;
import com.microsoft.playwright.options.AriaRole;
import com.microsoft.playwright.options.ColorScheme;
import com.microsoft.playwright.options.FilePayload;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.mission.TaskState;

/** Tasks are given, imported and scheduled in a real browser. */
class TaskPagesInBrowserTest extends PagesInBrowser {
  @Test
  void aTaskIsAssignedByClickingOnTheMapAndSeenToTheEnd() {
    Page page = loggedIn(1280, 900, ColorScheme.LIGHT);
    page.navigate(server.root() + "tasks/new");
    page.getByLabel("Task name").fill("Box of bolts");
    page.getByLabel("Load (kg)").fill("2.5");
    page.getByLabel("Deadline").fill("2098-07-01T15:00");
    assertThat(page.locator("#deadline-help")).hasText("Time zone: America/Bogota");
    Locator map = page.locator("#map");
    clickMap(page, map, 1.05, 5.25); // the station Dock A
    assertThat(page.locator("#startStation")).hasValue("Dock A");
    clickMap(page, map, 9, 4.5);
    assertThat(page.locator("#goalX")).hasValue(Pattern.compile("^(8\\.9|9\\.0).*"));
    assertThat(page.locator("#preview"))
        .hasText(
            Pattern.compile(
                "Needs 2 robots together. Estimated assignment: r1, r2 \\(that is"
                    + " sooner\\). Estimated distance of the load: 8.0 m."));
    picture(page, "new-task-picked");
    page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Create task")).click();

    assertThat(page.locator("h1")).hasText("Box of bolts");
    assertThat(page.locator("time[datetime='2098-07-01T20:00:00Z']")).containsText("3:00");
    assertThat(page.locator("[aria-current=step]")).hasText("Queued");
    server.fleet().changeTask(1, TaskState.CARRYING, List.of("r1"), "r1 carries the load.");
    assertThat(page.locator("[aria-current=step]")).hasText("Carrying");
    picture(page, "task-live");
    server.fleet().changeTask(1, TaskState.DONE, List.of("r1"), "r1 has parked.");
    assertThat(page.locator(".history li")).hasCount(3);
    assertThat(page.locator("[aria-current=step]")).hasText("Done");
  }

  @ParameterizedTest
  @CsvSource({"desk, 1280, 900", "phone, 390, 844"})
  void aTableIsImportedAfterItsBadLineIsMended(String name, int width, int height) {
    Page page = loggedIn(width, height, ColorScheme.LIGHT);
    page.navigate(server.root() + "tasks");
    page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Import")).click();
    assertThat(page.locator("#zone-name")).hasText("America/Bogota");
    String header = "name;load;start;goal;deadline\n";
    String good = "Box of bolts;2,5;Dock A;Shelf 3;2098-07-01 15:00\n";
    choose(page, header + good + "Box of nuts;heavy;Dock A;\n");
    assertThat(page.locator("main .notice.bad")).containsText("Nothing was imported.");
    assertThat(page.locator("#faults tbody tr")).hasCount(2);
    assertThat(page.locator("#faults tbody tr").first())
        .containsText("Enter a number, such as 2.5");
    picture(page, name + "-tasks-import-refused");

    choose(page, header + good + "Box of nuts;1;Dock A;Shelf 3;\n");

    assertThat(page.locator(".notice.good")).hasText("2 tasks were imported.");
    picture(page, name + "-tasks-imported");
    page.getByRole(AriaRole.LINK, new Page.GetByRoleOptions().setName("Box of bolts")).click();
    assertThat(page.locator("time[datetime='2098-07-01T20:00:00Z']")).containsText("3:00");
  }

  @ParameterizedTest
  @CsvSource({"desk, 1280, 900", "phone, 390, 844"})
  void aTaskIsScheduledForEveryWeekday(String name, int width, int height) {
    Page page = loggedIn(width, height, ColorScheme.LIGHT);
    page.navigate(server.root() + "tasks/new");
    page.getByLabel("Task name").fill("Morning tour");
    page.getByLabel("Load (kg)").fill("2.5");
    page.locator("#startStation").selectOption("Dock A");
    page.locator("#goalStation").selectOption("Shelf 3");
    assertThat(page.locator("#time")).isHidden();
    page.getByLabel("Schedule").selectOption("weekly");
    assertThat(page.locator("#first")).isHidden();
    page.getByLabel("Monday").check();
    page.getByLabel("Friday").check();
    picture(page, name + "-schedule-form");
    page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Create task")).click();
    assertThat(page.locator("#time-help")).containsText("Enter a time of day");
    assertThat(page.getByLabel("Monday")).isChecked();
    page.locator("#time").fill("08:00");
    page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Create task")).click();

    assertThat(page.locator(".notice.good")).hasText("The schedule was added.");
    assertThat(page.locator("tbody tr")).containsText("America/Bogota");
    picture(page, name + "-schedule-added");
    page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Pause").setExact(true))
        .click();
    assertThat(page.locator("tbody tr")).containsText("Paused");
    page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Delete")).click();
    assertThat(page.locator("tbody tr")).hasCount(0);
  }

  private static void choose(Page page, String table) {
    page.getByLabel("CSV file")
        .setInputFiles(
            new FilePayload("tasks.csv", "text/csv", table.getBytes(StandardCharsets.UTF_8)));
    page.getByRole(AriaRole.BUTTON, new Page.GetByRoleOptions().setName("Import tasks")).click();
  }
}
