package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskArchive.Filter;
import org.toqa.fleet.TaskArchive.Sort;
import org.toqa.mission.TaskState;
import org.toqa.web.FieldErrors;
import org.toqa.web.TaskListing;
import org.toqa.web.Tasks;

/** The tasks, all of them or some, page by page. */
public final class TasksServlet extends PageServlet {
  private static final int ON_A_PAGE = 25;

  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    TaskListing wanted = new TaskListing(request, errors);
    Filter filter = wanted.filter();
    Sort sort = wanted.sort();
    request.setAttribute("robots", services().fleet().feed().latest().robots());
    request.setAttribute("states", TaskState.values());
    request.setAttribute("columns", TaskListing.columns());
    request.setAttribute("isFiltered", !filter.equals(Filter.ANY));
    if (errors.isEmpty()) {
      list(request, filter, sort);
      show(request, response, "tasks");
    } else {
      showAgain(request, response, "tasks", errors);
    }
  }

  private void list(HttpServletRequest request, Filter filter, Sort sort) {
    Tasks tasks = new Tasks(services());
    long count = tasks.count(filter);
    int pages = (int) Math.max(1, (count + ON_A_PAGE - 1) / ON_A_PAGE);
    int page = Math.min(pages, pageNumber(request.getParameter("page")));
    request.setAttribute("tasks", tasks.list(filter, sort, (page - 1) * ON_A_PAGE, ON_A_PAGE));
    request.setAttribute("count", count);
    request.setAttribute("imported", imported(request.getParameter("imported")));
    request.setAttribute("page", page);
    request.setAttribute("pages", pages);
  }

  /** How many tasks the reader has just imported. */
  private static @Nullable Integer imported(@Nullable String given) {
    return given != null && given.matches("[1-9][0-9]{0,3}") ? Integer.valueOf(given) : null;
  }

  private static int pageNumber(@Nullable String given) {
    return given != null && given.matches("[1-9][0-9]{0,6}") ? Integer.parseInt(given) : 1;
  }
}
