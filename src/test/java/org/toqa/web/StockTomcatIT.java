package org.toqa.web;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.toqa.testbed.StockTomcat;

/** The same WAR on a Tomcat as its makers ship it. */
@Tag("full")
class StockTomcatIT {
  @TempDir private Path folder;

  @Test
  void servesTheLoginAndEndsCleanly() throws Exception {
    try (StockTomcat tomcat = StockTomcat.start(folder, Path.of("target/toqa.war"))) {
      tomcat.awaitStart();
      HttpResponse<String> page = get(tomcat.uri());
      assertEquals(200, page.statusCode(), tomcat.log());
      assertTrue(page.body().contains("name=\"password\""), page.body());
      assertEquals(403, get(tomcat.uri().resolve("org/toqa/launch/Launcher.class")).statusCode());

      tomcat.stop();

      assertFalse(tomcat.log().contains("SEVERE"), tomcat.log());
    }
  }

  private static HttpResponse<String> get(URI uri) throws Exception {
    try (HttpClient client =
        HttpClient.newBuilder().followRedirects(HttpClient.Redirect.NORMAL).build()) {
      return client.send(HttpRequest.newBuilder(uri).build(), HttpResponse.BodyHandlers.ofString());
    }
  }
}
