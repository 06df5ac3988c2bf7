package org.toqa.web.route;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.toqa.web.RequestPath;
import org.toqa.web.access.Permission;

/**
 * A method and a path that the server answers.
 *
 * @param path from the application's root; a segment in braces stands for any one segment, a last
 *     segment {@code *} for any rest
 */
public record Route(String method, String path, Permission permission) {

  /** Routes of the API answer in JSON, the others in pages. */
  public boolean isApi() {
    return RequestPath.isApi(path);
  }

  /** What stands in the place of each segment in braces, if the path fits. */
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
}
