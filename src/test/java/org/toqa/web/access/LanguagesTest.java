package org.toqa.web.access;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.net.URLEncoder;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.toqa.fleet.RobotState;
import org.toqa.geometry.Pose;
import org.toqa.mission.TaskState;
import org.toqa.testbed.Hall;
import org.toqa.web.TestClient;
import org.toqa.web.WebServerTest;
import org.toqa.web.WebTestServer;
import org.toqa.wording.Phrase;
import org.toqa.wording.Sentence;

/** Which language an answer is in, and what Arabic pages and forms are like. */
public class LanguagesTest extends WebServerTest {
  private static final String ARABIC_PAGE = "<html lang=\"ar\" dir=\"rtl\"";
  private static final String ENGLISH_PAGE = "<html lang=\"en\" dir=\"ltr\"";
  private static final Map<String, String> TASK =
      Map.of(
          "name", "صندوق براغٍ",
          "load", "٢٫٥",
          "startStation", "Dock A",
          "goalX", "١٠٫٣٥",
          "goalY", "۱٫۰۵");

  private TestClient arab;

  @BeforeAll
  void speakArabic() {
    server
        .fleet()
        .setRobots(Hall.robot("r1", RobotState.IDLE, new Pose(1.05, 0.75, 0), "127.0.0.1", 7275));
    server.fleet().changeFloor(Hall.crowdedFloor());
    arab = clerk;
    arab.get("language/ar");
    manager.get("language/ar");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          ar-EG,en;q=0.5 | ar | rtl | تسجيل الدخول
          en,ar;q=0.5    | en | ltr | Log in
          tlh            | en | ltr | Log in
          """)
  void aBrowserGetsTheLanguageThatItAsksFor(
      String accepted, String language, String direction, String title) {
    try (TestClient visitor = new TestClient(server.root())) {
      HttpResponse<String> page =
          visitor.send(visitor.request("").header("Accept-Language", accepted).build());

      assertTrue(
          page.body().contains("<html lang=\"%s\" dir=\"%s\"".formatted(language, direction)));
      assertTrue(page.body().contains("<h1>" + title + "</h1>"));
      assertEquals(language, page.headers().firstValue("Content-Language").orElseThrow());
      assertTrue(page.headers().allValues("Vary").contains("Accept-Language, Cookie"));
    }
  }

  @Test
  void whatWasChosenStaysAndGoesBeforeWhatTheBrowserAsksFor() {
    try (TestClient visitor = new TestClient(server.root())) {
      HttpResponse<String> chosen = visitor.get("language/ar?back=%2Fforgotten%3Fdone%3Dsent");

      assertEquals(303, chosen.statusCode());
      assertEquals("/forgotten?done=sent", location(chosen));
      String cookie = chosen.headers().firstValue("Set-Cookie").orElseThrow();
      assertTrue(cookie.startsWith("toqa-language=ar; "), cookie);
      assertTrue(cookie.contains("SameSite=Lax"), cookie);
      assertTrue(cookie.contains("Max-Age=31536000"), cookie);
      assertTrue(
          visitor
              .send(visitor.request("").header("Accept-Language", "en").build())
              .body()
              .contains(ARABIC_PAGE));
      assertTrue(visitor.get("nothing").body().contains(ARABIC_PAGE));

      visitor.get("language/en");
      assertTrue(visitor.get("").body().contains(ENGLISH_PAGE));
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "forgotten", "reset", "nothing"})
  void everyAnonymousPageHasTheLanguageSwitch(String path) {
    try (TestClient visitor = new TestClient(server.root())) {
      assertTrue(visitor.get(path).body().contains("href=\"/language/ar?back="), path);
    }
  }

  @ParameterizedTest
  @CsvSource({
    "/tasks?page=2, /tasks?page=2",
    "/users/7/sessions/3/end, /users/7",
    "/robots/r1/locate, /robots/r1",
    "/history?task=1&kind=task.done, /history?task=1&kind=task.done",
    "//evil.example, /",
    "https://evil.example/, /",
    "/\\evil.example, /",
    "/tasks?x=<script>, /",
    "'/tasks?x\r\nX-Evil: 1', /",
    "/api/v1/robots, /api",
    "/language/en?back=/map, /",
    "/assets/css/base.css, /",
    "'', /"
  })
  void theSwitchComesBackToAPageOfOurs(String back, String page) {
    HttpResponse<String> answer =
        arab.get("language/ar?back=" + URLEncoder.encode(back, StandardCharsets.UTF_8));

    assertEquals(303, answer.statusCode());
    assertEquals(page, location(answer));
    assertTrue(answer.headers().firstValue("X-Evil").isEmpty());
  }

  @Test
  void anotherSiteChoosesNothing() {
    HttpResponse<String> answer =
        arab.send(arab.request("language/en").header("Sec-Fetch-Site", "cross-site").build());

    assertEquals(303, answer.statusCode());
    assertEquals(List.of(), answer.headers().allValues("Set-Cookie"));
    assertTrue(arab.get("tasks").body().contains(ARABIC_PAGE));
  }

  @ParameterizedTest
  @ValueSource(strings = {"xx", "ar-EG", "../ar", "%22%3E%3Cscript%3E"})
  void aForgedCookieDoesNoHarm(String value) {
    try (TestClient visitor = new TestClient(server.root())) {
      HttpResponse<String> page =
          visitor.send(visitor.request("").header("Cookie", "toqa-language=" + value).build());

      assertEquals(200, page.statusCode());
      assertTrue(page.body().contains(ENGLISH_PAGE));
      assertFalse(page.body().contains(value));
    }
  }

  @Test
  void aLanguageThatIsNotSpokenCannotBeChosen() {
    HttpResponse<String> answer = arab.get("language/fr");

    assertEquals(404, answer.statusCode());
    assertEquals(List.of(), answer.headers().allValues("Set-Cookie"));
  }

  /** But what is marked as English, and what people and machines have named. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "map",
        "tasks",
        "tasks/new",
        "tasks/1",
        "robots",
        "robots/r1",
        "users",
        "users/1",
        "statistics",
        "history",
        "nothing"
      })
  void anArabicPageHasNoEnglishWord(String path) {
    arab.post("tasks/new", TASK);
    String page = manager.get(path).body();

    assertTrue(page.contains(ARABIC_PAGE));
    String visible =
        withoutIsolated(
            page.replaceAll("(?s)<bdi[ >].*?</bdi>", "")
                .replaceAll("<option[^>]* dir=\"auto\"[^>]*>[^<]*", "")
                .replaceAll("<a class=\"language\".*?</a>", "")
                .replaceAll("<time [^>]*>[^<]*", ""));
    List<String> words =
        Pattern.compile("(?:>|aria-label=\"|title=\"|data-label=\")([^<\"]*[A-Za-z]{2,}[^<\"]*)")
            .matcher(visible)
            .results()
            .map(found -> found.group(1).strip())
            .filter(text -> !text.matches("Toqa|.* · Toqa|UTC"))
            .toList();
    assertEquals(List.of(), words);
  }

  /** Names may be Latin; an isolation may stand in another one. */
  public static String withoutIsolated(String text) {
    String inner = text.replaceAll("[\u2066\u2068][^\u2066\u2068\u2069]*\u2069", "");
    return inner.equals(text) ? text : withoutIsolated(inner);
  }

  @Test
  void aFormUnderstandsTheNumbersOfTheArabicScript() {
    HttpResponse<String> answer = arab.post("tasks/new", TASK);

    assertEquals(303, answer.statusCode(), answer.body());
    String page = arab.get(location(answer)).body();
    assertTrue(page.contains("<bdi>صندوق براغٍ</bdi>"));
    assertTrue(page.contains("2.5 كغم"));
    assertTrue(page.contains("\u206610.35, 1.05\u2069 م"));
    assertEquals(200, arab.get("history?task=١").statusCode());
  }

  @Test
  void aRefusedNumberIsShownAgainAsItWasTyped() {
    Map<String, String> form = new TreeMap<>(TASK);
    form.put("load", "٢٬٥");

    HttpResponse<String> answer = arab.post("tasks/new", form);

    assertEquals(422, answer.statusCode());
    assertTrue(answer.body().contains("أدخل رقمًا، مثل"));
    assertTrue(answer.body().contains("value=\"٢٬٥\""));
    assertTrue(answer.body().contains("value=\"١٠٫٣٥\""));
  }

  @Test
  void jsonHasNumbersOfItsOwn() {
    HttpResponse<String> answer =
        arab.postJson(
            "api/v1/tasks",
            """
            {"name":"x","load":٢,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"}}
            """);

    assertEquals(400, answer.statusCode());
  }

  @Test
  void problemsOfTheApiAreSaidInTheLanguageThatIsAskedFor() {
    try (TestClient program = new TestClient(server.root())) {
      HttpResponse<String> arabic =
          program.send(program.request("api/v1/tasks").header("Accept-Language", "ar").build());
      assertEquals(401, arabic.statusCode());
      assertTrue(arabic.body().contains("سجّل الدخول أولًا"), arabic.body());
      assertEquals("ar", arabic.headers().firstValue("Content-Language").orElseThrow());

      HttpResponse<String> english = program.get("api/v1/tasks");
      assertTrue(english.body().contains("Log in first"), english.body());
      assertEquals("en", english.headers().firstValue("Content-Language").orElseThrow());
    }
  }

  @Test
  void aQuestionIsAskedInTheLanguageOfThePage() {
    String task = location(arab.post("tasks/new", TASK));
    long id = Long.parseLong(task.replaceAll("\\D", ""));
    server.fleet().changeTask(id, TaskState.CARRYING, List.of("r1"), "r1 carries the load.");
    server.fleet().loseRobotOf(id);

    String page = arab.get(task).body();

    assertTrue(
        page.contains("\u2068r1\u2069 مفقود والحمولة على متنه، عند \u2066(2.00, 2.00)\u2069."),
        page);
    assertTrue(page.contains(">انتظر الروبوت</button>"), page);
    assertTrue(page.contains("<bdi lang=\"en\" dir=\"ltr\">r1 carries the load.</bdi>"), page);
  }

  @Test
  void theFleetSpeaksTheLanguageThatIsAskedFor() throws IOException {
    String task = location(arab.post("tasks/new", TASK)).replaceAll("\\D", "");
    long id = Long.parseLong(task);
    Sentence late = Phrase.CANNOT_BE_IN_TIME.with("r1", Phrase.SECONDS.with(90));
    server.fleet().changeView(id, view -> view.withLateness(late));
    try (TestClient program = TestClient.signedIn(server.root(), WebTestServer.MANAGER)) {
      for (String path : List.of("api/v1/tasks/" + task, "api/v1/tasks", "api/v1/events")) {
        String arabic = said(program, path, "ar");
        assertTrue(arabic.contains("\"waitingFor\":\"جارٍ البحث عن روبوت.\""), arabic);
        assertTrue(arabic.contains("يسلّمها \u2068r1\u2069 متأخرة 90 ث على الأقل."), arabic);
        for (String language : List.of("en", "tlh")) {
          String english = said(program, path, language);
          assertTrue(english.contains("\"waitingFor\":\"Looking for a robot.\""), english);
          assertTrue(english.contains("r1 would deliver at least 90 s late"), english);
        }
      }
      assertTrue(said(program, "api/v1/robots/r1", "ar").contains("\"doing\":\"خامل\""));
      assertTrue(said(program, "api/v1/robots/r1", "en").contains("\"doing\":\"Idle\""));
      assertTrue(
          said(program, "api/v1/tasks/" + task, "ar")
              .contains("\"text\":\"أنشأها \u2068" + WebTestServer.CLERK + "\u2069\""));
      assertTrue(said(program, "api/v1/events", "ar").contains("تُخطَّط مساراتها من جديد."));
    }
  }

  @Test
  void aRefusalOfTheFleetIsInTheLanguageThatIsAskedFor() {
    Map<String, String> form = new TreeMap<>(TASK);
    form.put("load", "60");

    assertTrue(arab.post("tasks/new", form).body().contains("لا تستطيع الروبوتات حمل 60 كغم"));
    HttpResponse<String> answer =
        arab.postJson(
            "api/v1/tasks",
            """
            {"name":"x","load":60,"start":{"station":"Dock A"},"goal":{"station":"Shelf 3"}}
            """);
    assertEquals(422, answer.statusCode());
    assertEquals("ar", answer.headers().firstValue("Content-Language").orElseThrow());
    assertTrue(answer.body().contains("لا تستطيع الروبوتات حمل 60 كغم"), answer.body());
  }

  /** The first answer, or of the live events the first one. */
  private static String said(TestClient visitor, String path, String language) throws IOException {
    HttpResponse<InputStream> answer =
        visitor.send(
            visitor.request(path).header("Accept-Language", language).build(),
            BodyHandlers.ofInputStream());
    try (BufferedReader lines =
        new BufferedReader(new InputStreamReader(answer.body(), StandardCharsets.UTF_8))) {
      String line = lines.readLine();
      while (line != null && !line.contains("{")) {
        line = lines.readLine();
      }
      return String.valueOf(line);
    }
  }

  private static String location(HttpResponse<?> answer) {
    return answer.headers().firstValue("Location").orElseThrow();
  }
}
