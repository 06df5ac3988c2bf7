package org.toqa.web.route;

import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.toqa.web.TestClient;
import org.toqa.web.WebTestServer;

/** A server with a client of each role. */
abstract class AccessTestServer {
  static WebTestServer server;
  static TestClient anonymous;
  static TestClient clerk;
  static TestClient manager;

  @BeforeAll
  static void start() throws Exception {
    server = WebTestServer.start();
    anonymous = new TestClient(server.root());
    clerk = TestClient.signedIn(server.root(), WebTestServer.CLERK);
    manager = TestClient.signedIn(server.root(), WebTestServer.MANAGER);
  }

  @AfterAll
  static void stop() throws Exception {
    anonymous.close();
    clerk.close();
    manager.close();
    server.close();
  }
}
