package org.toqa.endtoend;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.microsoft.playwright.Locator;
import com.microsoft.playwright.Page;
import com.microsoft.playwright.options.AriaRole;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.BrowserTest;
import org.toqa.testbed.RealMySql;

/** An administrator makes a site, its people use it, and he looks at it and deletes it. */
class SitesIT extends BrowserTest {
  private static final String PASSWORD = "north-of-robots";

  @TempDir private Path folder;

  @Test
  void aSiteIsMadeUsedLookedAtAndDeleted() throws Exception {
    Page page = page();
    Path config = folder.resolve("server.yaml");
    Files.writeString(config, "database:\n  url: \"" + RealMySql.newDatabase() + "\"\n");
    try (RunningServer server =
        new RunningServer(folder, "--simulate", "2", "--config", config.toString())) {
      URI root = server.root();
      logIn(page, root, RunningServer.MANAGER, RunningServer.PASSWORD);
      page.navigate(root.resolve("users").toString());
      page.locator("main a").filter(having("Sites")).click();
      page.getByLabel("Name", exactly()).fill("north");
      page.getByLabel("Its first manager").fill("nora");
      page.getByLabel("The manager’s password").fill(PASSWORD);
      page.getByRole(AriaRole.BUTTON, button("Add site")).click();
      assertThat(page.getByRole(AriaRole.STATUS)).containsText("The site was added");
      assertThat(page.locator("tbody tr")).hasCount(2);
      logOut(page);

      logIn(page, root, "nora@north", PASSWORD);
      assertThat(page.locator("#robots li")).hasCount(0);
      page.navigate(root.resolve("users").toString());
      assertThat(page.locator("tbody tr")).hasCount(1);
      assertThat(page.locator("main a").filter(having("Sites"))).hasCount(0);
      page.navigate(root.resolve("floors").toString());
      assertThat(page.locator("tbody th")).hasText("lab");
      logOut(page);

      page.setViewportSize(390, 844);
      logIn(page, root, RunningServer.MANAGER, RunningServer.PASSWORD);
      assertThat(page.locator("#robots li")).hasCount(2);
      page.navigate(root.resolve("sites").toString());
      page.getByRole(AriaRole.BUTTON, button("Look at it")).click();
      assertThat(page.locator(".visit")).containsText("north");
      assertThat(page.locator("#robots li")).hasCount(0);
      assertThat(page.getByRole(AriaRole.BUTTON, button("Pause all robots"))).hasCount(0);
      page.navigate(root.resolve("users").toString());
      assertThat(page.locator("tbody tr th")).containsText("nora");
      page.locator(".visit button").click();
      assertThat(page.locator(".visit")).hasCount(0);
      assertThat(page.locator("h1")).hasText("Sites");
      page.locator("summary").filter(having("Delete")).click();
      page.getByRole(AriaRole.BUTTON, button("Delete site")).click();
      assertThat(page.getByRole(AriaRole.STATUS)).containsText("The site was deleted");
      assertThat(page.locator("tbody tr")).hasCount(1);
    }
    // what a page asks by itself while its session ends is refused
    assertEquals(
        List.of(), complaints().stream().filter(c -> !c.contains("a status of 401")).toList());
  }

  private static void logIn(Page page, URI root, String name, String password) {
    page.navigate(root.toString());
    page.getByLabel("Name").fill(name);
    page.getByLabel("Password").fill(password);
    page.locator("main button").click();
    assertThat(page).hasURL(root.resolve("map").toString());
  }

  private static void logOut(Page page) {
    page.getByRole(AriaRole.BUTTON, button("Log out")).click();
    assertThat(page.getByLabel("Password")).isVisible();
  }

  private static Page.GetByRoleOptions button(String name) {
    return new Page.GetByRoleOptions().setName(name);
  }

  private static Page.GetByLabelOptions exactly() {
    return new Page.GetByLabelOptions().setExact(true);
  }

  private static Locator.FilterOptions having(String text) {
    return new Locator.FilterOptions().setHasText(text);
  }
}
