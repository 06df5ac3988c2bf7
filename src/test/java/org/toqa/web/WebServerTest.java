package org.toqa.web;

import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.TestInstance;

/** A server for all tests of a class, with a client of each role. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
public abstract class WebServerTest {
  protected WebTestServer server;
  protected TestClient anonymous;
  protected TestClient clerk;
  protected TestClient manager;

  @BeforeAll
  final void startServer() throws Exception {
    server = WebTestServer.start();
    anonymous = new TestClient(server.root());
    clerk = TestClient.signedIn(server.root(), WebTestServer.CLERK);
    manager = TestClient.signedIn(server.root(), WebTestServer.MANAGER);
  }

  @AfterAll
  final void stopServer() throws Exception {
    anonymous.close();
    clerk.close();
    manager.close();
    server.close();
  }
}
