package org.toqa.web.api;

import com.fasterxml.jackson.annotation.JsonInclude;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.toqa.mission.Question;
import org.toqa.web.ErrorResponse;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.LineFaults;

/**
 * An error of the API as RFC 9457 has it.
 *
 * @param detail a sentence that says what to do
 * @param problems of a drawing that cannot be published
 * @param needs what must be said too, if that is what is missing
 * @param errors one for each field at fault, if fields are at fault
 */
@JsonInclude(JsonInclude.Include.NON_EMPTY)
public record Problem(
    String type,
    String title,
    int status,
    String detail,
    List<FieldProblem> errors,
    List<MapProblemJson> problems,
    @Nullable Question needs) {

  /**
   * What is wrong with one field; a dot leads into an object.
   *
   * @param line of a table, from 1
   * @param field empty where the whole line is at fault
   */
  @JsonInclude(JsonInclude.Include.NON_NULL)
  public record FieldProblem(@Nullable Long line, String field, String detail) {}

  /** Ends a request with a problem. */
  public static final class ProblemException extends RuntimeException {
    private final transient Problem problem;

    ProblemException(Problem problem) {
      super(problem.detail, null, false, false);
      this.problem = problem;
    }

    Problem problem() {
      return problem;
    }
  }

  public static Problem of(int status, String detail) {
    return new Problem("about:blank", title(status), status, detail, List.of(), List.of(), null);
  }

  static Problem conflict(String detail, @Nullable Question needs) {
    return new Problem("about:blank", title(409), 409, detail, List.of(), List.of(), needs);
  }

  static Problem conflict(String detail, List<MapProblemJson> problems) {
    return new Problem("about:blank", title(409), 409, detail, List.of(), problems, null);
  }

  static Problem of(FieldErrors errors) {
    return new Problem(
        "about:blank",
        title(422),
        422,
        String.join(" ", new LinkedHashSet<>(errors.sentences().values())),
        errors.sentences().entrySet().stream()
            .map(e -> new FieldProblem(null, e.getKey(), e.getValue()))
            .toList(),
        List.of(),
        null);
  }

  static Problem of(LineFaults faults, String detail) {
    return new Problem(
        "about:blank",
        title(422),
        422,
        detail,
        faults.first().stream()
            .map(
                fault ->
                    new FieldProblem(
                        fault.line(),
                        Objects.requireNonNullElse(fault.column(), ""),
                        fault.sentence()))
            .toList(),
        List.of(),
        null);
  }

  public ProblemException exception() {
    return new ProblemException(this);
  }

  public void send(HttpServletRequest request, HttpServletResponse response) throws IOException {
    ErrorResponse.sayWhenToRetry(response, status);
    Json.send(request, response, status, "application/problem+json", this);
  }

  /** The phrase that RFC 9110 gives the status. */
  private static String title(int status) {
    return switch (status) {
      case 400 -> "Bad Request";
      case 401 -> "Unauthorized";
      case 403 -> "Forbidden";
      case 404 -> "Not Found";
      case 405 -> "Method Not Allowed";
      case 409 -> "Conflict";
      case 410 -> "Gone";
      case 412 -> "Precondition Failed";
      case 413 -> "Content Too Large";
      case 415 -> "Unsupported Media Type";
      case 421 -> "Misdirected Request";
      case 422 -> "Unprocessable Content";
      case 429 -> "Too Many Requests";
      case 502 -> "Bad Gateway";
      case 503 -> "Service Unavailable";
      default -> status < 500 ? "Bad Request" : "Internal Server Error";
    };
  }
}
