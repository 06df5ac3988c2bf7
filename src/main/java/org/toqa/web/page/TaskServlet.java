package org.toqa.web.page;

import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.toqa.fleet.TaskView;
import org.toqa.mission.TaskState;
import org.toqa.web.Tasks;

/** One task: its state, its robots and what happened. */
public final class TaskServlet extends PageServlet {
  /** The road of a task that goes well. */
  private static final List<TaskState> ROAD =
      List.of(
          TaskState.QUEUED,
          TaskState.ASSIGNED,
          TaskState.TO_OBJECT,
          TaskState.CARRYING,
          TaskState.RETURNING,
          TaskState.DONE);

  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws ServletException, IOException {
    Optional<TaskView> task = new Tasks(services()).byId(pathNumber(request, "id"));
    if (task.isEmpty()) {
      notFound(request, response, "problem.noSuchTask");
      return;
    }
    request.setAttribute("task", task.get());
    request.setAttribute("history", services().archive().history(task.get().id()));
    request.setAttribute("road", ROAD);
    request.setAttribute("reached", ROAD.indexOf(task.get().state()));
    show(request, response, "task");
  }
}
