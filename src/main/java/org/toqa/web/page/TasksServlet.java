package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.jspecify.annotations.Nullable;
import org.toqa.web.Tasks;

/** All tasks, newest first, page by page. */
public final class TasksServlet extends PageServlet {
  private static final int ON_A_PAGE = 25;

  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Tasks tasks = new Tasks(services());
    long count = tasks.count();
    int pages = (int) Math.max(1, (count + ON_A_PAGE - 1) / ON_A_PAGE);
    int page = Math.min(pages, pageNumber(request.getParameter("page")));
    request.setAttribute("tasks", tasks.newest((page - 1) * ON_A_PAGE, ON_A_PAGE));
    request.setAttribute("count", count);
    request.setAttribute("imported", imported(request.getParameter("imported")));
    request.setAttribute("page", page);
    request.setAttribute("pages", pages);
    show(request, response, "tasks");
  }

  /** How many tasks the reader has just imported. */
  private static @Nullable Integer imported(@Nullable String given) {
    return given != null && given.matches("[1-9][0-9]{0,3}") ? Integer.valueOf(given) : null;
  }

  private static int pageNumber(@Nullable String given) {
    return given != null && given.matches("[1-9][0-9]{0,6}") ? Integer.parseInt(given) : 1;
  }
}
