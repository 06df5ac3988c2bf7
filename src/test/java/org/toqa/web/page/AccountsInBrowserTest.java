package org.toqa.web.page;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static java.util.Objects.requireNonNull;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.microsoft.playwright.Locator;
import com.microsoft.playwright.Page;
import com.microsoft.playwright.options.AriaRole;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.accounts.Role;
import org.toqa.web.TestClient;
import org.toqa.web.TestMailbox;
import org.toqa.web.WebTestServer;

/** How somebody comes to log in, in a real browser. */
class AccountsInBrowserTest extends PagesInBrowser {
  private static final Pattern LINK = Pattern.compile("https://toqa\\.example\\.org/(reset\\S+)");

  private static final Page.GetByLabelOptions EXACTLY = new Page.GetByLabelOptions().setExact(true);

  @Test
  void theFirstManagerIsMadeAtTheFirstStartAndAddsAClerk() throws Exception {
    try (WebTestServer empty = WebTestServer.startEmpty(0)) {
      Page page = page();
      DESK.show(page);
      page.navigate(empty.root().toString());
      assertThat(page.locator("h1")).hasText("Create the first manager");
      page.getByLabel("Code").fill(empty.firstStartCode());
      page.getByLabel("Name").fill("Ada");
      page.getByLabel("Password", EXACTLY).fill("short");
      click(button(page, "Create manager"));
      assertThat(page.locator("#password")).hasAttribute("aria-invalid", "true");
      assertThat(page.getByLabel("Name")).hasValue("Ada");
      page.getByLabel("Password", EXACTLY).fill("a sentence to remember");
      page.getByLabel("Password again").fill("a sentence to rememver");
      click(button(page, "Create manager"));
      assertThat(page.locator("#repeat-help")).containsText("not the password");
      page.getByLabel("Password", EXACTLY).fill("a sentence to remember");
      page.getByLabel("Password again").fill("a sentence to remember");
      click(button(page, "Create manager"));

      assertThat(page.locator("#age")).containsText("Live");
      page.navigate(empty.root() + "users");
      assertThat(page.locator("tbody tr")).hasCount(1);
      assertThat(page.locator("tbody tr")).containsText("Ada");
      assertThat(page.locator("tbody tr")).containsText("Administrator");
      click(button(page, "Log out"));
      assertThat(page.locator("h1")).hasText("Log in");
      page.navigate(empty.root() + "first-start");
      assertThat(page.locator("h1")).hasText("Log in"); // there is but one first manager
      page.getByLabel("Name").fill("Ada");
      page.getByLabel("Password").fill("a sentence to remember");
      click(button(page, "Log in"));
      assertThat(page.locator("#age")).containsText("Live");
    }
  }

  @Test
  void aForgottenPasswordIsChosenAnewByTheLinkOfTheMail() throws Exception {
    server.addUser("Grace", "grace@example.org", Role.CLERK);
    Page page = page();
    DESK.show(page);
    page.navigate(server.root().toString());
    click(page.getByText("Forgot your password?"));
    page.getByLabel("Name or e-mail address").fill("grace@example.org");
    click(button(page, "Send link"));
    assertThat(page.getByRole(AriaRole.STATUS)).containsText("a link was sent to that address");

    TestMailbox.Message mail = requireNonNull(server.mailbox().next(60), "no mail came");
    assertEquals("grace@example.org", mail.to());
    assertEquals("Toqa: reset your password", mail.subject());
    Matcher link = LINK.matcher(mail.text());
    assertTrue(link.find(), mail.text());
    page.navigate(server.root() + link.group(1));
    assertThat(page.locator("main")).containsText("Choose a new password for the user Grace.");
    page.getByLabel("New password").fill("grace");
    click(button(page, "Reset password"));
    assertThat(page.locator("#password")).hasAttribute("aria-invalid", "true");
    page.getByLabel("New password").fill("another sentence to remember");
    click(button(page, "Reset password"));

    assertThat(page.getByRole(AriaRole.STATUS)).containsText("Your password was reset.");
    page.getByLabel("Name").fill("Grace");
    page.locator("#password").fill(WebTestServer.PASSWORD);
    click(button(page, "Log in"));
    assertThat(page.getByRole(AriaRole.ALERT)).isVisible(); // the old one is not valid any more
    page.getByLabel("Name").fill("Grace");
    page.locator("#password").fill("another sentence to remember");
    click(button(page, "Log in"));
    assertThat(page.locator("#age")).containsText("Live");
    page.navigate(server.root() + link.group(1));
    assertThat(page.locator("main")).containsText("This link is no longer valid");
  }

  @ParameterizedTest
  @ValueSource(strings = {"en", "ar"})
  void longListsAreSearchedPageByPageAndTheAddressKeepsIt(String language) {
    for (int i = 1; i <= 55; i++) {
      server.addUser("driver-" + language + i, null, i == 7 ? Role.VIEWER : Role.CLERK);
    }
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "language/" + language);
    page.navigate(server.root() + "users?text=DRIVER-" + language);
    assertThat(page.locator("tbody tr")).hasCount(50);
    page.locator("a[rel=next]").click();
    assertThat(page.locator("tbody tr")).hasCount(5);
    page.locator(".filter select[name=role]").selectOption("viewer");
    page.locator(".filter button").click();
    assertThat(page.locator("tbody tr")).containsText("driver-" + language + "7");
    page.reload();
    assertThat(page.locator("tbody tr")).hasCount(1);
    assertFits(page, "users-searched-" + language, DESK, PHONE);

    try (TestClient manager = TestClient.signedIn(server.root(), WebTestServer.MANAGER)) {
      addSchedules(manager);
    }
    page.navigate(server.root() + "schedules?text=morning&state=active");
    assertThat(page.locator("tbody tr")).hasCount(3);
    page.locator("tbody form[action$='/pause'] button").first().click();
    page.navigate(server.root() + "schedules?state=paused");
    assertThat(page.locator("tbody tr")).hasCount(1);
    assertFits(page, "schedules-searched-" + language, DESK, PHONE);
    page.navigate(server.root() + "schedules?text=nothing+like+it");
    assertThat(page.locator("main .notice")).isVisible();
    page.navigate(server.root() + "schedules?state=late");
    assertThat(page.locator("select[name=state]")).isFocused();

    String name = "busy-" + language;
    server.addUser(name, null, Role.CLERK);
    for (int i = 0; i < 22; i++) {
      TestClient.signedIn(server.root(), name).close();
    }
    page.navigate(server.root() + "users?text=" + name);
    page.locator("tbody a").click();
    assertThat(page.locator("tbody tr")).hasCount(20);
    page.locator("a[rel=next]").click();
    assertThat(page.locator("tbody tr")).hasCount(2);
    assertFits(page, "sessions-" + language, DESK, PHONE);
    page.locator("main details summary").first().click();
    page.locator(".filter select[name=kind]").selectOption("token");
    page.locator(".filter button").click();
    assertThat(page.locator("tbody tr")).hasCount(0);
    page.navigate(server.root() + "users?text=" + WebTestServer.MANAGER);
    page.locator("tbody a").click();
    assertThat(page.locator(".agent").filter(new Locator.FilterOptions().setHasText("Linux")))
        .hasText(language.equals("en") ? "Chrome on Linux" : "Chrome على Linux");
  }
}
