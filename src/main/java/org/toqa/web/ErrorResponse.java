package org.toqa.web;

import jakarta.servlet.ServletRequest;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Optional;
import org.toqa.fleet.CheckRefusedException;
import org.toqa.persistence.StoreException;

/** The answer to a request that is refused: a problem for the API, else a page. */
public final class ErrorResponse {
  private static final String RETRY_SECONDS = "5";
  private static final int UNPROCESSABLE = 422;
  private static final int TOO_MANY_REQUESTS = 429;
  private static final String SENTENCE = ErrorResponse.class.getName();

  private ErrorResponse() {}

  /** Ends the request with a status and the sentence that the reader is shown. */
  public static void send(
      HttpServletRequest request, HttpServletResponse response, int status, String sentence)
      throws IOException {
    request.setAttribute(SENTENCE, sentence);
    response.sendError(status);
  }

  /** The same with the text of a key, in the reader's language. */
  public static void sendText(
      HttpServletRequest request,
      HttpServletResponse response,
      int status,
      String key,
      Object... values)
      throws IOException {
    send(request, response, status, Texts.of(request).get(key, values));
  }

  /** Of what is unavailable (503): after how many seconds, where nobody has said it better. */
  public static void sayWhenToRetry(HttpServletResponse response, int status) {
    if (status == HttpServletResponse.SC_SERVICE_UNAVAILABLE
        && !response.containsHeader("Retry-After")) {
      response.setHeader("Retry-After", RETRY_SECONDS);
    }
  }

  /** The status of what the store would not do. */
  public static int status(StoreException failure) {
    return switch (failure.kind()) {
      case UNKNOWN_USER -> HttpServletResponse.SC_UNAUTHORIZED;
      case REFUSED -> UNPROCESSABLE;
      case UNAVAILABLE, OVERTAKEN, TOO_SLOW -> HttpServletResponse.SC_SERVICE_UNAVAILABLE;
    };
  }

  /** What people are told of it. */
  public static String sentence(HttpServletRequest request, StoreException failure) {
    Texts texts = Texts.of(request);
    return switch (failure.kind()) {
      case UNAVAILABLE -> texts.get("problem.databaseUnavailable");
      case OVERTAKEN -> texts.get("problem.overtaken");
      case REFUSED -> texts.get("problem.cannotBeStored", String.valueOf(failure.getMessage()));
      case UNKNOWN_USER -> texts.get("problem.login");
      case TOO_SLOW -> texts.get("problem.databaseTooSlow");
    };
  }

  /**
   * The status of an order that was not checked; tells the caller when to send it again.
   *
   * @param response whose body is not begun
   */
  public static int status(HttpServletResponse response, CheckRefusedException refusal) {
    response.setHeader("Retry-After", Long.toString(refusal.reason().pause().toSeconds()));
    return switch (refusal.reason()) {
      case TOO_MANY -> TOO_MANY_REQUESTS;
      case OUT_OF_TIME -> HttpServletResponse.SC_SERVICE_UNAVAILABLE;
    };
  }

  /** What people are told of it. */
  public static String sentence(HttpServletRequest request, CheckRefusedException refusal) {
    return Texts.of(request)
        .get(
            switch (refusal.reason()) {
              case TOO_MANY -> "problem.tooManyChecks";
              case OUT_OF_TIME -> "problem.checkTooLong";
            });
  }

  /** What {@link #send} was given, while the error is shown. */
  public static Optional<String> sentence(ServletRequest request) {
    return Optional.ofNullable((String) request.getAttribute(SENTENCE));
  }
}
