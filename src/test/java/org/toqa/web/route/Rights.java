package org.toqa.web.route;

import java.io.IOException;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.toqa.accounts.Scope;
import org.toqa.web.TestClient;

/** The table of who may do what, and how its lines are tried. */
public final class Rights {
  /**
   * Who may do what, written by hand: a method, a path, and the status for a client that is not
   * signed in, a viewer, a clerk, an operator, a manager, an administrator, and one who looks at
   * another site. Each sends an order without fields, for what does not exist.
   */
  private static final Path FILE = Path.of("src/test/resources/web/rights.txt");

  /** Whoever sends these proves himself by what is in them. */
  private static final Set<String> WITHOUT_TOKEN =
      Set.of("/api/v1/session", "/api/v1/forgotten-password", "/api/v1/reset-password");

  private Rights() {}

  /** A line of the table. */
  public record Right(
      String method,
      String path,
      String ofAnonymous,
      String ofViewer,
      String ofClerk,
      String ofOperator,
      String ofManager,
      String ofAdministrator,
      String ofVisitor,
      String scope) {

    public boolean needsScope() {
      return Scope.ofWord(scope).isPresent();
    }

    public boolean isApi() {
      return path.startsWith("/api/v1/");
    }

    boolean needsToken() {
      return !method.equals("GET") && !(method.equals("POST") && WITHOUT_TOKEN.contains(path));
    }

    public boolean endsSession() {
      return path.equals("/logout") || (path.equals("/api/v1/session") && method.equals("DELETE"));
    }
  }

  public static List<Right> all() throws IOException {
    return Files.readAllLines(FILE).stream()
        .filter(line -> !line.isBlank() && !line.startsWith("#"))
        .map(line -> line.split(" +"))
        .map(
            word ->
                new Right(
                    word[0],
                    word[1],
                    word[2],
                    word[3],
                    word[4],
                    word[5],
                    word[6],
                    word[7],
                    word[8],
                    word.length > 9 ? word[9] : ""))
        .toList();
  }

  /** The status with which the line is answered; {@code login}: by the way to the login. */
  public static String answer(TestClient client, Right right) {
    HttpResponse<String> response = response(client, right);
    String target = response.headers().firstValue("Location").orElse("");
    return target.matches("/(\\?.*)?") ? "login" : String.valueOf(response.statusCode());
  }

  private static HttpResponse<String> response(TestClient client, Right right) {
    if (right.method().equals("GET")) {
      // the stream of events would not end
      return client.send(right.path().equals("/api/v1/events") ? "HEAD" : "GET", path(right));
    }
    return right.isApi()
        ? client.sendJson(right.method(), path(right), "{}")
        : client.post(path(right), Map.of());
  }

  public static String path(Right right) {
    return right
        .path()
        .substring(1)
        .replace("{id}", "999999")
        .replace("{language}", "en")
        .replace("{name}", "none")
        .replace("{session}", "999999")
        .replace("{reading}", "range")
        .replace("{floor}", "none")
        .replace("{box}", "0")
        .replace("{site}", "none")
        .replace("{topic}", "none")
        .replace("*", "css/base.css");
  }
}
