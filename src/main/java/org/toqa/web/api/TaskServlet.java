package org.toqa.web.api;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.toqa.fleet.TaskView;
import org.toqa.web.Tasks;
import org.toqa.web.Texts;

/** One task with its history. */
public final class TaskServlet extends ApiServlet {
  @Override
  protected void doGet(HttpServletRequest request, HttpServletResponse response)
      throws IOException {
    TaskView task =
        pathNumber(request, "id")
            .flatMap(new Tasks(services())::byId)
            .orElseThrow(
                () -> Problem.of(404, Texts.of(request).get("problem.noSuchTask")).raised());
    Json.send(response, 200, TaskJson.withHistory(task, services().archive().history(task.id())));
  }
}
