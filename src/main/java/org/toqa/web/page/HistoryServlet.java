package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import java.util.stream.Stream;
import org.toqa.fleet.EventArchive.Entry;
import org.toqa.fleet.EventArchive.Filter;
import org.toqa.web.FieldErrors;
import org.toqa.web.HistoryFilter;
import org.toqa.web.access.Caller;

/** Everything that has happened, newest first, as far as it is wanted. */
public final class HistoryServlet extends PageServlet {
  private static final int ON_A_PAGE = 100;
  private static final List<String> FAMILIES =
      List.of("task", "schedule", "robot", "fleet", "floor", "traffic");
  private static final String USERS = "user";

  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    request.setAttribute(
        "families",
        Stream.concat(
                FAMILIES.stream(),
                Caller.of(request).isManager() ? Stream.of(USERS) : Stream.empty())
            .toList());
    request.setAttribute("robots", services().fleet().feed().latest().robots());
    FieldErrors errors = new FieldErrors();
    HistoryFilter reader = new HistoryFilter(request, errors);
    Filter filter = reader.read();
    long before = reader.before();
    if (!errors.isEmpty()) {
      showAgain(request, response, "history", errors);
      return;
    }
    List<Entry> entries = services().history().events(filter, before, ON_A_PAGE);
    request.setAttribute("entries", entries);
    if (entries.size() == ON_A_PAGE) {
      request.setAttribute("next", entries.getLast().id());
    }
    show(request, response, "history");
  }
}
