package org.toqa.web.route;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.toqa.accounts.Scope;
import org.toqa.web.Handler;
import org.toqa.web.RequestPath;
import org.toqa.web.access.Permission;

/**
 * A method and a path that the server answers.
 *
 * @param path from the application's root; a segment in braces matches any one segment, a last
 *     segment {@code *} for any rest
 * @param scope what a token must have for it; null: no token opens it, or any
 * @param handler null: files are there, which the container's own servlet sends
 */
public record Route(
    String method,
    String path,
    Permission permission,
    @Nullable Scope scope,
    @Nullable Handler handler,
    Set<Option> options) {

  /** What holds for few routes. */
  public enum Option {
    /** It is answered also while there is no manager yet. */
    BEFORE_FIRST_START,
    /** Its form sends a file. */
    MULTIPART,
    /** It concerns its caller, or all sites: also while he looks at another site. */
    OWN_SITE,
    /** An administrator may write so in a site that he looks at. */
    EVERY_SITE,
    /** It stops robots, or tells how the server is: what else is asked for does not hold it up. */
    URGENT
  }

  /** Routes of the API answer in JSON, the others in pages. */
  public boolean isApi() {
    return RequestPath.isApi(path);
  }

  boolean has(Option option) {
    return options.contains(option);
  }

  Route with(Option option) {
    return new Route(
        method,
        path,
        permission,
        scope,
        handler,
        Stream.concat(options.stream(), Stream.of(option)).collect(Collectors.toUnmodifiableSet()));
  }

  /** The pattern of the Servlet specification (12.2) under which the container knows the path. */
  String urlPattern() {
    int firstBrace = path.indexOf('{');
    if (firstBrace >= 0) {
      return path.substring(0, firstBrace) + "*";
    }
    return path.equals("/") ? "" : path;
  }

  /** The value of each segment in braces, if the path matches. */
  Optional<Map<String, String>> match(String actual) {
    List<String> wanted = List.of(path.split("/", -1));
    List<String> given = List.of(actual.split("/", -1));
    boolean open = wanted.getLast().equals("*");
    if (open ? given.size() < wanted.size() : given.size() != wanted.size()) {
      return Optional.empty();
    }
    Map<String, String> parameters = new TreeMap<>();
    int fixed = open ? wanted.size() - 1 : wanted.size();
    for (int i = 0; i < fixed; i++) {
      String segment = wanted.get(i);
      String value = given.get(i);
      if (segment.startsWith("{") && !value.isEmpty()) {
        parameters.put(segment.substring(1, segment.length() - 1), value);
      } else if (!segment.equals(value)) {
        return Optional.empty();
      }
    }
    return Optional.of(parameters);
  }

  /** Without the handler, which has no name to show. */
  @Override
  public String toString() {
    return method + " " + path + " " + permission;
  }
}
