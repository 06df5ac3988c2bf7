package org.toqa.app.bench;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicLong;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Asks Chromium by its DevTools protocol (https://chromedevtools.github.io/devtools-protocol). */
final class DevToolsConnection implements AutoCloseable {
  private static final long LIMIT_SECONDS = 60;

  private final HttpClient http = HttpClient.newHttpClient();
  private final Map<Long, CompletableFuture<JsonNode>> answers = new ConcurrentHashMap<>();
  private final AtomicLong lastId = new AtomicLong();
  private final WebSocket socket;

  /**
   * @throws IOException nothing listens there
   */
  DevToolsConnection(URI address) throws IOException, InterruptedException {
    CompletableFuture<WebSocket> opened =
        http.newWebSocketBuilder().buildAsync(address, new AnswerListener());
    socket = await(opened, "connect");
  }

  /**
   * @param session of a page; null: the browser itself
   * @return its answer
   * @throws IOException it refuses that, or is gone
   */
  synchronized JsonNode call(String method, Map<String, ?> parameters, @Nullable String session)
      throws IOException, InterruptedException {
    long id = lastId.incrementAndGet();
    Map<String, Object> request = new LinkedHashMap<>();
    request.put("id", id);
    request.put("method", method);
    request.put("params", parameters);
    if (session != null) {
      request.put("sessionId", session);
    }
    CompletableFuture<JsonNode> answer = new CompletableFuture<>();
    answers.put(id, answer);
    await(socket.sendText(JsonMapper.shared().writeValueAsString(request), true), method);
    JsonNode said = await(answer, method);
    if (said.has("error")) {
      throw new IOException("Chromium refuses " + method + ": " + said.get("error"));
    }
    return said.path("result");
  }

  private static <T> T await(CompletableFuture<T> future, String method)
      throws IOException, InterruptedException {
    try {
      return future.get(LIMIT_SECONDS, TimeUnit.SECONDS);
    } catch (ExecutionException | TimeoutException e) {
      throw new IOException("Chromium does not answer (" + method + ").", e);
    }
  }

  @Override
  public void close() {
    http.shutdownNow();
  }

  /** Gives each answer to who has asked; events are dropped. */
  private final class AnswerListener implements WebSocket.Listener {
    private final StringBuilder text = new StringBuilder();

    @Override
    public @Nullable CompletionStage<?> onText(WebSocket from, CharSequence data, boolean isLast) {
      text.append(data);
      if (isLast) {
        JsonNode said = JsonMapper.shared().readTree(text.toString());
        text.setLength(0);
        CompletableFuture<JsonNode> asked = answers.remove(said.path("id").asLong(-1));
        if (asked != null) {
          asked.complete(said);
        }
      }
      from.request(1);
      return null;
    }

    @Override
    public void onError(WebSocket from, Throwable error) {
      answers.values().forEach(answer -> answer.completeExceptionally(error));
    }
  }
}
