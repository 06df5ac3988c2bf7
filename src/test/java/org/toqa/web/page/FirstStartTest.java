package org.toqa.web.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpResponse;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;

class FirstStartTest {
  private WebTestServer server;
  private TestClient visitor;

  @BeforeEach
  void start() throws Exception {
    server = WebTestServer.startEmpty(0);
    visitor = new TestClient(server.root());
  }

  @AfterEach
  void stop() throws Exception {
    visitor.close();
    server.close();
  }

  @Test
  void nothingElseIsReachableBeforeThereIsAManager() {
    for (String path : new String[] {"", "map", "tasks", "users"}) {
      HttpResponse<String> answer = visitor.get(path);
      assertEquals(303, answer.statusCode(), path);
      assertEquals("/first-start", answer.headers().firstValue("Location").orElseThrow(), path);
    }
    HttpResponse<String> session =
        visitor.postJson("api/v1/session", "{\"name\":\"a\",\"password\":\"b\"}");
    assertEquals(503, session.statusCode());
    assertTrue(session.body().contains("no manager yet"));
    assertEquals(200, visitor.get("api/v1/health").statusCode());
    assertEquals(200, visitor.get("assets/css/base.css").statusCode());
  }

  @Test
  void theFirstManagerIsSignedInAndFirstStartEnds() {
    assertEquals(200, visitor.get("first-start").statusCode());

    HttpResponse<String> answer =
        visitor.post("first-start", form(code(), "Max", "a sentence to remember"));

    assertEquals("/map", answer.headers().firstValue("Location").orElseThrow());
    assertTrue(visitor.get("users").body().contains("Add user"));
    assertEquals("/", visitor.get("first-start").headers().firstValue("Location").orElseThrow());
    assertEquals(
        "/",
        visitor
            .post("first-start", form(code(), "Thief", "a sentence to remember"))
            .headers()
            .firstValue("Location")
            .orElseThrow());
    assertTrue(server.accounts().accountByName("thief").isEmpty());
  }

  @Test
  void aPoorPasswordGetsASentence() {
    assertTrue(refusal("Max", "short").contains("A password has at least 10 characters."));
    assertTrue(refusal("Maximilian", "maximilian").contains("must differ from the name"));
    assertTrue(refusal("", "a sentence to remember").contains("A user name has"));
    assertTrue(server.accounts().accounts().isEmpty());
  }

  @Test
  void onlyWhoHasTheCodeMakesTheFirstManager() {
    for (String wrong : new String[] {"", "AAAA-BBBB-CCCC", code().substring(1)}) {
      HttpResponse<String> answer =
          visitor.post("first-start", form(wrong, "Thief", "a sentence to remember"));
      assertEquals(422, answer.statusCode());
      assertTrue(answer.body().contains("This is not the code"), answer.body());
    }
    assertTrue(server.accounts().accounts().isEmpty());

    String typed = code().toLowerCase(Locale.ROOT).replace("-", " ");
    assertEquals(
        303,
        visitor.post("first-start", form(typed, "Max", "a sentence to remember")).statusCode());
  }

  @Test
  void aSlipOfTheFingerLocksNobodyOut() {
    for (String repeat : new String[] {"", "a sentence to rememver", " a sentence to remember"}) {
      Map<String, String> form = new HashMap<>(form(code(), "Max", "a sentence to remember"));
      form.put("repeat", repeat);
      HttpResponse<String> answer = visitor.post("first-start", form);
      assertEquals(422, answer.statusCode());
      assertTrue(answer.body().contains("This is not the password that you typed above"));
    }
    Map<String, String> form = new HashMap<>(form(code(), "Max", "a sentence to remember"));
    form.remove("repeat");
    assertEquals(422, visitor.post("first-start", form).statusCode());
    assertTrue(server.accounts().accounts().isEmpty());
  }

  private static Map<String, String> form(String code, String name, String password) {
    return Map.of("code", code, "name", name, "password", password, "repeat", password);
  }

  private String code() {
    return server.firstStartCode();
  }

  private String refusal(String name, String password) {
    HttpResponse<String> answer = visitor.post("first-start", form(code(), name, password));
    assertEquals(422, answer.statusCode());
    return answer.body();
  }
}
