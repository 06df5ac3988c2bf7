package org.toqa.web.page;

import static com.microsoft.playwright.assertions.PlaywrightAssertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertEquals;

import com.microsoft.playwright.Page;
import com.microsoft.playwright.Page.GetByRoleOptions;
import com.microsoft.playwright.Route;
import com.microsoft.playwright.options.AriaRole;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.toqa.mission.TaskState;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;
import org.toqa.web.access.LanguagesTest;

/**
 * The pages in Arabic, from right to left. Pictures of them go to {@code target/screenshots}, to be
 * looked at.
 */
class LanguagesInBrowserTest extends PagesInBrowser {
  @Test
  void theLanguageIsChosenAtTheLoginAndStays() {
    DESK.show(page());
    page().navigate(server.root().toString());
    assertThat(page().locator("html")).hasAttribute("dir", "ltr");
    page().getByText("العربية").click();
    assertThat(page().locator("html")).hasAttribute("dir", "rtl");
    assertThat(page().locator("h1")).hasText("تسجيل الدخول");
    page().locator("main button").click();
    assertThat(page().locator("#name-help")).hasText("أدخل اسمك.");

    logIn();
    page().navigate(server.root() + "tasks?page=1");
    assertThat(page().locator("h1")).hasText("المهام");
    page().getByText("English").click();
    assertThat(page()).hasURL(server.root() + "tasks?page=1");
    assertThat(page().locator("h1")).hasText("Tasks");
    page().getByText("العربية").click();
    page().getByRole(AriaRole.BUTTON, new GetByRoleOptions().setName("خروج")).click();
    assertThat(page().locator("h1")).hasText("تسجيل الدخول");
    Page other = page().context().newPage();
    other.navigate(server.root().toString());
    assertThat(other.locator("html")).hasAttribute("lang", "ar");
  }

  /** A password went into the field of the name, where everybody could read it. */
  @Test
  void whoTypesBeforeAFaultIsPointedOutGoesOnWhereHeIs() {
    page().navigate(server.root().toString());
    List<Route> pointingOut = new ArrayList<>();
    page().route("**/first-fault.js", pointingOut::add);
    page().locator("main button").click();
    assertThat(page().locator("#name-help")).isVisible();
    page().locator("#password").focus();
    await(page(), () -> !pointingOut.isEmpty());
    pointingOut.getFirst().resume();

    page().waitForLoadState();

    assertThat(page().locator("#password")).isFocused();
    page().unroute("**/first-fault.js");
  }

  @Test
  void aTaskIsAssignedInArabic() {
    arabic();
    logIn();
    page().navigate(server.root() + "tasks/new");
    page().getByLabel("اسم المهمة").fill("صندوق براغٍ (2)");
    page().getByLabel("الحمولة (كغم)").fill("٢٫٥");
    clickMap(
        page(),
        page().locator("#map"),
        1.05,
        5.25); // the station Dock A, on the left as on every map
    assertThat(page().locator("#startStation")).hasValue("Dock A");
    page().locator("#goalX").fill("٩");
    page().locator("#goalY").fill("٤٫٥");

    assertThat(page().locator("#preview"))
        .containsText(Pattern.compile("عدد الروبوتات التي تحملها معًا: 2\\."));
    assertThat(page().locator("#preview")).containsText("المسافة المتوقعة للحمولة: 8.0 م.");
    picture(page(), "ar-new-task-picked");
    page().getByRole(AriaRole.BUTTON, new GetByRoleOptions().setName("أنشئ المهمة")).click();

    assertThat(page().locator("h1")).hasText("صندوق براغٍ (2)");
    assertThat(page().locator("[aria-current=step]")).hasText("في الانتظار");
    assertThat(page().locator(".history")).containsText("أنشأها");
    assertThat(page().locator("main")).containsText("جارٍ البحث عن روبوت.");
    server.fleet().changeTask(1, TaskState.CARRYING, List.of("r1"), "r1 carries the load.");
    assertThat(page().locator("[aria-current=step]")).hasText("قيد النقل");
    assertThat(page().locator("time").first()).containsText("2026");
  }

  @Test
  void theLiveMapSpeaksArabic() {
    addTasks();
    server.fleet().changeTask(1, TaskState.CARRYING, List.of("r1"), "r1 carries the load.");
    server.fleet().loseRobotOf(1);
    arabic();
    logIn();

    assertThat(page().locator("#age")).containsText("مباشر · حُدّث قبل");
    assertThat(page().locator("#robots li")).hasCount(6);
    assertThat(page().locator("#robots li").first()).containsText("84");
    assertThat(page().locator("#counts")).containsText("مجهول الموضع");
    assertThat(page().locator("#attention")).containsText("مفقود والحمولة على متنه");
    assertThat(page().locator("#robots .sentence").first()).hasText("ينقل حمولة المهمة 2");
    assertThat(page().locator("#robots bdi[lang=en][dir=ltr]"))
        .hasText("The battery is nearly empty.");
    assertThat(page().locator("#tasks")).containsText("جارٍ البحث عن روبوت.");
    assertEquals(
        List.of(), latin(page().locator(".sentence bdi:not([lang=en])").allTextContents()));
    assertThat(page().locator("#tasks")).containsText("في الانتظار");
    picture(page(), "ar-map-question");
  }

  /** Those that have Latin words, but names that are isolated. */
  private static List<String> latin(List<String> texts) {
    return texts.stream()
        .map(LanguagesTest::withoutIsolated)
        .filter(text -> text.matches("(?s).*[A-Za-z]{2,}.*"))
        .toList();
  }

  private void arabic() {
    DESK.show(page());
    page().navigate(server.root() + "language/ar");
    assertThat(page().locator("html")).hasAttribute("dir", "rtl");
  }

  private void addTasks() {
    try (TestClient visitor = TestClient.signedIn(server.root(), WebTestServer.CLERK)) {
      for (String task : List.of("Box of bolts (2)", "منصة تروس للخط 4")) {
        visitor.post(
            "tasks/new",
            Map.of(
                "name", task,
                "load", "2.5",
                "startStation", "Dock A",
                "goalX", "9",
                "goalY", "1.05"));
      }
    }
  }

  /** By words that a reader of Arabic sees. */
  private void logIn() {
    page().getByLabel("الاسم").fill(WebTestServer.MANAGER);
    page().getByLabel("كلمة المرور").fill(WebTestServer.PASSWORD);
    page().locator("main button").click();
    assertThat(page().locator("#map")).isVisible();
  }
}
