package org.toqa.web.api;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.io.InputStream;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.toqa.web.Handler;
import org.toqa.web.Texts;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * Answers a question as another handler does, if the API's description has all its parameters: one
 * that was misspelt would be left out of account, and nobody told. A question that has none is
 * answered whatever follows it, as programs that watch the server add a time.
 *
 * @param path as the description has it
 */
public record QueryCheck(String path, Handler handler) implements Handler {

  /** Of whatever belongs to a floor, also where that is known without it. */
  private static final String FLOOR = "floor";

  /** Of a name that is told again. */
  private static final int LONGEST = 64;

  /** Read when it is first asked for. */
  private static final class Described {
    /** By path, the names of a question's parameters. */
    static final Map<String, Set<String>> PARAMETERS = read();

    private static Map<String, Set<String>> read() {
      Map<String, Set<String>> parameters = new TreeMap<>();
      try (InputStream file =
          Objects.requireNonNull(QueryCheck.class.getResourceAsStream("openapi.json"))) {
        JsonNode described = JsonMapper.shared().readTree(file);
        for (Map.Entry<String, JsonNode> path : described.get("paths").properties()) {
          JsonNode question = path.getValue().get("get");
          if (question != null) {
            parameters.put(path.getKey(), names(question.path("parameters"), described));
          }
        }
      } catch (IOException e) {
        throw new IllegalStateException("The description of the API cannot be read.", e);
      }
      return parameters;
    }

    private static Set<String> names(JsonNode parameters, JsonNode described) {
      Set<String> names = new TreeSet<>();
      for (JsonNode parameter : parameters) {
        JsonNode reference = parameter.get("$ref");
        JsonNode known =
            reference == null ? parameter : described.at(reference.stringValue().substring(1));
        if (known.get("in").stringValue().equals("query")) {
          names.add(known.get("name").stringValue());
        }
      }
      return names;
    }
  }

  @Override
  public void handle(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    if (request.getQueryString() != null) {
      check(request, Described.PARAMETERS.get(path));
    }
    handler.handle(request, response);
  }

  /**
   * @param known null: the path is not described; empty: it has no answer but one
   */
  private static void check(HttpServletRequest request, @Nullable Set<String> known) {
    if (known == null || known.isEmpty()) {
      return;
    }
    Optional<String> unknown =
        request.getParameterMap().keySet().stream()
            .filter(name -> !known.contains(name) && !name.equals(FLOOR))
            .sorted()
            .map(name -> name.substring(0, Math.min(name.length(), LONGEST)))
            .findFirst();
    if (unknown.isPresent()) {
      throw Problem.of(
              400,
              Texts.of(request).get("problem.parameter", unknown.get(), String.join(", ", known)))
          .exception();
    }
  }
}
