package org.toqa.endtoend;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.microsoft.playwright.Page;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.BrowserTest;
import tools.jackson.databind.JsonNode;

/** A robot is paired as a manager does it: in the browser, by the API, and anew. */
class PairingIT extends BrowserTest {

  @TempDir private Path folder;

  @Test
  void robotIsPairedInTheBrowserAndAfterItsKeyWasReplacedAnew() throws Exception {
    Page page = page();
    try (RunningAgent agent = new RunningAgent(folder, "carl", 7.95, 3.15, 1);
        RunningServer server = new RunningServer(folder)) {
      page.navigate(server.root().toString());
      page.getByLabel("Name").fill(RunningServer.MANAGER);
      page.getByLabel("Password").fill(RunningServer.PASSWORD);
      page.locator("main button").click();
      page.navigate(server.root().resolve("robots").toString());
      String code = agent.restartForPairing();
      add(page, agent, code.substring(0, code.length() - 1) + (code.endsWith("A") ? "B" : "A"));
      assertThat(page.locator("#code-help")).containsText("The code is wrong; tries left: 4.");
      add(page, agent, code);
      assertThat(page.locator("h1")).hasText("Robot carl");
      server.await("robots/carl", PairingIT::isIdle);
      assertFalse(server.api().get("robots/carl").get("fingerprint").isNull());

      server.killAndRestart();
      server.await("robots/carl", PairingIT::isIdle);

      agent.kill();
      Files.delete(folder.resolve("carl/data/link.p12"));
      agent.start();
      JsonNode refused = server.await("robots/carl", robot -> !robot.get("alert").isNull());
      assertTrue(refused.get("alert").asString().contains("its key differs"), refused.toString());
      server
          .api()
          .post(
              "robots/carl/pair",
              Map.of("host", "127.0.0.1", "port", agent.port(), "code", agent.restartForPairing()));
      server.await("robots/carl", robot -> isIdle(robot) && robot.get("alert").isNull());
    }
  }

  private static void add(Page page, RunningAgent agent, String code) {
    page.locator("#name").fill(agent.name());
    page.locator("#host").fill("127.0.0.1");
    page.locator("#port").fill(String.valueOf(agent.port()));
    page.locator("#maxLoad").fill("5");
    page.locator("#code").fill(code);
    page.locator("main form button").last().click();
  }

  private static boolean isIdle(JsonNode robot) {
    return robot.get("state").asString().equals("IDLE");
  }
}
