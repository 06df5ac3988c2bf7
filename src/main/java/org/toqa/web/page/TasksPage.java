package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.toqa.fleet.TaskArchive.Filter;
import org.toqa.fleet.TaskArchive.Sort;
import org.toqa.fleet.TaskView;
import org.toqa.mission.TaskState;
import org.toqa.web.Orders;
import org.toqa.web.Tasks;
import org.toqa.web.input.FieldErrors;
import org.toqa.web.input.TaskQueryReader;

/** The tasks, all of them or some, page by page. */
public final class TasksPage extends PageHandler {
  private static final int PAGE_SIZE = 25;

  public static void show(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    FieldErrors errors = new FieldErrors();
    TaskQueryReader query = new TaskQueryReader(request, errors);
    Filter filter = query.filter();
    Sort sort = query.sort();
    request.setAttribute("robots", services(request).fleet().snapshots().latest().robots());
    request.setAttribute("states", TaskState.values());
    request.setAttribute("columns", TaskQueryReader.sortColumns());
    request.setAttribute("isFiltered", !filter.equals(Filter.ANY));
    if (errors.isEmpty()) {
      addTaskAttributes(request, filter, sort);
      show(request, response, "tasks");
    } else {
      showAgain(request, response, "tasks", errors);
    }
  }

  private static void addTaskAttributes(HttpServletRequest request, Filter filter, Sort sort) {
    Tasks tasks = new Tasks(services(request));
    long count = tasks.count(filter);
    int offset = ListPage.of(request, count, PAGE_SIZE).offset();
    List<TaskView> shown = tasks.page(filter, sort, offset, PAGE_SIZE);
    request.setAttribute("tasks", shown);
    request.setAttribute("orders", new Orders(services(request)).of(shown));
    request.setAttribute("count", count);
    request.setAttribute("imported", imported(request.getParameter("imported")));
    request.setAttribute("deleted", deleted(request.getParameter("deleted")));
  }

  /** How many tasks the reader has just imported. */
  private static @Nullable Integer imported(@Nullable String given) {
    return given != null && given.matches("[1-9][0-9]{0,3}") ? Integer.valueOf(given) : null;
  }

  /** The number of the task that the reader has just deleted. */
  private static @Nullable Long deleted(@Nullable String given) {
    return given != null && given.matches("[1-9][0-9]{0,17}") ? Long.valueOf(given) : null;
  }
}
