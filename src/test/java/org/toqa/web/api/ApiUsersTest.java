package org.toqa.web.api;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpResponse;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.toqa.web.WebTestServer;
import tools.jackson.databind.JsonNode;

/** Users that managers add, change and delete through the API. */
class ApiUsersTest extends ApiTestServer {
  @Test
  void aManagerAddsChangesAndDeletesUsers() {
    HttpResponse<String> added =
        post(token, "api/v1/users", "{\"name\":\"Omar\",\"password\":\"another long one\"}");
    assertEquals(201, added.statusCode());
    JsonNode omar = JSON.readTree(added.body());
    assertEquals("CLERK", omar.get("role").stringValue());
    assertFalse(added.body().contains("argon2"));
    String path = "api/v1/users/" + omar.get("id").asLong();
    assertTrue(added.headers().firstValue("Location").orElseThrow().endsWith(path));

    HttpResponse<String> changed = send("PUT", path, "{\"role\":\"MANAGER\",\"disabled\":true}");
    assertEquals(200, changed.statusCode());
    assertTrue(JSON.readTree(changed.body()).get("disabled").asBoolean());
    HttpResponse<String> login =
        post(null, "api/v1/session", "{\"name\":\"omar\",\"password\":\"another long one\"}");
    assertEquals(403, login.statusCode());
    assertTrue(detail(login).startsWith("This user is disabled."));

    assertEquals(204, send("DELETE", path, "").statusCode());
    assertEquals(404, send("DELETE", path, "").statusCode());
    assertEquals(2, JSON.readTree(get("api/v1/users").body()).size());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "{\"name\":\"Omar\",\"password\":\"short\"}|422|at least 10 characters",
        "{\"name\":\"Omar\",\"password\":\"password123\"}|422|This password is easy to guess",
        "{\"name\":\"Omarovich\",\"password\":\"omarovich1\"}|422|This password is easy to guess",
        "{\"name\":\"Omar\",\"password\":\"a long good one\",\"role\":\"KING\"}|422|one of VIEWER, CLERK, OPERATOR, MANAGER",
        "{\"name\":\"nora@north\",\"password\":\"a long good one\"}|422|the name of a site",
        "{\"name\":\"nora@2\",\"password\":\"a long good one\"}|422|the name of a site",
        "{\"name\":\"MAX\",\"password\":\"a long good one\"}|409|This name is already in use",
        "{\"name\":\"Omar\",\"password\":\"a long good one\",\"boss\":1}|422|boss"
      })
  void aUserWhoCannotBeAddedIsRefusedWithASentence(String body, int status, String sentence) {
    HttpResponse<String> answer = post(token, "api/v1/users", body);

    assertEquals(status, answer.statusCode(), answer.body());
    assertTrue(answer.body().contains(sentence), answer.body());
  }

  @Test
  void theLastManagerStaysOneAndAClerkChangesOnlyHisOwnPassword() {
    long max = server.accounts().accountByName(WebTestServer.MANAGER).orElseThrow().id();
    assertEquals(409, send("PUT", "api/v1/users/" + max, "{\"role\":\"CLERK\"}").statusCode());
    assertEquals(409, send("DELETE", "api/v1/users/" + max, "").statusCode());
    assertEquals(422, send("PUT", "api/v1/users/" + max, "{\"disabled\":\"no\"}").statusCode());

    String clerk = tokenOf(WebTestServer.CLERK);
    long clara = server.accounts().accountByName(WebTestServer.CLERK).orElseThrow().id();
    String path = "api/v1/users/" + clara + "/password";
    String withoutOld = "{\"password\":\"quite another password\"}";
    assertEquals(404, post(clerk, "api/v1/users/" + max + "/password", withoutOld).statusCode());
    assertEquals(422, post(clerk, path, withoutOld).statusCode());
    String withOld = withoutOld.replace("}", ",\"old\":\"" + WebTestServer.PASSWORD + "\"}");
    assertEquals(204, post(clerk, path, withOld).statusCode());
    assertEquals(401, post(clerk, path, withOld).statusCode(), "the token has ended");
  }
}
