package org.toqa.web.page;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.microsoft.playwright.Locator;
import com.microsoft.playwright.Page;
import com.microsoft.playwright.Route;
import com.microsoft.playwright.options.AriaRole;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.notices.Condition;
import org.toqa.notices.Notice;
import org.toqa.notices.NoticeKind;
import org.toqa.notices.NoticeStore.Change;
import org.toqa.web.WebTestServer;
import org.toqa.wording.Phrase;

/** How somebody is told by pages of what needs attention, and chooses it, in a real browser. */
class NoticesInBrowserTest extends PagesInBrowser {
  /** Counts sounds, and keeps what the browser was asked to show. */
  private static final String EARS =
      """
      window.shown = [];
      window.sounds = 0;
      window.Notification = class {
        static permission = 'granted';
        constructor(title, {body}) { window.shown.push(`${title}: ${body}`); }
        addEventListener() {}
      };
      const Silent = window.AudioContext;
      window.AudioContext = class extends Silent {
        constructor() { super(); window.sounds++; }
      };
      """;

  private void change(Notice notice, boolean ending) {
    server.notices().add(List.of(new Change(notice, ending, List.of())), Instant.now(), _ -> false);
  }

  private Notice begin(NoticeKind kind, String robot) {
    Notice notice =
        new Notice(
            0,
            UUID.randomUUID(),
            new Condition(
                kind,
                robot,
                "hall",
                null,
                robot,
                null,
                Phrase.NOTICE_OF_ROBOT.with(robot, Phrase.NOTICE_ROBOT_LOST.with())),
            Instant.now(),
            null);
    change(notice, false);
    return notice;
  }

  private void end(Notice notice) {
    change(new Notice(0, notice.uid(), notice.condition(), notice.begunAt(), Instant.now()), true);
  }

  private static Locator bell(Page page) {
    return page.locator(".bell");
  }

  @Test
  void theBadgeCountsOnEveryPageAndGoesWhenAllIsSeen() {
    Page page = loggedIn(WebTestServer.CLERK, DESK, "tasks");
    assertThat(bell(page).locator(".count")).isHidden();
    String icon = page.locator("link[rel=icon]").getAttribute("href");

    Notice lost = begin(NoticeKind.ROBOT_LOST, "r1"); // while the page is open
    assertThat(bell(page).locator(".count")).hasText("1");
    assertThat(page).hasTitle(Pattern.compile("^\\(1\\) .*"));
    assertThat(bell(page)).hasAttribute("aria-label", "Notices, 1 unseen");
    assertThat(page.locator("link[rel=icon]"))
        .hasAttribute("href", Pattern.compile("^data:image/png;base64,.*"));
    begin(NoticeKind.SERVER, "r2");
    assertThat(bell(page).locator(".count")).hasText("2");
    end(lost);

    click(bell(page));
    assertThat(page.locator("tbody tr")).hasCount(2);
    assertThat(page.locator("tbody tr").last()).containsText("r1: lost, nothing is heard of it");
    assertThat(page.locator("tbody tr").last().locator(".ongoing")).hasCount(0);
    assertThat(page.locator("tbody tr").first().locator(".ongoing")).hasText("Ongoing");
    assertFits(page, "notices", DARK, PHONE, DESK);
    click(page.locator("tbody tr").first().getByText("Mark as seen"));
    assertThat(page.locator("tbody tr").first()).containsText("Clara");
    assertThat(bell(page).locator(".count")).hasText("1");
    click(page.getByText("Mark all as seen"));
    assertThat(bell(page).locator(".count")).isHidden();
    assertThat(page).hasTitle(Pattern.compile("^Notices.*"));
    assertThat(page.locator("link[rel=icon]")).hasAttribute("href", icon);
    click(page.getByText("Not seen by you"));
    assertThat(page.locator("main")).containsText("You have seen all notices.");

    Page other = loggedIn(WebTestServer.MANAGER, DESK, "notices"); // it is seen by oneself
    assertThat(bell(other).locator(".count")).hasText("2");
    assertThat(other.locator("tbody tr").last()).containsText("Clara");
  }

  @Test
  void theBrowserTellsOnceWhatWasChosen() {
    Page page = loggedIn(WebTestServer.CLERK, DESK, "notices");
    page.context().addInitScript(EARS);
    page.navigate(server.root() + "notices/settings");
    page.getByLabel("Robot lost: Browser notification").check();
    page.getByLabel("Robot lost: Sound").check();
    page.getByLabel("Server needs attention: Count on pages").uncheck();
    assertThat(page.locator("#browser-state")).containsText("while a page of Toqa is open");
    click(button(page, "Save"));
    assertThat(page.getByRole(AriaRole.STATUS)).containsText("Your choice is saved.");
    assertThat(page.getByLabel("Robot lost: Sound")).isChecked();

    begin(NoticeKind.SERVER, "r2");
    begin(NoticeKind.ROBOT_LOST, "r1");
    await(page, "window.shown.length === 1");
    assertEquals("Robot lost: r1: lost, nothing is heard of it", page.evaluate("window.shown[0]"));
    await(page, "window.sounds === 1");
    assertThat(bell(page).locator(".count")).hasText("1");

    Page second = page.context().newPage(); // of the same browser: it has been told
    second.navigate(server.root() + "notices");
    assertThat(bell(second).locator(".count")).hasText("1");
    begin(NoticeKind.ROBOT_LOST, "r3");
    await(
        page,
        () ->
            ((List<?>) page.evaluate("window.shown")).size()
                    + ((List<?>) second.evaluate("window.shown")).size()
                == 2);
    assertThat(bell(page).locator(".count")).hasText("2");
    assertThat(bell(second).locator(".count")).hasText("2");
    assertEquals(
        2,
        ((List<?>) page.evaluate("window.shown")).size()
            + ((List<?>) second.evaluate("window.shown")).size());
    second.close();
  }

  @Test
  void whatBeginsBeforeThePageIsConnectedIsCountedToo() {
    Page page = loggedIn(WebTestServer.CLERK, DESK, "help");
    List<Route> connecting = new ArrayList<>();
    page.route("**/api/v1/events?*", connecting::add);
    page.waitForResponse("**/notices/news", page::reload);
    await(page, () -> !connecting.isEmpty());
    begin(NoticeKind.ROBOT_LOST, "r1");
    connecting.getFirst().resume();

    assertThat(bell(page).locator(".count")).hasText("1");
    page.unroute("**/api/v1/events?*");
  }

  @ParameterizedTest
  @CsvSource({
    "en, 'Enter both times, or leave both empty.', Webhooks",
    "ar, أدخل الوقتين معًا أو اتركهما فارغين., خطافات الويب"
  })
  void settingsAndWebhooksAreInNobodysWay(String language, String sentence, String webhooks) {
    Page page = loggedIn(WebTestServer.MANAGER, DESK, "notices");
    page.navigate(server.root() + "language/" + language + "?back=/notices/settings");
    page.locator("#quietFrom").fill("22:00");
    page.locator("main form > button").click();
    assertThat(page.locator("#quietUntil-help")).hasText(sentence);
    assertThat(page.locator("#quietFrom")).hasValue("22:00");
    assertEquals(List.of(), Accessibility.faults(page, "settings " + language));
    assertFits(page, "notice-settings-" + language, DARK, PHONE, DESK);

    page.navigate(server.root() + "notices");
    click(
        page.getByRole(AriaRole.BUTTON, link(webhooks))
            .or(page.getByRole(AriaRole.LINK, link(webhooks))));
    page.locator("#url").fill("https://10.0.0.1/hook");
    page.locator("main form button").last().click();
    assertThat(page.locator("#url")).hasAttribute("aria-invalid", "true"); // it is the new page
    page.locator("#url").fill("http://127.0.0.1:9/hook");
    page.locator("main form button").last().click();
    assertTrue(
        page.locator(".secret").textContent().matches("whsec_[A-Za-z0-9+/]{43}="),
        page.locator(".secret")::textContent);
    assertEquals(List.of(), Accessibility.faults(page, "webhooks " + language));
    assertFits(page, "webhooks-" + language, DARK, PHONE, DESK);
    page.reload();
    assertThat(page.locator(".secret")).hasCount(0);
    page.locator("article form[action$='/test'] button").click();
    assertThat(page.locator("main").getByRole(AriaRole.ALERT)).isVisible(); // nobody listens there
    page.locator("article details").last().locator("summary").click();
    page.locator("article form[action$='/delete'] button").click();
    assertThat(page.locator("article")).hasCount(1); // the form for another one
    page.navigate(server.root() + "language/en?back=/notices");
  }
}
