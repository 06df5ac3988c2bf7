package org.toqa.endtoend;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.microsoft.playwright.Page;
import com.microsoft.playwright.Page.ScreenshotOptions;
import com.microsoft.playwright.Page.WaitForFunctionOptions;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.stream.StreamSupport;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.ApiClient;
import org.toqa.testbed.BrowserTest;
import org.toqa.testbed.ToqaProcess;
import tools.jackson.databind.JsonNode;

/**
 * The demo with six robots, watched on the live map. After a whole walk {@code target/film} has the
 * film, and a picture of the page for each number of open tasks.
 */
class CrossingIT extends BrowserTest {
  private static final Path PICTURES = Path.of("target/film");
  private static final int ROBOTS = 6;
  private static final int LIMIT = 300; // seconds

  /** More than a robot's size on the map. */
  private static final double MOVED = 100; // pixels

  @TempDir private Path folder;

  @Test
  void sixRobotsCrossEachOthersWaysAndNeverMeet() throws Exception {
    Files.createDirectories(PICTURES);
    Path bodies = folder.resolve("bodies.jsonl");
    Page page = page();
    page.setViewportSize(1280, 900);
    try (ToqaProcess demo =
            ToqaProcess.program(
                folder,
                "demo",
                "--robots",
                String.valueOf(ROBOTS),
                "--speed",
                "20",
                "--port",
                "0",
                "--bodies",
                bodies.toString());
        MapRecording film = MapRecording.of(page, PICTURES.resolve("crossing.webm"))) {
      URI root = URI.create(demo.awaitErr("http://[^ ]*").group());
      try (ApiClient api = new ApiClient(root, "demo", "demo-robots")) {
        // else they have done it all before a busy machine's browser shows it
        assertTrue(api.replyTo("fleet/pause", Map.of()).isAccepted());
        FutureTask<Boolean> done = new FutureTask<>(() -> awaitAllDone(api));
        Thread.ofVirtual().start(done);

        logIn(page, root);
        assertThat(page.locator("#tasks li")).not().hasCount(0);
        assertTrue(api.replyTo("fleet/resume", Map.of()).isAccepted());
        assertThat(page.locator("#pause.paused")).hasCount(0); // which moves the map a little
        film.start();
        watchTheTasks(page);
        film.stop();

        for (int i = 1; i <= ROBOTS; i++) {
          assertTrue(
              film.distanceMoved("r" + i) > MOVED,
              "r" + i + " went " + film.distanceMoved("r" + i));
        }
        assertEquals(0, film.distanceMoved("Goods-out"), "the map itself moved");
        done.get(LIMIT, TimeUnit.SECONDS);
        RecordedBodies seen = RecordedBodies.read(bodies);
        seen.assertClear(ROBOTS);
        DemoIT.assertDone(api.get("tasks"));
        assertFalse(seen.crossings().isEmpty());
      }
    }
    assertEquals(List.of(), complaints());
  }

  private static void logIn(Page page, URI root) {
    page.navigate(root.toString());
    page.getByLabel("Name").fill("demo");
    page.getByLabel("Password").fill("demo-robots");
    page.locator("main button").click();
    assertThat(page.locator("#robots li")).hasCount(ROBOTS);
  }

  /** Until the page lists no open task any more. */
  private static void watchTheTasks(Page page) {
    int open = page.locator("#tasks li").count();
    while (open > 0) {
      if (IS_WHOLE_WALK) {
        page.screenshot(new ScreenshotOptions().setPath(PICTURES.resolve("open-" + open + ".png")));
      }
      page.waitForFunction(
          "open => document.querySelectorAll('#tasks li').length < open",
          open,
          new WaitForFunctionOptions().setTimeout(1_000.0 * LIMIT));
      open = page.locator("#tasks li").count();
    }
  }

  private static boolean awaitAllDone(ApiClient api) throws Exception {
    api.awaitSnapshot(
        snapshot -> {
          JsonNode tasks = snapshot.get("tasks");
          return tasks.size() > ROBOTS
              && StreamSupport.stream(tasks.spliterator(), false)
                  .allMatch(task -> task.get("state").asString().equals("DONE"));
        });
    return true;
  }
}
