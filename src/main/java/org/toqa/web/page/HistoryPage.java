package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;
import org.toqa.fleet.history.EventArchive.Entry;
import org.toqa.fleet.history.EventArchive.Filter;
import org.toqa.web.access.Caller;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.HistoryQueryReader;

/** Everything that has happened, newest first, as far as it is wanted. */
public final class HistoryPage extends PageHandler {
  private static final int PAGE_SIZE = 100;
  private static final List<String> FAMILIES =
      List.of(
          "task",
          "schedule",
          "template",
          "robot",
          "fleet",
          "floor",
          "traffic",
          "supervision",
          "exploration",
          "camera",
          "network");
  private static final List<String> OF_MANAGERS = List.of("user", "notice");
  private static final String SITES = "site";

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    request.setAttribute(
        "families",
        Stream.of(
                FAMILIES.stream(),
                Caller.of(request).isManager() ? OF_MANAGERS.stream() : Stream.<String>empty(),
                Caller.of(request).isAdministrator() ? Stream.of(SITES) : Stream.<String>empty())
            .flatMap(Function.identity())
            .toList());
    request.setAttribute("robots", services(request).history().robots());
    FieldErrors errors = new FieldErrors();
    HistoryQueryReader reader = new HistoryQueryReader(request, errors);
    Filter filter = reader.filter();
    long before = reader.before();
    if (!errors.isEmpty()) {
      showAgain(request, response, "history", errors);
      return;
    }
    List<Entry> entries = services(request).history().events(filter, before, PAGE_SIZE);
    request.setAttribute("entries", entries);
    if (entries.size() == PAGE_SIZE) {
      request.setAttribute("next", entries.getLast().id());
    }
    show(request, response, "history");
  }
}
