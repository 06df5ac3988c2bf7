package org.toqa.web.route;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.toqa.accounts.Role;
import org.toqa.fleet.EventKind;
import org.toqa.fleet.EventRecord;
import org.toqa.web.TestClient;
import org.toqa.web.WebServerTest;
import org.toqa.web.WebTestServer;

/** What a change of an account means for its sessions, and who may change one. */
class AccountAccessTest extends WebServerTest {
  @Test
  void aNewPasswordEndsTheUsersOtherSessions() {
    server.accounts().add("Nora", hash(), Role.CLERK, EventRecord.SYSTEM);
    try (TestClient here = TestClient.signedIn(server.root(), "Nora");
        TestClient elsewhere = TestClient.signedIn(server.root(), "Nora")) {
      long nora = server.accounts().accountByName("nora").orElseThrow().id();
      Map<String, String> form =
          Map.of("old", WebTestServer.PASSWORD, "password", "quite another password");

      assertEquals(303, here.post("users/" + nora + "/password", form).statusCode());

      assertEquals(200, here.get("map").statusCode());
      assertEquals(303, elsewhere.get("map").statusCode());
      assertEquals(422, here.post("users/" + nora + "/password", form).statusCode(), "old one");
    }
  }

  @Test
  void aClerkChangesNobodyElsesPassword() {
    long max = server.accounts().accountByName(WebTestServer.MANAGER).orElseThrow().id();

    HttpResponse<String> answer =
        clerk.post("users/" + max + "/password", Map.of("password", "taken over now"));

    assertEquals(403, answer.statusCode());
    assertEquals(200, manager.get("map").statusCode());
  }

  @Test
  void aDeletedUserIsOutAtOnce() {
    server.accounts().add("Gone", hash(), Role.MANAGER, EventRecord.SYSTEM);
    try (TestClient gone = TestClient.signedIn(server.root(), "Gone")) {
      server
          .accounts()
          .delete(server.accounts().accountByName("gone").orElseThrow().id(), EventRecord.SYSTEM);

      assertEquals(303, gone.get("map").statusCode());
    }
  }

  @Test
  void aDisabledUserIsOutAtOnceAndInAgainWhenAManagerSaysSo() {
    long idle = server.accounts().add("Idle", hash(), Role.CLERK, "Max").orElseThrow().id();
    try (TestClient user = TestClient.signedIn(server.root(), "Idle")) {
      Map<String, String> disabled = Map.of("role", "CLERK", "disabled", "on");
      assertEquals(303, manager.post("users/" + idle + "/change", disabled).statusCode());

      assertEquals(303, user.get("map").statusCode());
      Map<String, String> login = Map.of("name", "Idle", "password", WebTestServer.PASSWORD);
      HttpResponse<String> refused = user.post("", login);
      assertEquals(422, refused.statusCode());
      assertTrue(refused.body().contains("This user is disabled."));

      assertEquals(
          303, manager.post("users/" + idle + "/change", Map.of("role", "MANAGER")).statusCode());
      assertEquals(303, user.post("", login).statusCode());
      assertTrue(user.get("users").body().contains("Add user"), "a manager now");
    }
  }

  @Test
  void clerksDoNotSeeWhatManagersDoWithUsers() {
    server.accounts().add("Secret", hash(), Role.CLERK, "Max");

    assertTrue(manager.get("history?kind=user").body().contains("added user Secret"));
    assertFalse(clerk.get("history").body().contains("added user Secret"));
    assertFalse(clerk.get("history?kind=user").body().contains("added user Secret"));
  }

  /** But for sites, which are the administrators' alone. */
  @Test
  void everyKindOfEventCanBeChosenInTheHistory() {
    String page = manager.get("history").body();
    for (EventKind kind : EventKind.values()) {
      String family = kind.text().split("\\.")[0];
      assertTrue(
          family.equals("site") || page.contains("<option value=\"" + family + "\""), family);
    }
  }

  @Test
  void nobodyOverwritesWhatAnotherChangedMeanwhile() {
    long id = server.accounts().add("Etta", hash(), Role.CLERK, "Max").orElseThrow().id();
    String path = "api/v1/users/" + id;
    String read = manager.get(path).headers().firstValue("ETag").orElseThrow();
    assertEquals(200, put(path, "{\"role\":\"MANAGER\",\"disabled\":false}", read));
    assertEquals(412, put(path, "{\"role\":\"CLERK\",\"disabled\":true}", read));
    assertEquals(Role.MANAGER, server.accounts().account(id).orElseThrow().role());
    assertEquals(200, put(path, "{\"role\":\"CLERK\",\"disabled\":false}", "\"x\", *"));
    assertEquals(200, put(path, "{\"role\":\"MANAGER\",\"disabled\":false}", read), "as it was");
  }

  private int put(String path, String body, String version) {
    return manager
        .send(
            manager
                .request(path)
                .header("Content-Type", "application/json")
                .header("X-CSRF-Token", manager.csrf())
                .header("If-Match", version)
                .PUT(BodyPublishers.ofString(body))
                .build())
        .statusCode();
  }

  private String hash() {
    return server.accounts().accountByName(WebTestServer.CLERK).orElseThrow().passwordHash();
  }
}
