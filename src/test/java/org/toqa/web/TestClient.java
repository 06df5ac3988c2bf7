package org.toqa.web;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.CookieManager;
import java.net.URI;
import java.net.URLEncoder;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpRequest.BodyPublishers;
import java.net.http.HttpResponse;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/** Somebody with a browser's manners: keeps cookies, sends forms with their token. */
public final class TestClient implements AutoCloseable {
  private static final Duration LIMIT = Duration.ofSeconds(60);
  private static final Pattern CSRF = Pattern.compile("name=\"_csrf\" value=\"([^\"]+)\"");

  private final URI root;
  private final @Nullable String address;
  private final HttpClient client =
      HttpClient.newBuilder()
          .cookieHandler(new CookieManager())
          .followRedirects(HttpClient.Redirect.NEVER)
          .build();

  public TestClient(URI root) {
    this(root, null);
  }

  /**
   * @param address from which a proxy says that he asks; null: there is no proxy
   */
  public TestClient(URI root, @Nullable String address) {
    this.root = root;
    this.address = address;
  }

  public static TestClient signedIn(URI root, String name) {
    TestClient client = new TestClient(root);
    client.signIn(name);
    return client;
  }

  /** From now on he is this user. */
  public HttpResponse<String> signIn(String name) {
    HttpResponse<String> answer =
        post("", Map.of("name", name, "password", WebTestServer.PASSWORD));
    if (answer.statusCode() != 303) {
      throw new IllegalStateException("Login answered " + answer.statusCode());
    }
    return answer;
  }

  public HttpResponse<String> get(String path) {
    return send(request(path).build());
  }

  public HttpResponse<String> send(String method, String path) {
    return send(request(path).method(method, BodyPublishers.noBody()).build());
  }

  /** Sends a form with the session's token. */
  public HttpResponse<String> post(String path, Map<String, String> fields) {
    Map<String, String> all = new TreeMap<>(fields);
    all.put("_csrf", csrf());
    return postWithoutToken(path, all);
  }

  /** Sends a form as it is. */
  public HttpResponse<String> postWithoutToken(String path, Map<String, String> fields) {
    String body =
        fields.entrySet().stream()
            .map(e -> encoded(e.getKey()) + "=" + encoded(e.getValue()))
            .collect(Collectors.joining("&"));
    return send(
        request(path)
            .header("Content-Type", "application/x-www-form-urlencoded")
            .POST(BodyPublishers.ofString(body))
            .build());
  }

  /** Sends JSON with the session's token in the header. */
  public HttpResponse<String> postJson(String path, String body) {
    return sendJson("POST", path, body);
  }

  /** The same with another method. */
  public HttpResponse<String> sendJson(String method, String path, String body) {
    return sendJson(method, path, body, csrf());
  }

  /**
   * The same for who has the session's token already.
   *
   * @param csrf the token
   */
  public HttpResponse<String> sendJson(String method, String path, String body, String csrf) {
    return send(
        request(path)
            .header("Content-Type", "application/json")
            .header("X-CSRF-Token", csrf)
            .method(method, BodyPublishers.ofString(body))
            .build());
  }

  /** Sends a form with a file in it, and the session's token. */
  public HttpResponse<String> postFile(
      String path, Map<String, String> fields, String fileName, byte[] file) {
    String border = "border-of-the-parts";
    ByteArrayOutputStream body = new ByteArrayOutputStream();
    Map<String, String> all = new TreeMap<>(fields);
    all.putIfAbsent("_csrf", csrf());
    all.forEach(
        (name, value) -> writePart(body, border, name, value.getBytes(StandardCharsets.UTF_8)));
    writePart(body, border, "file\"; filename=\"" + fileName, file);
    body.writeBytes(("--" + border + "--").getBytes(StandardCharsets.UTF_8));
    return send(
        request(path)
            .header("Content-Type", "multipart/form-data; boundary=" + border)
            .POST(BodyPublishers.ofByteArray(body.toByteArray()))
            .build());
  }

  private static void writePart(
      ByteArrayOutputStream body, String border, String name, byte[] content) {
    body.writeBytes(
        "--%s\r\nContent-Disposition: form-data; name=\"%s\"\r\n\r\n"
            .formatted(border, name)
            .getBytes(StandardCharsets.UTF_8));
    body.writeBytes(content);
    body.writeBytes("\r\n".getBytes(StandardCharsets.UTF_8));
  }

  public HttpRequest.Builder request(String path) {
    HttpRequest.Builder request = HttpRequest.newBuilder(root.resolve(path)).timeout(LIMIT);
    return address == null ? request : request.header("X-Forwarded-For", address);
  }

  public HttpResponse<String> send(HttpRequest request) {
    return send(request, BodyHandlers.ofString());
  }

  public <T> HttpResponse<T> send(HttpRequest request, HttpResponse.BodyHandler<T> handler) {
    try {
      return client.send(request, handler);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException(e);
    }
  }

  /** The token that this visitor's pages have in their forms. */
  public String csrf() {
    for (String page : new String[] {"statistics", "", "first-start"}) {
      Matcher matcher = CSRF.matcher(get(page).body());
      if (matcher.find()) {
        return matcher.group(1);
      }
    }
    throw new IllegalStateException("No page has a form.");
  }

  @Override
  public void close() {
    client.shutdownNow();
  }

  private static String encoded(String value) {
    return URLEncoder.encode(value, StandardCharsets.UTF_8);
  }
}
